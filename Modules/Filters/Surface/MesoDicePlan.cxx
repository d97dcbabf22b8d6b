#include "MesoDicePlan.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

namespace
{
constexpr double Forgiven = 1e-3; // of a segment

// Edges beyond this are refused whatever the limit; squares of it still fit 64 bits.
constexpr double MostSegments = 1e9;

/// Number of points of the inner part before its row: rows have size + 1, size, ... points.
std::int64_t InnerBefore(std::int64_t size, std::int64_t row)
{
  return row * (size + 1) - row * (row - 1) / 2;
}

/// Number of triangles of a grid before its row: rows have 2 size - 1, 2 size - 3, ... triangles.
std::int64_t TrianglesBefore(std::int64_t size, std::int64_t row)
{
  return row * (2 * size - row);
}

std::int64_t InnerPoint(const MesoDicePlan::Grid& grid, std::int64_t i, std::int64_t row)
{
  return grid.FirstPoint + InnerBefore(grid.Size - 3, row) + i;
}

std::int32_t* Write(std::int64_t a, std::int64_t b, std::int64_t c, std::int32_t* out)
{
  *out++ = static_cast<std::int32_t>(a);
  *out++ = static_cast<std::int32_t>(b);
  *out++ = static_cast<std::int32_t>(c);
  return out;
}
}

MesoDicePlan::MesoDicePlan(const MesoTriangleMesh& mesh,
  const std::vector<std::array<double, 2>>& texels, double facetsPerTexel,
  std::int64_t mostTriangles)
{
  this->FindSides(mesh, texels, facetsPerTexel);
  const double triangles = this->MakeGrids(mesh);
  if (triangles > static_cast<double>(mostTriangles))
  {
    throw std::invalid_argument("dicing into " + std::to_string(std::llround(triangles)) +
      " triangles is more than the limit of " + std::to_string(mostTriangles) +
      "; take fewer facets a texel, fewer tiles, a smaller map or a higher limit");
  }
  this->Number(mesh);
}

void MesoDicePlan::FindSides(const MesoTriangleMesh& mesh,
  const std::vector<std::array<double, 2>>& texels, double facetsPerTexel)
{
  struct HalfEdge
  {
    std::array<std::int64_t, 2> Vertices; ///< the lesser first
    std::array<std::int64_t, 2> Ends;
    std::int64_t Corner;
  };
  const std::int64_t corners = mesh.NumberOfCorners();
  std::vector<HalfEdge> halves;
  halves.reserve(corners);
  this->Backwards.assign(corners, false);
  for (std::int64_t first = 0; first < corners; first += 3)
  {
    const std::int64_t a = mesh.VertexOf(first);
    const std::int64_t b = mesh.VertexOf(first + 1);
    const std::int64_t c = mesh.VertexOf(first + 2);
    if (a == b || b == c || c == a)
    {
      continue;
    }
    for (std::int64_t corner = first; corner < first + 3; ++corner)
    {
      const std::int64_t next = MesoTriangleMesh::Next(corner);
      HalfEdge half = { { mesh.VertexOf(corner), mesh.VertexOf(next) },
        { mesh.PointOf(corner), mesh.PointOf(next) }, corner };
      if (half.Vertices[1] < half.Vertices[0])
      {
        std::swap(half.Vertices[0], half.Vertices[1]);
        std::swap(half.Ends[0], half.Ends[1]);
        this->Backwards[corner] = true;
      }
      halves.push_back(half);
    }
  }
  std::sort(halves.begin(), halves.end(),
    [](const HalfEdge& a, const HalfEdge& b)
    { return std::tie(a.Vertices, a.Ends, a.Corner) < std::tie(b.Vertices, b.Ends, b.Corner); });

  this->SideOf.assign(corners, -1);
  this->HalfEdges.reserve(halves.size());
  for (std::size_t first = 0; first < halves.size();)
  {
    this->Edges.push_back(static_cast<std::int64_t>(this->Sides.size()));
    double wanted = 1.;
    std::size_t i = first;
    for (; i < halves.size() && halves[i].Vertices == halves[first].Vertices; ++i)
    {
      if (i == first || halves[i].Ends != halves[i - 1].Ends)
      {
        const auto& from = texels[halves[i].Ends[0]];
        const auto& to = texels[halves[i].Ends[1]];
        const double length = std::max(std::abs(to[0] - from[0]), std::abs(to[1] - from[1]));
        wanted = std::max(wanted, std::ceil(facetsPerTexel * length - Forgiven));
        this->Sides.push_back({ halves[i].Ends, 1, 0, static_cast<std::int64_t>(i), 0 });
      }
      this->Sides.back().EndHalfEdge = static_cast<std::int64_t>(i) + 1;
      this->SideOf[halves[i].Corner] = static_cast<std::int64_t>(this->Sides.size()) - 1;
      this->HalfEdges.push_back(halves[i].Corner);
    }
    const auto segments = static_cast<std::int64_t>(std::min(wanted, MostSegments));
    for (std::size_t side = this->Edges.back(); side < this->Sides.size(); ++side)
    {
      this->Sides[side].Segments = segments;
    }
    first = i;
  }
  this->Edges.push_back(static_cast<std::int64_t>(this->Sides.size()));
}

