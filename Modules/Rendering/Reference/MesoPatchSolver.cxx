#include "MesoPatchSolver.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double PieceTolerance = 1e-11; // of a cell: by so much pieces overlap
constexpr int DeepestPiece = 60;         // halvings, along x and y together
constexpr double Epsilon = std::numeric_limits<double>::epsilon();
constexpr double ResidualLimit = 1e-13; // of the size of what is added up

double Cross(const glm::dvec2& a, const glm::dvec2& b)
{
  return a.x * b.y - a.y * b.x;
}

MesoRect Overlap(const MesoRect& a, const MesoRect& b)
{
  return { std::max(a.X0, b.X0), std::min(a.X1, b.X1), std::max(a.Y0, b.Y0), std::min(a.Y1, b.Y1) };
}

double LargestPartOf(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}
}

MesoPatchSolver::MesoPatchSolver(
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax)
  : Origin(origin)
  , Direction(direction)
  , PerSquare(1. / glm::dot(direction, direction))
  , LargestPart(LargestPartOf(origin))
  , TMin(tMin)
  , TMax(tMax)
{
  const glm::dvec3 unit = direction * std::sqrt(this->PerSquare);
  const glm::dvec3 helper =
    std::abs(unit.x) < 0.6 ? glm::dvec3(1., 0., 0.) : glm::dvec3(0., 1., 0.);
  this->Axis0 = glm::normalize(glm::cross(helper, unit));
  this->Axis1 = glm::cross(unit, this->Axis0);
}

double MesoPatchSolver::Rounding(const glm::dvec3& middle) const
{
  return 32. * Epsilon * (this->LargestPart + LargestPartOf(middle) + std::abs(this->Over.Scale));
}

bool MesoPatchSolver::Touches(const Enclosure& enclosure, double& tLow) const
{
  const glm::dvec3 to = enclosure.Middle - this->Origin;
  const double ball = enclosure.Ball + this->Rounding(enclosure.Middle);
  double spread = ball * std::sqrt(this->PerSquare);
  glm::dvec2 edges[3];
  for (int k = 0; k < enclosure.NumberOfEdges; ++k)
  {
    spread += std::abs(glm::dot(this->Direction, enclosure.Edges[k])) * this->PerSquare;
    edges[k] = this->Across(enclosure.Edges[k]);
  }
  const double t = glm::dot(to, this->Direction) * this->PerSquare;
  tLow = t - spread;
  if (!(tLow <= this->TMax && t + spread >= this->TMin))
  {
    return false;
  }
  // The shadow of the parallelepiped is a polygon whose sides run along the edges' shadows.
  const glm::dvec2 f = this->Across(to);
  for (int k = 0; k < enclosure.NumberOfEdges; ++k)
  {
    const double length = std::sqrt(glm::dot(edges[k], edges[k]));
    double reach = ball * length;
    for (int other = 0; other < enclosure.NumberOfEdges; ++other)
    {
      reach += std::abs(Cross(edges[k], edges[other]));
    }
    if (std::abs(Cross(edges[k], f)) > reach)
    {
      return false;
    }
  }
  // Where edges have no shadow to speak of, the sides say little: the distance itself.
  double far = ball;
  for (int k = 0; k < enclosure.NumberOfEdges; ++k)
  {
    far += std::sqrt(glm::dot(edges[k], edges[k]));
  }
  return glm::dot(f, f) <= far * far;
}

bool MesoPatchSolver::Reaches(const MesoRect& rect, double low, double high, double& tLow)
{
  ++this->Done.Blocks;
  MesoBasePoint middle;
  MesoBaseBends bends;
  this->Patch->Evaluate(rect, middle, bends);
  const double x = 0.5 * (rect.X1 - rect.X0);
  const double y = 0.5 * (rect.Y1 - rect.Y0);
  const double scale = this->Over.Scale;
  const double g = (0.5 * (low + high) - this->Over.Reference) * scale;
  const double half = 0.5 * (high - low) * scale;
  const double most = std::abs(g) + half;

  Enclosure enclosure;
  enclosure.NumberOfEdges = 3;
  enclosure.Ball = 0.5 * (bends.Pxx * x * x + 2. * bends.Pxy * x * y + bends.Pyy * y * y);
  if (bends.Wild)
  {
    enclosure.Middle = middle.P;
    enclosure.Edges[0] = x * middle.Px;
    enclosure.Edges[1] = y * middle.Py;
    enclosure.NumberOfEdges = 2;
    enclosure.Ball += most;
  }
  else
  {
    enclosure.Middle = middle.P + g * middle.N;
    enclosure.Edges[0] = x * (middle.Px + g * middle.Nx);
    enclosure.Edges[1] = y * (middle.Py + g * middle.Ny);
    enclosure.Edges[2] = half * middle.N;
    enclosure.Ball += half * (x * glm::length(middle.Nx) + y * glm::length(middle.Ny)) +
      0.5 * most * (bends.Nxx * x * x + 2. * bends.Nxy * x * y + bends.Nyy * y * y);
  }
  return this->Touches(enclosure, tLow);
}

