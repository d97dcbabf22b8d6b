#include "MesoTriangleMesh.h"

#include "MesoFirstEqual.h"

#include <algorithm>
#include <numeric>

namespace
{
/// Pairs those half-edges that are alone with one other between two ends, numbers by corner.
void PairBy(const MesoTriangleMesh& mesh, bool byVertex, const std::vector<std::int64_t>& halfEdges,
  std::vector<std::int64_t>& partner)
{
  const auto numberOf = [&](std::int64_t corner)
  { return static_cast<double>(byVertex ? mesh.VertexOf(corner) : mesh.PointOf(corner)); };
  std::vector<std::array<double, 2>> ends;
  ends.reserve(halfEdges.size());
  for (std::int64_t c : halfEdges)
  {
    const double a = numberOf(c);
    const double b = numberOf(MesoTriangleMesh::Next(c));
    ends.push_back({ std::min(a, b), std::max(a, b) });
  }
  const std::vector<std::int64_t> edge = MesoFirstEqual(ends);
  std::vector<std::int64_t> count(edge.size(), 0);
  std::vector<std::int64_t> last(edge.size(), -1);
  for (std::size_t i = 0; i < edge.size(); ++i)
  {
    ++count[edge[i]];
    last[edge[i]] = halfEdges[i];
  }
  for (std::size_t i = 0; i < edge.size(); ++i)
  {
    if (edge[i] == static_cast<std::int64_t>(i) && count[i] == 2)
    {
      partner[halfEdges[i]] = last[i];
      partner[last[i]] = halfEdges[i];
    }
  }
}
}

std::vector<std::int64_t> MesoPairHalfEdges(
  const MesoTriangleMesh& mesh, const std::vector<bool>& used)
{
  const std::int64_t corners = mesh.NumberOfCorners();
  std::vector<std::int64_t> partner(corners, -1);
  for (const bool byVertex : { false, true })
  {
    std::vector<std::int64_t> halfEdges;
    for (std::int64_t c = 0; c < corners; ++c)
    {
      if (used[c / 3] && partner[c] < 0)
      {
        halfEdges.push_back(c);
      }
    }
    PairBy(mesh, byVertex, halfEdges, partner);
  }
  return partner;
}

MesoCornerSets::MesoCornerSets(std::int64_t size)
  : Parent(size)
{
  std::iota(this->Parent.begin(), this->Parent.end(), std::int64_t(0));
}

std::int64_t MesoCornerSets::Find(std::int64_t corner)
{
  while (this->Parent[corner] != corner)
  {
    this->Parent[corner] = this->Parent[this->Parent[corner]];
    corner = this->Parent[corner];
  }
  return corner;
}

void MesoCornerSets::Join(std::int64_t a, std::int64_t b)
{
  a = this->Find(a);
  b = this->Find(b);
  this->Parent[std::max(a, b)] = std::min(a, b);
}
