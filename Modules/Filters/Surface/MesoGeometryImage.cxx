#include "MesoGeometryImage.h"

#include "MesoTexelCover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double MostTiles = 2.;     // of coordinates that are still taken for an atlas
constexpr double NearestTexels = 2.; // from which a sample is drawn to the chart's edge

using Point2 = std::array<double, 2>;

Point2 Difference(const Point2& a, const Point2& b)
{
  return { a[0] - b[0], a[1] - b[1] };
}

MesoVector Blend(const MesoVector& a, const MesoVector& b, double along)
{
  return MesoSum(a, MesoScaled(MesoDifference(b, a), along));
}

MesoVector Unit(const MesoVector& a)
{
  const double length = MesoLength(a);
  return length > 0. ? MesoScaled(a, 1. / length) : MesoVector{ 0., 0., 1. };
}
}

MesoGeometryImage::MesoGeometryImage(const MesoGeometryInput& input)
  : Input(input)
{
  Point2 high = { 1., 1. };
  for (const Point2& coordinate : input.Coordinates)
  {
    for (int k = 0; k < 2; ++k)
    {
      this->Low[k] = std::min(this->Low[k], coordinate[k]);
      high[k] = std::max(high[k], coordinate[k]);
    }
  }
  for (int k = 0; k < 2; ++k)
  {
    this->Span[k] = high[k] - this->Low[k];
    if (!(this->Span[k] <= MostTiles))
    {
      throw std::invalid_argument("the texture coordinates spread over " +
        std::to_string(this->Span[k]) +
        " tiles: a geometry image needs an atlas in [0, 1] x [0, 1]");
    }
  }
  for (const Point2& coordinate : input.Coordinates)
  {
    this->Placed.push_back({ (coordinate[0] - this->Low[0]) / this->Span[0],
      (coordinate[1] - this->Low[1]) / this->Span[1] });
  }
  this->PointAt.resize(input.Mesh.Vertex.size(), -1);
  for (std::size_t i = input.Mesh.Vertex.size(); i-- > 0;)
  {
    this->PointAt[input.Mesh.Vertex[i]] = static_cast<std::int64_t>(i);
  }
  this->FindCharts();
  this->FindChains();
}

void MesoGeometryImage::FindCharts()
{
  const MesoTriangleMesh& mesh = this->Input.Mesh;
  // Half-edges whose other side is there in the texture as well belong to one chart.
  std::map<std::array<double, 4>, std::vector<std::int64_t>> byCoordinates;
  const auto key = [&](std::int64_t corner)
  {
    const Point2& a = this->Placed[mesh.PointOf(corner)];
    const Point2& b = this->Placed[mesh.PointOf(MesoTriangleMesh::Next(corner))];
    const Point2& first = std::min(a, b);
    const Point2& second = std::max(a, b);
    return std::array<double, 4>{ first[0], first[1], second[0], second[1] };
  };
  const auto ends = [&](std::int64_t corner)
  {
    const std::int64_t a = mesh.VertexOf(corner);
    const std::int64_t b = mesh.VertexOf(MesoTriangleMesh::Next(corner));
    return EdgeKey{ std::min(a, b), std::max(a, b) };
  };
  for (std::int64_t corner = 0; corner < mesh.NumberOfCorners(); ++corner)
  {
    byCoordinates[key(corner)].push_back(corner);
  }
  MesoCornerSets sets(static_cast<std::int64_t>(mesh.Triangles.size()));
  std::vector<std::int64_t> border;
  for (const auto& entry : byCoordinates)
  {
    for (const std::int64_t corner : entry.second)
    {
      bool alone = true;
      for (const std::int64_t other : entry.second)
      {
        if (other != corner && ends(other) == ends(corner))
        {
          sets.Join(corner / 3, other / 3);
          alone = false;
        }
      }
      if (alone)
      {
        border.push_back(corner);
      }
    }
  }
  std::map<std::int64_t, int> numbers;
  std::vector<double> areas;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const int chart =
      numbers.emplace(sets.Find(static_cast<std::int64_t>(t)), static_cast<int>(numbers.size()))
        .first->second;
    this->ChartOf.push_back(chart);
    areas.resize(numbers.size(), 0.);
    const Point2& origin = this->Placed[mesh.Triangles[t][0]];
    const Point2 a = Difference(this->Placed[mesh.Triangles[t][1]], origin);
    const Point2 b = Difference(this->Placed[mesh.Triangles[t][2]], origin);
    areas[chart] += a[0] * b[1] - a[1] * b[0];
  }
  for (const double area : areas)
  {
    this->Mirrored.push_back(area < 0.);
  }
  std::sort(border.begin(), border.end());
  for (const std::int64_t corner : border)
  {
    const EdgeKey edge = ends(corner);
    if (edge[0] != edge[1])
    {
      this->Cuts[edge].push_back(static_cast<int>(this->Sides.size()));
    }
    this->Sides.push_back({ corner, this->ChartOf[corner / 3], -1, 0., 0. });
  }
}

