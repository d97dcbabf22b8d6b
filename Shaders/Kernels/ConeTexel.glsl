// Cones free of relief over a height map, which end flat. The one of a texel and a way of travel (signs of du
// and dv) has its apex over the patch of four texels ahead of the texel that way, no deeper than the patch's
// highest corner, and widens with the sum of the distances along u and v. Within the quarter plane ahead
// that sum is linear, and a height map is bilinear from texel to texel, so relief that stays below the cone
// at all texel centres stays below it everywhere: no cone cuts a patch.
//
// Needs HeightField.glsl
// Needs HeightLevels.glsl
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

// The cone over a patch of a level (its lower left texel, not wrapped) for a way of travel.
// x: depth of the apex, y: by how much the cone's depth drops for each texel of distance from the
// patch's corner behind.
vec2 coneOfCell(ivec2 cell, ivec2 size, int level, bool left, bool down)
{
  int mode = wrapMode();
  ivec2 texel;
  texel.x = firstPeriod(cell.x, size.x, mode) + (left ? 1 : 0);
  texel.y = firstPeriod(cell.y, size.y, mode) + (down ? 1 : 0);
  bool isLeft = left;
  bool isDown = down;
  if (mode == WrapMirror) // every second tile is travelled the other way
  {
    isLeft = texel.x >= size.x && texel.x < 2 * size.x ? !left : left;
    isDown = texel.y >= size.y && texel.y < 2 * size.y ? !down : down;
  }
  texel.x = wrapNearTexel(texel.x, size.x, mode);
  texel.y = wrapNearTexel(texel.y, size.y, mode);
  vec2 cone = fetchCone(texel, (isLeft ? TravelLeft : 0) + (isDown ? TravelDown : 0), level);
  return vec2(cone.x, 0.5 * cone.y * cone.y);
}

// The patch of a point in a level's texels, its lower left texel.
ivec2 patchOfTexels(vec2 point, ivec2 size)
{
  vec2 low = clamp(floor(point), -1.0e9, 1.0e9);
  if (wrapMode() == WrapClamp)
  {
    low = clamp(low, vec2(-1.0), vec2(size - 1));
  }
  return ivec2(low);
}

// How far a point lies from the corner behind of the patch that it is over: |du| + |dv|. Beyond a clamped
// border patches have no end and distances are counted from the border on.
float distanceInCell(vec2 point, ivec2 cell, bool left, bool down)
{
  vec2 from = point - vec2(cell);
  return max(left ? 1.0 - from.x : from.x, 0.0) + max(down ? 1.0 - from.y : from.y, 0.0);
}
