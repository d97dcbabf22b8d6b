#include "MesoBasePatch.h"

#include <algorithm>
#include <cmath>

namespace
{
// Neighbouring patches overlap by this part of themselves, so that no ray slips between.
constexpr double EdgeTolerance = 1e-11;

glm::dvec3 ToVector(const std::array<double, 3>& values)
{
  return { values[0], values[1], values[2] };
}

/// Greatest value of an affine function on a rectangle.
double Greatest(double middle, const glm::dvec2& slope, double halfX, double halfY)
{
  return middle + std::abs(slope.x) * halfX + std::abs(slope.y) * halfY;
}
}

MesoBasePoint MesoBasePatch::At(double x, double y) const
{
  MesoBasePoint point;
  MesoBaseBends bends;
  this->Evaluate({ x, x, y, y }, point, bends);
  return point;
}

bool MesoTrianglePatch::Spans(const std::array<glm::dvec2, 3>& places)
{
  const glm::dvec2 a = places[1] - places[0];
  const glm::dvec2 b = places[2] - places[0];
  const double longest = std::max({ glm::dot(a, a), glm::dot(b, b), glm::dot(b - a, b - a) });
  const double area = std::abs(a.x * b.y - a.y * b.x);
  return area > 1e-9 * longest && std::isfinite(longest); // false for NaN
}

MesoTrianglePatch::MesoTrianglePatch(const std::array<glm::dvec3, 3>& positions,
  const std::array<glm::dvec3, 3>& normals, const std::array<glm::dvec2, 3>& places, bool mirrored)
  : Start(places[0])
  , P0(positions[0])
  , M0(normals[0])
{
  const glm::dvec2 a = places[1] - places[0];
  const glm::dvec2 b = places[2] - places[0];
  const double area = a.x * b.y - a.y * b.x;
  this->Weight1 = glm::dvec2(b.y, -b.x) / area;
  this->Weight2 = glm::dvec2(-a.y, a.x) / area;
  const auto along = [&](const std::array<glm::dvec3, 3>& corners, int k)
  {
    return (corners[1] - corners[0]) * this->Weight1[k] +
      (corners[2] - corners[0]) * this->Weight2[k];
  };
  this->Px = along(positions, 0);
  this->Py = along(positions, 1);
  this->Mx = along(normals, 0);
  this->My = along(normals, 1);
  this->Sign = (area > 0.) != mirrored ? 1. : -1.;
  const auto x = std::minmax({ places[0].x, places[1].x, places[2].x });
  const auto y = std::minmax({ places[0].y, places[1].y, places[2].y });
  const double widen = EdgeTolerance * (x.second - x.first + y.second - y.first);
  this->Around = { x.first - widen, x.second + widen, y.first - widen, y.second + widen };
}

void MesoTrianglePatch::Evaluate(
  const MesoRect& rect, MesoBasePoint& middle, MesoBaseBends& bends) const
{
  const double x = 0.5 * (rect.X0 + rect.X1) - this->Start.x;
  const double y = 0.5 * (rect.Y0 + rect.Y1) - this->Start.y;
  middle.P = this->P0 + x * this->Px + y * this->Py;
  middle.Px = this->Px;
  middle.Py = this->Py;
  const glm::dvec3 m = this->M0 + x * this->Mx + y * this->My;
  const double length = glm::length(m);
  const double perLength = length > 0. ? 1. / length : 0.;
  middle.N = m * perLength;
  middle.Nx = (this->Mx - middle.N * glm::dot(middle.N, this->Mx)) * perLength;
  middle.Ny = (this->My - middle.N * glm::dot(middle.N, this->My)) * perLength;

  // With N = m / |m| and m linear: |N_x| <= |m_x| / |m|, |N_xy| <= 3 |m_x| |m_y| / |m|^2.
  const double alongX = glm::length(this->Mx);
  const double alongY = glm::length(this->My);
  const double least = length - 0.5 * (alongX * (rect.X1 - rect.X0) + alongY * (rect.Y1 - rect.Y0));
  bends = MesoBaseBends();
  bends.Wild = !(least > 0.1 * length);
  if (!bends.Wild)
  {
    bends.Nx = alongX / least;
    bends.Ny = alongY / least;
    bends.Nxx = 3. * bends.Nx * bends.Nx;
    bends.Nxy = 3. * bends.Nx * bends.Ny;
    bends.Nyy = 3. * bends.Ny * bends.Ny;
  }
}