double MesoDicePlan::MakeGrids(const MesoTriangleMesh& mesh)
{
  double triangles = 0.;
  for (std::int64_t first = 0; first < mesh.NumberOfCorners(); first += 3)
  {
    if (this->SideOf[first] < 0)
    {
      continue;
    }
    const std::array<std::int64_t, 3> n = { this->SegmentsOf(first), this->SegmentsOf(first + 1),
      this->SegmentsOf(first + 2) };
    Grid grid = { first / 3, std::max({ n[0], n[1], n[2] }), n[0] == n[1] && n[1] == n[2], 0, 0,
      0 };
    grid.Size = grid.Uniform ? grid.Size : std::max<std::int64_t>(3, grid.Size);
    this->Grids.push_back(grid);
    const auto size = static_cast<double>(grid.Size);
    triangles += grid.Uniform
      ? size * size
      : (size - 3.) * (size - 3.) + static_cast<double>(n[0] + n[1] + n[2]) + 3. * (size - 3.);
  }
  return triangles;
}

void MesoDicePlan::Number(const MesoTriangleMesh& mesh)
{
  this->Numbers.assign(mesh.Positions.size(), -1);
  for (const Side& side : this->Sides)
  {
    this->Numbers[side.Ends[0]] = 0;
    this->Numbers[side.Ends[1]] = 0;
  }
  for (std::int64_t& number : this->Numbers)
  {
    number = number < 0 ? -1 : this->Points++;
  }
  for (Side& side : this->Sides)
  {
    side.FirstPoint = this->Points;
    this->Points += side.Segments - 1;
  }
  for (Grid& grid : this->Grids)
  {
    grid.FirstPoint = this->Points;
    grid.FirstTriangle = this->Triangles;
    grid.FirstItem = this->Items;
    this->Items += grid.Size;
    if (grid.Size >= 3)
    {
      this->Points += InnerBefore(grid.Size - 3, grid.Size - 2);
    }
    const std::int64_t inner = grid.Size - 3;
    const std::int64_t corner = 3 * grid.Triangle;
    this->Triangles += grid.Uniform ? grid.Size * grid.Size
                                    : inner * inner + this->SegmentsOf(corner) +
        this->SegmentsOf(corner + 1) + this->SegmentsOf(corner + 2) + 3 * inner;
  }
}

std::int64_t MesoDicePlan::SegmentsOf(std::int64_t corner) const
{
  return this->Sides[this->SideOf[corner]].Segments;
}

std::int64_t MesoDicePlan::PointOn(const Side& side, std::int64_t segment) const
{
  if (segment == 0 || segment == side.Segments)
  {
    return this->Numbers[side.Ends[segment == 0 ? 0 : 1]];
  }
  return side.FirstPoint + segment - 1;
}

