// How far a cubic path through a height map may go on without meeting it, by cones of free space (ConeTexel).
// In place of HeightCone.
//
// From a part on depth and distance are no greater than the parabola with the same value and rate and the
// greatest second derivative of what is left, which is that of one of its ends: a cubic's is linear.
// Distance is |du| + |dv|, and the cone holds within a quarter plane, so that the path's rates along u and v must
// keep their signs: where the control values of a rate, a quadratic, have one sign, so has it.
//
// Needs HeightField.glsl
// Needs HeightLevels.glsl
// Needs CubicPath.glsl
// Needs ConeTexel.glsl

// A path in texels of a level, centres at whole numbers: at s of its way it is at
// Map0 + s (Map1 + s (Map2 + s Map3)), and its depth likewise.
struct TexelPath
{
  int Level;
  ivec2 Size;
  vec2 Window; // the part of the way where the path starts, and how much of it it is
  vec2 Map0;
  vec2 Map1;
  vec2 Map2;
  vec2 Map3;
  float Depth0;
  float Depth1;
  float Depth2;
  float Depth3;
};

TexelPath texelPath(HeightPath near, int level)
{
  TexelPath path;
  path.Level = level;
  path.Size = levelSize(level);
  path.Window = near.Window;
  vec2 size = vec2(path.Size);
  path.Map0 = near.MapStart * size - 0.5;
  path.Map1 = (near.MapSpan + near.MapSag) * size;
  path.Map2 = (near.MapTwist - near.MapSag) * size;
  path.Map3 = -near.MapTwist * size;
  path.Depth0 = near.Depth0;
  path.Depth1 = near.DepthSpan + near.DepthSag;
  path.Depth2 = near.DepthTwist - near.DepthSag;
  path.Depth3 = -near.DepthTwist;
  return path;
}

// How much further than `part` the path may go without meeting relief. 0 where the path is below the cone,
// or turns.
float freePartAt(TexelPath path, float part)
{
  float at = path.Window.x + part * path.Window.y;
  float end = path.Window.x + path.Window.y;
  vec2 point = path.Map0 + at * (path.Map1 + at * (path.Map2 + at * path.Map3));
  vec2 rate = path.Map1 + at * (2.0 * path.Map2 + 3.0 * at * path.Map3);
  vec2 rateEnd = path.Map1 + end * (2.0 * path.Map2 + 3.0 * end * path.Map3);
  vec2 bend = 2.0 * path.Map2 + 6.0 * at * path.Map3;
  vec2 bendEnd = 2.0 * path.Map2 + 6.0 * end * path.Map3;
  vec2 rateBetween = rate + 0.5 * (end - at) * bend;
  bool left = rate.x + rateBetween.x + rateEnd.x < 0.0;
  bool down = rate.y + rateBetween.y + rateEnd.y < 0.0;
  vec2 way = vec2(left ? -1.0 : 1.0, down ? -1.0 : 1.0);
  vec2 slowest = min(min(way * rate, way * rateBetween), way * rateEnd);
  ivec2 cell = patchOfTexels(point, path.Size);
  vec2 cone = coneOfCell(cell, path.Size, path.Level, left, down);
  float depth = path.Depth0 + at * (path.Depth1 + at * (path.Depth2 + at * path.Depth3));
  float fall = path.Depth1 + at * (2.0 * path.Depth2 + 3.0 * at * path.Depth3);
  float fallBend = 2.0 * path.Depth2 + 6.0 * max(at * path.Depth3, end * path.Depth3);
  float above = cone.x - cone.y * distanceInCell(point, cell, left, down) - depth;
  float slope = fall + cone.y * dot(way, rate);
  float sag = 0.5 * (fallBend + cone.y * max(dot(way, bend), dot(way, bendEnd)));
  float free = firstRoot(max(above, 0.0), -slope, -sag);
  bool ahead = slowest.x >= 0.0 && slowest.y >= 0.0;
  return above > 0.0 && ahead ? free / path.Window.y : 0.0;
}