double MesoGeometryImage::LengthOf(const EdgeKey& edge) const
{
  double least = std::numeric_limits<double>::infinity();
  for (const int side : this->Cuts.at(edge))
  {
    const std::int64_t corner = this->Sides[side].Corner;
    const Point2 step =
      Difference(this->Placed[this->Input.Mesh.PointOf(MesoTriangleMesh::Next(corner))],
        this->Placed[this->Input.Mesh.PointOf(corner)]);
    least = std::min(least, std::max(std::abs(step[0]), std::abs(step[1])));
  }
  return least;
}

bool MesoGeometryImage::IsCorner(std::int64_t vertex, const std::vector<EdgeKey>& edges) const
{
  if (edges.size() != 2)
  {
    return true;
  }
  std::multiset<int> charts[2];
  // By chart and point: which way the outline runs there, out of the vertex.
  std::map<std::int64_t, std::vector<Point2>> ways;
  for (int k = 0; k < 2; ++k)
  {
    for (const int side : this->Cuts.at(edges[k]))
    {
      charts[k].insert(this->Sides[side].Chart);
      std::int64_t here = this->Input.Mesh.PointOf(this->Sides[side].Corner);
      std::int64_t there =
        this->Input.Mesh.PointOf(MesoTriangleMesh::Next(this->Sides[side].Corner));
      if (this->Input.Mesh.Vertex[here] != vertex)
      {
        std::swap(here, there);
      }
      ways[here].push_back(Difference(this->Placed[there], this->Placed[here]));
    }
  }
  if (charts[0] != charts[1])
  {
    return true;
  }
  for (const auto& way : ways)
  {
    if (way.second.size() != 2)
    {
      continue;
    }
    const Point2& a = way.second[0];
    const Point2& b = way.second[1];
    const double turn =
      Pi - std::abs(std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]));
    if (turn > CornerAngle * Pi / 180.)
    {
      return true;
    }
  }
  return false;
}

void MesoGeometryImage::Follow(
  EdgeKey edge, std::int64_t from, const std::vector<bool>& corners, std::map<EdgeKey, bool>& seen)
{
  Chain chain;
  const std::int64_t start = from;
  double length = 0.;
  while (true)
  {
    seen[edge] = true;
    const std::int64_t to = edge[0] == from ? edge[1] : edge[0];
    const double end = length + this->LengthOf(edge);
    for (const int number : this->Cuts.at(edge))
    {
      Side& side = this->Sides[number];
      const bool along = this->Input.Mesh.VertexOf(side.Corner) == from;
      side.Chain = static_cast<int>(this->Chains.size());
      side.From = along ? length : end;
      side.To = along ? end : length;
    }
    chain.Edges.push_back({ from, to });
    chain.Ends.push_back(end);
    length = end;
    from = to;
    if (corners[from] || from == start)
    {
      break;
    }
    const auto& edges = this->CutsAt[from];
    edge = edges[0] == edge ? edges[1] : edges[0];
  }
  chain.Loop = from == start;
  this->Chains.push_back(chain);
}

void MesoGeometryImage::FindChains()
{
  this->CutsAt.resize(this->Input.Mesh.Vertex.size());
  for (const auto& cut : this->Cuts)
  {
    this->CutsAt[cut.first[0]].push_back(cut.first);
    this->CutsAt[cut.first[1]].push_back(cut.first);
  }
  std::vector<bool> corners(this->CutsAt.size(), false);
  for (std::size_t vertex = 0; vertex < corners.size(); ++vertex)
  {
    corners[vertex] = !this->CutsAt[vertex].empty() &&
      this->IsCorner(static_cast<std::int64_t>(vertex), this->CutsAt[vertex]);
  }
  std::map<EdgeKey, bool> seen;
  for (const bool fromCorners : { true, false }) // what is left are loops without any
  {
    for (const auto& cut : this->Cuts)
    {
      for (const std::int64_t end : cut.first)
      {
        if (!seen[cut.first] && (corners[end] || !fromCorners))
        {
          this->Follow(cut.first, end, corners, seen);
        }
      }
    }
  }
}

