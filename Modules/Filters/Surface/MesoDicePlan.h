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
 * A triangle is cut into rows between its shortest edge, of n segments, and the corner opposite: R of
 * them, R being the segments of its longest edge. Row r, counted from the corner, has
 * m = ceil(n r / R) segments, so that a triangle that is long in the map is not cut finely across.
 * Where all three edges have the same number this is the barycentric grid of R^2 triangles. Else
 * the points on edges need not lie on rows: then only points inside the triangle are on rows, and a
 * ladder of triangles joins them to the points of each edge, and the edges to each other where rows
 * are too short to have points inside.
 *
 * Points are numbered: those of the mesh that a triangle uses, in their order; those inside the
 * edges, side after side; those inside the triangles. A side is a pair of the mesh's points along an
 * edge: at a seam of the texture an edge has two sides, and the points on each have numbers of
 * their own. Triangles with two corners in one merged vertex have no inside and are left out: what
 * they would join lies on one edge already.
 *
 * Work comes in items, each of which fills in its own points and triangles: a grid has Rows of them.
 */

#include "MesoTriangleMesh.h"

#include <cstdint>
#include <vector>

class MesoDicePlan
{
public:
  /// A triangle of the mesh with its rows.
  struct Grid
  {
    std::int64_t Triangle; ///< number in the mesh
    std::int64_t Apex;     ///< corner opposite the shortest edge: 0, 1 or 2
    std::int64_t Rows;     ///< R
    std::int64_t Short;    ///< n
    bool Uniform;          ///< all edges have R segments
    std::int64_t FirstPoint;
    std::int64_t FirstTriangle;
    std::int64_t FirstItem;

    /// Number of points of row r, 0 to R - 1, that lie inside the triangle: m - 1.
    std::int64_t Inside(std::int64_t r) const
    {
      return r > 0 ? (this->Short * r - 1) / this->Rows : 0;
    }
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
  /// A point inside a triangle, with weights (1 - I - J, I, J) of its corners.
  struct Inner
  {
    std::int64_t Point;
    double I;
    double J;
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
  /// The points that item `row` of a grid fills in: `place` is 0 to less than grid.Inside(row).
  static Inner InnerAt(const Grid& grid, std::int64_t row, std::int64_t place);
  /// Writes the item's triangles (three point numbers each) into the list of all triangles.
  void WriteTriangles(const Grid& grid, std::int64_t row, std::int32_t* triangles) const;

private:
  void FindSides(const MesoTriangleMesh& mesh, const std::vector<std::array<double, 2>>& texels,
    double facetsPerTexel);
  /// As a double, which does not overflow.
  double MakeGrids(const MesoTriangleMesh& mesh);
  void Number(const MesoTriangleMesh& mesh);

  std::int64_t SegmentsOf(std::int64_t corner) const;
  /// The point `segment` segments along a corner's half-edge, in its own direction.
  std::int64_t OnHalfEdge(std::int64_t corner, std::int64_t segment) const;
  /// Number of triangles of a grid, and of those of its rows before row r.
  std::int64_t TrianglesOf(const Grid& grid) const;
  static std::int64_t TrianglesBefore(const Grid& grid, std::int64_t r);
  void WriteUniformRow(const Grid& grid, std::int64_t row, std::int32_t* out) const;
  /// How many segments of the two edges at the apex end before the first point inside: there the
  /// edges are joined to each other.
  std::array<std::int64_t, 2> TipOf(const Grid& grid) const;
  std::int32_t* WriteTip(
    const Grid& grid, const std::array<std::int64_t, 2>& tip, std::int32_t* out) const;
  void WriteRim(const Grid& grid, std::int64_t edge, std::int32_t* out) const;

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
