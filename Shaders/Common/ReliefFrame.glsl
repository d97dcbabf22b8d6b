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

// The unit normal whose coordinates count PerMapV x PerDepth, PerDepth x PerMapU and
// PerMapU x PerMapV.
vec3 normalOfCross(MesoFragment f, vec3 coordinates)
{
  return tiltedNormal(f.PerMapU, f.PerMapV, f.PerDepth, f.NormalVC, coordinates);
}
