// The only functions that know the height map's sampler; the kernels stand on these.
//   MESO_WRAP     0 repeat, 1 clamp, 2 mirror
//   MESO_FILTER   where texels are smaller than pixels, a level of the map's pyramid is read
//   MESO_BICUBIC  heights between texels are those of Kernels/HeightBicubic
uniform sampler2D mesoHeightMap;

#ifdef MESO_FILTER
int mesoSearchedLevel = 0;   // of the pyramid, whose heights rays meet; 0 is the map itself
float mesoShadedLevel = 0.0; // and whose slopes are shaded, between two or one of them
#endif

// What searches look for: Common/HeightSurface.
float surfaceHeight(vec2 uv);

float fetchHeight(ivec2 texel)
{
  return texelFetch(mesoHeightMap, texel, 0).r;
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

#ifdef MESO_BICUBIC
// The cubic B-spline of the texels in four samples, each between two texels of a row and two rows: the
// spline's weights in pairs.
float splineSample(vec2 uv)
{
  vec2 size = vec2(mapSize());
  vec2 texel = uv * size - 0.5;
  vec2 corner = floor(texel);
  vec2 f = texel - corner;
  vec2 left = 1.0 - f;
  vec2 first = left * left * left / 6.0;
  vec2 last = f * f * f / 6.0;
  vec2 high = (1.0 + f * (3.0 + f * (3.0 - 2.0 * f))) / 6.0; // weight of the upper pair
  vec2 low = 1.0 - high;
  vec2 lowUV = (corner + 0.5 - first / low) / size;
  vec2 highUV = (corner + 1.5 + last / high) / size;
  float below = low.x * textureLod(mesoHeightMap, lowUV, 0.0).r +
    high.x * textureLod(mesoHeightMap, vec2(highUV.x, lowUV.y), 0.0).r;
  float above = low.x * textureLod(mesoHeightMap, vec2(lowUV.x, highUV.y), 0.0).r +
    high.x * textureLod(mesoHeightMap, highUV, 0.0).r;
  return low.y * below + high.y * above;
}
#endif

// As exact as the sampler is.
float sampleHeight(vec2 uv)
{
#if defined(MESO_BICUBIC) && defined(MESO_FILTER)
  return mesoSearchedLevel > 0 ? filteredHeight(uv, float(mesoSearchedLevel)) : splineSample(uv);
#elif defined(MESO_BICUBIC)
  return splineSample(uv);
#elif defined(MESO_FILTER)
  return filteredHeight(uv, float(mesoSearchedLevel));
#else
  return filteredHeight(uv, 0.0);
#endif
}
