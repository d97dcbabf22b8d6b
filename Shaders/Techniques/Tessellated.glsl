// The mesh has been diced and displaced before it came here: it is the detail. Only AOVs, colours by
// height and self-shadow come this way, ordinary frames are VTK's own.
// What blocks light: Common/HorizonLight.

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
