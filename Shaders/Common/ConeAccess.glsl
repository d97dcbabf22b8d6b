// The only functions that know the textures of cones and of levels of the height map; the kernels
// HeightLevels and HeightCone stand on them. Of the four ways of travel the leftwards lie in the right half of a
// level's part of the texture, the downwards in a texel's last two channels. The map's part comes first;
// above it those of the levels side by side.
//   MESO_CONE_LEVELS  searches look for levels of the map's pyramid where texels are smaller than pixels
uniform sampler2D mesoCones;

vec2 coneOfTexel(ivec2 place, int travel)
{
  vec4 cones = texelFetch(mesoCones, place, 0);
  return travel < 2 ? cones.rg : cones.ba;
}

#ifdef MESO_CONE_LEVELS
uniform sampler2D mesoHeightLevels;

int surfaceLevel()
{
  return mesoSearchedLevel;
}

ivec2 levelSize(int level)
{
  return mapSize() >> level;
}

// Where a level's part begins in a texture in which the map's is of some size.
ivec2 cornerOfLevel(ivec2 size, int level)
{
  return level == 0 ? ivec2(0) : ivec2(size.x - ((2 * size.x) >> level), size.y);
}

float fetchLevel(ivec2 texel, int level)
{
  return texelFetch(mesoHeightLevels, texel + cornerOfLevel(mapSize(), level), 0).r;
}

vec2 fetchCone(ivec2 texel, int travel, int level)
{
  ivec2 size = mapSize();
  ivec2 corner = cornerOfLevel(ivec2(2 * size.x, size.y), level);
  corner.x += (travel - travel / 2 * 2) * (size.x >> level);
  return coneOfTexel(texel + corner, travel);
}
#else
int surfaceLevel()
{
  return 0;
}

ivec2 levelSize(int level)
{
  return mapSize();
}

float fetchLevel(ivec2 texel, int level)
{
  return fetchHeight(texel);
}

vec2 fetchCone(ivec2 texel, int travel, int level)
{
  return coneOfTexel(ivec2(texel.x + (travel - travel / 2 * 2) * mapSize().x, texel.y), travel);
}
#endif
