#ifndef MesoReferenceShell_h
#define MesoReferenceShell_h

/**
 * @class MesoReferenceShell
 * @brief One node's volume of mesostructure, in the prisms over its mesh's triangles: the truth.
 *
 * q(b, z) = sum_i b_i (p_i + (z - r) H n_i), in object space. Matter is where the volume's trilinear
 * distance is negative; it ends, and its cut is seen, at bottom and top and at fins where the shell or the
 * map does not go on.
 */

#include "MesoBox.h"
#include "MesoPrismSolver.h"
#include "mesoRenderingReferenceModule.h" // for export macro

#include <array>
#include <cstdint>
#include <vector>

class MESORENDERINGREFERENCE_EXPORT MesoReferenceShell
{
public:
  /// A surface's points, unit or other normals, map coordinates and triangles; they are not copied.
  struct Base
  {
    const std::vector<glm::dvec3>& Points;
    const std::vector<glm::dvec3>& Normals;
    const std::vector<glm::dvec2>& Coordinates;
    const std::vector<std::array<std::uint32_t, 3>>& Triangles;
  };

  /// Normals and shading at a hit, object space, of any length; see MesoReferencePoint.
  struct Point
  {
    glm::dvec3 Geometric;
    glm::dvec3 Shading;
    glm::dvec2 MapCoord;
    double Relief;
    glm::dvec3 Color; ///< of the volume
    double VoxelSize; ///< the shortest side of a voxel there, object units
  };

  MesoReferenceShell(const Base& base, double thickness, double reference, vtkImageData* volume);

  MesoTruePrism PrismOf(std::size_t triangle) const;
  const MesoVolumeTruth& GetVolume() const { return this->Volume; }
  /// A box, in the space that `matrix` leads to, around a prism.
  MesoBox BoundsOf(std::size_t triangle, const glm::dmat4& matrix) const;
  /// `ray`: direction of the ray that hit, object space.
  Point Describe(std::size_t triangle, const MesoPrismHit& hit, const glm::dvec3& ray) const;
  std::size_t MemoryBytes() const;

private:
  void FindEnds();

  Base Mesh;
  double Thickness;
  double Reference;
  MesoVolumeTruth Volume;
  std::vector<std::uint8_t> Ends; ///< of each triangle; bit k: matter ends at the fin over edge k
};

#endif
