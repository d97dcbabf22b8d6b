// Everything that a kernel may contain, for the step to C++ and for glslangValidator.
//
// Needs AcceptedNeeded.glsl

const float AcceptedHalf = .5;
const float AcceptedThird = 1. / 3.0; /* a comment, with v.xy = 1 in it */
const vec3 AcceptedAxis = vec3(0.0, 1.0e0, 0.);
const bool AcceptedYes = true;

/* A comment over
   several lines: 1f % precise */
vec3 acceptedSwizzle(vec3 v)
{
  vec3 swapped = v.zyx;
  swapped.x += v.xy.y; // one letter may be written
  swapped.yz; // read, to no end
  return swapped + vec3(v.rg, v.stp.p);
}

float acceptedSum(const in float values[3], const float weights[3])
{
  float sum = 0.0;
  for (int i = 0; i < AcceptedCount; ++i)
  {
    sum += values[i] * weights[i];
  }
  return sum;
}

void acceptedFill(out float values[3], inout vec2 last, in int count)
{
  float local[3];
  for (int i = 0; i < 3; i++)
  {
    int whole = i * count + 2 - i / 2;
    local[i] = float(whole);
    values[i] = local[i];
  }
  last.y = values[2];
  last *= 2.0;
}

int acceptedInts(int i, ivec2 size)
{
  int scaled = i * 2 + size.x * 3;
  return max(scaled, 0) - (i < 0 ? 1 : 0) + clamp(size.y, 0, 7);
}

float acceptedFloats(float a, int i)
{
  AcceptedPair pair;
  pair.Low = a;
  pair.High = -1.5e-2;
  acceptedOrder(pair);
  float b = a * 2.0 - float(i) / 3.0;
  float e = 1.0e+2 * b;
  mat3 m = mat3(1.0);
  m[1] = vec3(a, e, pair.Low);
  return dot(m * AcceptedAxis, vec3(AcceptedHalf)) + pair.High + AcceptedThird;
}
