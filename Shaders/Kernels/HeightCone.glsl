// How far a path through a height map may go on without meeting it: cones free of relief, which end
// flat. The one of a texel and a way of travel (signs of du and dv) has its apex over the patch of
// four texels ahead of the texel that way, no deeper than the patch's highest corner, and widens with
// the sum of the distances along u and v. Within the quarter plane ahead that sum is linear, and a
// height map is bilinear from texel to texel, so relief that stays below the cone at all texel
// centres stays below it everywhere: no cone cuts a patch.
//
// Needs HeightField.glsl
// Needs HeightLevels.glsl
// Needs HeightPath.glsl
//
// Accessor, defined before this file:
//   vec2 fetchCone(ivec2 texel, int travel, int level)  of a texel inside a level of the map's pyramid
//     (HeightLevels, 0 is the map): depth of the apex, and the code c of the steepness: depth drops by
//     c^2 / 2 for each texel of distance
//     travel: TravelLeft + TravelDown, 0 for rightwards and upwards

const int TravelLeft = 1; // du < 0
const int TravelDown = 2; // dv < 0

// A part past all paths' ends.
const float NoPart = 1.0e30;

// A path in texels of a level: at part w it is at Start + w Span, at depth DepthStart + w (Fall - w Sag),
// with texel centres at whole numbers.
struct TexelPath
{
  int Level;
  ivec2 Size; // of the level
  vec2 Start;
  vec2 Span;
  vec2 PerTexel; // part for each texel along an axis, forwards; NoPart where it does not move
  float DepthStart;
  float DepthEnd;
  float Fall;
  float Sag;
  bool Left; // it moves to lower texels
  bool Down;
};

TexelPath texelPath(HeightPath near, int level)
{
  TexelPath path;
  path.Level = level;
  path.Size = levelSize(level);
  vec2 size = vec2(path.Size);
  path.Start = near.MapStart * size - 0.5;
  path.Span = near.MapSpan * size;
  vec2 speed = abs(path.Span);
  path.PerTexel.x = speed.x * NoPart > 1.0 ? 1.0 / speed.x : NoPart;
  path.PerTexel.y = speed.y * NoPart > 1.0 ? 1.0 / speed.y : NoPart;
  path.DepthStart = near.DepthStart;
  path.DepthEnd = near.DepthEnd;
  path.Fall = (near.DepthEnd - near.DepthStart) + near.Sag;
  path.Sag = near.Sag;
  path.Left = path.Span.x < 0.0;
  path.Down = path.Span.y < 0.0;
  return path;
}

float texelPathDepth(TexelPath path, float part)
{
  float bent = path.DepthStart + part * (path.Fall - part * path.Sag);
  return part < 1.0 ? bent : path.DepthEnd;
}

// The smallest t >= 0 with c0 + t (c1 + t c2) = 0, for c0 >= 0: without cancellation. NoPart where
// there is none.
float firstRoot(float c0, float c1, float c2)
{
  float discriminant = c1 * c1 - 4.0 * c0 * c2;
  float sum = abs(c1) + sqrt(max(discriminant, 0.0));
  bool falls = c1 < 0.0;
  // Falling: the nearer of two roots, or the only one. Rising: the one past the crest, if there is
  // a crest.
  float numerator = falls ? 2.0 * c0 : sum;
  float denominator = falls ? sum : -2.0 * c2;
  bool real = discriminant >= 0.0 && denominator > 0.0;
  return real ? numerator / denominator : NoPart;
}

// A patch's texel that stands for it in the map's first period, [0,n-1] (mirror: [0,2n-1]; clamp:
// [-1,n-1]).
int firstPeriod(int i, int n, int mode)
{
  int period = mode == WrapMirror ? 2 * n : n;
  // Exact for all i that a float holds exactly; the clamp keeps the rest inside the map.
  int inPeriod = i - period * int(floor((float(i) + 0.5) / float(period)));
  return mode == WrapClamp ? clamp(i, -1, n - 1) : clamp(inPeriod, 0, period - 1);
}

// A patch of the endless map in the first period.
ivec2 patchInPeriod(TexelPath path, ivec2 cell)
{
  int mode = wrapMode();
  return ivec2(firstPeriod(cell.x, path.Size.x, mode), firstPeriod(cell.y, path.Size.y, mode));
}

// The cone over a patch (its lower left texel, in the first period) along a path.
// x: depth of the apex, y: by how much the cone's depth drops for each texel of distance.
vec2 coneOfPatch(TexelPath path, ivec2 low)
{
  ivec2 size = path.Size;
  int mode = wrapMode();
  ivec2 texel = low;
  texel.x += path.Left ? 1 : 0;
  texel.y += path.Down ? 1 : 0;
  bool isLeft = path.Left;
  bool isDown = path.Down;
  if (mode == WrapMirror) // every second tile is travelled the other way
  {
    isLeft = texel.x >= size.x && texel.x < 2 * size.x ? !isLeft : isLeft;
    isDown = texel.y >= size.y && texel.y < 2 * size.y ? !isDown : isDown;
  }
  texel.x = wrapNearTexel(texel.x, size.x, mode);
  texel.y = wrapNearTexel(texel.y, size.y, mode);
  vec2 cone =
    fetchCone(texel, (isLeft ? TravelLeft : 0) + (isDown ? TravelDown : 0), path.Level);
  return vec2(cone.x, 0.5 * cone.y * cone.y);
}

// What a path sees of a cone from one of its parts on. x: the cone's depth there, y: by how much it
// drops for each part further.
vec2 coneAhead(TexelPath path, ivec2 cell, vec2 cone, float part)
{
  vec2 from = path.Start + part * path.Span - vec2(cell);
  float alongU = path.Left ? 1.0 - from.x : from.x;
  float alongV = path.Down ? 1.0 - from.y : from.y;
  // Beyond a clamped border patches have no end and distances are counted from the border on.
  float away = max(alongU, 0.0) + max(alongV, 0.0);
  return vec2(cone.x - cone.y * away, cone.y * (abs(path.Span.x) + abs(path.Span.y)));
}

// How much further than `part` the path may go without meeting relief, by a cone ahead of it there. 0
// where the path is below it.
float freePart(TexelPath path, vec2 ahead, float part)
{
  float above = ahead.x - texelPathDepth(path, part);
  float slope = path.Fall - 2.0 * part * path.Sag + ahead.y;
  float free = firstRoot(max(above, 0.0), -slope, path.Sag);
  return above > 0.0 ? free : 0.0;
}
