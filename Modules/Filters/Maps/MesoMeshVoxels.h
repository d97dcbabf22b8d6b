#ifndef MesoMeshVoxels_h
#define MesoMeshVoxels_h

#include "MesoVolume.h"

/**
 * @class MesoMeshVoxels
 * @brief The distances of a volume's samples to the triangles of a closed mesh.
 *
 * The mesh repeats in x and y with the tile, so what reaches out of one side of it comes in at the other, and
 * parts may be cut at the border. Inside is what triangles wind around: each column of samples counts
 * how often it has come in and gone out, with every edge given to one of its two triangles. Within a few
 * samples of a triangle distances are exact; further off they are this far, with the right sign, for
 * MesoDistanceTransform to complete.
 */
class MesoMeshVoxels
{
public:
  using Point = std::array<double, 3>;
  using Triangle = std::array<Point, 3>;

  /**
   * @param size samples of the tile
   * @param depth of the shell, tile widths
   */
  MesoMeshVoxels(std::array<int, 3> size, double depth);

  /// Triangles in tile widths, z from 0 to `depth`, wound so that they face outwards.
  void Add(const Triangle& triangle);

  /// Distances, negative inside; x fastest.
  std::vector<float> Finish() const;

private:
  struct Crossing
  {
    double Z;
    int Turn; ///< 1 where the column comes in, going up
  };

  void AddCrossings(const Triangle& triangle);
  void AddDistances(const Triangle& triangle);

  const std::array<int, 3> Size;
  const Point Spacing;
  const double Band;            ///< distances that are exact
  std::vector<float> Distances; ///< without sign
  std::vector<std::vector<Crossing>> Columns;
};

#endif
