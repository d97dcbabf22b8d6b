// A fragment's relief as a frame: directions into it, and normals out of it. Stands on Kernels/Frame.

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