bool MesoPatchSolver::FirstHit(const MesoBasePatch& patch, const MesoDisplacement& displacement,
  Facing facing, bool any, MesoPatchHit& hit)
{
  this->Patch = &patch;
  this->Over = displacement;
  this->Any = any;
  this->Found = false;
  // (qx x qy) . d is the Jacobian's determinant times |d|; fronts have it negative.
  this->Wanted = facing == Facing::Both ? 0.
    : facing == Facing::Front           ? -patch.Orientation()
                                        : patch.Orientation();
  const MesoRect& domain = patch.Domain();
  if (!displacement.Map)
  {
    this->Budget = EvaluationLimit;
    this->SolvePiece({ 0., 0., displacement.Height, 0., 0., 0. }, domain, 0);
  }
  else
  {
    const MesoHeightPyramid::Axis& x = displacement.Map->X();
    const MesoHeightPyramid::Axis& y = displacement.Map->Y();
    this->VisitTiles(
      x.TileOf(domain.X0), x.TileOf(domain.X1), y.TileOf(domain.Y0), y.TileOf(domain.Y1));
  }
  if (this->Found)
  {
    hit = this->Best;
  }
  return this->Found;
}

void MesoPatchSolver::VisitTiles(std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1)
{
  if (this->Finished())
  {
    return;
  }
  if (x0 == x1 && y0 == y1)
  {
    this->VisitTile(x0, y0);
    return;
  }
  // Several tiles: halved, as long as the map's whole range is met there.
  struct Part
  {
    std::int64_t X0;
    std::int64_t X1;
    std::int64_t Y0;
    std::int64_t Y1;
    double TLow;
  };
  const bool alongX = x1 - x0 >= y1 - y0;
  const std::int64_t middle = alongX ? x0 + (x1 - x0) / 2 : y0 + (y1 - y0) / 2;
  Part parts[2] = { { x0, alongX ? middle : x1, y0, alongX ? y1 : middle, 0. },
    { alongX ? middle + 1 : x0, x1, alongX ? y0 : middle + 1, y1, 0. } };
  const MesoHeightPyramid& map = *this->Over.Map;
  const MesoHeightPyramid::Range range = map.RangeOf(map.TopLevel(), 0, 0);
  bool reached[2];
  for (int k = 0; k < 2; ++k)
  {
    Part& part = parts[k];
    const MesoRect rect =
      Overlap({ map.X().Low(part.X0, 0), map.X().High(part.X1, map.X().Cells() - 1),
                map.Y().Low(part.Y0, 0), map.Y().High(part.Y1, map.Y().Cells() - 1) },
        this->Patch->Domain());
    reached[k] = !rect.Empty() && !this->Patch->Misses(rect) &&
      this->Reaches(rect, range.Low, range.High, part.TLow);
  }
  const int first = reached[1] && (!reached[0] || parts[1].TLow < parts[0].TLow) ? 1 : 0;
  for (int k : { first, 1 - first })
  {
    if (reached[k] && parts[k].TLow <= this->TMax)
    {
      this->VisitTiles(parts[k].X0, parts[k].X1, parts[k].Y0, parts[k].Y1);
    }
  }
}

MesoRect MesoPatchSolver::RectOf(
  std::int64_t tileX, std::int64_t tileY, int level, int i, int j) const
{
  const MesoHeightPyramid::Axis& x = this->Over.Map->X();
  const MesoHeightPyramid::Axis& y = this->Over.Map->Y();
  const auto last = [&](const MesoHeightPyramid::Axis& axis, int block)
  { return std::min(((block + 1) << level) - 1, axis.Cells() - 1); };
  return Overlap({ x.Low(tileX, i << level), x.High(tileX, last(x, i)), y.Low(tileY, j << level),
                   y.High(tileY, last(y, j)) },
    this->Patch->Domain());
}

