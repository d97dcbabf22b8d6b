// Where a path comes into a height map, by equal steps (Oliveira2005, section 2.1): what the
// searches refine, and whether the map blocks a light.
//
// Needs HeightField.glsl
// Needs HeightPath.glsl
// Needs HeightHit.glsl
//
// The march uses sampleHeight, whose weights may be coarse (8 bits on common samplers). Whatever it
// finds is confirmed by exactClearance before it counts, so that no hit and no shadow hangs on the
// sampler's rounding and every device finds the same point.

// Two points of a path, the first above the relief and the second inside of it.
struct HeightBracket
{
  float PartAbove;
  float ClearanceAbove; // > 0
  float PartInside;
  float ClearanceInside; // <= 0
};

// The first step that is inside, with the one before. A start on or below the relief is both ends,
// without a step. search.Hit says whether there is one. Features thinner than a step may be missed.
// `near` is a path near the origin, of finite numbers; at least one step is made.
HeightBracket bracketByEqualSteps(HeightPath near, int linearSteps, inout HeightHit search)
{
  HeightBracket bracket;
  bracket.PartAbove = 0.0;
  bracket.ClearanceAbove = exactClearance(near, 0.0);
  bracket.PartInside = 0.0;
  bracket.ClearanceInside = bracket.ClearanceAbove;
  search.Fetches += 1;
  search.Hit = bracket.ClearanceAbove <= 0.0;
  if (search.Hit)
  {
    return bracket;
  }

  int steps = max(linearSteps, 1);
  float stepPart = 1.0 / float(steps);
  while (!search.Hit && search.Iterations < steps)
  {
    // The loop that runs often holds nothing but samples: some devices do even what a condition skips.
    float part;
    bool suspected;
    do
    {
      search.Iterations += 1;
      search.Fetches += 1;
      part = search.Iterations < steps ? float(search.Iterations) * stepPart : 1.0;
      suspected = (1.0 - sampleHeight(pathMap(near, part))) - pathDepth(near, part) <= 0.0;
    } while (!suspected && search.Iterations < steps);
    if (suspected)
    {
      bracket.PartInside = part;
      bracket.ClearanceInside = exactClearance(near, part);
      search.Fetches += 1;
      search.Hit = bracket.ClearanceInside <= 0.0;
    }
  }
  if (!search.Hit)
  {
    return bracket;
  }

  // The near end: the step before, or an earlier one where the sampler was wrong about that; the
  // start is known to be outside.
  int above = search.Iterations;
  do
  {
    above -= 1;
    bracket.PartAbove = float(above) * stepPart;
    bracket.ClearanceAbove = exactClearance(near, bracket.PartAbove);
    search.Fetches += 1;
    if (bracket.ClearanceAbove <= 0.0)
    {
      bracket.PartInside = bracket.PartAbove;
      bracket.ClearanceInside = bracket.ClearanceAbove;
    }
  } while (bracket.ClearanceAbove <= 0.0 && above > 0);
  return bracket;
}

// The bracket's half that keeps the far end inside, given the clearance at a part between.
HeightBracket narrowed(HeightBracket bracket, float part, float clearance)
{
  HeightBracket closer = bracket;
  if (clearance <= 0.0)
  {
    closer.PartInside = part;
    closer.ClearanceInside = clearance;
  }
  else
  {
    closer.PartAbove = part;
    closer.ClearanceAbove = clearance;
  }
  return closer;
}

// Where the clearance is 0 between the bracket's ends, taking relief and path as straight there:
// never worse than the bracket, and flat ground exactly, its floor at depth 1 as well. The far end
// of a start that is inside.
float partBetween(HeightBracket bracket)
{
  if (bracket.ClearanceAbove <= 0.0)
  {
    return bracket.PartInside;
  }
  // Above > 0 >= inside, so the quotient is in (0,1]; 1 is taken as it is, without rounding.
  float between = bracket.ClearanceAbove / (bracket.ClearanceAbove - bracket.ClearanceInside);
  return between < 1.0
    ? bracket.PartAbove + between * (bracket.PartInside - bracket.PartAbove)
    : bracket.PartInside;
}

// The hit between the bracket's ends, after the work that `search` counts.
HeightHit hitInBracket(HeightPath path, HeightBracket bracket, HeightHit search)
{
  HeightHit hit = hitAtPart(path, partBetween(bracket), search);
  float width = bracket.PartInside - bracket.PartAbove;
  hit.Closing =
    width > 0.0 ? (bracket.ClearanceAbove - bracket.ClearanceInside) / width : 0.0;
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
    vec2 uv = pathMap(near, part);
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
