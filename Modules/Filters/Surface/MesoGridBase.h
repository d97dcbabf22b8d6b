#ifndef MesoGridBase_h
#define MesoGridBase_h

/**
 * @class MesoGridBase
 * @brief The triangles of a mesh as the bases of grids, and how finely each of their edges is cut.
 *
 * A grid is a barycentric lattice over a triangle whose points are placed where they are drawn, by
 * the vertex stage (Shaders/Techniques/Displacement.glsl): none of them is held in memory.
 *
 * An edge between two merged vertices is cut into a number of segments that the edge alone decides,
 * whatever triangles and charts meet there:
 *
 *     segments = max(1, ceil(min(facets a texel x texels, pixels / pixels a facet)))
 *
 * texels being max(|ds|, |dt|) of the longest of its sides, as in MesoDicePlan, and pixels the edge's
 * length at its nearer end, seen from before. A triangle's lattice has as many rows as its finest edge
 * has segments; points on its coarser edges are moved to the nearest of the edge's own, so that
 * neighbours have the same points there and nothing gapes between them.
 *
 * A lattice is drawn as pieces of at most MostRows rows, which all share one list of indices: the
 * first 3 n^2 are the grid of n rows (Shaders/Kernels/BarycentricGrid.glsl). Where it is cut into
 * pieces it may have a few rows more than its edges ask for.
 *
 * Points that are one merged vertex get the position of the first of them, and its normal where theirs
 * are equal but for rounding, so that edges are the same to the last bit from both sides. Triangles
 * with two corners in one merged vertex are left out.
 */

#include "MesoVector.h"
#include "mesoFiltersSurfaceModule.h" // for export macro

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

class vtkPolyData;

/// How a mesh is seen. Matrices are row-major and stand left of columns.
struct MesoGridView
{
  std::array<double, 16> ModelToView;
  std::array<double, 16> Projection; ///< view to clip coordinates
  double Near = 0.;                  ///< distance of the near plane
  double Height = 0.;                ///< of the picture, pixels
};

/// How finely edges are to be cut.
struct MesoGridSize
{
  std::array<double, 2> Texels = { 1., 1. }; ///< a unit of the mesh's own texture coordinate
  double FacetsPerTexel = 1.;
  double Reach = 0.; ///< how far the surface may lie from the mesh, object units
  /// Pixels along a facet's side; 0: texels alone decide, and all is drawn, seen or not.
  double FacetPixels = 0.;
};

/// Pieces to be drawn. Each is eight numbers: triangle, first I and J of the lattice, rows of the
/// lattice; segments of the three edges, below 0 where they count against the corners' order, and 1, or
/// -1 for a piece that is upside down.
struct MesoGridPieces
{
  struct Group
  {
    int Rows;
    int First;
    int Count;
  };
  std::vector<Group> Groups;
  std::vector<float> Numbers;
  std::int64_t Triangles = 0;
};

class MESOFILTERSSURFACE_EXPORT MesoGridBase
{
public:
  /// Rows of a piece, at most: 2145 points, which 16 bits count.
  static constexpr int MostRows = 64;
  /// Triangles of all pieces together, at most.
  static constexpr std::int64_t MostTriangles = 100000000;

  /// From a mesh with normals and texture coordinates. Throws std::invalid_argument that says what is
  /// missing or not finite.
  explicit MesoGridBase(vtkPolyData* mesh);

  ///@{
  /// By point.
  const std::vector<MesoVector>& GetPositions() const { return this->Positions; }
  const std::vector<MesoVector>& GetNormals() const { return this->Normals; }
  const std::vector<std::array<double, 2>>& GetCoordinates() const { return this->Coordinates; }
  ///@}
  /// Point numbers.
  const std::vector<std::array<std::int64_t, 3>>& GetTriangles() const { return this->Triangles; }

  /// The pieces that a view needs; all of them where `view` is null or FacetPixels 0. Throws
  /// std::invalid_argument where they are more than MostTriangles.
  MesoGridPieces PiecesFor(const MesoGridSize& size, const MesoGridView* view) const;

  /// Indices of the grid of MostRows rows, row by row, three a triangle.
  static std::vector<std::uint16_t> MakeIndices();

private:
  struct Edge
  {
    std::array<std::int64_t, 2> Ends = { 0, 0 }; ///< points, the one of the lesser vertex first
    std::array<double, 2> Extent = { 0., 0. };   ///< |du|, |dv| of its longest side
  };

  void Weld(const std::vector<std::int64_t>& vertices);
  void FindEdges(const std::vector<std::int64_t>& vertices);
  std::int64_t SegmentsOf(
    const Edge& edge, const MesoGridSize& size, const std::optional<MesoGridView>& view) const;

  std::vector<MesoVector> Positions;
  std::vector<MesoVector> Normals;
  std::vector<std::array<double, 2>> Coordinates;
  std::vector<std::array<std::int64_t, 3>> Triangles;
  std::vector<std::array<std::int64_t, 3>> EdgesOf; ///< edge k runs from corner k to the next
  std::vector<std::array<bool, 3>> Backwards;       ///< it runs against its edge
  std::vector<bool> Flat;                           ///< two corners are one vertex
  std::vector<Edge> Edges;
};

#endif
