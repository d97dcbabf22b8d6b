#include "MesoPrismShell.h"

#include "MesoFirstEqual.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
constexpr double SameNormal = 1e-5;
constexpr double SameCoordinate = 1e-4; // of a tile

double Triple(const MesoVector& a, const MesoVector& b, const MesoVector& c)
{
  return MesoDot(MesoCross(a, b), c);
}

/// For each point the first of its merged vertex that has its normal: the corners of the shell.
std::vector<std::int64_t> FindSites(const MesoPrismShellInput& input)
{
  const std::size_t size = input.Mesh.Positions.size();
  std::vector<std::vector<std::int64_t>> known(size); // of each merged vertex
  std::vector<std::int64_t> sites(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    auto& others = known[input.Mesh.Vertex[i]];
    const auto same = std::find_if(others.begin(), others.end(),
      [&](std::int64_t other)
      { return MesoLength(MesoDifference(input.Normals[other], input.Normals[i])) <= SameNormal; });
    sites[i] = same == others.end() ? static_cast<std::int64_t>(i) : *same;
    if (same == others.end())
    {
      others.push_back(sites[i]);
    }
  }
  return sites;
}

/// A corner's texture coordinate less that of the same place seen from beyond the fin, in tiles.
std::array<double, 2> Step(const MesoPrismShellInput& input, std::int64_t from, std::int64_t to)
{
  return { (input.Coordinates[to][0] - input.Coordinates[from][0]) * input.Tiles[0],
    (input.Coordinates[to][1] - input.Coordinates[from][1]) * input.Tiles[1] };
}

/// Whether the map goes on across an edge: by whole tiles, the same at both ends.
bool GoesOn(const std::array<double, 2>& first, const std::array<double, 2>& second)
{
  for (int k = 0; k < 2; ++k)
  {
    if (!(std::abs(first[k] - std::round(first[k])) <= SameCoordinate &&
          std::abs(first[k] - second[k]) <= SameCoordinate))
    {
      return false;
    }
  }
  return true;
}

class Maker
{
public:
  explicit Maker(const MesoPrismShellInput& input)
    : Input(input)
    , Sites(FindSites(input))
    , Rises(input.Mesh.Positions.size(), 1.)
  {
    // Fins are shared where both ends are: pairs are sought between the shell's corners.
    MesoTriangleMesh welded = input.Mesh;
    welded.Vertex = this->Sites;
    std::vector<bool> used;
    std::int64_t prisms = 0;
    for (const auto& triangle : welded.Triangles)
    {
      const auto& p = welded.Positions;
      const MesoVector area = MesoCross(MesoDifference(p[triangle[1]], p[triangle[0]]),
        MesoDifference(p[triangle[2]], p[triangle[0]]));
      used.push_back(MesoLength(area) > 0.);
      this->Numbers.push_back(used.back() ? prisms++ : -1);
      MesoVector normal = { 0., 0., 0. };
      for (std::int64_t point : triangle)
      {
        normal = MesoSum(normal, input.Normals[point]);
      }
      this->Winding.push_back(MesoDot(area, normal) < 0.);
      this->Turned += used.back() ? (this->Winding.back() ? 1 : -1) : 0;
    }
    this->Used = used;
    this->Partners = MesoPairHalfEdges(welded, used);
  }

  MesoPrismShell Make()
  {
    MesoPrismShell shell = this->Extrude();
    constexpr int mostRounds = 100;
    for (int round = 0; this->Input.Clamp && round < mostRounds && this->Thin(shell); ++round)
    {
      const std::vector<std::int64_t> inverted = shell.Inverted;
      shell = this->Extrude();
      shell.Inverted = inverted;
    }
    shell.LeastRise = *std::min_element(this->Rises.begin(), this->Rises.end());
    return shell;
  }

private:
  MesoPrism PrismOf(std::int64_t triangle) const
  {
    MesoPrism prism;
    prism.Triangle = triangle;
    prism.Points = this->Input.Mesh.Triangles[triangle];
    prism.Turned = this->Winding[triangle] != (this->Turned > 0);
    for (int k = 0; k < 3; ++k)
    {
      const std::int64_t site = this->Sites[prism.Points[k]];
      const MesoVector whole =
        MesoScaled(this->Input.Normals[site], this->Input.Thickness * this->Rises[site]);
      prism.Bottom[k] = MesoSum(
        this->Input.Mesh.Positions[prism.Points[k]], MesoScaled(whole, -this->Input.Reference));
      prism.Rise[k] = whole;
    }
    return prism;
  }

  MesoPrismShell Extrude() const
  {
    MesoPrismShell shell;
    const auto triangles = static_cast<std::int64_t>(this->Input.Mesh.Triangles.size());
    for (std::int64_t triangle = 0; triangle < triangles; ++triangle)
    {
      if (!this->Used[triangle])
      {
        ++shell.DegenerateTriangles;
        continue;
      }
      MesoPrism prism = this->PrismOf(triangle);
      for (int k = 0; k < 3; ++k)
      {
        this->SetFin(prism, k, shell);
      }
      if (!(MesoLeastJacobian(prism) > 0.))
      {
        shell.Inverted.push_back(triangle);
      }
      shell.Prisms.push_back(prism);
    }
    return shell;
  }

