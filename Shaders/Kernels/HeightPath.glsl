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

struct HeightHit
{
  bool Hit;
  float Part;     // of the path, at the hit
  float RayDepth; // depth of the path at the hit
  vec2 MapCoord;  // map coordinate at the hit, not wrapped
  float Relief;   // depth at the hit, [0,1]
  int Iterations; // steps of the search
  int Fetches;    // samples of a map: a patch of four texels counts as one
  int TexelReads; // texels behind them
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

// How far a point of the path lies above the relief, in depth; 0 or less is inside.
float exactClearance(HeightPath path, float part)
{
  return (1.0 - bilinearHeight(path.MapStart + part * path.MapSpan)) - pathDepth(path, part);
}

// No hit, and no work done.
HeightHit noHit()
{
  HeightHit hit;
  hit.Hit = false;
  hit.Part = 0.0;
  hit.RayDepth = 0.0;
  hit.MapCoord = vec2(0.0);
  hit.Relief = 0.0;
  hit.Iterations = 0;
  hit.Fetches = 0;
  hit.TexelReads = 0;
  return hit;
}

// A hit at a part of the path, after the work that `search` counts.
HeightHit hitAtPart(HeightPath path, float part, HeightHit search)
{
  HeightHit hit = search;
  hit.Hit = true;
  hit.Part = part;
  hit.RayDepth = pathDepth(path, part);
  hit.MapCoord = path.MapStart + part * path.MapSpan;
  hit.Relief = clamp(hit.RayDepth, 0.0, 1.0);
  return hit;
}
