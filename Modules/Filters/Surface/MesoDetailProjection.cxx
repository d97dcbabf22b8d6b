#include "MesoDetailProjection.h"

#include <algorithm>

namespace
{
glm::dvec3 ToGlm(const MesoVector& v)
{
  return { v[0], v[1], v[2] };
}

/// Collects every crossing of the outer side.
class AllCrossings : public MesoRayQuery
{
public:
  std::vector<std::int64_t> Triangles;

  void Test(int, unsigned int) override {}
  bool TestTriangle(int, unsigned int primitive, double, bool front) override
  {
    if (!front) // seen from within: the ray leaves through it
    {
      this->Triangles.push_back(primitive);
    }
    return false;
  }
};
}

MesoDetailProjection::MesoDetailProjection(const MesoTriangleMesh& detail)
  : Detail(detail)
{
  std::vector<glm::dvec3> points;
  points.reserve(detail.Positions.size());
  for (const MesoVector& position : detail.Positions)
  {
    points.push_back(ToGlm(position));
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangles.reserve(detail.Triangles.size());
  for (const auto& triangle : detail.Triangles)
  {
    triangles.push_back({ static_cast<std::uint32_t>(triangle[0]),
      static_cast<std::uint32_t>(triangle[1]), static_cast<std::uint32_t>(triangle[2]) });
  }
  this->Rays.AddTriangles(points, std::move(triangles));
  this->Rays.Commit();
}

std::optional<MesoDetailProjection::Hit> MesoDetailProjection::Find(
  const MesoVector& from, const MesoVector& direction, double reach) const
{
  AllCrossings query;
  query.Origin = ToGlm(MesoSum(from, MesoScaled(direction, -reach)));
  query.Direction = ToGlm(direction);
  query.TMin = 0.;
  query.TMax = 2. * reach;
  this->Rays.Trace(query);

  std::optional<Hit> nearest;
  std::vector<double> distances;
  for (const std::int64_t triangle : query.Triangles)
  {
    const auto& corners = this->Detail.Triangles[triangle];
    const MesoVector a = MesoDifference(this->Detail.Positions[corners[0]], from);
    const MesoVector b = MesoDifference(this->Detail.Positions[corners[1]], from);
    const MesoVector c = MesoDifference(this->Detail.Positions[corners[2]], from);
    const MesoVector normal = MesoCross(MesoDifference(b, a), MesoDifference(c, a));
    const double slope = MesoDot(normal, direction);
    if (!(slope > 0.))
    {
      continue; // edge on
    }
    const double distance = MesoDot(normal, a) / slope;
    if (!(std::abs(distance) <= reach))
    {
      continue;
    }
    distances.push_back(distance);
    if (!nearest || std::abs(distance) < std::abs(nearest->Distance))
    {
      // Volumes with the direction: of equal sign where it passes through the triangle.
      std::array<double, 3> weights = { MesoDot(direction, MesoCross(b, c)),
        MesoDot(direction, MesoCross(c, a)), MesoDot(direction, MesoCross(a, b)) };
      double sum = 0.;
      for (double& weight : weights)
      {
        weight = std::max(weight, 0.); // float took a hit just beside an edge
        sum += weight;
      }
      for (double& weight : weights)
      {
        weight = sum > 0. ? weight / sum : 1. / 3.;
      }
      nearest = Hit{ distance, triangle, weights, 0 };
    }
  }
  if (nearest)
  {
    // Neighbours both have a crossing on their common edge.
    std::sort(distances.begin(), distances.end());
    const double same = 4. * this->Rays.Rounding();
    nearest->Crossings = 1;
    for (std::size_t i = 1; i < distances.size(); ++i)
    {
      nearest->Crossings += distances[i] - distances[i - 1] > same ? 1 : 0;
    }
  }
  return nearest;
}