glm::dvec3 MesoTrianglePatch::Weights(double x, double y) const
{
  const glm::dvec2 from = glm::dvec2(x, y) - this->Start;
  const double second = glm::dot(this->Weight1, from);
  const double third = glm::dot(this->Weight2, from);
  return { 1. - second - third, second, third };
}

bool MesoTrianglePatch::Misses(const MesoRect& rect) const
{
  const glm::dvec3 weights = this->Weights(0.5 * (rect.X0 + rect.X1), 0.5 * (rect.Y0 + rect.Y1));
  const double halfX = 0.5 * (rect.X1 - rect.X0);
  const double halfY = 0.5 * (rect.Y1 - rect.Y0);
  return Greatest(weights.x, this->Weight1 + this->Weight2, halfX, halfY) < -EdgeTolerance ||
    Greatest(weights.y, this->Weight1, halfX, halfY) < -EdgeTolerance ||
    Greatest(weights.z, this->Weight2, halfX, halfY) < -EdgeTolerance;
}

bool MesoTrianglePatch::Contains(double x, double y) const
{
  const glm::dvec3 weights = this->Weights(x, y);
  return std::min({ weights.x, weights.y, weights.z }) >= -EdgeTolerance;
}

MesoBox MesoTrianglePatch::Bounds(const glm::dmat4& matrix, double low, double high) const
{
  // Corner 1 lies where the weights are (0, 1, 0): found back from their slopes.
  const double area =
    this->Weight1.x * this->Weight2.y - this->Weight1.y * this->Weight2.x; // 1 / the places'
  const glm::dvec2 steps[3] = { { 0., 0. }, glm::dvec2(this->Weight2.y, -this->Weight2.x) / area,
    glm::dvec2(-this->Weight1.y, this->Weight1.x) / area };
  MesoBox box;
  glm::dvec3 normals[3];
  glm::dvec3 mean(0.);
  for (int k = 0; k < 3; ++k)
  {
    const glm::dvec3 corner =
      glm::dvec3(matrix * glm::dvec4(this->P0 + steps[k].x * this->Px + steps[k].y * this->Py, 1.));
    box.Low = k == 0 ? corner : glm::min(box.Low, corner);
    box.High = k == 0 ? corner : glm::max(box.High, corner);
    normals[k] = this->M0 + steps[k].x * this->Mx + steps[k].y * this->My;
    mean += normals[k] / 3.;
  }
  // All m lie within `spread` of their mean, so N lies within this of the mean's direction: for
  // vectors of length >= least, |a/|a| - b/|b|| <= |a - b| / least.
  double spread = 0.;
  for (const glm::dvec3& normal : normals)
  {
    spread = std::max(spread, glm::length(normal - mean));
  }
  const double length = glm::length(mean);
  const bool known = length > 0. && length > spread;
  const glm::dvec3 direction = known ? mean / length : glm::dvec3(0.);
  const double off = known ? std::min(2., spread / (length - spread)) : 1.;
  const glm::dmat3 linear(matrix);
  const glm::dvec3 ends[2] = { linear * (low * direction), linear * (high * direction) };
  const double reach = std::max(std::abs(low), std::abs(high)) * off;
  const glm::dmat3 rows = glm::transpose(linear);
  for (int k = 0; k < 3; ++k)
  {
    const double around = glm::length(rows[k]) * reach;
    box.Low[k] += std::min(ends[0][k], ends[1][k]) - around;
    box.High[k] += std::max(ends[0][k], ends[1][k]) + around;
  }
  return box;
}