bool MesoPatchSolver::BlockReached(std::int64_t tileX, std::int64_t tileY, Block& block)
{
  const MesoRect rect = this->RectOf(tileX, tileY, block.Level, block.I, block.J);
  if (rect.Empty() || this->Patch->Misses(rect))
  {
    return false;
  }
  const MesoHeightPyramid::Range range = this->Over.Map->RangeOf(block.Level, block.I, block.J);
  return this->Reaches(rect, range.Low, range.High, block.TLow);
}

void MesoPatchSolver::VisitTile(std::int64_t tileX, std::int64_t tileY)
{
  // Not from the whole tile down, but from the least blocks of which two by two hold the domain.
  const MesoHeightPyramid& map = *this->Over.Map;
  const MesoRect& domain = this->Patch->Domain();
  const int i0 = map.X().CellOf(tileX, domain.X0);
  const int i1 = map.X().CellOf(tileX, domain.X1);
  const int j0 = map.Y().CellOf(tileY, domain.Y0);
  const int j1 = map.Y().CellOf(tileY, domain.Y1);
  int level = 0;
  while ((i1 >> level) - (i0 >> level) > 1 || (j1 >> level) - (j0 >> level) > 1)
  {
    ++level;
  }
  for (int j = j0 >> level; j <= j1 >> level; ++j)
  {
    for (int i = i0 >> level; i <= i1 >> level; ++i)
    {
      Block block = { level, i, j, 0. };
      if (!this->Finished() && this->BlockReached(tileX, tileY, block))
      {
        this->VisitBlock(tileX, tileY, block);
      }
    }
  }
}

void MesoPatchSolver::VisitBlock(std::int64_t tileX, std::int64_t tileY, const Block& block)
{
  if (block.Level == 0)
  {
    this->SolveCell(tileX, tileY, block.I, block.J);
    return;
  }
  const int level = block.Level - 1;
  const int lastI = (this->Over.Map->X().Cells() - 1) >> level;
  const int lastJ = (this->Over.Map->Y().Cells() - 1) >> level;
  Block children[4];
  int count = 0;
  for (int child = 0; child < 4; ++child)
  {
    Block part = { level, 2 * block.I + child % 2, 2 * block.J + child / 2, 0. };
    if (part.I > lastI || part.J > lastJ || !this->BlockReached(tileX, tileY, part))
    {
      continue;
    }
    int place = count++;
    for (; place > 0 && children[place - 1].TLow > part.TLow; --place)
    {
      children[place] = children[place - 1];
    }
    children[place] = part;
  }
  for (int k = 0; k < count && !this->Finished(); ++k)
  {
    if (children[k].TLow <= this->TMax)
    {
      this->VisitBlock(tileX, tileY, children[k]);
    }
  }
}

void MesoPatchSolver::SolveCell(std::int64_t tileX, std::int64_t tileY, int i, int j)
{
  const MesoHeightPyramid& map = *this->Over.Map;
  const std::array<double, 4> h = map.Corners(i, j);
  Cell cell;
  cell.X0 = map.X().High(tileX, i) - 1.; // the upper end is finite but in the last cell of clamp,
  cell.Y0 = map.Y().High(tileY, j) - 1.; // the lower but in the first
  cell.X0 = std::isfinite(cell.X0) ? cell.X0 : map.X().Low(tileX, i);
  cell.Y0 = std::isfinite(cell.Y0) ? cell.Y0 : map.Y().Low(tileY, j);
  cell.H00 = h[0];
  cell.HX = h[1] - h[0];
  cell.HY = h[2] - h[0];
  cell.HXY = h[3] - h[2] - cell.HX;
  this->Budget = EvaluationLimit;
  this->SolvePiece(cell, this->RectOf(tileX, tileY, 0, i, j), 0);
}

MesoPatchSolver::Offset MesoPatchSolver::OffsetAt(const Cell& cell, double x, double y) const
{
  const double a = x - cell.X0;
  const double b = y - cell.Y0;
  const double scale = this->Over.Scale;
  return { (cell.H00 - this->Over.Reference + a * cell.HX + b * cell.HY + a * b * cell.HXY) * scale,
    (cell.HX + b * cell.HXY) * scale, (cell.HY + a * cell.HXY) * scale, cell.HXY * scale };
}

