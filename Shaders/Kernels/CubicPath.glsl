// A way through a height map as a cubic: a piece of a straight ray over a curved base, between two of
// its points (Kernels/BaseSurface). In place of Kernels/HeightPath.
//
// Needs HeightField.glsl

// At part w of it, 0 to 1, the path is over map coordinate MapStart + w MapSpan + w (1 - w) (MapSag +
// w MapTwist), at depth Depth0 + w DepthSpan + w (1 - w) (DepthSag + w DepthTwist); at its end
// exactly at DepthEnd.
struct HeightPath
{
  vec2 MapStart;
  vec2 MapSpan;
  vec2 MapSag;
  vec2 MapTwist;
  float DepthStart;
  float DepthEnd;
  vec2 Window; // the part of the way where the path starts, and how much of it it is
  float Depth0; // where the way starts
  float DepthSpan;
  float DepthSag;
  float DepthTwist;
  float Share; // of a whole ray's way: how many of its steps fall to this path
};

// Numbers past this, Inf and NaN are no path.
const float PathGreatest = 1.0e30;

// False where one of the numbers that make a path is not finite.
bool pathIsSound(HeightPath path)
{
  vec2 sum = abs(path.MapStart) + abs(path.MapSpan) + abs(path.MapSag) + abs(path.MapTwist);
  float depths = abs(path.DepthStart) + abs(path.DepthEnd) + abs(path.DepthSag) +
    abs(path.DepthTwist);
  return sum.x + sum.y + depths <= PathGreatest;
}

// How many of a whole ray's steps this path takes, at least one.
int pathSteps(HeightPath path, int steps)
{
  return max(int(ceil(clamp(path.Share, 0.0, 1.0) * float(steps))), 1);
}

// The cubic with given ends and rates: of map and depth, per part (Hermite).
HeightPath cubicPath(vec2 mapStart, vec3 rateStart, float depthStart, vec2 mapEnd, vec3 rateEnd,
  float depthEnd, float share)
{
  HeightPath path;
  path.MapStart = mapStart;
  path.MapSpan = mapEnd - mapStart;
  path.MapSag = rateStart.xy - path.MapSpan;
  path.MapTwist = 2.0 * path.MapSpan - rateStart.xy - rateEnd.xy;
  float span = depthEnd - depthStart;
  path.Window = vec2(0.0, 1.0);
  path.DepthStart = depthStart;
  path.Depth0 = depthStart;
  path.DepthSpan = span;
  path.DepthEnd = depthEnd;
  path.DepthSag = rateStart.z - span;
  path.DepthTwist = 2.0 * span - rateStart.z - rateEnd.z;
  path.Share = share;
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
  float at = path.Window.x + part * path.Window.y;
  return path.MapStart + at * path.MapSpan +
    (at * (1.0 - at)) * (path.MapSag + at * path.MapTwist);
}

float pathDepth(HeightPath path, float part)
{
  float at = path.Window.x + part * path.Window.y;
  float bent = path.Depth0 + at * path.DepthSpan +
    (at * (1.0 - at)) * (path.DepthSag + at * path.DepthTwist);
  return part < 1.0 ? bent : path.DepthEnd;
}

// The path from one of its parts on, [0,1].
HeightPath restOfPath(HeightPath path, float part)
{
  HeightPath rest = path;
  rest.Window = vec2(path.Window.x + part * path.Window.y, (1.0 - part) * path.Window.y);
  rest.DepthStart = pathDepth(path, part);
  return rest;
}
