#ifndef MesoTechniqueModel_h
#define MesoTechniqueModel_h

/**
 * @class MesoTechniqueModel
 * @brief What a technique's own model says of each pixel, solved in double precision.
 *
 * The error of `relief` and `relief-quadric` has two parts: the model (a tangent plane or a quadric
 * in place of the surface) and the solver (a search that steps, in float). This class solves the same
 * model with the same interpolated inputs and misses nothing (MesoPathSolver). A rendering judged by
 * it shows the solver's error alone (`solver_texcoord_p95`, ...); it judged by MesoReference shows
 * the model's.
 *
 * The equations are those of Shaders/Techniques, with the kernels' double precision copies. All
 * fragments of front faces along a pixel's ray are solved, and the nearest hit is shown, as the depth
 * buffer does. Plain nodes are their base mesh. No OpenGL.
 */

#include "MesoExr.h"
#include "MesoScene.h"
#include "mesoRenderingReferenceModule.h" // for export macro

#include <functional>
#include <memory>

class MESORENDERINGREFERENCE_EXPORT MesoTechniqueModel
{
public:
  /// Read what the scene names. Throws MesoInputError, naming the node, where a file cannot be used
  /// and for techniques that have no such model (HasModel).
  explicit MesoTechniqueModel(const MesoScene& scene);
  ~MesoTechniqueModel();
  MesoTechniqueModel(const MesoTechniqueModel&) = delete;
  void operator=(const MesoTechniqueModel&) = delete;

  /// plain, bump, relief, and relief-quadric over the quadric itself. Over other curved bases, and
  /// across the view ray (relief-quadric-exact), the way of a ray is no parabola that could be solved
  /// for.
  static bool HasModel(const MesoMesostructureOptions& options);

  /**
   * All channels of vtkMesoAOVPass with their meanings; `fetches`, `texel_reads` and `iterations`
   * are 0. With the attributes of MesoAttributesOfScene. The result does not depend on the number of
   * threads.
   *
   * @param width,height 1 to MesoReference::LargestSize
   * @param progress is called now and then with the part that is done; false aborts, and the result
   *   then has no channels.
   * Throws MesoInputError for other sizes.
   */
  MesoExrImage Render(
    int width, int height, const std::function<bool(double)>& progress = {}) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Inside;
};

#endif
