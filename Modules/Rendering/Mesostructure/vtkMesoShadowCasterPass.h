/**
 * @class vtkMesoShadowCasterPass
 * @brief Tells mappers that a shadow map is being drawn, and each fragment to write its depth.
 *
 * Actors are numbered; target 0 takes the depth along the view and the number. Meso's mappers trace
 * their relief along the view's rays, which are the light's, so that depth and outline are those of
 * the detail; of other mappers the depth is that of their geometry.
 */

#ifndef vtkMesoShadowCasterPass_h
#define vtkMesoShadowCasterPass_h

#include "vtkOpenGLRenderPass.h"

#include <map>

class vtkMesoShadowCasterPass : public vtkOpenGLRenderPass
{
public:
  static vtkMesoShadowCasterPass* New();
  vtkTypeMacro(vtkMesoShadowCasterPass, vtkOpenGLRenderPass);

  /// The numbers of the actors, above 0.
  std::map<vtkProp*, int> Numbers;
  /// The view's near and far distance.
  double Range[2] = { 0., 1. };

  /// Draw the state's actors with the renderer's camera, viewport and frame buffer as they are.
  void Render(const vtkRenderState* state) override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;

protected:
  vtkMesoShadowCasterPass() = default;
  ~vtkMesoShadowCasterPass() override = default;

private:
  vtkMesoShadowCasterPass(const vtkMesoShadowCasterPass&) = delete;
  void operator=(const vtkMesoShadowCasterPass&) = delete;
};

#endif
