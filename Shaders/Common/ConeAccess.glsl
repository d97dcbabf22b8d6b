// The only functions that know the textures of cones and of levels of the height map; the kernels
// HeightLevels and HeightCone stand on them. The four ways of travel lie in the quarters of a texture, or of a
// level's part of it: leftwards in the right half, downwards in the upper. Levels above the map lie side by
// side.
//   MESO_CONE_LEVELS  searches look for levels of the map's pyramid where texels are smaller than pixels
uniform sampler2D mesoCones;

ivec2 quarterOf(int travel)
{
  return ivec2(travel - travel / 2 * 2, travel / 2);
}

#ifdef MESO_CONE_LEVELS
uniform sampler2D mesoHeightLevels;
uniform sampler2D mesoConeLevels;
uniform int mesoLastLevel;

float surfaceLevel()
{
  return mesoLevel;
}

ivec2 levelSize(int level)
{
  return mapSize() >> level;
}

// Both textures are read, the other one at its corner: a choice is no branch on some devices.
float fetchLevel(ivec2 texel, int level)
{
  bool isMap = level == 0;
  int width = mapSize().x;
  ivec2 place = ivec2(texel.x + width - ((2 * width) >> level), texel.y);
  float ofMap = fetchHeight(isMap ? texel : ivec2(0));
  float ofLevel = texelFetch(mesoHeightLevels, isMap ? ivec2(0) : place, 0).r;
  return isMap ? ofMap : ofLevel;
}

vec2 fetchCone(ivec2 texel, int travel, int level)
{
  bool isMap = level == 0;
  ivec2 size = mapSize();
  ivec2 place = texel + quarterOf(travel) * (size >> level);
  ivec2 beside = ivec2(place.x + 2 * size.x - ((4 * size.x) >> level), place.y);
  vec2 ofMap = texelFetch(mesoCones, isMap ? place : ivec2(0), 0).rg;
  vec2 ofLevel = texelFetch(mesoConeLevels, isMap ? ivec2(0) : beside, 0).rg;
  return isMap ? ofMap : ofLevel;
}
#else
float surfaceLevel()
{
  return 0.0;
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
  return texelFetch(mesoCones, texel + quarterOf(travel) * mapSize(), 0).rg;
}
#endif
