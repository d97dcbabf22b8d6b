// The only functions that know the height map's sampler; the kernels stand on these.
//   MESO_WRAP  0 repeat, 1 clamp, 2 mirror
uniform sampler2D mesoHeightMap;

float fetchHeight(ivec2 texel)
{
  return texelFetch(mesoHeightMap, texel, 0).r;
}

float sampleHeight(vec2 uv)
{
  return textureLod(mesoHeightMap, uv, 0.0).r;
}

// Of a level of the pyramid, where the technique has one.
float filteredHeight(vec2 uv, float level)
{
  return textureLod(mesoHeightMap, uv, level).r;
}

ivec2 mapSize()
{
  return textureSize(mesoHeightMap, 0);
}

int wrapMode()
{
  return MESO_WRAP;
}
