// Where a path meets a height map, by steps as long as a cone of free space allows, and then by
// halving. Where the cone allows less than an equal step, an equal step is made and looked at, so
// that the search ends after as many steps as the linear search, and can miss only what that can.
//
// Needs HeightField.glsl
// Needs HeightPath.glsl
// Needs HeightHit.glsl
// Needs HeightCone.glsl
// Needs LinearSearch.glsl

// A step further, but no further than the end: the last of many equal steps falls short of it by
// rounding.
float partAfter(float part, float stride, float equalStep)
{
  float next = part + stride;
  return next < 1.0 - 0.01 * equalStep ? next : 1.0;
}

// First step that comes below the relief, with the free one before, as bracketByEqualSteps.
HeightBracket bracketByCones(HeightPath near, int mostSteps, inout HeightHit search)
{
  HeightBracket bracket;
  bracket.PartAbove = 0.0;
  bracket.ClearanceAbove = exactClearance(near, 0.0);
  bracket.PartInside = 0.0;
  bracket.ClearanceInside = bracket.ClearanceAbove;
  search.Fetches += 1;
  search.TexelReads += 4;
  search.Hit = bracket.ClearanceAbove <= 0.0;
  TexelPath texels = texelPath(near, surfaceLevel());
  float equalStep = 1.0 / float(max(mostSteps, 1));
  float part = 0.0;
  while (!search.Hit && part < 1.0)
  {
    float next = partAfter(part, max(freePartAt(texels, part), equalStep), equalStep);
    float clearance = exactClearance(near, next);
    search.Iterations += 1;
    search.Fetches += 2;
    search.TexelReads += 5;
    if (clearance <= 0.0)
    {
      search.Hit = true;
      bracket.PartInside = next;
      bracket.ClearanceInside = clearance;
    }
    else
    {
      bracket.PartAbove = next;
      bracket.ClearanceAbove = clearance;
    }
    part = next;
  }
  return bracket;
}

// As searchLinearBinary, by at most as many steps of any length.
HeightHit searchCone(HeightPath path, int mostSteps, int binarySteps)
{
  HeightHit search = noHit();
  if (!pathIsSound(path))
  {
    return search;
  }
  HeightPath near = pathNearOrigin(path);
  HeightBracket bracket = bracketByCones(near, mostSteps, search);
  if (search.Hit && bracket.ClearanceAbove > 0.0)
  {
    for (int i = 0; i < binarySteps; ++i)
    {
      float part = 0.5 * (bracket.PartAbove + bracket.PartInside);
      bracket = narrowed(bracket, part, exactClearance(near, part));
      search.Iterations += 1;
      search.Fetches += 1;
      search.TexelReads += 4;
    }
  }
  return search.Hit ? hitInBracket(path, bracket, search) : search;
}

// As occludedLinear, by at most as many steps of any length.
float occludedCone(HeightPath path, int mostSteps, out int fetches)
{
  fetches = 0;
  if (!pathIsSound(path) || path.DepthStart <= 0.0)
  {
    return 0.0;
  }
  HeightPath near = pathNearOrigin(path);
  TexelPath texels = texelPath(near, surfaceLevel());
  float equalStep = 1.0 / float(max(mostSteps, 1));
  float part = 0.0;
  float blocked = 0.0;
  while (blocked == 0.0 && part < 1.0)
  {
    float free = freePartAt(texels, part);
    fetches += 1;
    if (free < equalStep) // looked at in its middle, as the linear search does
    {
      fetches += 1;
      blocked = exactClearance(near, min(part + 0.5 * equalStep, 1.0)) < 0.0 ? 1.0 : 0.0;
    }
    part = partAfter(part, max(free, equalStep), equalStep);
  }
  return blocked;
}
