// A way through a height map whose depth is the distance to a quadric across the view ray
// (Kernels/QuadricExact). In place of Kernels/HeightPath.
//
// Needs HeightField.glsl
// Needs QuadricExact.glsl

// At part w of it, 0 to 1, the path is over map coordinate MapStart + w MapSpan, at the point Start + w
// Span of the fragment's texture space; at its end exactly at DepthEnd.
struct HeightPath
{
  vec2 MapStart;
  vec2 MapSpan;
  float DepthStart;
  float DepthEnd;
  vec2 Window; // the part of the way where the path starts, and how much of it it is
  vec3 Quadric;
  vec3 Across;
  vec3 Start;
  vec3 Span;
};

// Numbers past this, Inf and NaN are no path.
const float PathGreatest = 1.0e30;

// False where one of the numbers that make a path is not finite.
bool pathIsSound(HeightPath path)
{
  vec2 sum = abs(path.MapStart) + abs(path.MapSpan);
  vec3 points = abs(path.Quadric) + abs(path.Across) + abs(path.Start) + abs(path.Span);
  return sum.x + sum.y + points.x + points.y + points.z + abs(path.DepthStart) <= PathGreatest;
}

// A ray's way from a point of texture space until it leaves the shell, no longer than `longest`.
// mapStart: the map coordinate there.
HeightPath acrossPath(vec3 quadric, vec3 across, vec2 mapStart, vec3 start, vec3 direction,
  float longest, out float time)
{
  HeightPath path;
  path.Window = vec2(0.0, 1.0);
  path.Quadric = quadric;
  path.Across = across;
  path.Start = start;
  path.DepthStart = distanceAcross(quadric, across, start);
  time = leaveAcross(quadric, across, start, direction, path.DepthEnd);
  if (longest < time)
  {
    time = longest;
    path.DepthEnd = distanceAcross(quadric, across, start + time * direction);
  }
  path.MapStart = mapStart;
  path.MapSpan = time * direction.xy;
  path.Span = time * direction;
  return path;
}

// The same path with whole tiles taken off, where coordinates are most precise.
HeightPath pathNearOrigin(HeightPath path)
{
  HeightPath near = path;
  near.MapStart = path.MapStart - wholeTiles(path.MapStart);
  return near;
}

vec2 pathMap(HeightPath path, float part)
{
  return path.MapStart + (path.Window.x + part * path.Window.y) * path.MapSpan;
}

float pathDepth(HeightPath path, float part)
{
  float at = path.Window.x + part * path.Window.y;
  return part < 1.0 ? distanceAcross(path.Quadric, path.Across, path.Start + at * path.Span)
                    : path.DepthEnd;
}

// How many of a search's steps the path takes.
int pathSteps(HeightPath path, int steps)
{
  return path.Span == vec3(0.0) ? 1 : steps;
}

// The path from one of its parts on, [0,1].
HeightPath restOfPath(HeightPath path, float part)
{
  HeightPath rest = path;
  rest.Window = vec2(path.Window.x + part * path.Window.y, (1.0 - part) * path.Window.y);
  rest.DepthStart = pathDepth(path, part);
  return rest;
}
