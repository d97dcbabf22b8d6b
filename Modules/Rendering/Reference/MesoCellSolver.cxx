#include "MesoCellSolver.h"

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

double LargestPartOf(const glm::dvec3& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}
}

MesoCellSolver::MesoCellSolver(
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

double MesoCellSolver::Rounding(const glm::dvec3& middle) const
{
  return 32. * Epsilon * (this->LargestPart + LargestPartOf(middle) + std::abs(this->Over.Scale));
}

bool MesoCellSolver::Touches(const Enclosure& enclosure, double& tLow) const
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

void MesoCellSolver::Begin(
  const MesoBasePatch& patch, const MesoDisplacement& displacement, MesoFacing facing, bool any)
{
  this->Patch = &patch;
  this->Over = displacement;
  this->Any = any;
  this->IsFound = false;
  // (qx x qy) . d is the Jacobian's determinant times |d|; fronts have it negative.
  this->Wanted = facing == MesoFacing::Both ? 0.
    : facing == MesoFacing::Front           ? -patch.Orientation()
                                            : patch.Orientation();
}

void MesoCellSolver::Solve(const MesoHeightCell& cell, const MesoRect& rect)
{
  this->Budget = EvaluationLimit;
  this->SolvePiece(cell, rect, 0);
}

MesoCellSolver::Offset MesoCellSolver::OffsetAt(
  const MesoHeightCell& cell, double x, double y) const
{
  const double a = x - cell.X0;
  const double b = y - cell.Y0;
  double height = 0.;
  double perX = 0.;
  double perY = 0.;
  for (int j = cell.Degree; j >= 0; --j)
  {
    double row = 0.;
    double rowPerX = 0.;
    for (int i = cell.Degree; i >= 0; --i)
    {
      rowPerX = rowPerX * a + row;
      row = row * a + cell.H[j][i];
    }
    perY = perY * b + height;
    height = height * b + row;
    perX = perX * b + rowPerX;
  }
  const double scale = this->Over.Scale;
  const double size = std::abs(scale);
  return { (height - this->Over.Reference) * scale, perX * scale, perY * scale, cell.MostXX * size,
    cell.MostXY * size, cell.MostYY * size };
}

MesoCellSolver::Expansion MesoCellSolver::Expand(
  const MesoHeightCell& cell, const MesoRect& rect) const
{
  MesoBasePoint middle;
  MesoBaseBends bends;
  this->Patch->Evaluate(rect, middle, bends);
  const double x = 0.5 * (rect.X1 - rect.X0);
  const double y = 0.5 * (rect.Y1 - rect.Y0);
  const Offset at = this->OffsetAt(cell, 0.5 * (rect.X0 + rect.X1), 0.5 * (rect.Y0 + rect.Y1));
  const double mostGx = std::abs(at.Gx) + at.Gxx * x + at.Gxy * y;
  const double mostGy = std::abs(at.Gy) + at.Gxy * x + at.Gyy * y;
  const double mostG = std::abs(at.G) + mostGx * x + mostGy * y;

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
  const double xx = bends.Pxx + at.Gxx + 2. * mostGx * bends.Nx + mostG * bends.Nxx;
  const double xy = bends.Pxy + at.Gxy + mostGx * bends.Ny + mostGy * bends.Nx + mostG * bends.Nxy;
  const double yy = bends.Pyy + at.Gyy + 2. * mostGy * bends.Ny + mostG * bends.Nyy;
  result.Around.Middle = middle.P + at.G * middle.N;
  result.Around.Edges[0] = x * (middle.Px + at.Gx * middle.N + at.G * middle.Nx);
  result.Around.Edges[1] = y * (middle.Py + at.Gy * middle.N + at.G * middle.Ny);
  result.Around.Ball = 0.5 * (xx * x * x + 2. * xy * x * y + yy * y * y);
  result.ChangeX = xx * x * x + xy * x * y;
  result.ChangeY = yy * y * y + xy * x * y;
  return result;
}

void MesoCellSolver::SolvePiece(const MesoHeightCell& cell, const MesoRect& rect, int depth)
{
  if (this->Finished() || this->Budget < 0 || rect.Empty() || this->Patch->Misses(rect))
  {
    return;
  }
  ++this->Work.Pieces;
  if (--this->Budget < 0)
  {
    ++this->Work.Unresolved;
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

void MesoCellSolver::TakePinched(const Expansion& piece, const MesoRect& rect)
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
  this->IsFound = true;
}

bool MesoCellSolver::Newton(const MesoHeightCell& cell, const MesoRect& rect)
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
        this->IsFound = true;
        this->Work.LargestResidual = std::max(this->Work.LargestResidual, residual);
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
