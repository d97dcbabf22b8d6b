// What blocks light where the relief is seen as a normal or as facets.
//   MESO_SELF_SHADOW  what Techniques/Horizon says; without it nothing

#ifdef MESO_SELF_SHADOW
float horizonBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, out int fetches);
#endif

float blockedFraction(
  MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, float lightDistance, out int fetches)
{
  fetches = 0;
#ifdef MESO_SELF_SHADOW
  if (!seenFromBehind(f))
  {
    return horizonBlocks(f, hit, lightOutVC, fetches);
  }
#endif
  return 0.0;
}