void MesoGeometryImage::PlaceOn(
  const Side& side, double along, std::size_t texel, MesoGeometryLevel& level) const
{
  const MesoTriangleMesh& mesh = this->Input.Mesh;
  if (side.Chain < 0)
  {
    level.Positions[texel] = mesh.Positions[this->PointAt[mesh.VertexOf(side.Corner)]];
    return;
  }
  const Chain& chain = this->Chains[side.Chain];
  const double length = chain.Ends.back();
  const int least = chain.Loop ? 3 : 1;
  const int places = std::max(least, static_cast<int>(length * level.Size / StitchStep));
  const double t = side.From + along * (side.To - side.From);
  const double place = std::round(length > 0. ? t / length * places : 0.) / places * length;
  std::size_t number =
    std::lower_bound(chain.Ends.begin(), chain.Ends.end(), place) - chain.Ends.begin();
  number = std::min(number, chain.Ends.size() - 1);
  const double start = number > 0 ? chain.Ends[number - 1] : 0.;
  const double size = chain.Ends[number] - start;
  const double part = size > 0. ? std::clamp((place - start) / size, 0., 1.) : 0.;
  const auto& ends = chain.Edges[number];
  // From the chain alone, so that both sides of the cut get the same to the last bit.
  level.Positions[texel] = part == 1.
    ? mesh.Positions[this->PointAt[ends[1]]]
    : Blend(mesh.Positions[this->PointAt[ends[0]]], mesh.Positions[this->PointAt[ends[1]]], part);
  // Normal and coordinate are this side's: of the chart, and nearest where it meets itself.
  double nearest = std::numeric_limits<double>::infinity();
  const Point2 here = level.Coordinates[texel];
  const EdgeKey key = { std::min(ends[0], ends[1]), std::max(ends[0], ends[1]) };
  for (const int other : this->Cuts.at(key))
  {
    if (this->Sides[other].Chart != side.Chart)
    {
      continue;
    }
    const std::int64_t corner = this->Sides[other].Corner;
    std::int64_t a = mesh.PointOf(corner);
    std::int64_t b = mesh.PointOf(MesoTriangleMesh::Next(corner));
    if (mesh.Vertex[a] != ends[0])
    {
      std::swap(a, b);
    }
    const Point2 step = Difference(this->Placed[b], this->Placed[a]);
    const Point2 at = { this->Placed[a][0] + part * step[0], this->Placed[a][1] + part * step[1] };
    const double distance = std::hypot(at[0] - here[0], at[1] - here[1]);
    if (distance < nearest)
    {
      nearest = distance;
      level.Coordinates[texel] = at;
      level.Normals[texel] = Unit(Blend(this->Input.Normals[a], this->Input.Normals[b], part));
    }
  }
}

void MesoGeometryImage::Stitch(MesoGeometryLevel& level) const
{
  const int n = level.Size;
  const auto chartAt = [&](int column, int row)
  {
    return column < 0 || row < 0 || column >= n || row >= n
      ? 0
      : std::abs(level.Charts[std::size_t(row) * n + column]);
  };
  /// The nearest side of a sample's chart.
  struct Nearest
  {
    double Distance = std::numeric_limits<double>::infinity();
    int Side = -1;
    double Along = 0.;
  };
  std::map<std::size_t, Nearest> samples;
  for (int row = 0; row < n; ++row)
  {
    for (int column = 0; column < n; ++column)
    {
      const int chart = chartAt(column, row);
      if (chart != 0 &&
        (chartAt(column - 1, row) != chart || chartAt(column + 1, row) != chart ||
          chartAt(column, row - 1) != chart || chartAt(column, row + 1) != chart))
      {
        samples[std::size_t(row) * n + column] = {};
      }
    }
  }
  for (std::size_t s = 0; s < this->Sides.size(); ++s)
  {
    const Side& side = this->Sides[s];
    const Point2& a = this->Placed[this->Input.Mesh.PointOf(side.Corner)];
    const Point2& b = this->Placed[this->Input.Mesh.PointOf(MesoTriangleMesh::Next(side.Corner))];
    const Point2 step = Difference(b, a);
    const double square = step[0] * step[0] + step[1] * step[1];
    int low[2];
    int high[2];
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::max(0, static_cast<int>(std::floor(std::min(a[k], b[k]) * n - 3.)));
      high[k] = std::min(n - 1, static_cast<int>(std::ceil(std::max(a[k], b[k]) * n + 3.)));
    }
    for (int row = low[1]; row <= high[1]; ++row)
    {
      for (int column = low[0]; column <= high[0]; ++column)
      {
        if (chartAt(column, row) != side.Chart + 1)
        {
          continue;
        }
        const auto found = samples.find(std::size_t(row) * n + column);
        if (found == samples.end())
        {
          continue;
        }
        const Point2 from = Difference({ (column + 0.5) / n, (row + 0.5) / n }, a);
        const double along =
          square > 0. ? std::clamp((from[0] * step[0] + from[1] * step[1]) / square, 0., 1.) : 0.;
        const double distance =
          n * std::hypot(from[0] - along * step[0], from[1] - along * step[1]);
        if (distance < found->second.Distance && distance <= NearestTexels)
        {
          found->second = { distance, static_cast<int>(s), along };
        }
      }
    }
  }
  for (const auto& sample : samples)
  {
    if (sample.second.Side >= 0)
    {
      this->PlaceOn(this->Sides[sample.second.Side], sample.second.Along, sample.first, level);
    }
  }
}