  void SetFin(MesoPrism& prism, int k, MesoPrismShell& shell) const
  {
    const std::int64_t from = prism.Points[k];
    const std::int64_t to = prism.Points[(k + 1) % 3];
    prism.Falling += this->Sites[to] < this->Sites[from] ? 1 << k : 0;
    const std::int64_t partner = this->Partners[3 * prism.Triangle + k];
    if (partner < 0)
    {
      ++shell.OpenFins;
      prism.Ends += 1 << k;
      return;
    }
    prism.Beyond[k] = this->LiesBeyond(prism, k, partner) ? this->Numbers[partner / 3] : -1;
    std::int64_t first = this->Input.Mesh.PointOf(partner);
    std::int64_t second = this->Input.Mesh.PointOf(MesoTriangleMesh::Next(partner));
    if (this->Sites[first] != this->Sites[from])
    {
      std::swap(first, second);
    }
    if (!GoesOn(Step(this->Input, from, first), Step(this->Input, to, second)))
    {
      ++shell.SeamFins;
      prism.Ends += 1 << k;
    }
  }

  /// Whether the prism at a fin's other side is on the other side: triangles that are there twice are not.
  bool LiesBeyond(const MesoPrism& prism, int k, std::int64_t partner) const
  {
    const int next = (k + 1) % 3;
    const MesoVector across = MesoCross(MesoDifference(prism.Bottom[next], prism.Bottom[k]),
      MesoSum(prism.Rise[k], prism.Rise[next]));
    const auto side = [&](std::int64_t point)
    {
      const auto& place = this->Input.Mesh.Positions;
      return MesoDot(across, MesoDifference(place[point], place[prism.Points[k]]));
    };
    const std::int64_t last = MesoTriangleMesh::Next(MesoTriangleMesh::Next(partner));
    return side(prism.Points[(k + 2) % 3]) * side(this->Input.Mesh.PointOf(last)) < 0.;
  }

  /// Lowers the corners of the prisms that turn over; false where there are none.
  bool Thin(const MesoPrismShell& shell)
  {
    constexpr double step = 0.9;
    std::set<std::int64_t> lowered;
    for (const MesoPrism& prism : shell.Prisms)
    {
      if (!(MesoLeastJacobian(prism) > 0.))
      {
        for (std::int64_t point : prism.Points)
        {
          lowered.insert(this->Sites[point]);
        }
      }
    }
    for (std::int64_t site : lowered)
    {
      this->Rises[site] *= step;
    }
    return !lowered.empty();
  }

  const MesoPrismShellInput& Input;
  std::vector<std::int64_t> Sites;
  std::vector<double> Rises;         ///< of sites: part of the thickness
  std::vector<bool> Used;            ///< triangles that have area
  std::vector<std::int64_t> Numbers; ///< of the triangles' prisms
  std::vector<bool> Winding;         ///< triangles whose corners run clockwise around their normals
  std::int64_t Turned = 0;           ///< triangles that do, less those that do not
  std::vector<std::int64_t> Partners;
};

/// The least of a + b z + c z^2 for z in [0, 1].
double LeastOfQuadratic(double a, double b, double c)
{
  double least = std::min(a, a + b + c);
  const double lowest = -0.5 * b;
  if (c > 0. && lowest > 0. && lowest < c)
  {
    least = std::min(least, a + 0.5 * b * lowest / c);
  }
  return least;
}
}

MesoPrismShell MesoMakePrismShell(const MesoPrismShellInput& input)
{
  if (input.Mesh.Positions.empty())
  {
    return {};
  }
  return Maker(input).Make();
}

double MesoLeastJacobian(const MesoPrism& prism)
{
  // Where all shrink to a point and grow again beyond it, the determinant only touches 0: edges turn round.
  int reversed = 0;
  for (int k = 0; k < 3; ++k)
  {
    const MesoVector below = MesoDifference(prism.Bottom[(k + 1) % 3], prism.Bottom[k]);
    const MesoVector above = MesoSum(below, MesoDifference(prism.Rise[(k + 1) % 3], prism.Rise[k]));
    reversed += MesoDot(below, above) <= 0. ? 1 : 0;
  }
  if (reversed == 3)
  {
    return 0.;
  }
  // For a fixed z it is linear over the triangle, and in z a quadratic: its least is over a corner.
  const MesoVector e1 = MesoDifference(prism.Bottom[1], prism.Bottom[0]);
  const MesoVector e2 = MesoDifference(prism.Bottom[2], prism.Bottom[0]);
  const MesoVector g1 = MesoDifference(prism.Rise[1], prism.Rise[0]);
  const MesoVector g2 = MesoDifference(prism.Rise[2], prism.Rise[0]);
  const MesoVector middle =
    MesoScaled(MesoSum(prism.Rise[0], MesoSum(prism.Rise[1], prism.Rise[2])), 1. / 3.);
  const double size =
    Triple(MesoSum(e1, MesoScaled(g1, 0.5)), MesoSum(e2, MesoScaled(g2, 0.5)), middle);
  const double sign = size < 0. ? -1. : 1.;
  if (size == 0.)
  {
    return 0.;
  }
  double least = 1e300;
  for (const MesoVector& rise : prism.Rise)
  {
    const double a = sign * Triple(e1, e2, rise);
    const double b = sign * (Triple(g1, e2, rise) + Triple(e1, g2, rise));
    const double c = sign * Triple(g1, g2, rise);
    least = std::min(least, LeastOfQuadratic(a, b, c));
  }
  return least / std::abs(size);
}
