/**
 * @class vtkMesoTessellatedMapper
 * @brief Draw a mesh that vtkMesoDisplacedMesh has diced and displaced.
 *
 * Ordinary triangles: frames are those of vtkPolyDataMapper on the same mesh, bit for bit, and
 * occlusion, depth, outline, bounds, picking, clipping, shadow maps and translucency are VTK's own.
 * The class adds what a pixel knows (vtkMesoAOVPass): `relief` is the point array `MesoRelief`
 * interpolated, 0 where the mesh has none; `texcoord` the mesh's texture coordinate times Tiles;
 * `shadow` 1 where the flat facet faces away from the light, else 0, as detail does not shade itself.
 * The array goes to the GPU for those passes and for colours by height alone.
 *
 * Scale and quality of the options have had their say when the mesh was diced and do nothing here.
 *
 * @sa vtkMesoDisplacedMesh, vtkMesoPolyDataMapper
 */

#ifndef vtkMesoTessellatedMapper_h
#define vtkMesoTessellatedMapper_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkMesoPolyDataMapper.h"

#include <memory>

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoTessellatedMapper : public vtkMesoPolyDataMapper
{
public:
  static vtkMesoTessellatedMapper* New();
  vtkTypeMacro(vtkMesoTessellatedMapper, vtkMesoPolyDataMapper);

protected:
  vtkMesoTessellatedMapper();
  ~vtkMesoTessellatedMapper() override;

  MesoTechniqueShader* GetTechnique() override;
  MesoTechnique TechniqueOf(const MesoMesostructureOptions& options) const override;

private:
  vtkMesoTessellatedMapper(const vtkMesoTessellatedMapper&) = delete;
  void operator=(const vtkMesoTessellatedMapper&) = delete;

  std::unique_ptr<MesoTechniqueShader> Tessellated;
};

#endif