MesoPatchSolver::Expansion MesoPatchSolver::Expand(const Cell& cell, const MesoRect& rect) const
{
  MesoBasePoint middle;
  MesoBaseBends bends;
  this->Patch->Evaluate(rect, middle, bends);
  const double x = 0.5 * (rect.X1 - rect.X0);
  const double y = 0.5 * (rect.Y1 - rect.Y0);
  const Offset at = this->OffsetAt(cell, 0.5 * (rect.X0 + rect.X1), 0.5 * (rect.Y0 + rect.Y1));
  const double twist = std::abs(at.Gxy);
  const double mostGx = std::abs(at.Gx) + twist * y;
  const double mostGy = std::abs(at.Gy) + twist * x;
  const double mostG = std::abs(at.G) + std::abs(at.Gx) * x + mostGy * y;

  Expansion result;
  result.Wild = bends.Wild;
  result.Normal = middle.N;
  result.Around.NumberOfEdges = 2;
  if (bends.Wild)
  {
    result.Around.Middle = middle.P;
    result.Around.Edges[0] = x * middle.Px;
    result.Around.Edges[1] = y * middle.Py;
    result.Around.Ball =
      mostG + 0.5 * (bends.Pxx * x * x + 2. * bends.Pxy * x * y + bends.Pyy * y * y);
    result.ChangeX = result.ChangeY = 0.;
    return result;
  }
  // Bounds of q's second derivatives.
  const double xx = bends.Pxx + 2. * mostGx * bends.Nx + mostG * bends.Nxx;
  const double xy = bends.Pxy + twist + mostGx * bends.Ny + mostGy * bends.Nx + mostG * bends.Nxy;
  const double yy = bends.Pyy + 2. * mostGy * bends.Ny + mostG * bends.Nyy;
  result.Around.Middle = middle.P + at.G * middle.N;
  result.Around.Edges[0] = x * (middle.Px + at.Gx * middle.N + at.G * middle.Nx);
  result.Around.Edges[1] = y * (middle.Py + at.Gy * middle.N + at.G * middle.Ny);
  result.Around.Ball = 0.5 * (xx * x * x + 2. * xy * x * y + yy * y * y);
  result.ChangeX = xx * x * x + xy * x * y;
  result.ChangeY = yy * y * y + xy * x * y;
  return result;
}

void MesoPatchSolver::SolvePiece(const Cell& cell, const MesoRect& rect, int depth)
{
  if (this->Finished() || this->Budget < 0 || rect.Empty() || this->Patch->Misses(rect))
  {
    return;
  }
  ++this->Done.Pieces;
  if (--this->Budget < 0)
  {
    ++this->Done.Unresolved;
    return;
  }
  const Expansion piece = this->Expand(cell, rect);
  double tLow = 0.;
  if (!this->Touches(piece.Around, tLow))
  {
    return;
  }
  const glm::dvec2 jx = this->Across(piece.Around.Edges[0]); // the Jacobian, in units of the piece
  const glm::dvec2 jy = this->Across(piece.Around.Edges[1]);
  const double lengthX = std::sqrt(glm::dot(jx, jx));
  const double lengthY = std::sqrt(glm::dot(jy, jy));
  if (!piece.Wild)
  {
    const double determinant = Cross(jx, jy);
    const double change =
      lengthX * piece.ChangeY + lengthY * piece.ChangeX + piece.ChangeX * piece.ChangeY;
    const double edgeOn =
      64. * Epsilon * glm::length(piece.Around.Edges[0]) * glm::length(piece.Around.Edges[1]);
    if (this->Wanted != 0. ? this->Wanted * determinant + change <= edgeOn
                           : std::abs(determinant) + change <= edgeOn)
    {
      return; // turned away or edge-on throughout
    }
    // Least singular value by the determinant: |det| = least * greatest.
    const double greatest = std::sqrt(lengthX * lengthX + lengthY * lengthY);
    const double varies = std::sqrt(piece.ChangeX * piece.ChangeX + piece.ChangeY * piece.ChangeY);
    if (std::abs(determinant) > 1.5 * varies * greatest && std::abs(determinant) > edgeOn &&
      this->Newton(cell, rect))
    {
      return;
    }
  }
  if (depth >= DeepestPiece)
  {
    this->TakePinched(piece, rect);
    return;
  }
  // Along the direction that keeps the piece from being decided: as the ray sees it.
  const bool alongX = piece.Wild ? rect.X1 - rect.X0 >= rect.Y1 - rect.Y0
                                 : lengthX + piece.ChangeX >= lengthY + piece.ChangeY;
  MesoRect parts[2] = { rect, rect };
  if (alongX)
  {
    parts[0].X1 = parts[1].X0 = 0.5 * (rect.X0 + rect.X1);
  }
  else
  {
    parts[0].Y1 = parts[1].Y0 = 0.5 * (rect.Y0 + rect.Y1);
  }
  this->SolvePiece(cell, parts[0], depth + 1);
  this->SolvePiece(cell, parts[1], depth + 1);
}

