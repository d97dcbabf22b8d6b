#ifndef MesoReferenceTracer_h
#define MesoReferenceTracer_h

/**
 * @class MesoReferenceTracer
 * @brief Rays against all surfaces of a scene: exactly, or as diced triangles.
 *
 * Exact: each patch is a box in the hierarchy, and MesoPatchSolver finds the hits in it. Diced, the
 * independent second way: each triangle of a base mesh is cut into n x n facets, about as many to a
 * texel as asked for, whose corners lie on the true surface, and Embree intersects those; t is then
 * found again in double. Which facets face away is told by their own winding.
 *
 * Back faces are passed through by the eye's rays. A `two_sided` surface is hit from behind as well:
 * one without a map itself, a displaced one as its plain base. Light is stopped by either side.
 */

#include "MesoRayScene.h"
#include "MesoReferenceSurface.h"

#include <memory>
#include <vector>

/// What tracing has cost, and how exact it was.
struct MesoTraceWork
{
  std::uint64_t Rays = 0;
  MesoSolverWork Solver;

  void Add(const MesoTraceWork& other);
};

class MESORENDERINGREFERENCE_EXPORT MesoReferenceTracer
{
public:
  struct Ray
  {
    glm::dvec3 Origin;
    glm::dvec3 Direction;
    double TMin = 0.;
    double TMax = 0.;
  };

  /// facetsPerTexel 0: exact. Throws MesoInputError where a closed form is to be diced, or where the
  /// facets would be more than MostFacets.
  MesoReferenceTracer(
    const std::vector<std::unique_ptr<MesoReferenceSurface>>& surfaces, double facetsPerTexel);

  static constexpr std::size_t MostFacets = 200000000;

  /// Of all surfaces only what lies on the side that the normal points to is there, for Trace and
  /// Blocked. World space.
  void AddClippingPlane(const glm::dvec3& point, const glm::dvec3& normal);

  /// The nearest hit.
  bool Trace(const Ray& ray, MesoReferenceHit& hit, MesoTraceWork& work) const;

  /// Whether anything lies in the way from a point of the surface `from`. With `alone` only that
  /// surface counts. Its own plain base, drawn from behind, never does.
  bool Blocked(const Ray& ray, int from, bool alone, MesoTraceWork& work) const;

  /// Whether the ray meets a front face of this surface's base.
  bool MeetsBase(const Ray& ray, int surface, MesoTraceWork& work) const;

  std::size_t NumberOfFacets() const { return this->Facets; }
  std::size_t MemoryBytes() const;

private:
  class Query;
  /// The facets of one mesh: rows of the triangles' grids, one triangle after the other.
  struct Dicing
  {
    std::vector<std::uint32_t> Cuts;       ///< of each triangle
    std::vector<std::uint32_t> FirstFacet; ///< of each triangle, and of the end
  };
  void Dice(double facetsPerTexel);
  /// The stretch of a ray that the clipping planes keep; TMin > TMax where there is none.
  Ray Kept(const Ray& ray) const;
  /// A hit on a facet as one on the patch that it was cut from; t in double.
  void FromFacet(const Ray& ray, MesoReferenceHit& hit) const;

  const std::vector<std::unique_ptr<MesoReferenceSurface>>& Surfaces;
  MesoRayScene Patches;
  std::unique_ptr<MesoRayScene> Diced;
  std::vector<Dicing> Dicings;
  std::size_t Facets = 0;
  std::vector<glm::dvec4> ClippingPlanes; ///< (n, d): n.p + d >= 0 is kept
  bool AnyTwoSided = false;               ///< among the displaced
};

#endif
