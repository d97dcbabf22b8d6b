// The rest of a path through a height map, for rays whose first stretch is cut away.
//
// Needs HeightPath.glsl

// The path from one of its parts on, [0,1].
HeightPath restOfPath(HeightPath path, float part)
{
  HeightPath rest = path;
  float left = 1.0 - part;
  rest.MapStart = path.MapStart + part * path.MapSpan;
  rest.MapSpan = left * path.MapSpan;
  rest.DepthStart = pathDepth(path, part);
  rest.Sag = path.Sag * left * left;
  return rest;
}

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
