// Where a ray is in the table of a generalized displacement map: Wang2004, sections 3.1 and 4.1.
//
// Texture space: x, y in tiles, z in [0, 1] through the shell. Directions are in (x, y, F z), tile widths,
// of any length but 0. Points of the table lie at ((i + 0.5) / W, (j + 0.5) / H, k / (D - 1)); phi runs
// from +x towards +y, theta from +z, both ends included, in equal steps of it or of its cosine.
//
// Accessors, defined before this file:
//   ivec3 gdmSize()        W, H, D; D at least 2
//   ivec2 gdmDirections()  azimuths (at least 1) and polars (at least 2)
//   bool gdmEven()         equal steps of cos(theta)

const float GDMHalfTurn = 3.14159265358979;

struct GDMPlace
{
  vec2 Tile;     // x, y as they are given
  float Level;   // of z, [0, D - 1]
  float Azimuth; // of phi, [0, azimuths): the last is followed by the first
  float Polar;   // of theta, [0, polars - 1]
};

float gdmLevel(float z)
{
  return clamp(z, 0.0, 1.0) * float(gdmSize().z - 1);
}

float gdmAzimuth(vec3 direction)
{
  int count = gdmDirections().x;
  if (direction.x == 0.0 && direction.y == 0.0)
  {
    return 0.0; // at the poles all are the same
  }
  float turns = 0.5 * atan(direction.y, direction.x) / GDMHalfTurn;
  float place = (turns - floor(turns)) * float(count);
  return place < float(count) ? place : 0.0; // one just before 0 may be rounded to count
}

float gdmPolar(vec3 direction)
{
  float last = float(gdmDirections().y - 1);
  float part = 0.0;
  if (gdmEven())
  {
    part = 0.5 - 0.5 * direction.z / length(direction);
  }
  else
  {
    part = atan(length(vec2(direction.x, direction.y)), direction.z) / GDMHalfTurn;
  }
  return clamp(part * last, 0.0, last);
}

GDMPlace gdmPlace(vec3 position, vec3 direction)
{
  GDMPlace place;
  place.Tile = vec2(position.x, position.y);
  place.Level = gdmLevel(position.z);
  place.Azimuth = gdmAzimuth(direction);
  place.Polar = gdmPolar(direction);
  return place;
}
