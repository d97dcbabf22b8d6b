// Where a view ray meets a height map, by equal steps and then by halving (Oliveira2005,
// section 2.1). Depth is 1 - height: 0 at the top of the relief, 1 at its bottom.
//
// Needs HeightField.glsl
//
// The march uses sampleHeight, whose weights may be coarse (8 bits on common samplers). Whatever it
// finds is confirmed by bilinearHeight before it counts, so that no hit and no shadow hangs on the
// sampler's rounding and every device finds the same point.

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
  int Iterations; // linear and binary steps
  int Fetches;    // filtered samples: bilinearHeight counts as one
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

// First meeting of the path with the relief. A start on or below the relief is the hit itself,
// exactly and without a step: an all-0 depth map gives back the plain surface. The first step found
// inside is bracketed with the one before; halving keeps the bracket's far end inside. Within the
// last bracket relief and path are taken as straight, which is never worse than the bracket and
// gives flat ground exactly, its floor at depth 1 as well. Features thinner than a step may be
// missed. No hit where the path ends above the relief, or a number is not finite. At least one
// linear step is made.
HeightHit searchLinearBinary(HeightPath path, int linearSteps, int binarySteps)
{
  HeightHit hit;
  hit.Hit = false;
  hit.Part = 0.0;
  hit.RayDepth = 0.0;
  hit.MapCoord = vec2(0.0);
  hit.Relief = 0.0;
  hit.Iterations = 0;
  hit.Fetches = 0;
  if (!pathIsSound(path))
  {
    return hit;
  }

  HeightPath near = pathNearOrigin(path);
  int steps = max(linearSteps, 1);
  float stepPart = 1.0 / float(steps);
  float partInside = 0.0;
  float clearanceInside = exactClearance(near, 0.0);
  hit.Fetches = 1;
  hit.Hit = clearanceInside <= 0.0;

  if (!hit.Hit)
  {
    for (int i = 1; i <= steps; ++i)
    {
      float part = i < steps ? float(i) * stepPart : 1.0;
      vec2 uv = near.MapStart + part * near.MapSpan;
      hit.Iterations = i;
      hit.Fetches += 1;
      if ((1.0 - sampleHeight(uv)) - pathDepth(near, part) <= 0.0)
      {
        float clearance = exactClearance(near, part);
        hit.Fetches += 1;
        if (clearance <= 0.0)
        {
          hit.Hit = true;
          partInside = part;
          clearanceInside = clearance;
          break;
        }
      }
    }
    if (!hit.Hit)
    {
      return hit;
    }

    // The near end of the bracket: the step before, or an earlier one where the sampler was wrong
    // about that; the start is known to be outside.
    int above = hit.Iterations;
    float partAbove;
    float clearanceAbove;
    do
    {
      above -= 1;
      partAbove = float(above) * stepPart;
      clearanceAbove = exactClearance(near, partAbove);
      hit.Fetches += 1;
      if (clearanceAbove <= 0.0)
      {
        partInside = partAbove;
        clearanceInside = clearanceAbove;
      }
    } while (clearanceAbove <= 0.0 && above > 0);

    for (int i = 0; i < binarySteps; ++i)
    {
      float part = 0.5 * (partAbove + partInside);
      float clearance = exactClearance(near, part);
      if (clearance <= 0.0)
      {
        partInside = part;
        clearanceInside = clearance;
      }
      else
      {
        partAbove = part;
        clearanceAbove = clearance;
      }
      hit.Iterations += 1;
      hit.Fetches += 1;
    }
    // Above > 0 >= inside, so the quotient is in (0,1]; 1 is taken as it is, without rounding.
    float between = clearanceAbove / (clearanceAbove - clearanceInside);
    partInside = between < 1.0 ? partAbove + between * (partInside - partAbove) : partInside;
  }

  hit.Part = partInside;
  hit.RayDepth = pathDepth(near, partInside);
  hit.MapCoord = path.MapStart + partInside * path.MapSpan;
  hit.Relief = clamp(hit.RayDepth, 0.0, 1.0);
  return hit;
}

// 1.0 where the relief blocks a path out of it, else 0.0. The samples are the middles of `steps`
// equal parts, so that none is spent at depth 0, where nothing lies above. The caller moves the
// start off the surface first. A number that is not finite blocks nothing. fetches: filtered
// samples.
float occludedLinear(HeightPath path, int steps, out int fetches)
{
  fetches = 0;
  if (!pathIsSound(path) || path.DepthStart <= 0.0)
  {
    return 0.0;
  }
  HeightPath near = pathNearOrigin(path);
  float stepPart = 1.0 / float(max(steps, 1));
  float blocked = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    float part = (float(i) + 0.5) * stepPart;
    vec2 uv = near.MapStart + part * near.MapSpan;
    fetches += 1;
    if (1.0 - sampleHeight(uv) < pathDepth(near, part))
    {
      fetches += 1;
      if (exactClearance(near, part) < 0.0)
      {
        blocked = 1.0;
        break;
      }
    }
  }
  return blocked;
}
