#ifndef MesoPrismSolver_h
#define MesoPrismSolver_h

/**
 * @file MesoPrismSolver.h
 * @brief The first meeting of a ray with the matter of a volume in one prism, in double.
 *
 * The prism's points are q = sum_i b_i (Bottom_i + z Rise_i), bounded by bilinear fins. Where a ray crosses
 * the planes of bottom and top and the ruled surfaces of the fins is known in closed form, and whether a
 * stretch between two crossings lies inside from the cubic that z of its middle solves. Inside, the ray's
 * way through texture space is curved; it is followed without an approximation, by steps that cannot
 * pass a zero of the volume's trilinear distance: the distance over a bound of its change along the way.
 * Steps are at least a thousandth of a voxel, so that what a ray is in for less than that may be missed.
 */

#include "MesoPatchSolver.h" // for MesoSolverWork
#include "MesoVolume.h"
#include "mesoRenderingReferenceModule.h" // for export macro

#include <array>
#include <vector>

/// A canonical volume, and how fast its distance changes at most, per tile width.
class MESORENDERINGREFERENCE_EXPORT MesoVolumeTruth
{
public:
  explicit MesoVolumeTruth(vtkImageData* volume);

  const MesoVolumeField& Field() const { return this->Samples; }
  double At(const glm::dvec3& place) const
  {
    return this->Samples.At({ place.x, place.y, place.z });
  }
  /// Of the interpolant itself, over texture space.
  glm::dvec3 Gradient(const glm::dvec3& place) const;
  /// Central differences of one voxel.
  glm::dvec3 SmoothGradient(const glm::dvec3& place) const;
  /// Red, green and blue; 1 where the volume has no colours.
  glm::dvec3 ColorAt(const glm::dvec3& place) const;
  double MostChange() const { return this->Most; }
  /// The shortest side of a voxel, tile widths.
  double VoxelSide() const;

private:
  MesoVolumeField Samples;
  double Most = 0.;
  std::vector<glm::dvec3> Colors; ///< x fastest; none where the volume has none
};

/// A prism, and how the map lies over it.
struct MESORENDERINGREFERENCE_EXPORT MesoTruePrism
{
  std::array<glm::dvec3, 3> Bottom;
  std::array<glm::dvec3, 3> Rise;
  std::array<glm::dvec2, 3> Map; ///< map coordinates

  /// dq/db1, dq/db2 and dq/dz at (b1, b2, z).
  glm::dmat3 Jacobian(const glm::dvec3& place) const;
  glm::dvec3 PointAt(const glm::dvec3& place) const;
  /// Texture space (x, y, z) of (b1, b2, z), and its change with them.
  glm::dvec3 ChartAt(const glm::dvec3& place) const;
  glm::dmat3 ChartJacobian() const;
  /// (b1, b2, z) of a point inside; false where it is outside.
  bool Find(const glm::dvec3& point, glm::dvec3& place) const;
};

struct MesoPrismHit
{
  double T = 0.;
  glm::dvec3 Place; ///< (b1, b2, z)
  /// The face through which the ray came in and at which it met matter at once: 0 bottom, 1 top, 2 + k
  /// the fin over the edge from corner k. -1: matter's own surface; -2: the ray starts in matter.
  int Cut = -1;
};

/// The first meeting of o + t d, t in [tMin, tMax].
MESORENDERINGREFERENCE_EXPORT bool MesoFirstInPrism(const MesoTruePrism& prism,
  const MesoVolumeTruth& volume, const glm::dvec3& origin, const glm::dvec3& direction, double tMin,
  double tMax, MesoPrismHit& hit, MesoSolverWork& work);

#endif
