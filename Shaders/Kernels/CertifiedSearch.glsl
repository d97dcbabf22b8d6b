// Where a path meets a height map, exactly: cones of free space carry it past what it cannot meet,
// and each patch of four texels that it may meet is solved. Along a straight line over the map a
// bilinear patch's height is quadratic, the path's depth is quadratic, so their difference has its
// roots in closed form. No patch is left out: none is smaller than a step.
//
// Needs HeightField.glsl
// Needs HeightLevels.glsl
// Needs HeightPath.glsl
// Needs HeightHit.glsl
// Needs HeightCone.glsl

// Patches that a path may go over, one by one, before it is given up (it is said to meet the relief
// where it is, never to miss it). A path crosses no more than the texels of its span along u and v
// and two more, so that only those of over 65000 texels are bounded by this number.
const int MostPatches = 65536;

// Clearance of a path over a patch from a part on: c0 + t (c1 + t c2), t parts further.
struct PatchClearance
{
  float c0;
  float c1;
  float c2;
};

PatchClearance clearanceOverPatch(TexelPath path, ivec2 cell, float part)
{
  int mode = wrapMode();
  ivec2 low =
    ivec2(firstPeriod(cell.x, path.Size.x, mode), firstPeriod(cell.y, path.Size.y, mode));
  float height00 = nearHeightOfLevel(low.x, low.y, path.Level);
  float height10 = nearHeightOfLevel(low.x + 1, low.y, path.Level);
  float height01 = nearHeightOfLevel(low.x, low.y + 1, path.Level);
  float height11 = nearHeightOfLevel(low.x + 1, low.y + 1, path.Level);
  vec2 from = path.Start + part * path.Span - vec2(cell);
  float alongBelow = height10 - height00;
  float alongAbove = height11 - height01;
  float below = height00 + from.x * alongBelow;
  float across = height01 + from.x * alongAbove - below;
  float twist = alongAbove - alongBelow;
  PatchClearance clearance;
  clearance.c0 = (1.0 - (below + from.y * across)) - texelPathDepth(path, part);
  clearance.c1 = 2.0 * part * path.Sag - path.Fall -
    (alongBelow + from.y * twist) * path.Span.x - across * path.Span.y;
  clearance.c2 = path.Sag - twist * path.Span.x * path.Span.y;
  return clearance;
}

// Where a path goes from a patch.
struct PatchExit
{
  float Part;  // where it leaves, 1 at most
  bool AlongU; // it goes on to the next patch along u, else along v
};

PatchExit patchExit(TexelPath path, ivec2 cell, float part)
{
  vec2 from = path.Start + part * path.Span - vec2(cell);
  vec2 toEdge;
  toEdge.x = max(path.Left ? from.x : 1.0 - from.x, 0.0) * path.PerTexel.x;
  toEdge.y = max(path.Down ? from.y : 1.0 - from.y, 0.0) * path.PerTexel.y;
  if (wrapMode() == WrapClamp) // the patches at the border have no end outwards
  {
    ivec2 size = path.Size;
    toEdge.x = cell.x == (path.Left ? -1 : size.x - 1) ? NoPart : toEdge.x;
    toEdge.y = cell.y == (path.Down ? -1 : size.y - 1) ? NoPart : toEdge.y;
  }
  PatchExit way;
  way.Part = min(part + min(toEdge.x, toEdge.y), 1.0);
  way.AlongU = toEdge.x <= toEdge.y;
  return way;
}

// The patch that the path is over at a later part, given the way out of `cell`: at least the next one
// from where it leaves on.
ivec2 laterPatch(TexelPath path, ivec2 cell, PatchExit way, float part)
{
  ivec2 there = patchAtPart(path, part);
  ivec2 next = cell;
  next.x += way.AlongU ? (path.Left ? -1 : 1) : 0;
  next.y += way.AlongU ? 0 : (path.Down ? -1 : 1);
  next.x = path.Left ? min(next.x, there.x) : max(next.x, there.x);
  next.y = path.Down ? min(next.y, there.y) : max(next.y, there.y);
  return part < way.Part ? cell : next;
}

// First part at which a path meets the level that is looked for, or, with `inside`, comes below it.
HeightHit searchPatches(HeightPath path, bool inside)
{
  HeightHit search = noHit();
  if (!pathIsSound(path))
  {
    return search;
  }
  HeightPath near = pathNearOrigin(path);
  TexelPath texels = texelPath(near, surfaceLevel());
  float span = abs(texels.Span.x) + abs(texels.Span.y) + 4.0;
  int most = int(min(span, float(MostPatches)));
  ivec2 cell = patchAtPart(texels, 0.0);
  float part = 0.0;
  int patches = 0;
  while (!search.Hit && part < 1.0 && search.Iterations < most)
  {
    // By cones to the next patch that the path may meet.
    bool reached = false;
    PatchExit way;
    while (!reached && part < 1.0 && search.Iterations < most)
    {
      search.Iterations += 1;
      vec2 cone = coneOfPatch(texels, cell);
      way = patchExit(texels, cell, part);
      float time = way.Part - part;
      float deepest = max(texelPathDepth(texels, part), texelPathDepth(texels, way.Part)) +
        0.25 * time * time * max(texels.Sag, 0.0);
      reached = !(deepest <= cone.x);
      if (!reached)
      {
        float free = freePart(texels, coneAhead(texels, cell, cone, part), part);
        part = max(min(part + free, 1.0), way.Part);
        cell = laterPatch(texels, cell, way, part);
      }
    }
    if (reached)
    {
      PatchClearance clearance = clearanceOverPatch(texels, cell, part);
      float root = firstRoot(max(clearance.c0, 0.0), clearance.c1, clearance.c2);
      bool within = inside ? clearance.c0 < 0.0 : clearance.c0 <= 0.0;
      patches += 1;
      search.Hit = within || root <= way.Part - part;
      if (search.Hit)
      {
        part = within ? part : part + root;
      }
      else
      {
        part = way.Part;
        cell = laterPatch(texels, cell, way, part);
      }
    }
  }
  search.Hit = search.Hit || part < 1.0; // given up: said to meet the relief where it is
  search.Part = part;
  search.Fetches = search.Iterations + patches;
  search.TexelReads = search.Iterations + 4 * patches;
  if (!search.Hit)
  {
    // The path's end is looked at by the numbers that say where it is, without rounding on the way.
    float clearance = exactClearance(near, 1.0);
    search.Part = 1.0;
    search.Fetches += 1;
    search.TexelReads += 4;
    search.Hit = inside ? clearance < 0.0 : clearance <= 0.0;
  }
  return search.Hit ? hitAtPart(path, search.Part, search) : search;
}

// First meeting of the path with the relief: none is missed. A start on or below the relief is the
// hit itself. No hit where the path ends above the relief, or a number is not finite.
HeightHit searchCertified(HeightPath path)
{
  return searchPatches(path, false);
}

// 1.0 where the relief blocks a path out of it, else 0.0, as occludedLinear, with nothing left out.
float occludedCertified(HeightPath path, out int fetches)
{
  fetches = 0;
  if (!pathIsSound(path) || path.DepthStart <= 0.0)
  {
    return 0.0;
  }
  HeightHit search = searchPatches(path, true);
  fetches = search.Fetches;
  return search.Hit ? 1.0 : 0.0;
}
