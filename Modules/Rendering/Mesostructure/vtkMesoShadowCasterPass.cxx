#include "vtkMesoShadowCasterPass.h"

#include "MesoShaderAssembler.h"
#include "MesoShaderLibrary.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

vtkStandardNewMacro(vtkMesoShadowCasterPass);

void vtkMesoShadowCasterPass::Render(const vtkRenderState* state)
{
  this->PreRender(state);
  for (int i = 0; i < state->GetPropArrayCount(); ++i)
  {
    state->GetPropArray()[i]->RenderOpaqueGeometry(state->GetRenderer());
  }
  this->PostRender(state);
}

bool vtkMesoShadowCasterPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  MesoShaderAssembler fragment("fragment shader", fragmentShader);
  const bool done = fragment.Before("//VTK::CustomUniforms::Dec", "Common/ShadowCasterDec.glsl",
    MesoShaderText("Common/ShadowCasterDec.glsl"));
  fragmentShader = fragment.GetText();
  return done;
}

bool vtkMesoShadowCasterPass::PostReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  MesoShaderAssembler fragment("fragment shader", fragmentShader);
  const bool done = fragment.Before("//VTK::DepthPeeling::Impl", "Common/ShadowCasterImpl.glsl",
    MesoShaderText("Common/ShadowCasterImpl.glsl"));
  fragmentShader = fragment.GetText();
  return done;
}

bool vtkMesoShadowCasterPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  if (program->IsUniformUsed("mesoCaster"))
  {
    const auto found = this->Numbers.find(prop);
    program->SetUniformf("mesoCaster", found == this->Numbers.end() ? 0.f : float(found->second));
  }
  if (program->IsUniformUsed("mesoCasterRange"))
  {
    const float range[2] = { static_cast<float>(this->Range[0]),
      static_cast<float>(this->Range[1]) };
    program->SetUniform2f("mesoCasterRange", range);
  }
  return true;
}
