#ifndef CurvedMeshes_h
#define CurvedMeshes_h

#include "SurfaceArrays.h"

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <string>

/// A mesh whose points lie on a smooth surface, with the surface's own curvatures at each.
struct CurvedMesh
{
  vtkSmartPointer<vtkPolyData> Mesh;             ///< doubles, points and triangles only
  std::vector<std::array<double, 2>> Curvatures; ///< c_max, c_min
  std::vector<MesoVector> Directions;            ///< of c_max, unit; only where the two differ
  std::vector<bool> Border;

  double Largest() const
  {
    double largest = 0.;
    for (const auto& c : this->Curvatures)
    {
      largest = std::max({ largest, std::abs(c[0]), std::abs(c[1]) });
    }
    return largest;
  }
};

struct CurvedPoint
{
  MesoVector Position;
  double Maximum;
  double Minimum;
  MesoVector Direction;
};

/// At (u, v) in [0,1] x [0,1].
using CurvedSurface = std::function<CurvedPoint(double u, double v)>;

/// What a graph z = f(x, y) over [-1,1] x [-1,1] has, from f and its derivatives.
inline CurvedPoint GraphPoint(
  double x, double y, double z, double fx, double fy, double fxx, double fxy, double fyy)
{
  // Eigenvectors of I^-1 II, in the basis (1, 0, fx), (0, 1, fy), with the sign turned over.
  const double root = std::sqrt(1. + fx * fx + fy * fy);
  const double E = 1. + fx * fx;
  const double F = fx * fy;
  const double G = 1. + fy * fy;
  const double e = -fxx / root;
  const double f = -fxy / root;
  const double g = -fyy / root;
  const double det = E * G - F * F;
  const double K = (e * g - f * f) / det;
  const double H = (e * G - 2. * f * F + g * E) / (2. * det);
  const double d = std::sqrt(std::max(0., H * H - K));
  const double c = H + d;
  // (e - c E) a + (f - c F) b = 0 or (f - c F) a + (g - c G) b = 0, whichever is longer.
  std::array<double, 2> t = { f - c * F, c * E - e };
  const std::array<double, 2> other = { c * G - g, f - c * F };
  t = std::hypot(t[0], t[1]) > std::hypot(other[0], other[1]) ? t : other;
  MesoVector direction = { t[0], t[1], t[0] * fx + t[1] * fy };
  const double length = MesoLength(direction);
  direction = length > 0. ? MesoScaled(direction, 1. / length) : MesoVector{ 1., 0., 0. };
  return { { x, y, z }, c, H - d, direction };
}

inline CurvedSurface SurfaceNamed(const std::string& name)
{
  const double pi = std::acos(-1.);
  if (name == "plane")
  {
    return [](double u, double v)
    { return GraphPoint(2. * u - 1., 2. * v - 1., 0., 0., 0., 0., 0., 0.); };
  }
  if (name == "saddle")
  {
    return [](double u, double v)
    {
      const double x = 2. * u - 1.;
      const double y = 2. * v - 1.;
      return GraphPoint(x, y, x * x - y * y, 2. * x, -2. * y, 2., 0., -2.);
    };
  }
  if (name == "monkey saddle")
  {
    return [](double u, double v)
    {
      const double x = 2. * u - 1.;
      const double y = 2. * v - 1.;
      return GraphPoint(x, y, x * x * x - 3. * x * y * y, 3. * (x * x - y * y), -6. * x * y, 6. * x,
        -6. * y, -6. * x);
    };
  }
  if (name == "cylinder")
  {
    return [pi](double u, double v)
    {
      const double a = 2. * pi * u;
      return CurvedPoint{ { std::cos(a), std::sin(a), 4. * v - 2. }, 1., 0.,
        { -std::sin(a), std::cos(a), 0. } };
    };
  }
  return [pi](double u, double v) // torus, R = 1, r = 0.4
  {
    const double a = 2. * pi * u;
    const double b = 2. * pi * v;
    const double w = 1. + 0.4 * std::cos(b);
    return CurvedPoint{ { w * std::cos(a), w * std::sin(a), 0.4 * std::sin(b) }, 2.5,
      std::cos(b) / w, { -std::sin(b) * std::cos(a), -std::sin(b) * std::sin(a), std::cos(b) } };
  };
}

