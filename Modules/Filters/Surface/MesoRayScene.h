#ifndef MesoRayScene_h
#define MesoRayScene_h

/**
 * @class MesoRayScene
 * @brief A bounding volume hierarchy over things of any kind: the one place that knows Embree.
 *
 * Embree computes in float; what is hit is decided in double by the caller. So Embree is given the
 * scene moved and scaled to a unit ball, rays from where they enter that ball, and boxes padded
 * by 1e-6 of it, ten times what a float ray can be off by: no box that the double ray meets is
 * passed over, wherever the scene lies and whatever its size.
 *
 * Two kinds of geometry: primitives with boxes of their own, for each of which the ray asks
 * MesoRayQuery::Test, and triangles, which Embree intersects itself (in float) and offers to
 * MesoRayQuery::TestTriangle.
 */

#include "MesoBox.h"                  // for what primitives fill
#include "mesoFiltersSurfaceModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

/// A ray o + t d in double, and what it makes of the things that lie in its way.
class MESOFILTERSSURFACE_EXPORT MesoRayQuery
{
public:
  virtual ~MesoRayQuery() = default;

  glm::dvec3 Origin;
  glm::dvec3 Direction; ///< any length but 0
  double TMin = 0.;
  double TMax = 0.;  ///< to be lowered as hits are found
  bool Done = false; ///< to be set where nothing further is asked for

  /// Look at a primitive, whose box the ray may meet.
  virtual void Test(int geometry, unsigned int primitive) = 0;
  /// Look at a triangle that the ray meets at t, as exact as float is; `front`: on the side from which
  /// its corners run counter-clockwise. False: the ray passes through.
  virtual bool TestTriangle(int geometry, unsigned int primitive, double t, bool front) = 0;
};

class MESOFILTERSSURFACE_EXPORT MesoRayScene
{
public:
  MesoRayScene();
  ~MesoRayScene();
  MesoRayScene(const MesoRayScene&) = delete;
  void operator=(const MesoRayScene&) = delete;

  /// Add primitives 0 to count - 1 with their boxes; a box that is not finite is left out. Returns
  /// the number that queries are told, from 0 in order of adding.
  int AddPrimitives(std::size_t count, const std::function<MesoBox(std::size_t primitive)>& boxOf);
  /// Add triangles by their corners.
  int AddTriangles(
    const std::vector<glm::dvec3>& points, std::vector<std::array<std::uint32_t, 3>> triangles);

  /// Build. Throws std::runtime_error where Embree cannot.
  void Commit();

  /// Let a ray meet what lies in its way, until nothing nearer can. For any number of threads.
  void Trace(MesoRayQuery& query) const;

  /// Length by which a ray may pass beside a triangle that it is said to meet: float's rounding.
  double Rounding() const;

  /// Bytes that Embree and the primitives' boxes hold.
  std::size_t MemoryBytes() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Inside;
};

#endif
