// How far a path through a height map may go on without meeting it, by cones of free space (ConeTexel). One
// of two: CubicCone has the same names for cubic paths (TexelPath, texelPath, freePartAt).
//
// Needs HeightField.glsl
// Needs HeightLevels.glsl
// Needs HeightPath.glsl
// Needs ConeTexel.glsl

// A path in texels of a level: at part w it is at Start + w Span, at depth DepthStart + w (Fall - w Sag),
// with texel centres at whole numbers.
struct TexelPath
{
  int Level;
  ivec2 Size; // of the level
  vec2 Start;
  vec2 Span;
  vec2 PerTexel; // part for each texel along an axis, forwards; NoPart where it does not move
  float DepthStart;
  float DepthEnd;
  float Fall;
  float Sag;
  bool Left; // it moves to lower texels
  bool Down;
};

TexelPath texelPath(HeightPath near, int level)
{
  TexelPath path;
  path.Level = level;
  path.Size = levelSize(level);
  vec2 size = vec2(path.Size);
  path.Start = near.MapStart * size - 0.5;
  path.Span = near.MapSpan * size;
  vec2 speed = abs(path.Span);
  path.PerTexel.x = speed.x * NoPart > 1.0 ? 1.0 / speed.x : NoPart;
  path.PerTexel.y = speed.y * NoPart > 1.0 ? 1.0 / speed.y : NoPart;
  path.DepthStart = near.DepthStart;
  path.DepthEnd = near.DepthEnd;
  path.Fall = (near.DepthEnd - near.DepthStart) + near.Sag;
  path.Sag = near.Sag;
  path.Left = path.Span.x < 0.0;
  path.Down = path.Span.y < 0.0;
  return path;
}

float texelPathDepth(TexelPath path, float part)
{
  float bent = path.DepthStart + part * (path.Fall - part * path.Sag);
  return part < 1.0 ? bent : path.DepthEnd;
}

// The patch that the path is over at a part.
ivec2 patchAtPart(TexelPath path, float part)
{
  return patchOfTexels(path.Start + part * path.Span, path.Size);
}

vec2 coneOfPatch(TexelPath path, ivec2 cell)
{
  return coneOfCell(cell, path.Size, path.Level, path.Left, path.Down);
}

// What a path sees of a cone from one of its parts on. x: the cone's depth there, y: by how much it
// drops for each part further.
vec2 coneAhead(TexelPath path, ivec2 cell, vec2 cone, float part)
{
  float away = distanceInCell(path.Start + part * path.Span, cell, path.Left, path.Down);
  return vec2(cone.x - cone.y * away, cone.y * (abs(path.Span.x) + abs(path.Span.y)));
}

// How much further than `part` the path may go without meeting relief, by a cone ahead of it there. 0
// where the path is below it.
float freePart(TexelPath path, vec2 ahead, float part)
{
  float above = ahead.x - texelPathDepth(path, part);
  float slope = path.Fall - 2.0 * part * path.Sag + ahead.y;
  float free = firstRoot(max(above, 0.0), -slope, path.Sag);
  return above > 0.0 ? free : 0.0;
}

// The same by the cone of the patch that it is over there.
float freePartAt(TexelPath path, float part)
{
  ivec2 cell = patchAtPart(path, part);
  return freePart(path, coneAhead(path, cell, coneOfPatch(path, cell), part), part);
}
