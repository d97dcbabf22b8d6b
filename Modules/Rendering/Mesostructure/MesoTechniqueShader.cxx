#include "MesoTechniqueShader.h"

void MesoShaderShape::UseFrame()
{
  if (!this->UsesFrame)
  {
    this->UsesFrame = true;
    this->Attributes.insert(this->Attributes.end(),
      { { "mesoTangent", "MesoTangent" }, { "mesoBitangent", "MesoBitangent" },
        { "mesoTileScale", "MesoTileScale" } });
  }
}

MesoShaderShape MesoTechniqueShader::GetShape() const
{
  MesoShaderShape shape;
  shape.Chunks = { "Techniques/Plain.glsl" };
  return shape;
}

std::string MesoTechniqueShader::Activate(vtkOpenGLRenderWindow*)
{
  return {};
}

void MesoTechniqueShader::SetUniforms(vtkShaderProgram*) {}

const double* MesoTechniqueShader::GetCentre() const
{
  return nullptr;
}

void MesoTechniqueShader::Deactivate() {}

void MesoTechniqueShader::ReleaseGraphicsResources(vtkWindow*) {}

std::size_t MesoTechniqueShader::GetGPUBytes() const
{
  return 0;
}
