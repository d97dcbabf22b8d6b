/**
 * @class vtkMesoGeometryImageMapper
 * @brief Draw a mesh out of its geometry image, as a grid whose level of detail suits the picture.
 *
 * What is drawn is the image of SetGeometryImage (vtkMesoGeometryImage): the coarsest of its levels whose
 * triangles are no larger on the screen than FacetPixels of the options (default: the quality's; 0: always
 * the finest). The input is the mesh that the image is of, or any other with about its bounds, with normals
 * and texture coordinates: without an image, or without the effect `shading`, it is what is drawn.
 *
 * Positions, normals and texture coordinates are the image's. Colours by the input's arrays are not read,
 * and picking knows the actor, not its cells. Points and wireframe show the input.
 *
 * Sources: Gu, Gortler and Hoppe, "Geometry Images", SIGGRAPH 2002; Marschner, "Representing geometric
 * details with textures", 2008.
 */

#ifndef vtkMesoGeometryImageMapper_h
#define vtkMesoGeometryImageMapper_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkMesoPolyDataMapper.h"

#include <memory>

class MesoGeometryImageShader;
class vtkImageData;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoGeometryImageMapper : public vtkMesoPolyDataMapper
{
public:
  static vtkMesoGeometryImageMapper* New();
  vtkTypeMacro(vtkMesoGeometryImageMapper, vtkMesoPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The image that is drawn.
  void SetGeometryImage(vtkImageData* image);
  vtkImageData* GetGeometryImage();
  ///@}

  /// The level that the last frame was drawn with, 0 the finest.
  int GetLevelDrawn() const;
  std::int64_t GetNumberOfTrianglesDrawn() override;

  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;

protected:
  vtkMesoGeometryImageMapper();
  ~vtkMesoGeometryImageMapper() override;

  MesoTechniqueShader* GetTechnique() override;
  MesoTechnique TechniqueOf(const MesoMesostructureOptions& options) const override;
  void OptionsChanged() override;

private:
  vtkMesoGeometryImageMapper(const vtkMesoGeometryImageMapper&) = delete;
  void operator=(const vtkMesoGeometryImageMapper&) = delete;

  std::unique_ptr<MesoGeometryImageShader> Shader;
};

#endif
