/**
 * @class vtkMesoBumpMapper
 * @brief Detail in the shading alone: the base mesh stays where it is, and its normal is the detail's.
 *
 * The options' Technique says which:
 *
 * - Bump (any other than the next): the normal of `q = p + (h - 1) D n`, with D the Scale of the options
 *   and h the height map, from central differences of the heights around each fragment. Where texels are
 *   smaller than pixels the differences are those of a filtered map, a texel of its level apart.
 * - Normal: that of SetNormalMap, in tangent space or relative to a flat map.
 * - NormalObject: that of SetNormalMap, in object space.
 * - Parallax: as Bump, read where the view ray meets the relief, about (Parallax of the options): in
 *   equal steps and a straight line between the last two, or by a few steps to the plane of the slope.
 *   The mesh is to be the one where height 1 lies.
 * - Horizon: as Bump, and the relief shades itself by the horizons of SetHorizonMap, with a soft edge
 *   (Penumbra of the options).
 *
 * Nothing moves: the outline and the depth buffer are those of the mesh, and but for Parallax near
 * detail does not hide far detail. Tangents need be neither orthogonal nor right-handed: scaled, sheared and mirrored charts
 * are right.
 *
 * Heights: one component of float in [0,1], row 0 at t = 0, bilinear between texel centres. With Normal
 * and NormalObject they serve the pixels' numbers and colours by height alone.
 *
 * Sources: Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH 1978; Marschner, "Representing geometric
 * details with textures", 2008; Kaneko et al., "Detailed Shape Representation with Parallax Mapping",
 * ICAT 2001; Max, "Horizon Mapping: Shadows for Bump-Mapped Surfaces", The Visual Computer 4(2), 1988.
 *
 * @sa vtkMesoPolyDataMapper, vtkMesoSurfaceFrames, vtkMesoHorizonMap, vtkMesoNormalMap
 */

#ifndef vtkMesoBumpMapper_h
#define vtkMesoBumpMapper_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkMesoPolyDataMapper.h"

#include <memory>

class MesoBumpShader;
class vtkImageData;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoBumpMapper : public vtkMesoPolyDataMapper
{
public:
  static vtkMesoBumpMapper* New();
  vtkTypeMacro(vtkMesoBumpMapper, vtkMesoPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The height map; Bump without one draws the base mesh.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap();
  ///@}

  ///@{
  /// The horizons of the height map, and the Scale that vtkMesoHorizonMap had; Horizon without them is
  /// Bump.
  void SetHorizonMap(vtkImageData* horizons, double scale);
  vtkImageData* GetHorizonMap();
  ///@}

protected:
  vtkMesoBumpMapper();
  ~vtkMesoBumpMapper() override;

  MesoTechniqueShader* GetTechnique() override;
  MesoTechnique TechniqueOf(const MesoMesostructureOptions& options) const override;
  void OptionsChanged() override;

private:
  vtkMesoBumpMapper(const vtkMesoBumpMapper&) = delete;
  void operator=(const vtkMesoBumpMapper&) = delete;

  std::unique_ptr<MesoBumpShader> Bump;
};

#endif
