#include "MesoPatchSolver.h"

#include "MesoSplineCell.h"

#include <algorithm>
#include <cmath>

namespace
{
MesoRect Overlap(const MesoRect& a, const MesoRect& b)
{
  return { std::max(a.X0, b.X0), std::min(a.X1, b.X1), std::max(a.Y0, b.Y0), std::min(a.Y1, b.Y1) };
}
}

MesoPatchSolver::MesoPatchSolver(
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax)
  : Cells(origin, direction, tMin, tMax)
{
}

bool MesoPatchSolver::Reaches(const MesoRect& rect, double low, double high, double& tLow)
{
  ++this->Cells.Work.Blocks;
  MesoBasePoint middle;
  MesoBaseBends bends;
  this->Patch->Evaluate(rect, middle, bends);
  const double x = 0.5 * (rect.X1 - rect.X0);
  const double y = 0.5 * (rect.Y1 - rect.Y0);
  const double scale = this->Over.Scale;
  const double g = (0.5 * (low + high) - this->Over.Reference) * scale;
  const double half = 0.5 * (high - low) * scale;
  const double most = std::abs(g) + half;

  MesoCellSolver::Enclosure enclosure;
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
  return this->Cells.Touches(enclosure, tLow);
}

bool MesoPatchSolver::FirstHit(const MesoBasePatch& patch, const MesoDisplacement& displacement,
  MesoFacing facing, bool any, MesoPatchHit& hit)
{
  this->Patch = &patch;
  this->Over = displacement;
  this->Cells.Begin(patch, displacement, facing, any);
  const MesoRect& domain = patch.Domain();
  if (!displacement.Map)
  {
    MesoHeightCell level = {};
    level.H[0][0] = displacement.Height;
    this->Cells.Solve(level, domain);
  }
  else
  {
    const MesoHeightPyramid::Axis& x = displacement.Map->X();
    const MesoHeightPyramid::Axis& y = displacement.Map->Y();
    this->VisitTiles(
      x.TileOf(domain.X0), x.TileOf(domain.X1), y.TileOf(domain.Y0), y.TileOf(domain.Y1));
  }
  if (this->Cells.Found())
  {
    hit = this->Cells.Hit();
  }
  return this->Cells.Found();
}

void MesoPatchSolver::VisitTiles(std::int64_t x0, std::int64_t x1, std::int64_t y0, std::int64_t y1)
{
  if (this->Cells.Finished())
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
    if (reached[k] && parts[k].TLow <= this->Cells.GetTMax())
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
      if (!this->Cells.Finished() && this->BlockReached(tileX, tileY, block))
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
  for (int k = 0; k < count && !this->Cells.Finished(); ++k)
  {
    if (children[k].TLow <= this->Cells.GetTMax())
    {
      this->VisitBlock(tileX, tileY, children[k]);
    }
  }
}

void MesoPatchSolver::SolveCell(std::int64_t tileX, std::int64_t tileY, int i, int j)
{
  const MesoHeightPyramid& map = *this->Over.Map;
  const MesoRect rect = this->RectOf(tileX, tileY, 0, i, j);
  double x0 = map.X().High(tileX, i) - 1.; // the upper end is finite but in the last cell of clamp,
  double y0 = map.Y().High(tileY, j) - 1.; // the lower but in the first
  x0 = std::isfinite(x0) ? x0 : map.X().Low(tileX, i);
  y0 = std::isfinite(y0) ? y0 : map.Y().Low(tileY, j);
  if (map.Interpolation() == MesoInterpolation::Bicubic)
  {
    const MesoSplineCell spline(map, i, j, x0, y0);
    for (const MesoRect& part : spline.Parts(rect))
    {
      this->Cells.Solve(spline.Over(part), part);
    }
    return;
  }
  const std::array<double, 4> h = map.Corners(i, j);
  MesoHeightCell cell = {};
  cell.X0 = x0;
  cell.Y0 = y0;
  cell.Degree = 1;
  cell.H[0][0] = h[0];
  cell.H[0][1] = h[1] - h[0];
  cell.H[1][0] = h[2] - h[0];
  cell.H[1][1] = h[3] - h[2] - cell.H[0][1];
  cell.MostXY = std::abs(cell.H[1][1]);
  this->Cells.Solve(cell, rect);
}
