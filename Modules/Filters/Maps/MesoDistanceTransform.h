#ifndef MesoDistanceTransform_h
#define MesoDistanceTransform_h

#include "MesoPointTree.h"
#include "MesoVolume.h"

class vtkAlgorithm;

/**
 * @class MesoDistanceTransform
 * @brief The distance of every sample of a volume to the surface between its samples.
 *
 * The surface is the zero set of the trilinear interpolant of the values, not the samples' borders, so
 * distances are right to a small part of a voxel. Points of it are found in every cell that it passes
 * (where it cuts the cell's edges, and eight that are moved onto it along the gradient); the nearest of them,
 * over tiles too, is slid along the surface to the foot of the perpendicular. Euclidean in
 * (x, y, F z); exact up to the curvature within a cell.
 *
 * Where there is no surface at all, every distance is 1 + F.
 */
class MesoDistanceTransform
{
public:
  explicit MesoDistanceTransform(const MesoVolumeField& field);

  /// Signed distances of slices [first, last) to `distances`, x fastest; signs are those of the values.
  void Slices(int first, int last, float* distances) const;

private:
  using Vector = MesoVolumeField::Vector;

  std::vector<Vector> FindSurface() const;
  bool Project(Vector& position) const;
  double DistanceOf(const Vector& position, std::size_t& nearest) const;

  const MesoVolumeField& Field;
  const double Voxel;    ///< the shorter of a voxel's sides in x and y
  MesoPointTree Surface; ///< points of it in tile widths, over half a tile more to each side
};

/// The canonical volume of values whose zero set is the surface. `filter` tells progress; where it was
/// aborted there is none.
vtkSmartPointer<vtkImageData> MesoCanonicalVolume(
  const MesoVolumeField& field, vtkAlgorithm* filter);

#endif