MesoGeometryLevel MesoGeometryImage::Sample(int size) const
{
  const MesoTriangleMesh& mesh = this->Input.Mesh;
  const MesoTexelCover cover = MesoCoverTexels(this->Placed, mesh.Triangles, size, size);
  MesoGeometryLevel level;
  level.Size = size;
  level.Overlapping = cover.Overlapping;
  const std::size_t texels = cover.Triangle.size();
  level.Positions.assign(texels, { 0., 0., 0. });
  level.Normals.assign(texels, { 0., 0., 0. });
  level.Coordinates.assign(texels, { 0., 0. });
  level.Charts.assign(texels, 0);
  for (std::size_t texel = 0; texel < texels; ++texel)
  {
    const std::int32_t triangle = cover.Triangle[texel];
    if (triangle < 0)
    {
      continue;
    }
    const auto weights = cover.WeightsOf(texel);
    const auto& corners = mesh.Triangles[triangle];
    MesoVector normal = { 0., 0., 0. };
    for (int k = 0; k < 3; ++k)
    {
      level.Positions[texel] =
        MesoSum(level.Positions[texel], MesoScaled(mesh.Positions[corners[k]], weights[k]));
      normal = MesoSum(normal, MesoScaled(this->Input.Normals[corners[k]], weights[k]));
    }
    level.Normals[texel] = Unit(normal);
    const std::size_t row = texel / size;
    const std::size_t column = texel % size;
    level.Coordinates[texel] = { (static_cast<double>(column) + 0.5) / size,
      (static_cast<double>(row) + 0.5) / size };
    const int chart = this->ChartOf[triangle];
    level.Charts[texel] = this->Mirrored[chart] ? -1 - chart : 1 + chart;
  }
  this->Stitch(level);
  for (Point2& coordinate : level.Coordinates)
  {
    for (int k = 0; k < 2; ++k)
    {
      coordinate[k] = this->Low[k] + this->Span[k] * coordinate[k];
    }
  }
  return level;
}

std::vector<std::int32_t> MesoGeometryImage::Triangles(const MesoGeometryLevel& level)
{
  std::vector<std::int32_t> triangles;
  const int n = level.Size;
  const auto& positions = level.Positions;
  const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c)
  {
    if (positions[a] != positions[b] && positions[b] != positions[c] &&
      positions[c] != positions[a])
    {
      const bool mirrored = level.Charts[a] < 0;
      triangles.insert(triangles.end(), { a, mirrored ? c : b, mirrored ? b : c });
    }
  };
  for (int row = 0; row + 1 < n; ++row)
  {
    for (int column = 0; column + 1 < n; ++column)
    {
      const std::int32_t first = row * n + column;
      const std::int32_t quad[] = { first, first + 1, first + n + 1, first + n };
      int shared = 0; // samples of the quad's first chart that has three
      int odd = -1;
      for (int k = 0; k < 4; ++k)
      {
        int same = 0;
        for (const std::int32_t other : quad)
        {
          same += level.Charts[other] == level.Charts[quad[k]] ? 1 : 0;
        }
        if (same >= 3 && level.Charts[quad[k]] != 0)
        {
          shared = same;
        }
        else
        {
          odd = k;
        }
      }
      if (shared == 3)
      {
        add(quad[(odd + 1) % 4], quad[(odd + 2) % 4], quad[(odd + 3) % 4]);
      }
      else if (shared == 4)
      {
        const auto length = [&](int a, int b)
        { return MesoLength(MesoDifference(positions[quad[a]], positions[quad[b]])); };
        const int turn = length(1, 3) < length(0, 2) ? 1 : 0;
        add(quad[turn], quad[turn + 1], quad[(turn + 2) % 4]);
        add(quad[turn], quad[(turn + 2) % 4], quad[(turn + 3) % 4]);
      }
    }
  }
  return triangles;
}
