// Where a view ray meets a height map, by equal steps and then by secants: what halving takes many
// steps for, a secant finds in one where relief and path are nearly straight within the bracket.
//
// Needs HeightField.glsl
// Needs HeightPath.glsl
// Needs HeightHit.glsl
// Needs LinearSearch.glsl

// As searchLinearBinary, with secants in place of halvings. An end of the bracket that stays for two
// secants counts half as much for the next (the Illinois rule), so that both ends close in at kinks
// too.
HeightHit searchLinearSecant(HeightPath path, int linearSteps, int secantSteps)
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
    HeightBracket weighted = bracket; // its clearances choose the next part, nothing else
    bool wasInside = false;
    for (int i = 0; i < secantSteps; ++i)
    {
      float part = partBetween(weighted);
      float clearance = exactClearance(near, part);
      bool inside = clearance <= 0.0;
      bool again = i > 0 && inside == wasInside;
      bracket = narrowed(bracket, part, clearance);
      weighted = narrowed(weighted, part, clearance);
      if (again && inside)
      {
        weighted.ClearanceAbove = 0.5 * weighted.ClearanceAbove;
      }
      else if (again)
      {
        weighted.ClearanceInside = 0.5 * weighted.ClearanceInside;
      }
      wasInside = inside;
      search.Iterations += 1;
      search.Fetches += 1;
    }
  }
  search.TexelReads = 4 * search.Fetches;
  return search.Hit ? hitInBracket(path, bracket, search) : search;
}
