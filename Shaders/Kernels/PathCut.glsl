// Where a path through a height map is outside of it, for rays whose first stretch is cut away.
//
// Needs HeightField.glsl
// Needs HeightPath.glsl
// Needs HeightHit.glsl

// The first part of a path, from one of its parts on, where it is above the relief: `from` itself, or
// the first of equal steps after it, `steps` for a whole path. 1.0 where it stays inside to its end.
// Inside is behind the surface, which is seen from outside only. fetches: filtered samples.
float partOutside(HeightPath path, float from, int steps, out int fetches)
{
  fetches = 1;
  if (exactClearance(path, from) > 0.0)
  {
    return from;
  }
  float stepPart = 1.0 / float(max(steps, 1));
  for (int i = 1; i <= steps; ++i)
  {
    float part = from + float(i) * stepPart;
    if (part >= 1.0)
    {
      break;
    }
    fetches += 1;
    if (exactClearance(path, part) > 0.0)
    {
      return part;
    }
  }
  return 1.0;
}
