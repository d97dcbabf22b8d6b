#include "MesoCornerNormals.h"

#include <algorithm>

namespace
{
// Below this sine of all its angles a triangle is a sliver, whose area is held against rounding.
constexpr double SliverSine = 1e-3;
// A mean of unit normals that is shorter is taken to be rounding.
constexpr double ShortestMean = 1e-6;
// Keeps an edge bent by just the feature angle smooth in spite of the rounding of its triangles.
constexpr double CosineRounding = 1e-6;

double AngleBetween(const MesoVector& a, const MesoVector& b)
{
  return std::atan2(MesoLength(MesoCross(a, b)), MesoDot(a, b));
}

MesoTriangleMeasure Measure(const std::array<MesoVector, 3>& p, double rounding)
{
  MesoTriangleMeasure measure;
  // edge[k] is opposite corner k.
  const std::array<MesoVector, 3> edge = { MesoDifference(p[2], p[1]), MesoDifference(p[0], p[2]),
    MesoDifference(p[1], p[0]) };
  const MesoVector normal = MesoCross(edge[2], MesoScaled(edge[1], -1.));
  const double twiceArea = MesoLength(normal);
  std::array<double, 3> length = { MesoLength(edge[0]), MesoLength(edge[1]), MesoLength(edge[2]) };
  std::sort(length.begin(), length.end());
  double largest = 0.;
  for (const MesoVector& position : p)
  {
    for (double component : position)
    {
      largest = std::max(largest, std::abs(component));
    }
  }
  const bool sliver = twiceArea < SliverSine * length[1] * length[2];
  const double noise = sliver ? rounding * largest * (length[1] + length[2]) : 0.;
  if (!(twiceArea > noise) || !std::isfinite(twiceArea))
  {
    return measure;
  }
  measure.Normal = MesoScaled(normal, 1. / twiceArea);
  measure.Area = 0.5 * twiceArea;
  for (std::size_t k = 0; k < 3; ++k)
  {
    measure.Angles[k] = AngleBetween(edge[(k + 2) % 3], MesoScaled(edge[(k + 1) % 3], -1.));
  }
  return measure;
}

class NormalMaker
{
public:
  NormalMaker(const MesoTriangleMesh& mesh, const std::vector<MesoTriangleMeasure>& measures)
    : Mesh(mesh)
    , Measures(measures)
    , Corners(mesh.NumberOfCorners())
  {
  }

  MesoCornerNormals Make(bool split, double featureAngle)
  {
    this->Result.Group.resize(this->Corners);
    if (split)
    {
      this->GroupSmooth(featureAngle);
    }
    else
    {
      for (std::int64_t c = 0; c < this->Corners; ++c)
      {
        this->Result.Group[c] = this->Mesh.VertexOf(c);
      }
    }
    this->Average();
    return std::move(this->Result);
  }

private:
  const MesoTriangleMeasure& MeasureOf(std::int64_t c) const { return this->Measures[c / 3]; }

  void GroupSmooth(double featureAngle)
  {
    MesoCornerSets sets(this->Corners);
    this->JoinAcrossEdges(std::cos(featureAngle * std::acos(-1.) / 180.) - CosineRounding, sets);
    // Corners without area join the first that has one at their point, so as to make no points.
    std::vector<std::int64_t> firstAtPoint(this->Mesh.Positions.size(), -1);
    for (const bool withArea : { true, false })
    {
      for (std::int64_t c = 0; c < this->Corners; ++c)
      {
        if ((this->MeasureOf(c).Area > 0.) == withArea)
        {
          std::int64_t& first = firstAtPoint[this->Mesh.PointOf(c)];
          if (first < 0)
          {
            first = c;
          }
          else if (!withArea)
          {
            sets.Join(first, c);
          }
        }
      }
    }
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      this->Result.Group[c] = sets.Find(c);
    }
  }

