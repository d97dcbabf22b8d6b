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

void MesoShaderShape::DefineEffects(const MesoEffects& effects)
{
  const std::pair<MesoEffect, const char*> names[] = { { MesoEffect::Shading, "MESO_SHADING" },
    { MesoEffect::Occlusion, "MESO_OCCLUSION" }, { MesoEffect::SelfShadow, "MESO_SELF_SHADOW" },
    { MesoEffect::Depth, "MESO_DEPTH" }, { MesoEffect::Silhouette, "MESO_SILHOUETTE" },
    { MesoEffect::Curvature, "MESO_CURVATURE" } };
  for (const auto& name : names)
  {
    if (effects.Has(name.first))
    {
      this->Defines.emplace_back(name.second, "");
    }
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
