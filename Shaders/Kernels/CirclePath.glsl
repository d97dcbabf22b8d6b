// A way through a height map that lies below a circle: a straight ray over the circle of its own normal
// curvature, in the plane of ray and normal. In place of Kernels/HeightPath.
//
// Needs HeightField.glsl
// Needs Quadric.glsl
//
// Lengths are in units of D, curvatures in 1 / D, > 0 where the base is convex. With x along the base
// and z down from where the ray starts, the point (x, z) lies
//
//   1/k - sqrt(x^2 + (1/k - z)^2) = F / (1 + sqrt(1 - k F)),   F = 2 z - k (x^2 + z^2)
//
// below the circle, over its arc atan(k x / (1 - k z)) / k. Nothing is divided by k: a straight base is
// k = 0.

// At part w of it, 0 to 1, the path is at the point (w Along, Depth0 + w Down); at its end exactly
// at DepthEnd.
struct HeightPath
{
  vec2 MapStart;
  vec2 MapSpan; // what the map would move by along a straight base
  float DepthStart;
  float DepthEnd;
  vec2 Window; // the part of the way where the path starts, and how much of it it is
  float Curvature;
  float Depth0; // where the way starts
  float Along;
  float Down;
};

// Numbers past this, Inf and NaN are no path.
const float PathGreatest = 1.0e30;

// A circle's centre has no arc: the relief ends this part of the radius below the circle.
const float CircleDeepest = 0.98;

// False where one of the numbers that make a path is not finite.
bool pathIsSound(HeightPath path)
{
  vec2 sum = abs(path.MapStart) + abs(path.MapSpan);
  float depths = abs(path.DepthStart) + abs(path.DepthEnd);
  float circle = abs(path.Curvature) + abs(path.Along) + abs(path.Down);
  return sum.x + sum.y + depths + circle <= PathGreatest;
}

// F of the point (x, z).
float circlePower(float curvature, float x, float z)
{
  return 2.0 * z - curvature * (x * x + z * z);
}

float depthBelowCircle(float curvature, float x, float z)
{
  float power = circlePower(curvature, x, z);
  return power / (1.0 + sqrt(max(1.0 - curvature * power, 0.0)));
}

// The arc from x = 0 to below (x, z), over x. The series' next term is 3e-8.
float arcPerLength(float curvature, float x, float z)
{
  float across = curvature * x;
  float inward = 1.0 - curvature * z;
  float slope = across / max(abs(inward), 1.0e-6);
  float square = slope * slope;
  float series = (1.0 - square * (1.0 / 3.0 - square * (0.2 - square / 7.0))) / inward;
  return inward > 0.0 && abs(slope) < 0.15 ? series : atan(across, inward) / across;
}

// A ray's way from a depth below the circle until it leaves the shell, no longer than `longest`. mapRate:
// over a straight base; along, down: its speed along the base and down, along >= 0.
HeightPath circlePath(float curvature, vec2 mapStart, float depthStart, vec2 mapRate, float along,
  float down, float longest, out float time)
{
  HeightPath path;
  float deepest = curvature > CircleDeepest ? CircleDeepest / curvature : 1.0;
  float bottom = circlePower(curvature, 0.0, deepest);
  float start = clamp(depthStart, 0.0, deepest);
  float depthEnd;
  time = leaveShell(circlePower(curvature, 0.0, start) / bottom,
    2.0 * down * (1.0 - curvature * start) / bottom,
    curvature * (along * along + down * down) / bottom, depthEnd);
  if (longest < time)
  {
    time = longest;
    depthEnd = depthBelowCircle(curvature, time * along, start + time * down);
  }
  path.MapStart = mapStart;
  path.MapSpan = time * mapRate;
  path.Window = vec2(0.0, 1.0);
  path.DepthStart = start;
  path.Depth0 = start;
  path.DepthEnd = depthEnd;
  path.Curvature = curvature;
  path.Along = time * along;
  path.Down = time * down;
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
  float arc = arcPerLength(path.Curvature, at * path.Along, path.Depth0 + at * path.Down);
  return path.MapStart + (at * arc) * path.MapSpan;
}

float pathDepth(HeightPath path, float part)
{
  float at = path.Window.x + part * path.Window.y;
  return part < 1.0 ? depthBelowCircle(path.Curvature, at * path.Along, path.Depth0 + at * path.Down)
                    : path.DepthEnd;
}

// How many of a search's steps the path takes.
int pathSteps(HeightPath path, int steps)
{
  return path.Along == 0.0 && path.Down == 0.0 ? 1 : steps;
}

// The path from one of its parts on, [0,1].
HeightPath restOfPath(HeightPath path, float part)
{
  HeightPath rest = path;
  rest.Window = vec2(path.Window.x + part * path.Window.y, (1.0 - part) * path.Window.y);
  rest.DepthStart = pathDepth(path, part);
  return rest;
}
