// A generalized displacement map without factors: linear between the 32 numbers around a place and
// a direction, by weights of our own, the same on every device.
//
// Needs GDMTable.glsl
//
// Accessors, defined before this file:
//   float fetchGDM(ivec3 point, ivec2 direction)  a number of the table; tile widths

int gdmWrap(int i, int count)
{
  int rest = i - (i / count) * count;
  return rest < 0 ? rest + count : rest;
}

// Over x and y, which repeat, at a level and in a direction. `low` is not wrapped.
float gdmOverTile(ivec2 low, vec2 weight, int level, ivec2 direction)
{
  ivec3 size = gdmSize();
  int x0 = gdmWrap(low.x, size.x);
  int x1 = gdmWrap(low.x + 1, size.x);
  int y0 = gdmWrap(low.y, size.y);
  int y1 = gdmWrap(low.y + 1, size.y);
  return mix(
    mix(fetchGDM(ivec3(x0, y0, level), direction), fetchGDM(ivec3(x1, y0, level), direction),
      weight.x),
    mix(fetchGDM(ivec3(x0, y1, level), direction), fetchGDM(ivec3(x1, y1, level), direction),
      weight.x),
    weight.y);
}

// Over x, y and z in a direction.
float gdmOverVolume(GDMPlace place, ivec2 direction)
{
  ivec3 size = gdmSize();
  vec2 point = place.Tile * vec2(float(size.x), float(size.y)) - 0.5;
  vec2 corner = floor(point);
  float level = min(floor(place.Level), float(size.z - 2));
  return mix(gdmOverTile(ivec2(corner), point - corner, int(level), direction),
    gdmOverTile(ivec2(corner), point - corner, int(level) + 1, direction), place.Level - level);
}

// As GDMFactors' function of that name.
float gdmDistance(vec3 position, vec3 direction)
{
  GDMPlace place = gdmPlace(position, direction);
  ivec2 count = gdmDirections();
  float azimuth = floor(place.Azimuth);
  float polar = min(floor(place.Polar), float(count.y - 2));
  int a0 = int(azimuth);
  int a1 = gdmWrap(a0 + 1, count.x);
  int p0 = int(polar);
  float weight = place.Azimuth - azimuth;
  return mix(mix(gdmOverVolume(place, ivec2(a0, p0)), gdmOverVolume(place, ivec2(a1, p0)), weight),
    mix(gdmOverVolume(place, ivec2(a0, p0 + 1)), gdmOverVolume(place, ivec2(a1, p0 + 1)), weight),
    place.Polar - polar);
}
