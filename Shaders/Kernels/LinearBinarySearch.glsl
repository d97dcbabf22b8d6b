// Where a view ray meets a height map, by equal steps and then by halving (Oliveira2005,
// section 2.1).
//
// Needs HeightField.glsl
// Needs HeightPath.glsl
// Needs HeightHit.glsl
// Needs LinearSearch.glsl

// First meeting of the path with the relief. A start on or below the relief is the hit itself,
// exactly and without a step: an all-0 depth map gives back the plain surface. The first step found
// inside is bracketed with the one before; halving keeps the bracket's far end inside. Features
// thinner than a step may be missed. No hit where the path ends above the relief, or a number is
// not finite. At least one linear step is made.
HeightHit searchLinearBinary(HeightPath path, int linearSteps, int binarySteps)
{
  HeightHit search = noHit();
  if (!pathIsSound(path))
  {
    return search;
  }
  HeightPath near = pathNearOrigin(path);
  HeightBracket bracket = bracketByEqualSteps(near, linearSteps, search);
  if (search.Hit && bracket.ClearanceAbove > 0.0)
  {
    for (int i = 0; i < binarySteps; ++i)
    {
      float part = 0.5 * (bracket.PartAbove + bracket.PartInside);
      bracket = narrowed(bracket, part, exactClearance(near, part));
      search.Iterations += 1;
      search.Fetches += 1;
    }
  }
  search.TexelReads = 4 * search.Fetches;
  return search.Hit ? hitInBracket(path, bracket, search) : search;
}
