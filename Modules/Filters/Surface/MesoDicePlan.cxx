#include "MesoDicePlan.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

namespace
{
constexpr double Forgiven = 1e-3; // of a segment

// Edges beyond this are refused whatever the limit; its square still fits 64 bits.
constexpr double MostSegments = 1e9;

/// Sum of floor((a i + b) / m) for 0 <= i < n; all are 0 or more, m more than 0.
std::int64_t SumOfFloors(std::int64_t n, std::int64_t m, std::int64_t a, std::int64_t b)
{
  std::int64_t sum = 0;
  while (n > 0)
  {
    sum += n * (n - 1) / 2 * (a / m) + n * (b / m);
    a %= m;
    b %= m;
    // What is left counts the lattice points below a line; turned about, the line is that of fewer.
    const std::int64_t top = a * n + b;
    n = top / m;
    b = top % m;
    std::swap(m, a);
  }
  return sum;
}

/// Number of points inside the triangle on the rows before row r.
std::int64_t InsideBefore(const MesoDicePlan::Grid& grid, std::int64_t r)
{
  return r > 1 ? SumOfFloors(r - 1, grid.Rows, grid.Short, grid.Short - 1) : 0;
}

/// The first row with a point inside; it has one.
std::int64_t FirstRowInside(const MesoDicePlan::Grid& grid)
{
  return grid.Rows / grid.Short + 1;
}

std::int64_t InnerPoint(const MesoDicePlan::Grid& grid, std::int64_t row, std::int64_t place)
{
  return grid.FirstPoint + InsideBefore(grid, row) + place;
}

/// Segments between points that lie at (k + Offset) / Size along an edge or a row.
struct Span
{
  std::int64_t Segments;
  std::int64_t Offset;
  std::int64_t Size;
};

std::int32_t* Write(std::int64_t a, std::int64_t b, std::int64_t c, std::int32_t* out)
{
  *out++ = static_cast<std::int32_t>(a);
  *out++ = static_cast<std::int32_t>(b);
  *out++ = static_cast<std::int32_t>(c);
  return out;
}

/// The triangles between two chains of points that run the same way, the second to the left of the
/// first: a segment of either, and the point of the other that it has come to.
template <typename Right, typename Left>
std::int32_t* WriteLadder(
  const Right& right, const Span& ofRight, const Left& left, const Span& ofLeft, std::int32_t* out)
{
  std::int64_t a = 0;
  std::int64_t b = 0;
  while (a < ofRight.Segments || b < ofLeft.Segments)
  {
    // The next step is the one whose middle comes first.
    const bool stepRight = b == ofLeft.Segments ||
      (a < ofRight.Segments &&
        (2 * (a + ofRight.Offset) + 1) * ofLeft.Size <=
          (2 * (b + ofLeft.Offset) + 1) * ofRight.Size);
    if (stepRight)
    {
      out = Write(right(a), right(a + 1), left(b), out);
      ++a;
    }
    else
    {
      out = Write(right(a), left(b + 1), left(b), out);
      ++b;
    }
  }
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
    const std::int64_t shortest = std::min_element(n.begin(), n.end()) - n.begin();
    const std::int64_t longest = *std::max_element(n.begin(), n.end());
    this->Grids.push_back(
      { first / 3, (shortest + 2) % 3, longest, n[shortest], n[shortest] == longest, 0, 0, 0 });
    triangles += static_cast<double>(this->TrianglesOf(this->Grids.back()));
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
    this->Points += InsideBefore(grid, grid.Rows);
    this->Triangles += this->TrianglesOf(grid);
    this->Items += grid.Rows;
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

std::int64_t MesoDicePlan::GridOfItem(std::int64_t item) const
{
  const auto next = std::upper_bound(this->Grids.begin(), this->Grids.end(), item,
    [](std::int64_t value, const Grid& grid) { return value < grid.FirstItem; });
  return next - this->Grids.begin() - 1;
}

MesoDicePlan::Inner MesoDicePlan::InnerAt(const Grid& grid, std::int64_t row, std::int64_t place)
{
  const auto rows = static_cast<double>(grid.Rows);
  const auto r = static_cast<double>(row);
  const auto along = static_cast<double>(place + 1) / static_cast<double>(grid.Inside(row) + 1);
  std::array<double, 3> weights;
  weights[grid.Apex] = (rows - r) / rows;
  weights[(grid.Apex + 1) % 3] = r / rows * (1. - along);
  weights[(grid.Apex + 2) % 3] = r / rows * along;
  return { InnerPoint(grid, row, place), weights[1], weights[2] };
}

std::int64_t MesoDicePlan::TrianglesBefore(const Grid& grid, std::int64_t r)
{
  // Between rows q and q + 1: 2 q + 1; or their segments inside the triangle.
  return grid.Uniform
    ? r * r
    : InsideBefore(grid, r) + InsideBefore(grid, r + 1) - 1 - 2 * (r - FirstRowInside(grid));
}

std::int64_t MesoDicePlan::TrianglesOf(const Grid& grid) const
{
  if (grid.Uniform)
  {
    return grid.Rows * grid.Rows;
  }
  const std::int64_t corner = 3 * grid.Triangle;
  const std::int64_t rim =
    this->SegmentsOf(corner) + this->SegmentsOf(corner + 1) + this->SegmentsOf(corner + 2);
  if (grid.Short == 1)
  {
    return rim - 2;
  }
  const std::int64_t last = grid.Rows - 1;
  return TrianglesBefore(grid, last) + rim + grid.Inside(last) - 1 +
    2 * (last - FirstRowInside(grid));
}

void MesoDicePlan::WriteTriangles(const Grid& grid, std::int64_t row, std::int32_t* triangles) const
{
  std::int32_t* const out = triangles + 3 * grid.FirstTriangle;
  if (grid.Uniform)
  {
    this->WriteUniformRow(grid, row, out + 3 * TrianglesBefore(grid, row));
    return;
  }
  if (grid.Short == 1)
  {
    if (row == 0)
    {
      this->WriteTip(grid, this->TipOf(grid), out);
    }
    return;
  }
  // The first row inside is the second or a later one, so rows 0 and 1 have time for two ladders.
  const std::int64_t last = grid.Rows - 1;
  const std::int64_t first = FirstRowInside(grid);
  if (row == last || row < 2)
  {
    this->WriteRim(grid, row == last ? 1 : 2 * row, out);
  }
  else if (row >= first)
  {
    const std::int64_t ahead = InnerPoint(grid, row + 1, 0);
    const std::int64_t behind = InnerPoint(grid, row, 0);
    const std::int64_t aheadSize = grid.Inside(row + 1) + 1;
    const std::int64_t behindSize = grid.Inside(row) + 1;
    WriteLadder([ahead](std::int64_t k) { return ahead + k; }, { aheadSize - 2, 1, aheadSize },
      [behind](std::int64_t k) { return behind + k; }, { behindSize - 2, 1, behindSize },
      out + 3 * TrianglesBefore(grid, row));
  }
}

void MesoDicePlan::WriteUniformRow(const Grid& grid, std::int64_t row, std::int32_t* out) const
{
  const std::int64_t left = 3 * grid.Triangle + grid.Apex;
  const std::int64_t base = MesoTriangleMesh::Next(left);
  const std::int64_t right = MesoTriangleMesh::Next(base);
  const auto pointsOf = [&](std::int64_t r)
  {
    const std::int64_t first = InnerPoint(grid, r, 0);
    return [this, &grid, left, base, right, r, first](std::int64_t k)
    {
      return r == grid.Rows ? this->OnHalfEdge(base, k)
        : k == 0            ? this->OnHalfEdge(left, r)
        : k == r            ? this->OnHalfEdge(right, grid.Rows - r)
                            : first + k - 1;
    };
  };
  WriteLadder(pointsOf(row + 1), { row + 1, 0, row + 1 }, pointsOf(row),
    { row, 0, std::max<std::int64_t>(1, row) }, out);
}

std::array<std::int64_t, 2> MesoDicePlan::TipOf(const Grid& grid) const
{
  const std::int64_t left = this->SegmentsOf(3 * grid.Triangle + grid.Apex);
  const std::int64_t right = this->SegmentsOf(3 * grid.Triangle + (grid.Apex + 2) % 3);
  if (grid.Short == 1)
  {
    return { left, right };
  }
  const std::int64_t first = FirstRowInside(grid);
  const std::array<std::int64_t, 2> tip = { (first * left - 1) / grid.Rows,
    (first * right - 1) / grid.Rows };
  // An edge that has no point there lies with the apex on one line.
  return tip[0] > 0 && tip[1] > 0 ? tip : std::array<std::int64_t, 2>{ 0, 0 };
}

/// The triangles between the apex and the tip's ends on both edges.
std::int32_t* MesoDicePlan::WriteTip(
  const Grid& grid, const std::array<std::int64_t, 2>& tip, std::int32_t* out) const
{
  const std::int64_t left = 3 * grid.Triangle + grid.Apex;
  const std::int64_t right = 3 * grid.Triangle + (grid.Apex + 2) % 3;
  const std::int64_t ofLeft = this->SegmentsOf(left);
  const std::int64_t ofRight = this->SegmentsOf(right);
  const auto onLeft = [&](std::int64_t k) { return this->OnHalfEdge(left, k + 1); };
  const auto onRight = [&](std::int64_t k) { return this->OnHalfEdge(right, ofRight - k - 1); };
  out = Write(this->OnHalfEdge(left, 0), onLeft(0), onRight(0), out);
  return WriteLadder(onLeft, { tip[0] - 1, 1, ofLeft }, onRight, { tip[1] - 1, 1, ofRight }, out);
}

/// The ladder between an edge (0: that leaves the apex, and on from there) and the points inside;
/// with that of edge 0 the tip.
void MesoDicePlan::WriteRim(const Grid& grid, std::int64_t edge, std::int32_t* out) const
{
  const std::int64_t first = FirstRowInside(grid);
  const std::int64_t last = grid.Rows - 1;
  const std::int64_t corner = 3 * grid.Triangle + (grid.Apex + edge) % 3;
  const std::int64_t segments = this->SegmentsOf(corner);
  const auto onEdge = [&](std::int64_t k) { return this->OnHalfEdge(corner, k); };
  const std::array<std::int64_t, 2> tip = this->TipOf(grid);
  // The rows come first, then edge 0 with the tip, 2 and 1.
  out += 3 * TrianglesBefore(grid, last);
  if (edge == 0)
  {
    if (tip[0] > 0)
    {
      out = this->WriteTip(grid, tip, out);
      const std::int64_t right = 3 * grid.Triangle + (grid.Apex + 2) % 3;
      out = Write(onEdge(tip[0]), InnerPoint(grid, first, 0),
        this->OnHalfEdge(right, this->SegmentsOf(right) - tip[1]), out);
    }
    WriteLadder([&](std::int64_t k) { return onEdge(tip[0] + k); },
      { segments - tip[0], tip[0], segments },
      [&](std::int64_t k) { return InnerPoint(grid, first + k, 0); },
      { last - first, first, grid.Rows }, out);
    return;
  }
  out += 3 * (this->SegmentsOf(3 * grid.Triangle + grid.Apex) + tip[1] + last - first);
  if (edge == 2)
  {
    WriteLadder(
      onEdge, { segments - tip[1], 0, segments },
      [&](std::int64_t k) { return InnerPoint(grid, last - k, grid.Inside(last - k) - 1); },
      { last - first, 1, grid.Rows }, out);
    return;
  }
  out += 3 * (this->SegmentsOf(3 * grid.Triangle + (grid.Apex + 2) % 3) - tip[1] + last - first);
  const std::int64_t begin = InnerPoint(grid, last, 0);
  WriteLadder(
    onEdge, { segments, 0, segments }, [begin](std::int64_t k) { return begin + k; },
    { grid.Inside(last) - 1, 1, grid.Inside(last) + 1 }, out);
}
