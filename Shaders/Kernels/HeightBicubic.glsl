// A height map's surface in close-ups: the uniform cubic B-spline whose control points are the texels.
// It has no edges, its second derivatives are continuous, and it never leaves the range of the 4 x 4
// texels around, so that the shell of the relief still bounds it; the price is that it is smoother than
// the texels: a ripple of period p texels keeps (2 + cos(2 pi / p)) / 3 of its height. (Splines through
// the texels leave their range at every step.) One of two: HeightBilinear has the same names.
//
// Needs HeightField.glsl

// A row of four control points a, b, c, d at f of [0,1] between b and c is
// a + x (b - a) + y (c - b) + z (d - c): sums of the basis from each point on. Constants stay exact.
vec3 splineParts(float f)
{
  float left = 1.0 - f;
  vec3 parts;
  parts.x = 1.0 - left * left * left / 6.0;
  parts.y = (1.0 + f * (3.0 + f * (3.0 - 2.0 * f))) / 6.0;
  parts.z = f * f * f / 6.0;
  return parts;
}

// Their derivatives.
vec3 splineSlopes(float f)
{
  float left = 1.0 - f;
  vec3 slopes;
  slopes.x = 0.5 * left * left;
  slopes.y = 0.5 + f * (1.0 - f);
  slopes.z = 0.5 * f * f;
  return slopes;
}

// Four texels of a row from a column on, as the first and the steps from each to the next.
vec4 rowSteps(int column, int row)
{
  float a = nearHeight(column, row);
  float b = nearHeight(column + 1, row);
  float c = nearHeight(column + 2, row);
  float d = nearHeight(column + 3, row);
  return vec4(a, b - a, c - b, d - c);
}

float mapHeight(vec2 uv)
{
  ivec2 low;
  vec2 weight = patchAt(uv, low);
  vec4 along = vec4(1.0, splineParts(weight.x));
  vec3 across = splineParts(weight.y);
  float row0 = dot(along, rowSteps(low.x - 1, low.y - 1));
  float row1 = dot(along, rowSteps(low.x - 1, low.y));
  float row2 = dot(along, rowSteps(low.x - 1, low.y + 1));
  float row3 = dot(along, rowSteps(low.x - 1, low.y + 2));
  float height =
    row0 + (across.x * (row1 - row0) + across.y * (row2 - row1) + across.z * (row3 - row2));
  return clamp(height, 0.0, 1.0); // rounding alone leaves the range
}

// (dh/du, dh/dv), height per map coordinate: of the surface itself, and of the shading normal as well.
vec2 mapFacet(vec2 uv)
{
  ivec2 low;
  vec2 weight = patchAt(uv, low);
  vec4 along = vec4(1.0, splineParts(weight.x));
  vec4 slopes = vec4(0.0, splineSlopes(weight.x));
  vec3 across = splineParts(weight.y);
  vec3 up = splineSlopes(weight.y);
  vec4 steps0 = rowSteps(low.x - 1, low.y - 1);
  vec4 steps1 = rowSteps(low.x - 1, low.y);
  vec4 steps2 = rowSteps(low.x - 1, low.y + 1);
  vec4 steps3 = rowSteps(low.x - 1, low.y + 2);
  vec2 gradient;
  gradient.x = dot(slopes,
    steps0 + across.x * (steps1 - steps0) + across.y * (steps2 - steps1) +
      across.z * (steps3 - steps2));
  gradient.y = dot(along,
    up.x * (steps1 - steps0) + up.y * (steps2 - steps1) + up.z * (steps3 - steps2));
  if (wrapMode() == WrapClamp) // beyond its border the map is level
  {
    gradient.x = uv.x < 0.0 || uv.x > 1.0 ? 0.0 : gradient.x;
    gradient.y = uv.y < 0.0 || uv.y > 1.0 ? 0.0 : gradient.y;
  }
  return gradient * vec2(mapSize());
}

vec2 mapGradient(vec2 uv)
{
  return mapFacet(uv);
}
