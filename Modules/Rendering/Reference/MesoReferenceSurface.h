#ifndef MesoReferenceSurface_h
#define MesoReferenceSurface_h

/**
 * @class MesoReferenceSurface
 * @brief One node's true surface: its base as patches, what is laid over them, and its matrix.
 *
 * A normal map that the node's material names gives the shading normals in place of the surface's own.
 *
 * The base is the node's mesh, with p linear and n normalised-linear in each triangle, or, where
 * the base is to be smooth, the closed form of its built-in shape, cut into as many rectangles as
 * the mesh has. Displaced: q = p + (h - r) D n. Not displaced (`plain`): q = p.
 * A volume lies in the shell of prisms over the mesh: MesoReferenceShell.
 *
 * A displaced triangle whose texture coordinates span no area, are not finite or beyond 1e12 texels, has no way to lay
 * the map over it: it is displaced evenly, by the height at its middle, or not at all, and counted.
 */

#include "MesoBasePatch.h"
#include "MesoHeightPyramid.h"
#include "MesoPatchSolver.h" // for MesoDisplacement
#include "MesoReferenceNormals.h"
#include "MesoReferenceShell.h"
#include "MesoSceneBuilder.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

/// Where a ray met a surface.
struct MesoReferenceHit
{
  int Object = -1; ///< index of the surface
  unsigned int Patch = 0;
  double T = 0.; ///< along the ray
  double X = 0.; ///< in the patch
  double Y = 0.;
  double Z = 0.;       ///< height in the prism, of volumes
  int Cut = -1;        ///< of volumes: MesoPrismHit
  bool OnBase = false; ///< the base itself, of a displaced surface, seen from behind
  bool Behind = false; ///< seen from behind
};

/// What is known of the surface at a hit; world space.
struct MesoReferencePoint
{
  glm::dvec3 Geometric; ///< unit, towards where the ray came from
  glm::dvec3 Shading;   ///< unit
  glm::dvec2 MapCoord;
  double Relief;
  glm::dvec3 Color =
    glm::dvec3(1.); ///< of the detail, by which diffuse and ambient light are multiplied
  double TexelSize; ///< the shorter side of a texel on the base; 1e-3 of the object without a map
};

class MESORENDERINGREFERENCE_EXPORT MesoReferenceSurface
{
public:
  /// Throws MesoInputError, naming the node, where there is no such surface: a matrix that flattens,
  /// polygons that are not triangles, no closed form where one is asked for.
  MesoReferenceSurface(
    const MesoSceneBuilder::Object& object, const MesoSceneMesh& source, bool smooth);

  std::size_t NumberOfPatches() const;

  /// Hand a patch, and what lies over it, to a function of both.
  template <typename Function>
  void WithPatch(std::size_t number, Function&& function) const;

  /// The base as a technique rasterises it: where height 1 lies, p + (1 - r) D n.
  MesoDisplacement DrawnBase() const;

  /// A box in world space around the patch's surface and its base.
  MesoBox BoundsOf(std::size_t patch) const;

  /// `ray`: direction of the ray that hit, in world space.
  MesoReferencePoint Describe(const MesoReferenceHit& hit, const glm::dvec3& ray) const;

  /// A point of the true surface for a patch's (x, y), in world space.
  glm::dvec3 PositionAt(std::size_t patch, double x, double y) const;

  /// (x, y) of the corners of a mesh's triangle in its patch.
  std::array<glm::dvec2, 3> PlacesOf(std::size_t triangle) const;

  bool IsDisplaced() const { return this->Displaced; }
  /// The volume of mesostructure over the mesh; null where there is none.
  const MesoReferenceShell* GetShell() const { return this->Shell.get(); }
  /// Whether detail lies over the base, of either kind.
  bool HasDetail() const { return this->Displaced || this->Shell; }
  bool IsTwoSided() const { return this->TwoSided; }
  bool IsSmooth() const { return this->Shape.has_value(); }
  const MesoHeightPyramid* GetMap() const { return this->Map.get(); }
  const glm::dmat4& WorldToObject() const { return this->Inverse; }
  const glm::dvec3& Centre() const { return this->Middle; }
  std::size_t NumberOfTriangles() const { return this->Triangles.size(); }
  std::size_t NumberOfDegenerateTriangles() const { return this->Degenerate; }
  std::size_t MemoryBytes() const;

private:
  MesoReferencePoint DescribeInShell(const MesoReferenceHit& hit, const glm::dvec3& ray) const;
  void ReadMesh(vtkPolyData* mesh, const MesoMesostructureOptions& options);
  void FindShape(const MesoSceneMesh& source);
  /// Whether the map can be laid over a triangle.
  bool HasChart(std::size_t triangle) const;
  MesoShapePatch ShapePatch(std::size_t number) const;
  MesoTrianglePatch TrianglePatch(std::size_t number) const;
  MesoDisplacement Over(std::size_t patch) const;
  glm::dvec2 MapCoordAt(const MesoBasePatch& patch, const MesoReferenceHit& hit) const;
  glm::dvec2 ShadingGradient(double x, double y) const;
  /// The normal map's shading normal in place of a hit's own, object space.
  std::optional<glm::dvec3> MappedNormal(const MesoReferenceHit& hit, const MesoBasePatch& patch,
    const glm::dvec3& px, const glm::dvec3& py, const glm::dvec3& normal) const;

  std::string Label; ///< "node 1 'wall'"
  bool Displaced = false;
  bool TwoSided = false;
  double Scale = 0.;
  double Reference = 1.;
  glm::dvec2 Tiles = glm::dvec2(1.);
  glm::dmat4 Matrix = glm::dmat4(1.);
  glm::dmat4 Inverse = glm::dmat4(1.);
  bool Mirrored = false;
  std::shared_ptr<const MesoHeightPyramid> Map; ///< null where not displaced
  std::unique_ptr<const MesoReferenceShell> Shell;
  std::optional<MesoReferenceNormals> NormalMap; ///< given in place of the surface's own normals
  std::optional<MesoShape> Shape;                ///< the base's closed form, where it is smooth

  std::vector<glm::dvec3> Points;
  std::vector<glm::dvec3> Normals;
  std::vector<glm::dvec2> Coordinates; ///< map coordinates; empty without any
  std::vector<std::array<std::uint32_t, 3>> Triangles;
  std::size_t Degenerate = 0;
  glm::dvec3 Middle = glm::dvec3(0.); ///< of the points' box, object space
  double Diagonal = 0.;               ///< of the points' box, world space
};

template <typename Function>
void MesoReferenceSurface::WithPatch(std::size_t number, Function&& function) const
{
  if (this->Shape)
  {
    const MesoShapePatch patch = this->ShapePatch(number);
    function(static_cast<const MesoBasePatch&>(patch), this->Over(number));
  }
  else
  {
    const MesoTrianglePatch patch = this->TrianglePatch(number);
    function(static_cast<const MesoBasePatch&>(patch), this->Over(number));
  }
}

#endif
