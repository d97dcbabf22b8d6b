// Levels of a height map's pyramid: what is read where texels are smaller than pixels. Stands on
// Common/HeightAccess.

// (dh/du, dh/dv) of a level: central differences over one of its texels.
vec2 gradientOfLevel(vec2 uv, float level)
{
  vec2 texel = exp2(level) / vec2(mapSize());
  vec2 alongU = vec2(texel.x, 0.0);
  vec2 alongV = vec2(0.0, texel.y);
  return 0.5 *
    vec2(filteredHeight(uv + alongU, level) - filteredHeight(uv - alongU, level),
      filteredHeight(uv + alongV, level) - filteredHeight(uv - alongV, level)) /
    texel;
}
