#ifndef MesoSmoothPatches_h
#define MesoSmoothPatches_h

/**
 * @file MesoSmoothPatches.h
 * @brief The vertices of a mesh as smooth surface sees them, and the rings around each.
 *
 * A **site** is a merged vertex together with a set of triangles around it that are joined by edges
 * bent by no more than the feature angle (MesoMakeCornerNormals with `split`). A vertex within a
 * smooth surface is one site, whatever seams the texture has; one on a crease has a site on each
 * side of it. Sites are neighbours where a triangle's edge joins them, so that no path leads across
 * a crease.
 */

#include "MesoCornerNormals.h"
#include "mesoFiltersSurfaceModule.h" // for export macro

class MESOFILTERSSURFACE_EXPORT MesoSmoothPatches
{
public:
  /// Keeps a reference to the mesh. Degrees.
  MesoSmoothPatches(const MesoTriangleMesh& mesh, double featureAngle);

  std::int64_t NumberOfSites() const { return static_cast<std::int64_t>(this->Normals.size()); }
  const MesoVector& NormalOf(std::int64_t site) const { return this->Normals[site]; }
  const MesoVector& PositionOf(std::int64_t site) const
  {
    return this->Mesh.Positions[this->Points[site]];
  }
  /// The site that a point's triangles meet in; -1 where it has no triangle with area. Where they
  /// meet in several, for a crease runs through or sheets touch there, it is the one that has more
  /// than 4/5 of their angles (the rest then is slivers or a fold), or -1.
  std::int64_t SiteOf(std::int64_t point) const { return this->SiteOfPoint[point]; }
  /// Which part of the angles around the point its site has: 1 within smooth surface, 0 without
  /// site.
  double ShareOf(std::int64_t point) const { return this->ShareOfPoint[point]; }

  /// Bookkeeping of one thread.
  struct Walk
  {
    std::vector<std::int64_t> Sites; ///< found so far, nearest ring first, without the centre
    std::vector<std::size_t> RingEnds;
    std::vector<std::int32_t> Seen; ///< by site: number of the walk that saw it last
    std::int32_t Number = 0;
    std::int64_t Centre = 0;
  };

  void Begin(std::int64_t site, Walk& walk) const;
  /// Adds the next ring; false where there is none. Of a vertex with very many neighbours, and of a
  /// ring with very many vertices, an even choice is taken, so that time stays linear.
  bool AddRing(Walk& walk) const;

private:
  void FindSites(const std::vector<MesoTriangleMeasure>& measures, double featureAngle);
  void FindSitesOfPoints(const std::vector<MesoTriangleMeasure>& measures);
  void FindNeighbours(const std::vector<MesoTriangleMeasure>& measures);

  const MesoTriangleMesh& Mesh;
  std::vector<std::int64_t> SiteOfCorner; ///< -1 in triangles without area
  std::vector<std::int64_t> SiteOfPoint;
  std::vector<double> ShareOfPoint;
  std::vector<std::int64_t> Points; ///< by site: a point there
  std::vector<MesoVector> Normals;
  std::vector<std::int64_t> Start; ///< by site, and one more
  std::vector<std::int64_t> Neighbours;
};

#endif
