#ifndef MesoDetailProjection_h
#define MesoDetailProjection_h

/**
 * @class MesoDetailProjection
 * @brief Where a line along a base's normal meets a detailed mesh.
 *
 * Looks inward and outward at once, for the nearest crossing of the detail's outer side: a triangle
 * whose normal, by its own winding, points along the base's. Lines are found by Embree, crossings
 * computed in double.
 */

#include "MesoRayScene.h"
#include "MesoTriangleMesh.h"

#include <optional>

class MESOFILTERSSURFACE_EXPORT MesoDetailProjection
{
public:
  struct Hit
  {
    double Distance;               ///< along the direction, signed
    std::int64_t Triangle;         ///< of the detail
    std::array<double, 3> Weights; ///< of its corners, [0,1], sum 1
    int Crossings;                 ///< of the outer side within reach; more than one is a fold
  };

  /// The mesh is kept by reference. Throws std::runtime_error where Embree cannot hold it.
  explicit MesoDetailProjection(const MesoTriangleMesh& detail);

  /// `direction` is unit; crossings up to `reach` away count. For any number of threads.
  std::optional<Hit> Find(const MesoVector& from, const MesoVector& direction, double reach) const;

private:
  const MesoTriangleMesh& Detail;
  MesoRayScene Rays;
};

#endif
