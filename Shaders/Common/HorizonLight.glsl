// What blocks light where the relief is seen as a normal or as facets: the facet itself, and with
//   MESO_SELF_SHADOW  what Techniques/Horizon says

#ifdef MESO_SELF_SHADOW
float horizonBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, out int fetches);
#endif

float blockedFraction(
  MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, float lightDistance, out int fetches)
{
  fetches = 0;
  if (!(dot(hit.FacetNormalVC, lightOutVC) > 0.0))
  {
    return 1.0;
  }
#ifdef MESO_SELF_SHADOW
  if (!seenFromBehind(f))
  {
    return horizonBlocks(f, hit, lightOutVC, fetches);
  }
#endif
  return 0.0;
}