  void JoinAcrossEdges(double leastCosine, MesoCornerSets& sets) const
  {
    std::vector<bool> used;
    for (const MesoTriangleMeasure& measure : this->Measures)
    {
      used.push_back(measure.Area > 0.);
    }
    const std::vector<std::int64_t> partner = MesoPairHalfEdges(this->Mesh, used);
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      const std::int64_t other = partner[c];
      if (other < c) // none, or seen from its other side
      {
        continue;
      }
      const std::int64_t next = MesoTriangleMesh::Next(c);
      const std::int64_t otherNext = MesoTriangleMesh::Next(other);
      const bool opposed = this->Mesh.VertexOf(c) == this->Mesh.VertexOf(otherNext);
      if (opposed &&
        MesoDot(this->MeasureOf(c).Normal, this->MeasureOf(other).Normal) >= leastCosine)
      {
        sets.Join(c, otherNext);
        sets.Join(next, other);
      }
    }
  }

  /// Adds up the normals of the groups from `firstGroup` on.
  void Accumulate(std::int64_t firstGroup)
  {
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      const std::int64_t group = this->Result.Group[c];
      const MesoTriangleMeasure& measure = this->MeasureOf(c);
      if (group >= firstGroup && measure.Area > 0.)
      {
        const double angle = measure.Angles[c % 3];
        MesoVector& sum = this->Result.Normals[group];
        sum = MesoSum(sum, MesoScaled(measure.Normal, angle));
        this->Weight[group] += angle;
      }
    }
  }

  bool Normalize(std::int64_t group)
  {
    MesoVector& normal = this->Result.Normals[group];
    const double length = MesoLength(normal);
    if (!(length > ShortestMean * this->Weight[group]))
    {
      return false;
    }
    normal = MesoScaled(normal, 1. / length);
    return true;
  }

  void Average()
  {
    const auto points = static_cast<std::int64_t>(this->Mesh.Positions.size());
    const std::int64_t groups = std::max(this->Corners, points);
    this->Result.Normals.assign(groups, { 0., 0., 0. });
    this->Weight.assign(groups, 0.);
    this->Accumulate(0);
    std::vector<bool> good(groups);
    for (std::int64_t group = 0; group < groups; ++group)
    {
      good[group] = this->Normalize(group);
    }
    bool allGood = true;
    for (std::int64_t& group : this->Result.Group)
    {
      allGood = allGood && good[group];
    }
    if (!allGood)
    {
      this->AveragePoints(good);
    }
  }

  /// Gives the corners of groups that are not good a group for each point.
  void AveragePoints(const std::vector<bool>& good)
  {
    const auto groups = static_cast<std::int64_t>(good.size());
    const auto points = static_cast<std::int64_t>(this->Mesh.Positions.size());
    this->Result.Normals.resize(groups + points, { 0., 0., 0. });
    this->Weight.resize(groups + points, 0.);
    std::vector<std::int64_t> firstTriangle(points, -1);
    for (std::int64_t c = 0; c < this->Corners; ++c)
    {
      std::int64_t& group = this->Result.Group[c];
      if (!good[group])
      {
        const std::int64_t point = this->Mesh.PointOf(c);
        group = groups + point;
        if (firstTriangle[point] < 0 && this->MeasureOf(c).Area > 0.)
        {
          firstTriangle[point] = c / 3;
        }
      }
    }
    this->Accumulate(groups);
    for (std::int64_t point = 0; point < points; ++point)
    {
      if (!this->Normalize(groups + point))
      {
        const std::int64_t triangle = firstTriangle[point];
        this->Result.Normals[groups + point] =
          triangle < 0 ? MesoVector{ 0., 0., 1. } : this->Measures[triangle].Normal;
      }
    }
  }

  const MesoTriangleMesh& Mesh;
  const std::vector<MesoTriangleMeasure>& Measures;
  const std::int64_t Corners;
  std::vector<double> Weight;
  MesoCornerNormals Result;
};
}

std::vector<MesoTriangleMeasure> MesoMeasureTriangles(const MesoTriangleMesh& mesh)
{
  std::vector<MesoTriangleMeasure> measures;
  measures.reserve(mesh.Triangles.size());
  for (const auto& corners : mesh.Triangles)
  {
    measures.push_back(Measure(
      { mesh.Positions[corners[0]], mesh.Positions[corners[1]], mesh.Positions[corners[2]] },
      mesh.PositionRounding));
  }
  return measures;
}

MesoCornerNormals MesoMakeCornerNormals(const MesoTriangleMesh& mesh,
  const std::vector<MesoTriangleMeasure>& measures, bool split, double featureAngle)
{
  return NormalMaker(mesh, measures).Make(split, featureAngle);
}