void MesoPatchSolver::TakePinched(const Expansion& piece, const MesoRect& rect)
{
  const glm::dvec3 to = piece.Around.Middle - this->Origin;
  const double wide = piece.Around.Ball + glm::length(this->Across(piece.Around.Edges[0])) +
    glm::length(this->Across(piece.Around.Edges[1]));
  const double size = this->LargestPart + LargestPartOf(piece.Around.Middle);
  const double residual = glm::length(this->Across(to)) / size;
  const double turn = glm::dot(piece.Normal, this->Direction) * this->Patch->Orientation();
  const double t = glm::dot(to, this->Direction) * this->PerSquare;
  if (piece.Wild || wide > ResidualLimit * size || residual > ResidualLimit ||
    this->Wanted * turn < 0. || !(t > this->TMin && t < this->TMax))
  {
    return;
  }
  this->TMax = t;
  this->Best = { t, 0.5 * (rect.X0 + rect.X1), 0.5 * (rect.Y0 + rect.Y1),
    turn * this->Patch->Orientation() < 0. };
  this->Found = true;
}

bool MesoPatchSolver::Newton(const Cell& cell, const MesoRect& rect)
{
  const double halfX = 0.5 * (rect.X1 - rect.X0);
  const double halfY = 0.5 * (rect.Y1 - rect.Y0);
  double x = 0.5 * (rect.X0 + rect.X1);
  double y = 0.5 * (rect.Y0 + rect.Y1);
  const double startX = x;
  const double startY = y;
  constexpr int MostSteps = 16;
  double last = std::numeric_limits<double>::infinity();
  for (int step = 0; step < MostSteps; ++step)
  {
    const MesoBasePoint base = this->Patch->At(x, y);
    const Offset at = this->OffsetAt(cell, x, y);
    const glm::dvec3 to = base.P + at.G * base.N - this->Origin;
    const glm::dvec2 f = this->Across(to);
    const double size = this->LargestPart + LargestPartOf(base.P) + std::abs(this->Over.Scale);
    const double residual = std::sqrt(glm::dot(f, f)) / size;
    const glm::dvec2 jx = this->Across(base.Px + at.Gx * base.N + at.G * base.Nx);
    const glm::dvec2 jy = this->Across(base.Py + at.Gy * base.N + at.G * base.Ny);
    const double determinant = Cross(jx, jy);
    // On until rounding is reached: as long as it still halves.
    if (residual <= ResidualLimit && !(residual < 0.5 * last))
    {
      const double widenX = PieceTolerance + 4. * Epsilon * std::abs(x);
      const double widenY = PieceTolerance + 4. * Epsilon * std::abs(y);
      if (x < rect.X0 - widenX || x > rect.X1 + widenX || y < rect.Y0 - widenY ||
        y > rect.Y1 + widenY || !this->Patch->Contains(x, y))
      {
        return true; // the only root there is lies outside
      }
      const double t = glm::dot(to, this->Direction) * this->PerSquare;
      if (t > this->TMin && t < this->TMax)
      {
        this->TMax = t;
        this->Best = { t, x, y, determinant * this->Patch->Orientation() < 0. };
        this->Found = true;
        this->Done.LargestResidual = std::max(this->Done.LargestResidual, residual);
      }
      return true;
    }
    last = residual;
    if (determinant == 0.)
    {
      return false;
    }
    x -= Cross(f, jy) / determinant;
    y -= Cross(jx, f) / determinant;
    // A root of this piece is never further from the middle than a half edge.
    if (!(std::abs(x - startX) <= 4. * halfX && std::abs(y - startY) <= 4. * halfY))
    {
      return false;
    }
  }
  return false;
}
