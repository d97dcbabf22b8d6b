// The mesh has been diced and displaced before it came here: it is the detail. Only AOVs, colours by
// height and self-shadow come this way, ordinary frames are VTK's own.
//   MESO_SELF_SHADOW  Techniques/Horizon says what blocks light

#ifdef MESO_SELF_SHADOW
float horizonBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, out int fetches);
#endif

// Unit normal of the flat facet, towards the eye.
vec3 facetNormal(MesoFragment f)
{
  vec3 normal = cross(dFdx(f.PositionVC), dFdy(f.PositionVC));
  float size = length(normal);
  return size > 0.0 && size < 1.0e30 ? normal / size : f.NormalVC;
}

MesoSurfaceHit traceSurface(MesoFragment f)
{
  MesoSurfaceHit hit = baseSurface(f);
  hit.Relief = clamp(mesoReliefVSOutput, 0.0, 1.0);
  hit.FacetNormalVC = facetNormal(f);
  return hit;
}

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