std::int64_t MesoDicePlan::OnHalfEdge(std::int64_t corner, std::int64_t segment) const
{
  const Side& side = this->Sides[this->SideOf[corner]];
  return this->PointOn(side, this->Backwards[corner] ? side.Segments - segment : segment);
}

std::int64_t MesoDicePlan::OnUniformGrid(const Grid& grid, std::int64_t i, std::int64_t j) const
{
  const std::int64_t corner = 3 * grid.Triangle;
  if (j == 0)
  {
    return this->OnHalfEdge(corner, i);
  }
  if (i + j == grid.Size)
  {
    return this->OnHalfEdge(corner + 1, j);
  }
  if (i == 0)
  {
    return this->OnHalfEdge(corner + 2, grid.Size - j);
  }
  return InnerPoint(grid, i - 1, j - 1);
}

std::int64_t MesoDicePlan::GridOfItem(std::int64_t item) const
{
  const auto next = std::upper_bound(this->Grids.begin(), this->Grids.end(), item,
    [](std::int64_t value, const Grid& grid) { return value < grid.FirstItem; });
  return next - this->Grids.begin() - 1;
}

std::int64_t MesoDicePlan::NumberOfInner(const Grid& grid, std::int64_t item)
{
  return std::max<std::int64_t>(0, grid.Size - 2 - item);
}

MesoDicePlan::Inner MesoDicePlan::InnerAt(const Grid& grid, std::int64_t item, std::int64_t place)
{
  return { InnerPoint(grid, place, item), place + 1, item + 1 };
}

void MesoDicePlan::WriteTriangles(
  const Grid& grid, std::int64_t item, std::int32_t* triangles) const
{
  std::int32_t* out = triangles + 3 * grid.FirstTriangle;
  const std::int64_t inner = grid.Size - 3;
  const std::int64_t size = grid.Uniform ? grid.Size : inner;
  if (item < size)
  {
    const auto at = [&](std::int64_t i, std::int64_t j)
    { return grid.Uniform ? this->OnUniformGrid(grid, i, j) : InnerPoint(grid, i, j); };
    out += 3 * TrianglesBefore(size, item);
    for (std::int64_t i = 0; i < size - item; ++i)
    {
      out = Write(at(i, item), at(i + 1, item), at(i, item + 1), out);
      if (i + 1 < size - item)
      {
        out = Write(at(i + 1, item), at(i + 1, item + 1), at(i, item + 1), out);
      }
    }
    return;
  }
  out += 3 * inner * inner;
  for (std::int64_t edge = 0; edge < item - inner; ++edge)
  {
    out += 3 * (this->SegmentsOf(3 * grid.Triangle + edge) + inner);
  }
  this->WriteLadder(grid, item - inner, out);
}

void MesoDicePlan::WriteLadder(const Grid& grid, std::int64_t edge, std::int32_t* out) const
{
  const std::int64_t corner = 3 * grid.Triangle + edge;
  const std::int64_t segments = this->SegmentsOf(corner);
  const std::int64_t inner = grid.Size - 3;
  const auto within = [&](std::int64_t m)
  {
    return edge == 0 ? InnerPoint(grid, m, 0)
      : edge == 1    ? InnerPoint(grid, inner - m, m)
                     : InnerPoint(grid, 0, inner - m);
  };
  std::int64_t a = 0; // on the edge
  std::int64_t b = 0; // on the inner part, at (b + 3/2) / Size along the edge
  while (a < segments || b < inner)
  {
    // The next step is that whose middle comes first.
    const bool onEdge =
      b == inner || (a < segments && (2 * a + 1) * grid.Size <= (2 * b + 4) * segments);
    if (onEdge)
    {
      out = Write(this->OnHalfEdge(corner, a), this->OnHalfEdge(corner, a + 1), within(b), out);
      ++a;
    }
    else
    {
      out = Write(this->OnHalfEdge(corner, a), within(b + 1), within(b), out);
      ++b;
    }
  }
}
