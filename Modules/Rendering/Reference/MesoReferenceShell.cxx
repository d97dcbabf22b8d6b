#include "MesoReferenceShell.h"

#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace
{
using Place = std::tuple<double, double, double>;

Place PlaceOf(const glm::dvec3& point)
{
  return { point.x, point.y, point.z };
}

/// How a triangle sees an edge: its corners, in the order of their places.
struct Side
{
  std::size_t Triangle;
  int Edge;
  std::uint32_t First;
  std::uint32_t Second;
};
}

MesoReferenceShell::MesoReferenceShell(
  const Base& base, double thickness, double reference, vtkImageData* volume)
  : Mesh(base)
  , Thickness(thickness)
  , Reference(reference)
  , Volume(volume)
{
  this->FindEnds();
}

void MesoReferenceShell::FindEnds()
{
  this->Ends.assign(this->Mesh.Triangles.size(), 7);
  std::map<std::pair<Place, Place>, std::vector<Side>> edges;
  for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      Side side = { i, k, this->Mesh.Triangles[i][k], this->Mesh.Triangles[i][(k + 1) % 3] };
      Place first = PlaceOf(this->Mesh.Points[side.First]);
      Place second = PlaceOf(this->Mesh.Points[side.Second]);
      if (second < first)
      {
        std::swap(first, second);
        std::swap(side.First, side.Second);
      }
      edges[{ first, second }].push_back(side);
    }
  }
  const auto same = [&](std::uint32_t a, std::uint32_t b, glm::dvec2& tiles)
  {
    constexpr double rounding = 1e-4;
    const glm::dvec2 step = this->Mesh.Coordinates[b] - this->Mesh.Coordinates[a];
    tiles = glm::round(step);
    const glm::dvec2 rest = glm::abs(step - tiles);
    return glm::length(glm::normalize(this->Mesh.Normals[a]) -
             glm::normalize(this->Mesh.Normals[b])) < 2e-5 &&
      rest.x <= rounding && rest.y <= rounding;
  };
  for (const auto& edge : edges)
  {
    const std::vector<Side>& sides = edge.second;
    glm::dvec2 first;
    glm::dvec2 second;
    if (sides.size() == 2 && same(sides[0].First, sides[1].First, first) &&
      same(sides[0].Second, sides[1].Second, second) && first == second)
    {
      for (const Side& side : sides)
      {
        this->Ends[side.Triangle] &= static_cast<std::uint8_t>(~(1u << side.Edge));
      }
    }
  }
}

MesoTruePrism MesoReferenceShell::PrismOf(std::size_t triangle) const
{
  MesoTruePrism prism;
  for (int k = 0; k < 3; ++k)
  {
    const std::uint32_t corner = this->Mesh.Triangles[triangle][k];
    prism.Rise[k] = this->Thickness * glm::normalize(this->Mesh.Normals[corner]);
    prism.Bottom[k] = this->Mesh.Points[corner] - this->Reference * prism.Rise[k];
    prism.Map[k] = this->Mesh.Coordinates[corner];
  }
  return prism;
}

MesoBox MesoReferenceShell::BoundsOf(std::size_t triangle, const glm::dmat4& matrix) const
{
  // The fins are ruled, so that the corners span the prism.
  const MesoTruePrism prism = this->PrismOf(triangle);
  MesoBox box = { glm::dvec3(std::numeric_limits<double>::infinity()),
    glm::dvec3(-std::numeric_limits<double>::infinity()) };
  for (int k = 0; k < 3; ++k)
  {
    for (const double z : { 0., 1. })
    {
      const glm::dvec3 corner(matrix * glm::dvec4(prism.Bottom[k] + z * prism.Rise[k], 1.));
      if (!std::isfinite(corner.x + corner.y + corner.z))
      {
        const glm::dvec3 none(std::numeric_limits<double>::quiet_NaN());
        return { none, none };
      }
      box.Low = glm::min(box.Low, corner);
      box.High = glm::max(box.High, corner);
    }
  }
  return box;
}

MesoReferenceShell::Point MesoReferenceShell::Describe(
  std::size_t triangle, const MesoPrismHit& hit, const glm::dvec3& ray) const
{
  const MesoTruePrism prism = this->PrismOf(triangle);
  const glm::dvec3 chart = prism.ChartAt(hit.Place);
  const glm::dmat3 toPlace = glm::inverse(prism.Jacobian(hit.Place));
  const auto normalOf = [&](const glm::dvec3& gradient)
  { return glm::transpose(toPlace) * gradient; };
  const glm::dmat3 ofChart = glm::transpose(prism.ChartJacobian());
  Point point;
  point.MapCoord = glm::dvec2(chart);
  point.Relief = glm::clamp(1. - chart.z, 0., 1.);
  point.Color = this->Volume.ColorAt(chart);
  const bool cut = hit.Cut >= 0 && (hit.Cut < 2 || ((this->Ends[triangle] >> (hit.Cut - 2)) & 1));
  if (hit.Cut == -2)
  {
    point.Geometric = -ray;
    point.Shading = -ray;
  }
  else if (cut)
  {
    // Outward, where the weight or the height that ends there grows no more.
    const glm::dvec3 outward[] = { { 0., 0., -1. }, { 0., 0., 1. }, { 0., -1., 0. }, { 1., 1., 0. },
      { -1., 0., 0. } };
    point.Geometric = normalOf(outward[hit.Cut]);
    point.Shading = point.Geometric;
  }
  else
  {
    point.Geometric = normalOf(ofChart * this->Volume.Gradient(chart));
    point.Shading = normalOf(ofChart * this->Volume.SmoothGradient(chart));
  }
  const std::array<int, 3>& size = this->Volume.Field().GetSize();
  point.VoxelSize = this->Thickness / size[2];
  for (int k = 0; k < 3; ++k)
  {
    const int next = (k + 1) % 3;
    const glm::dvec2 step =
      (prism.Map[next] - prism.Map[k]) * glm::dvec2(size[0], size[1]); // in voxels
    const double voxels = glm::length(step);
    if (voxels > 0.)
    {
      point.VoxelSize =
        std::min(point.VoxelSize, glm::length(prism.Bottom[next] - prism.Bottom[k]) / voxels);
    }
  }
  return point;
}

std::size_t MesoReferenceShell::MemoryBytes() const
{
  return this->Volume.Field().GetValues().size() * sizeof(float) + this->Ends.size();
}
