#ifndef MesoDicePlan_h
#define MesoDicePlan_h

/**
 * @class MesoDicePlan
 * @brief Which points and triangles a mesh is diced into; where they lie is left to others.
 *
 * An edge between two merged vertices is cut into as many segments as the longest of its sides asks
 * for, whatever triangles and charts meet there, so that all of them have the same points on it:
 *
 *     segments = max(1, ceil(facetsPerTexel * max(|ds|, |dt|)))
 *
 * with (ds, dt) the edge in texels. (A thousandth of a segment is forgiven, lest rounding add one.)
 * A triangle whose three edges have the same number N is cut into the N^2 triangles of the
 * barycentric grid. Any other has the inner part of the grid of N = max(3, its largest number): the
 * points with all three coordinates above 0, (N - 3)^2 triangles between them, and a ladder of
 * triangles from each side of that part to the points of the edge.
 *
 * Points are numbered: those of the mesh that a triangle uses, in their order; those inside the
 * edges, side after side; those inside the triangles. A side is a pair of the mesh's points along an
 * edge: at a seam of the texture an edge has two sides, and the points on each have numbers of
 * their own. Triangles with two corners in one merged vertex have no inside and are left out: what
 * they would join lies on one edge already.
 *
 * Work comes in items, each of which fills in its own points and triangles: Items in all, those of
 * triangle t being the Grid(t).Size from Grid(t).FirstItem on.
 */

#include "MesoTriangleMesh.h"

#include <cstdint>
#include <vector>

class MesoDicePlan
{
public:
  /// A triangle of the mesh with its grid.
  struct Grid
  {
    std::int64_t Triangle; ///< number in the mesh
    std::int64_t Size;     ///< N
    bool Uniform;          ///< all edges have N segments
    std::int64_t FirstPoint;
    std::int64_t FirstTriangle;
    std::int64_t FirstItem;
  };
  /// The points of the mesh along an edge, and the corners (half-edges) that run there. Segments run
  /// from the end in the lesser merged vertex.
  struct Side
  {
    std::array<std::int64_t, 2> Ends; ///< points of the mesh
    std::int64_t Segments;
    std::int64_t FirstPoint; ///< of the Segments - 1 points between the ends
    std::int64_t FirstHalfEdge;
    std::int64_t EndHalfEdge;
  };
  /// A point of an inner part's row: its weights are (Size - I - J, I, J) / Size.
  struct Inner
  {
    std::int64_t Point;
    std::int64_t I;
    std::int64_t J;
  };

  /// `texels` are the points' map coordinates in texels. Throws std::invalid_argument, which names
  /// the number and the limit, before memory is taken for more than `mostTriangles`.
  MesoDicePlan(const MesoTriangleMesh& mesh, const std::vector<std::array<double, 2>>& texels,
    double facetsPerTexel, std::int64_t mostTriangles);

  std::int64_t NumberOfPoints() const { return this->Points; }
  std::int64_t NumberOfTriangles() const { return this->Triangles; }
  std::int64_t NumberOfItems() const { return this->Items; }

  const std::vector<Grid>& GetGrids() const { return this->Grids; }
  const std::vector<Side>& GetSides() const { return this->Sides; }
  /// Sides by edge: those of edge e are numbered from GetEdges()[e] to less than GetEdges()[e + 1].
  const std::vector<std::int64_t>& GetEdges() const { return this->Edges; }
  /// Corners along the sides, as Side::FirstHalfEdge counts them.
  const std::vector<std::int64_t>& GetHalfEdges() const { return this->HalfEdges; }
  /// Number that a point of the mesh has among the diced points, -1 where nothing uses it.
  std::int64_t NumberOf(std::int64_t point) const { return this->Numbers[point]; }
  /// Number of the diced point on a side, `segment` segments from its first end.
  std::int64_t PointOn(const Side& side, std::int64_t segment) const;

  /// Where the grid of an item stands in GetGrids().
  std::int64_t GridOfItem(std::int64_t item) const;
  /// Number of points inside the triangle that an item of its grid (0 to Size - 1) fills in.
  static std::int64_t NumberOfInner(const Grid& grid, std::int64_t item);
  static Inner InnerAt(const Grid& grid, std::int64_t item, std::int64_t place);
  /// Writes the item's triangles (three point numbers each) into the list of all triangles.
  void WriteTriangles(const Grid& grid, std::int64_t item, std::int32_t* triangles) const;

private:
  void FindSides(const MesoTriangleMesh& mesh, const std::vector<std::array<double, 2>>& texels,
    double facetsPerTexel);
  /// As a double, which does not overflow.
  double MakeGrids(const MesoTriangleMesh& mesh);
  void Number(const MesoTriangleMesh& mesh);

  std::int64_t SegmentsOf(std::int64_t corner) const;
  /// The point `segment` segments along a corner's half-edge, in its own direction.
  std::int64_t OnHalfEdge(std::int64_t corner, std::int64_t segment) const;
  std::int64_t OnUniformGrid(const Grid& grid, std::int64_t i, std::int64_t j) const;
  void WriteLadder(const Grid& grid, std::int64_t edge, std::int32_t* out) const;

  std::vector<Grid> Grids;
  std::vector<Side> Sides;
  std::vector<std::int64_t> Edges;
  std::vector<std::int64_t> HalfEdges;
  std::vector<std::int64_t> SideOf; ///< by corner; -1 where the triangle is left out
  std::vector<bool> Backwards;      ///< by corner: it runs against its side
  std::vector<std::int64_t> Numbers;
  std::int64_t Points = 0;
  std::int64_t Triangles = 0;
  std::int64_t Items = 0;
};

#endif
