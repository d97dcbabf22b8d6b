// A height map's pyramid between its texels. Level 0 is the map; each level has half the texels of the
// one before along u and v, rounded down, and a texel is the mean of what it covers. A level is bilinear
// between its own texel centres.
//
// Needs HeightField.glsl
//
// Accessors, defined before this file:
//   float fetchLevel(ivec2 texel, int level)  height of a texel inside a level
//   ivec2 levelSize(int level)                its width and height in texels, at least 1
//   int surfaceLevel()                        the level that searches look for, 0 to the last

// Height of a near texel of a level, see wrapNearTexel.
float nearHeightOfLevel(int column, int row, int level)
{
  ivec2 size = levelSize(level);
  int mode = wrapMode();
  return fetchLevel(
    ivec2(wrapNearTexel(column, size.x, mode), wrapNearTexel(row, size.y, mode)), level);
}

// As bilinearHeight.
float heightOfLevel(vec2 uv, int level)
{
  ivec2 low;
  vec2 weight = patchOfSize(uv, levelSize(level), low);
  float height00 = nearHeightOfLevel(low.x, low.y, level);
  float height10 = nearHeightOfLevel(low.x + 1, low.y, level);
  float height01 = nearHeightOfLevel(low.x, low.y + 1, level);
  float height11 = nearHeightOfLevel(low.x + 1, low.y + 1, level);
  float below = height00 + weight.x * (height10 - height00);
  float above = height01 + weight.x * (height11 - height01);
  return below + weight.y * (above - below);
}
