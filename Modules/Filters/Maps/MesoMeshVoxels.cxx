#include "MesoMeshVoxels.h"

#include <algorithm>
#include <cmath>

namespace
{
using Point = MesoMeshVoxels::Point;

constexpr double BandOfSamples = 3.;

Point Minus(const Point& a, const Point& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Point& a, const Point& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double SquareToSegment(const Point& point, const Point& a, const Point& b)
{
  const Point along = Minus(b, a);
  const double length = Dot(along, along);
  const double part = length > 0. ? std::clamp(Dot(Minus(point, a), along) / length, 0., 1.) : 0.;
  const Point off = { point[0] - a[0] - part * along[0], point[1] - a[1] - part * along[1],
    point[2] - a[2] - part * along[2] };
  return Dot(off, off);
}

double SquareToTriangle(const Point& point, const MesoMeshVoxels::Triangle& triangle)
{
  const Point u = Minus(triangle[1], triangle[0]);
  const Point v = Minus(triangle[2], triangle[0]);
  const Point w = Minus(point, triangle[0]);
  const double uu = Dot(u, u);
  const double uv = Dot(u, v);
  const double vv = Dot(v, v);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 0.)
  {
    const double s = (vv * Dot(w, u) - uv * Dot(w, v)) / determinant;
    const double t = (uu * Dot(w, v) - uv * Dot(w, u)) / determinant;
    if (s >= 0. && t >= 0. && s + t <= 1.)
    {
      const Point off = { w[0] - s * u[0] - t * v[0], w[1] - s * u[1] - t * v[1],
        w[2] - s * u[2] - t * v[2] };
      return Dot(off, off);
    }
  }
  return std::min({ SquareToSegment(point, triangle[0], triangle[1]),
    SquareToSegment(point, triangle[1], triangle[2]),
    SquareToSegment(point, triangle[2], triangle[0]) });
}

/// Twice the area of a, b, p in the plane, the same number (but for its sign) in whichever order a and b come,
/// so that two triangles agree about their edge.
double Side(const Point& a, const Point& b, double x, double y)
{
  if (std::pair{ a[0], a[1] } < std::pair{ b[0], b[1] })
  {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
  }
  return -((a[0] - b[0]) * (y - b[1]) - (a[1] - b[1]) * (x - b[0]));
}

/// Whether a point on the edge belongs to the triangle that has it in this direction.
bool Owns(const Point& a, const Point& b)
{
  return std::pair{ a[1], b[0] } < std::pair{ b[1], a[0] };
}

int Wrapped(int i, int period)
{
  const int rest = i % period;
  return rest < 0 ? rest + period : rest;
}
}

MesoMeshVoxels::MesoMeshVoxels(std::array<int, 3> size, double depth)
  : Size(size)
  , Spacing{ 1. / size[0], 1. / size[1], depth / size[2] }
  , Band(BandOfSamples * *std::max_element(this->Spacing.begin(), this->Spacing.end()))
  , Distances(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]),
      static_cast<float>(this->Band))
  , Columns(std::size_t(size[0]) * std::size_t(size[1]))
{
}

void MesoMeshVoxels::Add(const Triangle& triangle)
{
  this->AddCrossings(triangle);
  this->AddDistances(triangle);
}

void MesoMeshVoxels::AddCrossings(const Triangle& triangle)
{
  const auto range = [&](int axis)
  {
    const auto [least, most] =
      std::minmax({ triangle[0][axis], triangle[1][axis], triangle[2][axis] });
    return std::pair{ static_cast<int>(std::ceil(least / this->Spacing[axis] - 0.5)),
      static_cast<int>(std::floor(most / this->Spacing[axis] - 0.5)) };
  };
  const auto [firstI, lastI] = range(0);
  const auto [firstJ, lastJ] = range(1);
  for (int j = firstJ; j <= lastJ; ++j)
  {
    for (int i = firstI; i <= lastI; ++i)
    {
      const double x = (i + 0.5) * this->Spacing[0];
      const double y = (j + 0.5) * this->Spacing[1];
      double area[3];
      int above = 0;
      int below = 0;
      for (int e = 0; e < 3; ++e)
      {
        const Point& a = triangle[(e + 1) % 3];
        const Point& b = triangle[(e + 2) % 3];
        area[e] = Side(a, b, x, y);
        above += area[e] > 0. || (area[e] == 0. && Owns(a, b));
        below += area[e] < 0. || (area[e] == 0. && Owns(b, a));
      }
      const double sum = area[0] + area[1] + area[2];
      if ((above == 3 || below == 3) && sum != 0.)
      {
        const double z =
          (area[0] * triangle[0][2] + area[1] * triangle[1][2] + area[2] * triangle[2][2]) / sum;
        // A triangle that is seen from above, turning left, is a way out.
        this
          ->Columns[std::size_t(Wrapped(j, this->Size[1])) * this->Size[0] +
            Wrapped(i, this->Size[0])]
          .push_back({ z, sum > 0. ? -1 : 1 });
      }
    }
  }
}

void MesoMeshVoxels::AddDistances(const Triangle& triangle)
{
  int first[3];
  int last[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto [least, most] =
      std::minmax({ triangle[0][axis], triangle[1][axis], triangle[2][axis] });
    first[axis] = static_cast<int>(std::ceil((least - this->Band) / this->Spacing[axis] - 0.5));
    last[axis] = static_cast<int>(std::floor((most + this->Band) / this->Spacing[axis] - 0.5));
  }
  first[2] = std::max(first[2], 0);
  last[2] = std::min(last[2], this->Size[2] - 1);
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        const Point point = { (i + 0.5) * this->Spacing[0], (j + 0.5) * this->Spacing[1],
          (k + 0.5) * this->Spacing[2] };
        float& distance =
          this->Distances[(std::size_t(k) * this->Size[1] + Wrapped(j, this->Size[1])) *
              this->Size[0] +
            Wrapped(i, this->Size[0])];
        distance =
          std::min(distance, static_cast<float>(std::sqrt(SquareToTriangle(point, triangle))));
      }
    }
  }
}

std::vector<float> MesoMeshVoxels::Finish() const
{
  std::vector<float> signedDistances = this->Distances;
  const std::size_t slice = this->Columns.size();
  for (std::size_t column = 0; column < slice; ++column)
  {
    std::vector<Crossing> crossings = this->Columns[column];
    std::sort(crossings.begin(), crossings.end(),
      [](const Crossing& a, const Crossing& b) {
        return std::pair{ a.Z, a.Turn } < std::pair{ b.Z, b.Turn };
      });
    std::size_t next = 0;
    int turns = 0;
    for (int k = 0; k < this->Size[2]; ++k)
    {
      const double z = (k + 0.5) * this->Spacing[2];
      for (; next < crossings.size() && crossings[next].Z <= z; ++next)
      {
        turns += crossings[next].Turn;
      }
      float& distance = signedDistances[std::size_t(k) * slice + column];
      distance = turns > 0 ? -distance : distance;
    }
  }
  return signedDistances;
}
