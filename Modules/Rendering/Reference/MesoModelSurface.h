#ifndef MesoModelSurface_h
#define MesoModelSurface_h

/**
 * @class MesoModelSurface
 * @brief One node as its technique models it: fragments of the base mesh, and what a ray meets at one.
 *
 * Follows Shaders/Common/Surface.glsl and Shaders/Techniques line by line, in world space and double
 * precision, with MesoPathSolver in place of the search.
 */

#include "MesoPathSolver.h"
#include "MesoSceneBuilder.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// The base mesh where a ray meets it.
struct MesoModelFragment
{
  double T; ///< along the ray, whose direction is unit
  glm::dvec3 View;
  glm::dvec3 Normal; ///< unit, to the eye's side
  glm::dvec2 MapCoord;
  glm::dvec3 PerMapU;
  glm::dvec3 PerMapV;
  glm::dvec3 PerDepth;
  glm::dvec3 Quadric;
  glm::dvec3 Metric;
};

struct MesoModelHit
{
  double T;
  glm::dvec2 MapCoord;
  double Relief;
  glm::dvec3 Normal;
  glm::dvec3 FacetNormal;
};

class MesoModelSurface
{
public:
  explicit MesoModelSurface(const MesoSceneBuilder::Object& object);

  const std::vector<glm::dvec3>& WorldPoints() const { return this->Points; }
  const std::vector<std::array<std::uint32_t, 3>>& Corners() const { return this->Triangles; }
  bool CullsBackFaces() const { return this->Culls; }

  /// The fragment of a triangle on a ray; empty where the ray passes beside it by more than
  /// `rounding`, a length.
  std::optional<MesoModelFragment> FragmentAt(std::size_t triangle, bool front,
    const glm::dvec3& origin, const glm::dvec3& direction, double rounding) const;

  /// What the technique draws at the fragment; empty where it discards.
  std::optional<MesoModelHit> Solve(const MesoModelFragment& fragment) const;

  /// Whether the detail blocks light that comes from a unit direction and distance.
  bool Blocks(const MesoModelFragment& fragment, const MesoModelHit& hit,
    const glm::dvec3& towardsLight, double distance) const;

private:
  void Read(vtkPolyData* mesh, const glm::dmat4& matrix);
  bool SeenFromBehind(const MesoModelFragment& fragment) const;
  bool ToTexture(
    const MesoModelFragment& fragment, const glm::dvec3& vector, glm::dvec3& rates) const;
  glm::dvec3 ReliefNormal(
    const MesoModelFragment& fragment, const MesoModelHit& hit, const glm::dvec2& gradient) const;
  /// False where the base itself is drawn; `misses` where nothing is.
  bool FollowRay(const MesoModelFragment& fragment, MesoModelHit& hit, bool& misses) const;

  MesoMesostructureOptions Options;
  MesoEffects Effects;
  bool Traces = false; ///< the technique shows more than the base mesh
  bool Bends = false;  ///< relief-quadric
  bool Culls = true;
  glm::dmat3 Linear = glm::dmat3(1.);
  std::optional<MesoModelField> Field;
  MesoKernels::Double::Frame Frame;
  MesoKernels::Double::Quadric Quadrics;

  std::vector<glm::dvec3> Points; ///< world
  std::vector<std::array<std::uint32_t, 3>> Triangles;
  std::vector<glm::dvec3> Normals; ///< object space
  std::vector<glm::dvec2> Coordinates;
  std::vector<glm::dvec3> PerTCoordU; ///< object space
  std::vector<glm::dvec3> PerTCoordV;
  std::vector<glm::dvec3> QuadricsOverTexture;
  std::vector<glm::dvec3> Metrics;
};

#endif
