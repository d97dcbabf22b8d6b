#include "MesoTriangulate.h"

#include <algorithm>
#include <cmath>

namespace
{
using Point3 = std::array<double, 3>;
using Point2 = std::array<double, 2>;

Point3 Difference(const Point3& a, const Point3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Point3 Cross(const Point3& a, const Point3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

double Dot(const Point3& a, const Point3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The polygon moved to its first corner and scaled to size 1, so that thresholds are relative.
std::vector<Point3> Normalised(const std::vector<Point3>& corners)
{
  double size = 0.;
  for (const Point3& corner : corners)
  {
    for (double component : Difference(corner, corners[0]))
    {
      size = std::max(size, std::abs(component));
    }
  }
  const double factor = size > 0. ? 1. / size : 0.;
  std::vector<Point3> result;
  result.reserve(corners.size());
  for (const Point3& corner : corners)
  {
    const Point3 d = Difference(corner, corners[0]);
    result.push_back({ d[0] * factor, d[1] * factor, d[2] * factor });
  }
  return result;
}

/// Twice the vector area; unit length unless the polygon has no area.
Point3 NewellNormal(const std::vector<Point3>& corners)
{
  Point3 normal = { 0., 0., 0. };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point3 cross = Cross(corners[i], corners[(i + 1) % corners.size()]);
    for (int k = 0; k < 3; ++k)
    {
      normal[k] += cross[k];
    }
  }
  const double length = std::sqrt(Dot(normal, normal));
  if (length > 0.)
  {
    for (double& component : normal)
    {
      component /= length;
    }
  }
  return normal;
}

constexpr double LeastArea = 1e-12;

bool CutQuad(const std::vector<Point3>& p, std::vector<int>& triangles)
{
  const Point3 normal = NewellNormal(p);
  const auto area = [&](int a, int b, int c)
  { return Dot(Cross(Difference(p[b], p[a]), Difference(p[c], p[a])), normal); };
  const double least02 = std::min(area(0, 1, 2), area(0, 2, 3));
  const double least13 = std::min(area(0, 1, 3), area(1, 2, 3));
  const bool good02 = least02 > LeastArea;
  const bool good13 = least13 > LeastArea;
  bool along02 = least02 >= least13;
  if (good02 && good13)
  {
    const Point3 d02 = Difference(p[2], p[0]);
    const Point3 d13 = Difference(p[3], p[1]);
    // Rounding must not decide between diagonals that are meant to be equal.
    along02 = Dot(d02, d02) <= Dot(d13, d13) * (1. + 1e-6);
  }
  if (along02)
  {
    triangles.insert(triangles.end(), { 0, 1, 2, 0, 2, 3 });
  }
  else
  {
    triangles.insert(triangles.end(), { 0, 1, 3, 1, 2, 3 });
  }
  return good02 || good13;
}

/// Ear clipping of a polygon in its plane, over a ring of the corners that are left.
class EarClipper
{
public:
  explicit EarClipper(const std::vector<Point3>& corners)
  {
    const Point3 n = NewellNormal(corners);
    const Point3 helper = std::abs(n[0]) < 0.6 ? Point3{ 1., 0., 0. } : Point3{ 0., 1., 0. };
    Point3 s = Cross(helper, n);
    const double length = std::sqrt(Dot(s, s));
    for (double& component : s)
    {
      component = length > 0. ? component / length : 0.;
    }
    const Point3 t = Cross(n, s);
    const int count = static_cast<int>(corners.size());
    for (int i = 0; i < count; ++i)
    {
      this->Corners.push_back({ Dot(corners[i], s), Dot(corners[i], t) });
      this->Previous.push_back((i + count - 1) % count);
      this->Next.push_back((i + 1) % count);
    }
  }

  bool Cut(std::vector<int>& triangles)
  {
    bool isSound = true;
    int candidate = 1;
    int left = static_cast<int>(this->Corners.size());
    int tried = 0;
    while (left > 3)
    {
      if (tried < left && !this->IsEar(candidate))
      {
        candidate = this->Next[candidate];
        ++tried;
        continue;
      }
      if (tried == left)
      {
        isSound = false; // no ear is left: the polygon crosses itself or has lost its area
        candidate = this->WidestCorner(candidate);
      }
      triangles.insert(
        triangles.end(), { this->Previous[candidate], candidate, this->Next[candidate] });
      this->Next[this->Previous[candidate]] = this->Next[candidate];
      this->Previous[this->Next[candidate]] = this->Previous[candidate];
      // Going on beyond the neighbour keeps fans from gathering at one corner.
      candidate = this->Next[this->Next[candidate]];
      --left;
      tried = 0;
    }
    triangles.insert(
      triangles.end(), { this->Previous[candidate], candidate, this->Next[candidate] });
    return isSound && this->AreaAt(candidate) > LeastArea;
  }

private:
  static double Area(const Point2& a, const Point2& b, const Point2& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  double AreaAt(int i) const
  {
    return Area(this->Corners[this->Previous[i]], this->Corners[i], this->Corners[this->Next[i]]);
  }

  bool IsEar(int i) const
  {
    if (this->AreaAt(i) <= LeastArea)
    {
      return false;
    }
    const Point2& a = this->Corners[this->Previous[i]];
    const Point2& b = this->Corners[i];
    const Point2& c = this->Corners[this->Next[i]];
    for (int j = this->Next[this->Next[i]]; j != this->Previous[i]; j = this->Next[j])
    {
      const Point2& p = this->Corners[j];
      if (p == a || p == b || p == c)
      {
        continue;
      }
      if (Area(a, b, p) >= 0. && Area(b, c, p) >= 0. && Area(c, a, p) >= 0.)
      {
        return false;
      }
    }
    return true;
  }

  int WidestCorner(int start) const
  {
    int widest = start;
    for (int i = this->Next[start]; i != start; i = this->Next[i])
    {
      widest = this->AreaAt(i) > this->AreaAt(widest) ? i : widest;
    }
    return widest;
  }

  std::vector<Point2> Corners;
  std::vector<int> Previous;
  std::vector<int> Next;
};
}

bool MesoTriangulate(const std::vector<std::array<double, 3>>& corners, std::vector<int>& triangles)
{
  if (corners.size() < 3)
  {
    return false;
  }
  if (corners.size() == 3)
  {
    triangles.insert(triangles.end(), { 0, 1, 2 });
    const auto p = Normalised(corners);
    const Point3 cross = Cross(p[1], p[2]); // the first corner is the origin
    return std::sqrt(Dot(cross, cross)) > LeastArea;
  }
  const auto p = Normalised(corners);
  return p.size() == 4 ? CutQuad(p, triangles) : EarClipper(p).Cut(triangles);
}
