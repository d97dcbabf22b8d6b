// The contract of a technique for those that look for a height map's relief along a ray: what they share
// around their way to it. Stands on Common/ReliefFrame and Common/HeightSurface. The technique itself
// defines the three functions that are declared here.

// Follow the view ray to the hit's RayLength, MapCoord, Relief, Fetches and Iterations, or to a miss.
// Where no ray can be followed the hit stays the base, and the result is false.
bool followRay(MesoFragment f, inout MesoSurfaceHit hit);
// Unit normal of the relief at a hit, for dh/du, dh/dv = gradient.
vec3 reliefNormal(MesoFragment f, MesoSurfaceHit hit, vec2 gradient);
// Does the detail block light from a direction and distance? travel: that direction in the relief's
// coordinates (directionInTS); lift: the offset of the shadow ray's start, likewise.
float reliefBlocks(MesoFragment f, MesoSurfaceHit hit, vec3 travel, vec3 lift, float lightDistance,
  out int fetches);

// A ray that runs further than this many tiles in the relief grazes the surface so flatly that a
// float no longer tells neighbouring texels apart: the base itself is drawn.
const float MESO_MAX_TILES = 1.0e5;

#ifdef MESO_SELF_SHADOW
vec3 mesoMetNormalVC; // unit, of the surface that the view ray met: the facet's, or that of the level searched
#endif

MesoSurfaceHit traceSurface(MesoFragment f)
{
  MesoSurfaceHit hit = baseSurface(f);
#ifdef MESO_SELF_SHADOW
  mesoMetNormalVC = hit.FacetNormalVC;
#endif
  if (seenFromBehind(f))
  {
#ifdef MESO_FILTER
    forgetRoughness();
#endif
    return hit;
  }
#ifdef MESO_OCCLUSION
  if (!followRay(f, hit))
  {
    return hit;
  }
#else
  hit.Relief = 1.0 - surfaceHeight(f.MapCoord);
  hit.Fetches = 1;
  hit.TexelReads = 4;
#endif
#ifdef MESO_SHADING
  hit.NormalVC = reliefNormal(f, hit, surfaceGradient(hit.MapCoord));
  hit.Fetches += 1;
  hit.TexelReads += 12;
#endif
#if defined(MESO_SELF_SHADOW) || defined(MESO_AOV) || defined(MESO_DIFFERENTIAL)
  hit.FacetNormalVC = reliefNormal(f, hit, surfaceFacet(hit.MapCoord));
#endif
#ifdef MESO_SELF_SHADOW
#ifdef MESO_FILTER
  mesoMetNormalVC = reliefNormal(f, hit, searchedSlope(hit.MapCoord));
#else
  mesoMetNormalVC = hit.FacetNormalVC;
#endif
  hit.Fetches += 1; // the facet's; AOVs alone do not count as cost
  hit.TexelReads += 4;
#endif
  return hit;
}

float blockedFraction(
  MesoFragment f, MesoSurfaceHit hit, vec3 lightOutVC, float lightDistance, out int fetches)
{
  fetches = 0;
#ifdef MESO_SELF_SHADOW
  // The shadow ray starts 1e-3 texel off the surface that the view ray met.
  vec2 texel = vec2(length(f.PerMapU), length(f.PerMapV)) * searchedTexel();
  vec3 travel;
  vec3 lift;
  if (!seenFromBehind(f) && directionInTS(f, lightOutVC, travel) &&
    directionInTS(f, 1.0e-3 * min(texel.x, texel.y) * mesoMetNormalVC, lift))
  {
    float blocked = reliefBlocks(f, hit, travel, lift, lightDistance, fetches);
#ifdef MESO_FILTER
    blocked = 1.0 - (1.0 - blocked) * averagedShare(f, hit.FacetNormalVC, lightOutVC);
#endif
    return blocked;
  }
#endif
  return 0.0; // no relief here: the base's own normal has decided
}
