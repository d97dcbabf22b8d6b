#include "MesoLoopSubdivision.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
using Pair = std::array<std::int64_t, 2>;

Pair Sorted(std::int64_t a, std::int64_t b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// An edge between merged vertices, and the vertices opposite of it.
struct Edge
{
  std::vector<std::int64_t> Opposite;
  std::int64_t Number = 0; ///< of its new vertex
};

/// What lies around the merged vertices.
struct Rings
{
  std::map<Pair, Edge> Edges;
  std::vector<MesoVector> Positions; ///< by vertex
  std::vector<std::vector<std::int64_t>> Neighbours;
  std::vector<std::vector<std::int64_t>> Border; ///< those over edges that are boundaries

  explicit Rings(const MesoTriangleMesh& mesh)
    : Positions(mesh.Positions.size(), MesoVector{ 0., 0., 0. })
    , Neighbours(mesh.Positions.size())
    , Border(mesh.Positions.size())
  {
    for (std::size_t i = mesh.Positions.size(); i-- > 0;)
    {
      this->Positions[mesh.Vertex[i]] = mesh.Positions[i]; // the first point's, in the end
    }
    for (std::int64_t corner = 0; corner < mesh.NumberOfCorners(); ++corner)
    {
      const std::int64_t next = MesoTriangleMesh::Next(corner);
      const std::int64_t ends[] = { mesh.VertexOf(corner), mesh.VertexOf(next) };
      if (ends[0] != ends[1])
      {
        this->Edges[Sorted(ends[0], ends[1])].Opposite.push_back(
          mesh.VertexOf(MesoTriangleMesh::Next(next)));
      }
    }
    for (auto& edge : this->Edges)
    {
      const bool border = edge.second.Opposite.size() != 2;
      for (int end = 0; end < 2; ++end)
      {
        this->Neighbours[edge.first[end]].push_back(edge.first[1 - end]);
        if (border)
        {
          this->Border[edge.first[end]].push_back(edge.first[1 - end]);
        }
      }
    }
  }

  /// v with a weight and its neighbours with another each.
  MesoVector Blend(
    std::int64_t vertex, double own, const std::vector<std::int64_t>& others, double other) const
  {
    MesoVector sum = MesoScaled(this->Positions[vertex], own);
    for (const std::int64_t neighbour : others)
    {
      sum = MesoSum(sum, MesoScaled(this->Positions[neighbour], other));
    }
    return sum;
  }

  /// Loop's weight of each of n neighbours.
  static double Beta(std::size_t n)
  {
    const double cosine = 0.375 + 0.25 * std::cos(2. * std::acos(-1.) / static_cast<double>(n));
    return (0.625 - cosine * cosine) / static_cast<double>(n);
  }

  MesoVector Moved(std::int64_t vertex) const
  {
    const auto& neighbours = this->Neighbours[vertex];
    const auto& border = this->Border[vertex];
    if (border.size() == 2)
    {
      return this->Blend(vertex, 0.75, border, 0.125);
    }
    if (!border.empty() || neighbours.size() < 3)
    {
      return this->Positions[vertex];
    }
    const double beta = Beta(neighbours.size());
    return this->Blend(
      vertex, 1. - static_cast<double>(neighbours.size()) * beta, neighbours, beta);
  }

  MesoVector Limit(std::int64_t vertex) const
  {
    const auto& neighbours = this->Neighbours[vertex];
    const auto& border = this->Border[vertex];
    if (border.size() == 2)
    {
      return this->Blend(vertex, 2. / 3., border, 1. / 6.);
    }
    if (!border.empty() || neighbours.size() < 3)
    {
      return this->Positions[vertex];
    }
    const double own = 0.375 / Beta(neighbours.size());
    const double sum = own + static_cast<double>(neighbours.size());
    return this->Blend(vertex, own / sum, neighbours, 1. / sum);
  }

  MesoVector Middle(const Pair& ends, const Edge& edge) const
  {
    const MesoVector sum = MesoSum(this->Positions[ends[0]], this->Positions[ends[1]]);
    if (edge.Opposite.size() != 2)
    {
      return MesoScaled(sum, 0.5);
    }
    const MesoVector opposite =
      MesoSum(this->Positions[edge.Opposite[0]], this->Positions[edge.Opposite[1]]);
    return MesoSum(MesoScaled(sum, 0.375), MesoScaled(opposite, 0.125));
  }
};
}

MesoSubdividedMesh MesoSubdivide(const MesoSubdividedMesh& coarse)
{
  const MesoTriangleMesh& mesh = coarse.Mesh;
  Rings rings(mesh);
  MesoSubdividedMesh fine;
  fine.Mesh.PositionRounding = mesh.PositionRounding;
  fine.Mesh.Vertex = mesh.Vertex;
  fine.Coordinates = coarse.Coordinates;
  for (const std::int64_t vertex : mesh.Vertex)
  {
    fine.Mesh.Positions.push_back(rings.Moved(vertex));
  }
  auto vertices = static_cast<std::int64_t>(mesh.Positions.size());
  for (auto& edge : rings.Edges)
  {
    edge.second.Number = vertices++;
  }
  // The new point between two points: charts that meet at an edge have one each.
  std::map<Pair, std::int64_t> middles;
  const auto middleOf = [&](std::int64_t a, std::int64_t b)
  {
    const std::int64_t ends[] = { mesh.Vertex[a], mesh.Vertex[b] };
    if (ends[0] == ends[1])
    {
      return a; // a collapsed edge stays so
    }
    const auto found =
      middles.emplace(Sorted(a, b), static_cast<std::int64_t>(fine.Mesh.Positions.size()));
    if (found.second)
    {
      const Pair key = Sorted(ends[0], ends[1]);
      const Edge& edge = rings.Edges.at(key);
      fine.Mesh.Positions.push_back(rings.Middle(key, edge));
      fine.Mesh.Vertex.push_back(edge.Number);
      if (!coarse.Coordinates.empty())
      {
        const auto& first = coarse.Coordinates[a];
        const auto& second = coarse.Coordinates[b];
        fine.Coordinates.push_back({ 0.5 * (first[0] + second[0]), 0.5 * (first[1] + second[1]) });
      }
    }
    return found.first->second;
  };
  for (const auto& corners : mesh.Triangles)
  {
    std::array<std::int64_t, 3> middle;
    for (int k = 0; k < 3; ++k)
    {
      middle[k] = middleOf(corners[k], corners[(k + 1) % 3]);
    }
    fine.Mesh.Triangles.push_back({ corners[0], middle[0], middle[2] });
    fine.Mesh.Triangles.push_back({ middle[0], corners[1], middle[1] });
    fine.Mesh.Triangles.push_back({ middle[2], middle[1], corners[2] });
    fine.Mesh.Triangles.push_back(middle);
  }
  // Vertices are to be counted from 0 to less than there are points.
  std::map<std::int64_t, std::int64_t> numbers;
  for (std::int64_t& vertex : fine.Mesh.Vertex)
  {
    vertex = numbers.emplace(vertex, static_cast<std::int64_t>(numbers.size())).first->second;
  }
  return fine;
}

void MesoMoveToLimit(MesoTriangleMesh& mesh)
{
  const Rings rings(mesh);
  for (std::size_t i = 0; i < mesh.Positions.size(); ++i)
  {
    mesh.Positions[i] = rings.Limit(mesh.Vertex[i]);
  }
}
