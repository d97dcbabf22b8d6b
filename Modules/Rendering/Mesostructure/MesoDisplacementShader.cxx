#include "MesoDisplacementShader.h"

#include "vtkMath.h"
#include "vtkShaderProgram.h"

MesoDisplacementShader::MesoDisplacementShader() = default;

MesoDisplacementShader::~MesoDisplacementShader() = default;

int MesoDisplacementShader::GetCornerTexels() const
{
  switch (this->Extras)
  {
    case Extra::Colors:
      return 9;
    case Extra::Coordinates:
      return 8;
    case Extra::Nothing:
      break;
  }
  return 6;
}

MesoShaderShape MesoDisplacementShader::GetShape() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  if (effects.Without({ MesoEffect::CastShadow }).Empty() || !this->Heights.GetHeightMap())
  {
    return MesoTechniqueShader::GetShape();
  }
  MesoShaderShape shape;
  shape.Displaced = true;
  shape.Diced = true;
  shape.VertexChunks = { "Common/HeightAccess.glsl", "Kernels/HeightField.glsl",
    "Kernels/BarycentricGrid.glsl", "Kernels/DisplacedNormal.glsl",
    "Techniques/Displacement.glsl" };
  shape.Defines = { { "MESO_WRAP", std::to_string(static_cast<int>(this->Options.Wrap)) } };
  if (effects.Has(MesoEffect::Shading))
  {
    shape.Defines.emplace_back("MESO_SHADING", "");
  }
  if (effects.Has(MesoEffect::Curvature))
  {
    shape.Defines.emplace_back("MESO_SECOND_ORDER", "");
  }
  if (this->Extras != Extra::Nothing)
  {
    shape.Defines.emplace_back(
      this->Extras == Extra::Colors ? "MESO_COLORED" : "MESO_COORDINATES", "");
  }
  if (effects.Has(MesoEffect::SelfShadow) && this->Horizon.GetHorizonMap())
  {
    shape.Traces = true;
    shape.UsesFrame = true;
    shape.Chunks = { "Kernels/Frame.glsl", "Common/ReliefFrame.glsl", "Techniques/Tessellated.glsl",
      "Common/HorizonLight.glsl", "Kernels/Horizon.glsl", "Techniques/Horizon.glsl" };
    shape.Defines.emplace_back("MESO_SELF_SHADOW", "");
  }
  else
  {
    shape.Chunks = { "Techniques/Tessellated.glsl", "Common/HorizonLight.glsl" };
  }
  return shape;
}

std::string MesoDisplacementShader::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->Failure.empty())
  {
    return this->Failure;
  }
  const std::string failure = this->Heights.Activate(window, this->Options.Wrap);
  return failure.empty() ? this->Horizon.Activate(window, this->Options.Wrap) : failure;
}

void MesoDisplacementShader::SetUniforms(vtkShaderProgram* program)
{
  this->Heights.SetUniforms(program);
  this->Horizon.SetUniforms(program);
  const auto set = [&](const char* name, double value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformf(name, static_cast<float>(value));
    }
  };
  set("mesoScale", this->Options.Scale);
  set("mesoReference", this->Options.Reference);
  set("mesoPenumbra", vtkMath::RadiansFromDegrees(this->Options.Penumbra));
  if (program->IsUniformUsed("mesoCornerTexels"))
  {
    program->SetUniformi("mesoCornerTexels", this->GetCornerTexels());
  }
  if (program->IsUniformUsed("mesoBufferScale"))
  {
    const float scale[3] = { static_cast<float>(this->BufferScale[0]),
      static_cast<float>(this->BufferScale[1]), static_cast<float>(this->BufferScale[2]) };
    program->SetUniform3f("mesoBufferScale", scale);
  }
}

void MesoDisplacementShader::Deactivate()
{
  this->Heights.Deactivate();
  this->Horizon.Deactivate();
}

void MesoDisplacementShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Heights.ReleaseGraphicsResources(window);
  this->Horizon.ReleaseGraphicsResources(window);
}

std::size_t MesoDisplacementShader::GetGPUBytes() const
{
  return this->Heights.GetGPUBytes() + this->Horizon.GetGPUBytes();
}