MesoShapePatch::MesoShapePatch(
  const MesoShape& shape, const MesoRect& rect, double perX, double perY)
  : Shape(shape)
  , PerX(perX)
  , PerY(perY)
{
  this->Around = rect;
}

void MesoShapePatch::Evaluate(
  const MesoRect& rect, MesoBasePoint& middle, MesoBaseBends& bends) const
{
  const double u = this->PerX * (0.5 * (rect.X0 + rect.X1) + 0.5);
  const double v = this->PerY * (0.5 * (rect.Y0 + rect.Y1) + 0.5);
  const double halfU = 0.5 * this->PerX * (rect.X1 - rect.X0);
  const double halfV = 0.5 * this->PerY * (rect.Y1 - rect.Y0);
  const MesoShapePoint point = this->Shape.At(u, v);
  const MesoShapeBends shape = this->Shape.BendsAround(point, u, v, halfU, halfV);
  const double xx = this->PerX * this->PerX;
  const double xy = this->PerX * this->PerY;
  const double yy = this->PerY * this->PerY;
  middle.P = ToVector(point.Position);
  middle.N = ToVector(point.Normal);
  middle.Px = this->PerX * point.Scale[0] * ToVector(point.Tangent);
  middle.Py = this->PerY * point.Scale[1] * ToVector(point.Bitangent);
  middle.Nx = this->PerX * ToVector(shape.NormalU);
  middle.Ny = this->PerY * ToVector(shape.NormalV);
  bends = MesoBaseBends();
  bends.Pxx = xx * shape.Puu;
  bends.Pxy = xy * shape.Puv;
  bends.Pyy = yy * shape.Pvv;
  bends.Nx = this->PerX * shape.Nu;
  bends.Ny = this->PerY * shape.Nv;
  bends.Nxx = xx * shape.Nuu;
  bends.Nxy = xy * shape.Nuv;
  bends.Nyy = yy * shape.Nvv;
}

glm::dvec3 MesoShapePatch::Weights(double, double) const
{
  return glm::dvec3(0.);
}

bool MesoShapePatch::Misses(const MesoRect& rect) const
{
  return rect.X1 < this->Around.X0 || rect.X0 > this->Around.X1 || rect.Y1 < this->Around.Y0 ||
    rect.Y0 > this->Around.Y1;
}

bool MesoShapePatch::Contains(double x, double y) const
{
  const double widen =
    EdgeTolerance * (1. + this->Around.X1 - this->Around.X0 + this->Around.Y1 - this->Around.Y0);
  return x >= this->Around.X0 - widen && x <= this->Around.X1 + widen &&
    y >= this->Around.Y0 - widen && y <= this->Around.Y1 + widen;
}

MesoBox MesoShapePatch::Bounds(const glm::dmat4& matrix, double low, double high) const
{
  MesoBasePoint middle;
  MesoBaseBends bends;
  this->Evaluate(this->Around, middle, bends);
  const double x = 0.5 * (this->Around.X1 - this->Around.X0);
  const double y = 0.5 * (this->Around.Y1 - this->Around.Y0);
  const double reach = std::max(std::abs(low), std::abs(high));
  // Taylor about the middle; what is of second order goes into a ball, as does N's change.
  const double ball = 0.5 * (bends.Pxx * x * x + 2. * bends.Pxy * x * y + bends.Pyy * y * y) +
    reach * std::min(2., bends.Nx * x + bends.Ny * y);
  const glm::dmat3 linear(matrix);
  const glm::dmat3 rows = glm::transpose(linear);
  const glm::dvec3 centre =
    glm::dvec3(matrix * glm::dvec4(middle.P + 0.5 * (low + high) * middle.N, 1.));
  const glm::dvec3 half = glm::abs(linear * (x * middle.Px)) + glm::abs(linear * (y * middle.Py)) +
    glm::abs(linear * (0.5 * (high - low) * middle.N)) +
    ball * glm::dvec3(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
  return { centre - half, centre + half };
}
