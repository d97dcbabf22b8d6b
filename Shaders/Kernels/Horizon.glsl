// Horizon mapping: Max1988 (Documentation/Techniques/References.md). A table holds, for a number of
// azimuths over the map that are evenly spaced from (1, 0) towards (0, 1), the angle above the base at
// which the relief around each point begins.

const float HorizonTurn = 6.28318531; // 2 pi
const float HorizonHalfTurn = 3.14159265;

// The azimuth of a table of `count` at or before a direction over the map; weight: of the one after it,
// [0,1). The last is followed by the first.
int azimuthBefore(vec2 direction, int count, out float weight)
{
  float turns = atan(direction.y, direction.x) / HorizonTurn;
  float place = (turns - floor(turns)) * float(count);
  float before = floor(place);
  weight = place - before;
  int azimuth = int(before);
  return azimuth < count ? azimuth : 0; // a place just before 0 may be rounded to count
}

int azimuthAfter(int azimuth, int count)
{
  return azimuth + 1 < count ? azimuth + 1 : 0;
}

// The part of a light's disc that lies below a straight horizon: elevations of the disc's centre and of the
// horizon, and the disc's diameter, all in radians.
float discBelow(float light, float horizon, float diameter)
{
  float above = light - horizon;
  if (2.0 * abs(above) >= diameter)
  {
    return above > 0.0 ? 0.0 : 1.0;
  }
  float s = 2.0 * above / diameter;
  return 0.5 - (asin(s) + s * sqrt(1.0 - s * s)) / HorizonHalfTurn;
}
