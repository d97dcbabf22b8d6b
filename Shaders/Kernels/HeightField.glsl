// A height map between its texels. Truth is bilinear between texel centres, which lie at
// (i + 0.5) / size. Heights are in [0,1]; a map coordinate counts tiles.
//
// Accessors, defined before this file:
//   float fetchHeight(ivec2 texel)  height of a texel inside the map
//   float sampleHeight(vec2 uv)     filtered height, level 0, wrapped; as exact as the sampler is
//   ivec2 mapSize()                 width and height in texels, at least 1
//   int wrapMode()                  one of the three below

const int WrapRepeat = 0;
const int WrapClamp = 1;
const int WrapMirror = 2;

// The texel of [0,n-1] that stands for texel i, any int. Mirrored as GL's MIRRORED_REPEAT. Integer
// division of non-negative numbers only: GLSL leaves the rest open.
int wrapTexel(int i, int n, int mode)
{
  if (mode == WrapClamp)
  {
    return clamp(i, 0, n - 1);
  }
  int fromEdge = i < 0 ? -1 - i : i; // texels from the edge at 0, on either side of it
  int period = fromEdge / n;
  int inPeriod = fromEdge - period * n;
  bool backwards = i < 0;
  if (mode == WrapMirror)
  {
    backwards = period - period / 2 * 2 == 1; // the sides of 0 mirror each other
  }
  return backwards ? n - 1 - inPeriod : inPeriod;
}

// wrapTexel where i is at most 2 outside of [0,n-1] (mirror: of [0,2n-1]), without division, which
// costs more than the texel's fetch on some devices. Always inside the map, whatever i.
int wrapNearTexel(int i, int n, int mode)
{
  int wrapped = i;
  if (mode == WrapRepeat)
  {
    wrapped = i < 0 ? i + n : (i >= n ? i - n : i);
  }
  else if (mode == WrapMirror)
  {
    int fromEdge = i < 0 ? -1 - i : i;
    int mirrored = fromEdge >= n ? n - 1 - (fromEdge - n) : fromEdge;
    wrapped = mirrored < 0 ? -1 - mirrored : mirrored;
  }
  return clamp(wrapped, 0, n - 1);
}

// Height of a near texel, see wrapNearTexel.
float nearHeight(int column, int row)
{
  ivec2 size = mapSize();
  int mode = wrapMode();
  return fetchHeight(
    ivec2(wrapNearTexel(column, size.x, mode), wrapNearTexel(row, size.y, mode)));
}

// Whole tiles that may be taken off a map coordinate without changing what is seen there (an even
// number for mirror, none for clamp). Taken off first, they cost no precision later.
vec2 wholeTiles(vec2 uv)
{
  int mode = wrapMode();
  vec2 tiles = vec2(0.0);
  if (mode == WrapRepeat)
  {
    tiles = floor(uv);
  }
  else if (mode == WrapMirror)
  {
    tiles = 2.0 * floor(0.5 * uv);
  }
  return tiles;
}

// The patch of four texel centres around a map coordinate in a map of some size. low: its lower left
// texel, not wrapped, in [-1,n-1] (mirror: [-1,2n-1]). Result: where uv lies in the patch, [0,1]. NaN
// counts as 0.
vec2 patchOfSize(vec2 uv, ivec2 size, out ivec2 low)
{
  vec2 inTile = uv - wholeTiles(uv);
  if (wrapMode() == WrapClamp)
  {
    inTile = clamp(inTile, 0.0, 1.0);
  }
  inTile.x = inTile.x >= 0.0 ? inTile.x : 0.0; // NaN compares false
  inTile.y = inTile.y >= 0.0 ? inTile.y : 0.0;
  vec2 texel = inTile * vec2(size) - 0.5;
  vec2 corner = floor(texel);
  low = ivec2(corner);
  return texel - corner;
}

// The same in the height map itself.
vec2 patchAt(vec2 uv, out ivec2 low)
{
  return patchOfSize(uv, mapSize(), low);
}

// Height by weights of our own, the same on every device: samplers may have 8-bit weights. Written
// as a + w * (b - a), which gives a constant map's height and a texel's own height exactly.
float bilinearHeight(vec2 uv)
{
  ivec2 low;
  vec2 weight = patchAt(uv, low);
  float height00 = nearHeight(low.x, low.y);
  float height10 = nearHeight(low.x + 1, low.y);
  float height01 = nearHeight(low.x, low.y + 1);
  float height11 = nearHeight(low.x + 1, low.y + 1);
  float below = height00 + weight.x * (height10 - height00);
  float above = height01 + weight.x * (height11 - height01);
  return below + weight.y * (above - below);
}

// (dh/du, dh/dv), height per map coordinate, of the shading normal: central differences over one
// texel at the texel centres, interpolated bilinearly. 12 texels.
vec2 heightGradient(vec2 uv)
{
  ivec2 low;
  vec2 weight = patchAt(uv, low);
  int column = low.x;
  int row = low.y;
  float height00 = nearHeight(column, row);
  float height10 = nearHeight(column + 1, row);
  float height01 = nearHeight(column, row + 1);
  float height11 = nearHeight(column + 1, row + 1);
  // Twice the change over one texel, at the four centres: along u, then along v.
  float alongU00 = height10 - nearHeight(column - 1, row);
  float alongU10 = nearHeight(column + 2, row) - height00;
  float alongU01 = height11 - nearHeight(column - 1, row + 1);
  float alongU11 = nearHeight(column + 2, row + 1) - height01;
  float alongV00 = height01 - nearHeight(column, row - 1);
  float alongV10 = height11 - nearHeight(column + 1, row - 1);
  float alongV01 = nearHeight(column, row + 2) - height00;
  float alongV11 = nearHeight(column + 1, row + 2) - height10;
  vec2 below = mix(vec2(alongU00, alongV00), vec2(alongU10, alongV10), weight.x);
  vec2 above = mix(vec2(alongU01, alongV01), vec2(alongU11, alongV11), weight.x);
  return 0.5 * mix(below, above, weight.y) * vec2(mapSize());
}

// (dh/du, dh/dv), height per map coordinate, of the bilinear patch itself: the geometric normal's,
// discontinuous from texel to texel. 4 texels.
vec2 patchGradient(vec2 uv)
{
  ivec2 low;
  vec2 weight = patchAt(uv, low);
  float height00 = nearHeight(low.x, low.y);
  float height10 = nearHeight(low.x + 1, low.y);
  float height01 = nearHeight(low.x, low.y + 1);
  float height11 = nearHeight(low.x + 1, low.y + 1);
  vec2 below = vec2(height10 - height00, height01 - height00);
  vec2 above = vec2(height11 - height01, height11 - height10);
  return vec2(mix(below.x, above.x, weight.y), mix(below.y, above.y, weight.x)) * vec2(mapSize());
}
