#include "MesoDisplacement.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double Epsilon = std::numeric_limits<double>::epsilon();
constexpr double Roundings = 4.; // that two sides of an edge may differ by

MesoVector Blend(const MesoVector& a, const MesoVector& b, double along)
{
  return MesoSum(a, MesoScaled(MesoDifference(b, a), along));
}

template <typename Tuple>
Tuple Blend(const Tuple& a, const Tuple& b, const Tuple& c, double i, double j)
{
  Tuple result;
  for (std::size_t k = 0; k < result.size(); ++k)
  {
    result[k] = a[k] + i * (b[k] - a[k]) + j * (c[k] - a[k]);
  }
  return result;
}

MesoVector Unit(const MesoVector& a)
{
  const double length = MesoLength(a);
  return length > 0. ? MesoScaled(a, 1. / length) : a;
}

/// Derivatives of a linear function that grows by a and b along two edges.
std::array<MesoVector, 2> Solve(const MesoVector& a, const MesoVector& b,
  const std::array<double, 2>& edgeA, const std::array<double, 2>& edgeB, double area)
{
  return { MesoDifference(MesoScaled(a, edgeB[1] / area), MesoScaled(b, edgeA[1] / area)),
    MesoDifference(MesoScaled(b, edgeA[0] / area), MesoScaled(a, edgeB[0] / area)) };
}
}

MesoDisplacement::MesoDisplacement(const Base& base,
  const MesoKernels::Double::HeightField& heights, std::array<double, 2> tiles, double scale,
  double reference)
  : Mesh(base)
  , Heights(heights)
  , Tiles(tiles)
  , Scale(scale)
  , Reference(reference)
{
}

MesoDisplacement::Derivatives MesoDisplacement::DerivativesOf(std::int64_t triangle) const
{
  const auto& corners = this->Mesh.Mesh.Triangles[triangle];
  std::array<double, 2> edges[2];
  double largest = 0.;
  double length = 0.;
  for (int k = 0; k < 2; ++k)
  {
    const double from = this->Tiles[k] * this->Mesh.Coordinates[corners[0]][k];
    largest = std::max(largest, std::abs(from));
    for (int edge = 0; edge < 2; ++edge)
    {
      const double to = this->Tiles[k] * this->Mesh.Coordinates[corners[edge + 1]][k];
      edges[edge][k] = to - from;
      largest = std::max(largest, std::abs(to));
      length += std::abs(edges[edge][k]);
    }
  }
  const double area = edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0];
  const double rounding = std::max(this->Mesh.CoordinateRounding, Epsilon);
  Derivatives result;
  // The negation takes NaN and overflow along.
  if (!(std::abs(area) > Roundings * rounding * largest * length) || !std::isfinite(area))
  {
    return result;
  }
  result.Valid = true;
  const auto solve = [&](const std::vector<MesoVector>& values)
  {
    return Solve(MesoDifference(values[corners[1]], values[corners[0]]),
      MesoDifference(values[corners[2]], values[corners[0]]), edges[0], edges[1], area);
  };
  result.Position = solve(this->Mesh.Mesh.Positions);
  result.Normal = solve(this->Mesh.Normals);
  return result;
}

MesoBasePoint MesoDisplacement::At(std::int64_t point) const
{
  return { this->Mesh.Mesh.Positions[point], this->Mesh.Normals[point],
    this->Mesh.Coordinates[point] };
}

MesoBasePoint MesoDisplacement::Between(std::int64_t from, std::int64_t to, double along) const
{
  const auto& a = this->Mesh.Coordinates[from];
  const auto& b = this->Mesh.Coordinates[to];
  return { Blend(this->Mesh.Mesh.Positions[from], this->Mesh.Mesh.Positions[to], along),
    Blend(this->Mesh.Normals[from], this->Mesh.Normals[to], along),
    { a[0] + along * (b[0] - a[0]), a[1] + along * (b[1] - a[1]) } };
}

MesoBasePoint MesoDisplacement::Inside(std::int64_t triangle, double i, double j) const
{
  const auto& corners = this->Mesh.Mesh.Triangles[triangle];
  const auto blend = [&](const auto& values)
  { return Blend(values[corners[0]], values[corners[1]], values[corners[2]], i, j); };
  return { blend(this->Mesh.Mesh.Positions), blend(this->Mesh.Normals),
    blend(this->Mesh.Coordinates) };
}

MesoDisplacedPoint MesoDisplacement::Displaced(const MesoBasePoint& base) const
{
  MesoDisplacedPoint point;
  point.UnitNormal = Unit(base.Normal);
  point.MapCoordinate = { base.Coordinate[0] * this->Tiles[0],
    base.Coordinate[1] * this->Tiles[1] };
  point.Height = this->Heights.bilinearHeight({ point.MapCoordinate[0], point.MapCoordinate[1] });
  point.Position = MesoSum(
    base.Position, MesoScaled(point.UnitNormal, (point.Height - this->Reference) * this->Scale));
  return point;
}

std::array<double, 2> MesoDisplacement::Gradient(const MesoDisplacedPoint& point) const
{
  const auto gradient =
    this->Heights.heightGradient({ point.MapCoordinate[0], point.MapCoordinate[1] });
  return { gradient.x, gradient.y };
}

MesoVector MesoDisplacement::ShadingNormal(const Derivatives& triangle, const MesoBasePoint& base,
  const MesoDisplacedPoint& point, const std::array<double, 2>& gradient) const
{
  if (!triangle.Valid)
  {
    return point.UnitNormal;
  }
  const auto vector = [](const MesoVector& v) { return glm::dvec3(v[0], v[1], v[2]); };
  const double length = MesoLength(base.Normal);
  const MesoKernels::Double::Grid kernel;
  const glm::dvec3 normal = kernel.displacedNormal(vector(triangle.Position[0]),
    vector(triangle.Position[1]), vector(point.UnitNormal), vector(triangle.Normal[0]) / length,
    vector(triangle.Normal[1]) / length, { gradient[0], gradient[1] },
    point.Height - this->Reference, this->Scale);
  return { normal.x, normal.y, normal.z };
}

bool MesoDisplacement::Agree(const MesoDisplacedPoint& a, const MesoDisplacedPoint& b) const
{
  const double ofNormals = Roundings * std::max(this->Mesh.NormalRounding, Epsilon);
  for (int k = 0; k < 3; ++k)
  {
    if (!(std::abs(a.UnitNormal[k] - b.UnitNormal[k]) <= ofNormals))
    {
      return false;
    }
  }
  if (a.Height == b.Height)
  {
    return true;
  }
  double allowed = Roundings * Epsilon;
  for (const MesoDisplacedPoint* point : { &a, &b })
  {
    const auto slope =
      this->Heights.patchGradient({ point->MapCoordinate[0], point->MapCoordinate[1] });
    allowed += std::max(this->Mesh.CoordinateRounding, Epsilon) *
      (std::abs(slope.x * point->MapCoordinate[0]) + std::abs(slope.y * point->MapCoordinate[1]));
  }
  return std::abs(a.Height - b.Height) <= Roundings * allowed;
}
