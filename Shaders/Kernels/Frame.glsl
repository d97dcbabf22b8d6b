// Coordinates of a vector in a frame whose axes need be neither unit nor orthogonal. View and light
// go to texture space this way, not by dot products, so that sheared and mirrored charts are right.

// Axes that span less than this volume, once each has length 1, are taken as degenerate. A solution
// splits r into three shares, x.x * a and so on; the length of each is off by at most 4 float
// epsilons of their summed lengths / volume, half a percent at this bound.
const float FrameLeastVolume = 1.0e-4;

// Axes outside these sizes are refused: their quotients could overflow a float.
const float FrameLeastSize = 1.0e-15;
const float FrameGreatestSize = 1.0e15;

// A right-hand side below this is 0: dividing by it could overflow a float.
const float FrameLeastVector = 1.0e-30;

// Sum of the components' amounts: scales a vector without under- or overflow, and unlike a maximum
// is NaN wherever a component is.
float frameSize(vec3 v)
{
  return abs(v.x) + abs(v.y) + abs(v.z);
}

// False for 0, Inf, NaN and what is too small or too great.
bool frameSizeIsSound(float size)
{
  return size >= FrameLeastSize && size <= FrameGreatestSize;
}

// Cramer's rule: x with x.x * a + x.y * b + x.z * c = r. All in one space, any unit; x is r's unit
// over the axes'. The axes are normalised first, so the test for degeneracy and the error depend on
// their directions alone: lengths may differ by any ratio. False, with x = 0, where an axis has no
// length, the axes lie in a plane, or an argument is not finite.
bool solveFrame(vec3 a, vec3 b, vec3 c, vec3 r, out vec3 x)
{
  x = vec3(0.0);
  float sizeA = frameSize(a);
  float sizeB = frameSize(b);
  float sizeC = frameSize(c);
  float sizeR = frameSize(r);
  if (!frameSizeIsSound(sizeA) || !frameSizeIsSound(sizeB) || !frameSizeIsSound(sizeC) ||
    !(sizeR <= FrameGreatestSize))
  {
    return false;
  }
  vec3 unitA = a / sizeA;
  vec3 unitB = b / sizeB;
  vec3 unitC = c / sizeC;
  float lengthA = length(unitA);
  float lengthB = length(unitB);
  float lengthC = length(unitC);
  unitA = unitA / lengthA;
  unitB = unitB / lengthB;
  unitC = unitC / lengthC;
  vec3 crossBC = cross(unitB, unitC);
  float volume = dot(unitA, crossBC);
  if (!(abs(volume) >= FrameLeastVolume))
  {
    return false;
  }
  if (sizeR < FrameLeastVector)
  {
    return true;
  }
  vec3 unitR = r / sizeR;
  x.x = dot(unitR, crossBC) / volume * (sizeR / sizeA) / lengthA;
  x.y = dot(unitR, cross(unitC, unitA)) / volume * (sizeR / sizeB) / lengthB;
  x.z = dot(unitR, cross(unitA, unitB)) / volume * (sizeR / sizeC) / lengthC;
  return true;
}

// The unit normal q_u x q_v of a surface over a frame of dp/du, dp/dv and the way of depth, whose
// coordinates count perV x perDepth, perDepth x perU and perU x perV: (dh/du, dh/dv, 1) for heights h
// where depth runs by 1 - h. The last is taken as the base's own unit normal times the frame's area, so
// that a mirrored chart, where it points against the normal, comes out right and a flat map gives the
// normal itself, bit for bit.
vec3 tiltedNormal(vec3 perU, vec3 perV, vec3 perDepth, vec3 normal, vec3 coordinates)
{
  vec3 tilt = coordinates.x * cross(perV, perDepth) + coordinates.y * cross(perDepth, perU);
  float area = dot(cross(perU, perV), normal);
  if (!(abs(area) > 0.0) || tilt == vec3(0.0))
  {
    return normal;
  }
  return normalize(coordinates.z * normal + tilt / area);
}
