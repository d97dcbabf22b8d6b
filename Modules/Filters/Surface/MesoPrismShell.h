#ifndef MesoPrismShell_h
#define MesoPrismShell_h

/**
 * @file MesoPrismShell.h
 * @brief A mesh's triangles extruded to prisms that share their corners, fins and the fins' diagonals.
 *
 * A prism's points are, for z in [0, 1] and b over the triangle (Wang2004, section 3.1),
 *
 *     q(b, z) = sum_i b_i (Bottom_i + z Rise_i),    Bottom_i = p_i - r H n_i,    Rise_i = H n_i
 *
 * with p_i and n_i the triangle's corners and unit normals, H the thickness and r the part of it that
 * lies below the mesh. Fin k stands over the edge from corner k to corner k + 1; between four corners
 * it is bilinear, and two triangles stand for it.
 */

#include "MesoTriangleMesh.h"

#include <cstdint>
#include <vector>

struct MesoPrism
{
  std::array<MesoVector, 3> Bottom;
  std::array<MesoVector, 3> Rise;
  std::array<std::int64_t, 3> Points; ///< of the mesh
  std::int64_t Triangle = 0;          ///< of the mesh
  /// Bit k: fin k is cut from the top of its corner k to the bottom of its corner k + 1, else from the
  /// bottom of the first to the top of the second. The prism beyond the fin cuts it alike.
  int Falling = 0;
  /// Bit k: what fills the prism ends at fin k: no prism is beyond it, or one whose texture
  /// coordinates do not go on.
  int Ends = 0;
  /// Of each fin the prism on its other side, -1: none.
  std::array<std::int64_t, 3> Beyond = { -1, -1, -1 };
  bool Turned = false; ///< its corners run the other way round than in most prisms

  int Flags() const { return this->Falling + 8 * this->Ends; }
};

struct MesoPrismShellInput
{
  MesoTriangleMesh Mesh;
  std::vector<MesoVector> Normals;                ///< a point each, unit
  std::vector<std::array<double, 2>> Coordinates; ///< a point each
  std::array<double, 2> Tiles = { 1., 1. };       ///< map coordinate = texture coordinate x tiles
  double Thickness = 0.;                          ///< H, object units
  double Reference = 0.;                          ///< r
  bool Clamp = false;                             ///< make prisms thinner that would turn over
};

struct MesoPrismShell
{
  std::vector<MesoPrism> Prisms;
  std::int64_t DegenerateTriangles = 0; ///< without area: no prism stands on them
  std::int64_t OpenFins = 0;            ///< beyond which there is no prism
  std::int64_t SeamFins = 0;            ///< across which texture coordinates do not go on
  /// Triangles whose prism turns over somewhere: its Jacobian dq/d(b, z) is not everywhere of one
  /// sign. With Clamp: those that had to be made thinner.
  std::vector<std::int64_t> Inverted;
  double LeastRise = 1.; ///< the smallest part of the thickness that Clamp has left
};

/// Points of one merged vertex and (to 1e-5) one normal are one corner of the shell; where normals
/// differ, at hard edges, the shell comes apart as the surface does, and each side ends by a fin.
MesoPrismShell MesoMakePrismShell(const MesoPrismShellInput& input);

/// The least of the Jacobian's determinant in a prism over its size at the prism's middle; at most 0
/// where the prism turns over, passes through a point, or has no volume.
double MesoLeastJacobian(const MesoPrism& prism);

#endif