/// `nu` x `nv` squares, each cut in two; points jittered by up to `jitter` of a square.
inline CurvedMesh SampleSurface(
  const CurvedSurface& surface, int nu, int nv, bool closedU, bool closedV, double jitter)
{
  CurvedMesh result;
  std::mt19937 random(7);
  const auto shift = [&]()
  { return jitter * (2. * static_cast<double>(random()) / 4294967295. - 1.); };
  const int pu = closedU ? nu : nu + 1;
  const int pv = closedV ? nv : nv + 1;
  std::vector<MesoVector> positions;
  for (int j = 0; j < pv; ++j)
  {
    for (int i = 0; i < pu; ++i)
    {
      const bool edgeU = !closedU && (i == 0 || i == nu);
      const bool edgeV = !closedV && (j == 0 || j == nv);
      const double du = shift();
      const double dv = shift();
      const CurvedPoint p = surface((i + (edgeU ? 0. : du)) / nu, (j + (edgeV ? 0. : dv)) / nv);
      positions.push_back(p.Position);
      result.Curvatures.push_back({ p.Maximum, p.Minimum });
      result.Directions.push_back(p.Direction);
      result.Border.push_back(edgeU || edgeV);
    }
  }
  std::vector<std::vector<vtkIdType>> cells;
  for (int j = 0; j < nv; ++j)
  {
    for (int i = 0; i < nu; ++i)
    {
      const auto at = [&](int a, int b) { return vtkIdType(b % pv) * pu + a % pu; };
      // Jittered meshes have their diagonals at random.
      const bool turn = jitter > 0. && (random() & 1u) != 0u;
      const std::array<vtkIdType, 4> q = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
      const int s = turn ? 1 : 0;
      cells.push_back({ q[s], q[s + 1], q[s + 2] });
      cells.push_back({ q[s], q[s + 2], q[(s + 3) % 4] });
    }
  }
  result.Mesh = MakeMesh(positions, {}, cells);
  return result;
}

/// Unit sphere from an icosahedron, each edge in n parts.
inline CurvedMesh SampleSphere(int n, double jitter)
{
  const double g = 0.5 * (1. + std::sqrt(5.));
  const std::vector<MesoVector> corner = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
    { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
    { -g, 0, -1 }, { -g, 0, 1 } };
  const std::vector<std::array<int, 3>> face = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 },
    { 0, 7, 10 }, { 0, 10, 11 }, { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 },
    { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 }, { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 },
    { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 }, { 9, 8, 1 } };
  std::vector<MesoVector> positions;
  const auto unit = [](const MesoVector& a) { return MesoScaled(a, 1. / MesoLength(a)); };
  const double size = jitter * 1.1 / n;
  std::vector<std::vector<vtkIdType>> cells;
  std::map<std::array<long, 3>, vtkIdType> known;
  std::mt19937 random(7);
  for (const auto& f : face)
  {
    const auto at = [&](int i, int j)
    {
      MesoVector p = MesoScaled(corner[f[0]], double(n - i - j));
      p = MesoSum(p, MesoScaled(corner[f[1]], double(i)));
      p = MesoSum(p, MesoScaled(corner[f[2]], double(j)));
      const std::array<long, 3> key = { std::lround(p[0] * 1e6), std::lround(p[1] * 1e6),
        std::lround(p[2] * 1e6) };
      const auto found = known.emplace(key, static_cast<vtkIdType>(positions.size()));
      if (found.second)
      {
        p = unit(p);
        for (double& x : p)
        {
          x += size * (2. * static_cast<double>(random()) / 4294967295. - 1.);
        }
        positions.push_back(unit(p));
      }
      return found.first->second;
    };
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n - j; ++i)
      {
        cells.push_back({ at(i, j), at(i + 1, j), at(i, j + 1) });
        if (i + j + 1 < n)
        {
          cells.push_back({ at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
        }
      }
    }
  }
  CurvedMesh result;
  result.Mesh = MakeMesh(positions, {}, cells);
  result.Curvatures.assign(positions.size(), { 1., 1. });
  result.Directions.assign(positions.size(), { 0., 0., 0. });
  result.Border.assign(positions.size(), false);
  return result;
}

/// About `points` vertices of plane, sphere, cylinder, torus, saddle or monkey saddle.
inline CurvedMesh SampleNamed(const std::string& name, int points, double jitter)
{
  const double side = std::sqrt(static_cast<double>(points));
  const auto number = [](double value) { return static_cast<int>(std::lround(value)); };
  if (name == "sphere")
  {
    return SampleSphere(number(std::sqrt(points / 10.)), jitter);
  }
  const CurvedSurface surface = SurfaceNamed(name);
  if (name == "torus")
  {
    return SampleSurface(
      surface, number(side * std::sqrt(2.)), number(side / std::sqrt(2.)), true, true, jitter);
  }
  if (name == "cylinder")
  {
    return SampleSurface(surface, number(side * 1.25), number(side / 1.25), true, false, jitter);
  }
  return SampleSurface(surface, number(side), number(side), false, false, jitter);
}

#endif
