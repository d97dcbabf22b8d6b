// A way through a height map: a straight ray's, or a ray's over a base that bends away from it.
// Depth is 1 - height: 0 at the top of the relief, 1 at its bottom.
//
// Needs HeightField.glsl

// A path through the relief. At part w of it, 0 to 1, it is over map coordinate MapStart + w MapSpan
// at depth DepthStart + w (DepthEnd - DepthStart + Sag (1 - w)): straight where Sag is 0, else bent
// with the base, which a straight ray sees as a parabola (Oliveira2005, equation 7).
struct HeightPath
{
  vec2 MapStart;
  vec2 MapSpan;
  float DepthStart;
  float DepthEnd;
  float Sag;
};

// Numbers past this, Inf and NaN are no path.
const float PathGreatest = 1.0e30;

// False where one of the numbers that make a path is not finite.
bool pathIsSound(HeightPath path)
{
  vec2 sum = abs(path.MapStart) + abs(path.MapSpan);
  float depths = abs(path.DepthStart) + abs(path.DepthEnd) + abs(path.Sag);
  return sum.x + sum.y + depths <= PathGreatest;
}

// The path of a straight ray from a depth to another, which moves by mapPerDepth for each unit.
HeightPath straightPath(vec2 mapStart, vec2 mapPerDepth, float depthStart, float depthEnd)
{
  HeightPath path;
  path.MapStart = mapStart;
  path.MapSpan = (depthEnd - depthStart) * mapPerDepth;
  path.DepthStart = depthStart;
  path.DepthEnd = depthEnd;
  path.Sag = 0.0;
  return path;
}

// The path of a ray for a time, which moves by mapPerTime, over a base that bends away from it by
// bend t^2 in depth.
HeightPath bentPath(
  vec2 mapStart, vec2 mapPerTime, float depthStart, float depthEnd, float bend, float time)
{
  HeightPath path;
  path.MapStart = mapStart;
  path.MapSpan = time * mapPerTime;
  path.DepthStart = depthStart;
  path.DepthEnd = depthEnd;
  path.Sag = bend * time * time;
  return path;
}

// The same path with whole tiles taken off, where coordinates are most precise.
HeightPath pathNearOrigin(HeightPath path)
{
  HeightPath near = path;
  near.MapStart = path.MapStart - wholeTiles(path.MapStart);
  return near;
}

// Depth at a part of the path; at its end exactly DepthEnd.
float pathDepth(HeightPath path, float part)
{
  float bent = path.DepthStart +
    part * ((path.DepthEnd - path.DepthStart) + path.Sag * (1.0 - part));
  return part < 1.0 ? bent : path.DepthEnd;
}

// Map coordinate at a part of the path.
vec2 pathMap(HeightPath path, float part)
{
  return path.MapStart + part * path.MapSpan;
}

// How many of a search's steps the path takes: one that leaves the relief where it starts can only
// meet it there.
int pathSteps(HeightPath path, int steps)
{
  bool isPoint = path.MapSpan == vec2(0.0) && path.DepthStart == path.DepthEnd && path.Sag == 0.0;
  return isPoint ? 1 : steps;
}

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
