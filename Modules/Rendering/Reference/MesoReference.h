#ifndef MesoReference_h
#define MesoReference_h

/**
 * @class MesoReference
 * @brief Ray traces a scene over its true surface: what every technique is judged against.
 *
 * The true surface (Documentation/Reference.md) of a node with a height map and any technique but
 * `plain` is q = p + (h - 1) D n, with p linear and n normalised-linear in each triangle of the
 * node's mesh (Surface::Mesh) or both of the closed form of its built-in shape (Surface::Smooth),
 * and h bilinear between texel centres, displaced in object space before the node's matrix. Hits
 * are found in double precision, none missed (MesoPatchSolver, MesoCellSolver).
 *
 *     MesoReference reference(MesoReadScene("scene.json"));
 *     const MesoReferenceResult truth = reference.Render(800, 600);
 *
 * No OpenGL. Rendering uses all of vtkSMPTools' threads; the result does not depend on how many.
 */

#include "MesoExr.h"
#include "MesoScene.h"
#include "mesoRenderingReferenceModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkImageData;

/// What the result has cost, and how exact it is.
struct MesoReferenceCounters
{
  std::uint64_t Rays = 0;      ///< of the eye, of shadow, and those that look for the base
  double Seconds = 0.;         ///< in Render
  double PrepareSeconds = 0.;  ///< in the constructor: reading, building
  std::size_t MemoryBytes = 0; ///< meshes, maps, hierarchies
  /// Of all hits: distance between ray and surface, over the size of the numbers added up.
  double LargestResidual = 0.;
  std::uint64_t Blocks = 0;              ///< blocks of cells looked at
  std::uint64_t Pieces = 0;              ///< cells and pieces of cells looked at
  std::uint64_t UnresolvedCells = 0;     ///< given up, edge-on to the ray
  std::uint64_t Triangles = 0;           ///< of the base meshes, or the shapes' patches
  std::uint64_t DegenerateTriangles = 0; ///< displaced evenly: no area in texture coordinates
  std::uint64_t Facets = 0;              ///< of the diced surface
};

struct MesoReferenceResult
{
  /// Channels named as vtkMesoAOVPass names them, all of them, and `base`: 1 where the pixel's ray
  /// meets a front face of the hit object's base mesh at or before the hit. `fetches`,
  /// `texel_reads` and `iterations` are 0. One sample at each pixel's centre. With the attributes
  /// of MesoAttributesOfScene.
  MesoExrImage AOVs;
  /// RGB of 8 bit, row 0 at the bottom; null where rendering was aborted.
  vtkSmartPointer<vtkImageData> Picture;
  MesoReferenceCounters Counters;
};

class MESORENDERINGREFERENCE_EXPORT MesoReference
{
public:
  enum class Surface
  {
    Mesh,
    Smooth
  };

  /// Pixels in either direction, at most.
  static constexpr int LargestSize = 16384;

  /**
   * Read what the scene names and build the hierarchy.
   *
   * @param facetsPerTexel 0: the exact surface. More: the independent second way, triangles of
   *   about so many to a texel (each way), for Surface::Mesh alone.
   * Throws MesoInputError, one line, where a file cannot be used, and for what the reference does
   * not show: translucent or edged nodes, matrices that flatten, nodes without a closed form for
   * Surface::Smooth.
   */
  explicit MesoReference(
    const MesoScene& scene, Surface surface = Surface::Mesh, double facetsPerTexel = 0.);
  ~MesoReference();
  MesoReference(const MesoReference&) = delete;
  void operator=(const MesoReference&) = delete;

  /// What is odd but no error, a line each.
  const std::vector<std::string>& GetWarnings() const;

  /**
   * Trace every pixel. The picture is the mean of `samples` places in each pixel, the same that
   * `meso render` takes; one sample is the pixel's centre.
   *
   * @param progress is called now and then with the part that is done; false aborts, and the
   *   result then has no picture.
   * @param bounces diffuse surfaces that light may come over on its way from a light to the surface
   *   that is seen. 0: light comes straight. More: paths are traced, one a sample, so that the picture
   *   is noisy unless there are many; light is then blocked on plain nodes as well. The AOVs stay.
   * Throws MesoInputError for sizes out of [1, LargestSize], samples less than 1 and bounces less
   * than 0.
   */
  MesoReferenceResult Render(int width, int height, int samples = 1,
    const std::function<bool(double)>& progress = {}, int bounces = 0) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Inside;
};

#endif
