// Where a ray meets a height map, by equal steps and then by halving (Oliveira2005,
// section 2.1). Depth is 1 - height: 0 at the top of the relief, 1 at its bottom.
//
// Needs HeightField.glsl
//
// The march uses sampleHeight, whose weights may be coarse (8 bits on common samplers). Whatever it
// finds is confirmed by bilinearHeight before it counts, so that no hit and no shadow hangs on the
// sampler's rounding and every device finds the same point.

struct HeightHit
{
  bool Hit;
  float RayDepth; // ray depth at the hit
  vec2 MapCoord;  // map coordinate at the hit, not wrapped
  float Relief;   // depth at the hit, [0,1]
  int Iterations; // linear and binary steps
  int Fetches;    // filtered samples: bilinearHeight counts as one
};

// Numbers past this, Inf and NaN are no ray.
const float RayGreatest = 1.0e30;

// False where one of the numbers that make a ray is not finite.
bool rayIsSound(vec2 mapCoord, vec2 direction, float depth)
{
  vec2 sum = abs(mapCoord) + abs(direction);
  return sum.x + sum.y + abs(depth) <= RayGreatest;
}

// How far a point of the ray lies above the relief, in depth; 0 or less is inside.
float exactClearance(vec2 uv, float rayDepth)
{
  return (1.0 - bilinearHeight(uv)) - rayDepth;
}

// First meeting of the ray with the relief. At ray depth s in [depthStart,1] the ray is over map
// coordinate mapEntry + (s - depthStart) * mapPerDepth. A start on or below the relief is the hit
// itself, exactly and without a step: an all-0 depth map gives back the plain surface. The first
// step found inside is bracketed with the one before; halving keeps the bracket's far end inside.
// Within the last bracket the relief is taken as straight, which is never worse than the bracket
// and gives flat ground exactly, its floor at depth 1 as well. Features thinner than a step may be
// missed. No hit where a number is not finite. At least one linear step is made.
HeightHit searchLinearBinary(
  vec2 mapEntry, vec2 mapPerDepth, float depthStart, int linearSteps, int binarySteps)
{
  HeightHit hit;
  hit.Hit = false;
  hit.RayDepth = 0.0;
  hit.MapCoord = vec2(0.0);
  hit.Relief = 0.0;
  hit.Iterations = 0;
  hit.Fetches = 0;
  if (!rayIsSound(mapEntry, mapPerDepth, depthStart))
  {
    return hit;
  }

  vec2 base = mapEntry - wholeTiles(mapEntry);
  int steps = max(linearSteps, 1);
  float stepDepth = (1.0 - depthStart) / float(steps);
  float depthInside = depthStart;
  float clearanceInside = exactClearance(base, depthStart);
  hit.Fetches = 1;
  hit.Hit = clearanceInside <= 0.0;

  if (!hit.Hit)
  {
    for (int i = 1; i <= steps; ++i)
    {
      float s = i < steps ? depthStart + float(i) * stepDepth : 1.0;
      vec2 uv = base + (s - depthStart) * mapPerDepth;
      float clearance = (1.0 - sampleHeight(uv)) - s;
      hit.Iterations = i;
      hit.Fetches += 1;
      if (clearance <= 0.0)
      {
        clearance = exactClearance(uv, s);
        hit.Fetches += 1;
        if (clearance <= 0.0)
        {
          hit.Hit = true;
          depthInside = s;
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
    float depthAbove;
    float clearanceAbove;
    do
    {
      above -= 1;
      depthAbove = depthStart + float(above) * stepDepth;
      clearanceAbove = exactClearance(base + (depthAbove - depthStart) * mapPerDepth, depthAbove);
      hit.Fetches += 1;
      if (clearanceAbove <= 0.0)
      {
        depthInside = depthAbove;
        clearanceInside = clearanceAbove;
      }
    } while (clearanceAbove <= 0.0 && above > 0);

    for (int i = 0; i < binarySteps; ++i)
    {
      float s = 0.5 * (depthAbove + depthInside);
      float clearance = exactClearance(base + (s - depthStart) * mapPerDepth, s);
      if (clearance <= 0.0)
      {
        depthInside = s;
        clearanceInside = clearance;
      }
      else
      {
        depthAbove = s;
        clearanceAbove = clearance;
      }
      hit.Iterations += 1;
      hit.Fetches += 1;
    }
    // Above > 0 >= inside, so the quotient is in (0,1]; 1 is taken as it is, without rounding.
    float part = clearanceAbove / (clearanceAbove - clearanceInside);
    depthInside =
      part < 1.0 ? depthAbove + part * (depthInside - depthAbove) : depthInside;
  }

  hit.RayDepth = depthInside;
  hit.MapCoord = mapEntry + (depthInside - depthStart) * mapPerDepth;
  hit.Relief = clamp(depthInside, 0.0, 1.0);
  return hit;
}

// 1.0 where the relief blocks a ray that rises from depthStart to depthEnd (0, or where the light
// is), else 0.0. At ray depth s the ray is over map coordinate mapStart + (depthStart - s) *
// mapPerHeight. The samples are the middles of `steps` equal parts, so that none is spent at depth
// 0, where nothing lies above. The caller moves the start off the surface first. A number that is
// not finite blocks nothing. fetches: filtered samples.
float occludedLinear(
  vec2 mapStart, vec2 mapPerHeight, float depthStart, float depthEnd, int steps, out int fetches)
{
  fetches = 0;
  if (!rayIsSound(mapStart, mapPerHeight, depthStart) || depthStart <= 0.0)
  {
    return 0.0;
  }
  vec2 base = mapStart - wholeTiles(mapStart);
  float stepDepth = max(depthStart - max(depthEnd, 0.0), 0.0) / float(max(steps, 1));
  float blocked = 0.0;
  for (int i = 0; i < steps; ++i)
  {
    float risen = (float(i) + 0.5) * stepDepth;
    float s = depthStart - risen;
    vec2 uv = base + risen * mapPerHeight;
    fetches += 1;
    if (1.0 - sampleHeight(uv) < s)
    {
      fetches += 1;
      if (exactClearance(uv, s) < 0.0)
      {
        blocked = 1.0;
        break;
      }
    }
  }
  return blocked;
}
