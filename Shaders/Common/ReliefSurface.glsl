// What the relief techniques share around their search: the side that has relief, the start of a
// shadow ray, and normals. Stands on Kernels/Frame and Kernels/LinearBinarySearch.

// A ray that runs further than this many tiles in the relief grazes the surface so flatly that a
// float no longer tells neighbouring texels apart: the base itself is drawn.
const float MESO_MAX_TILES = 1.0e5;

// From behind the base itself is drawn: its normal has been turned to the eye, PerDepth has not.
bool seenFromBehind(MesoFragment f)
{
  return dot(f.PerDepth, f.NormalVC) > 0.0;
}

// The coordinates of a view space direction in the relief: steps over the map and in depth. False
// where there is no relief.
bool directionInTS(MesoFragment f, vec3 directionVC, out vec3 directionTS)
{
  return solveFrame(f.PerMapU, f.PerMapV, f.PerDepth, directionVC, directionTS);
}

// The offset of a shadow ray's start, in the relief's coordinates: 1e-3 texel off the surface along
// the facet's normal.
bool shadowOffset(MesoFragment f, MesoSurfaceHit hit, out vec3 offsetTS)
{
  vec2 texel = vec2(length(f.PerMapU), length(f.PerMapV)) / vec2(mapSize());
  return directionInTS(f, 1.0e-3 * min(texel.x, texel.y) * hit.FacetNormalVC, offsetTS);
}

// The unit normal q_u x q_v whose coordinates count PerMapV x PerDepth, PerDepth x PerMapU and
// PerMapU x PerMapV. The last is taken as the base's own normal times its area, so that a mirrored
// chart, where it points against n, comes out right and a flat map gives n itself, bit for bit.
vec3 normalOfCross(MesoFragment f, vec3 coordinates)
{
  vec3 tilt = coordinates.x * cross(f.PerMapV, f.PerDepth) +
    coordinates.y * cross(f.PerDepth, f.PerMapU);
  float area = dot(cross(f.PerMapU, f.PerMapV), f.NormalVC);
  if (!(abs(area) > 0.0) || tilt == vec3(0.0))
  {
    return f.NormalVC;
  }
  return normalize(coordinates.z * f.NormalVC + tilt / area);
}

// What the search found; hit.RayLength is the caller's.
void takeSearch(HeightHit found, inout MesoSurfaceHit hit)
{
  hit.MapCoord = found.MapCoord;
  hit.Relief = found.Relief;
  hit.Fetches = found.Fetches;
  hit.Iterations = found.Iterations;
}
