#ifndef MesoTriangleMesh_h
#define MesoTriangleMesh_h

/**
 * @file MesoTriangleMesh.h
 * @brief Triangles over points, the pairs of triangles at their edges, and sets of their corners.
 *
 * Corner c = 3 t + k is the k-th corner of triangle t; half-edge c runs from corner c to the next
 * corner of its triangle.
 */

#include "MesoVector.h"

#include <array>
#include <cstdint>
#include <vector>

struct MesoTriangleMesh
{
  std::vector<MesoVector> Positions; ///< n, finite, in object space
  /// n: number of the merged vertex, from 0 to less than n.
  std::vector<std::int64_t> Vertex;
  std::vector<std::array<std::int64_t, 3>> Triangles; ///< point numbers
  /// Rounding of the stored positions, relative to their size: 2^-24 where they come from floats.
  double PositionRounding = 0.;

  std::int64_t NumberOfCorners() const
  {
    return static_cast<std::int64_t>(3 * this->Triangles.size());
  }
  std::int64_t PointOf(std::int64_t corner) const
  {
    return this->Triangles[corner / 3][corner % 3];
  }
  std::int64_t VertexOf(std::int64_t corner) const { return this->Vertex[this->PointOf(corner)]; }
  static std::int64_t Next(std::int64_t corner)
  {
    return corner % 3 == 2 ? corner - 2 : corner + 1;
  }
};

/// For each half-edge the other one at its edge, in either direction, or -1. Two that are alone
/// between the same points are a pair, wherever else sheets touch; of those that are left, two that
/// are alone between the same merged vertices. Triangles that are not `used` are taken not to be
/// there.
std::vector<std::int64_t> MesoPairHalfEdges(
  const MesoTriangleMesh& mesh, const std::vector<bool>& used);

/// Sets of corners, joined pair by pair. The smallest corner of a set stands for it.
class MesoCornerSets
{
public:
  explicit MesoCornerSets(std::int64_t size);

  std::int64_t Find(std::int64_t corner);
  void Join(std::int64_t a, std::int64_t b);

private:
  std::vector<std::int64_t> Parent;
};

#endif
