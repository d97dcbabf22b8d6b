#include "MesoBumpShader.h"

#include "vtkMath.h"
#include "vtkShaderProgram.h"

MesoBumpShader::MesoBumpShader()
{
  this->Heights.SetMipmaps(true);
}

MesoBumpShader::~MesoBumpShader() = default;

void MesoBumpShader::SetHeightMap(vtkImageData* heights)
{
  this->Heights.SetHeightMap(heights);
}

vtkImageData* MesoBumpShader::GetHeightMap() const
{
  return this->Heights.GetHeightMap();
}

MesoShaderShape MesoBumpShader::GetShape() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  const MesoTechnique technique = this->Options.Technique;
  const bool mapped =
    technique == MesoTechnique::Normal || technique == MesoTechnique::NormalObject;
  if (effects.Without({ MesoEffect::CastShadow }).Empty() || !(mapped || this->GetHeightMap()))
  {
    return MesoTechniqueShader::GetShape();
  }
  MesoShaderShape shape;
  shape.Traces = true;
  shape.MeshCasts = true;
  if (this->GetHeightMap())
  {
    shape.UseFrame();
    shape.Chunks = { "Common/HeightAccess.glsl", "Common/HeightLevels.glsl", "Kernels/Frame.glsl",
      "Kernels/HeightField.glsl", "Common/ReliefFrame.glsl" };
    shape.Defines = { { "MESO_HEIGHTS", "" },
      { "MESO_WRAP", std::to_string(static_cast<int>(this->Options.Wrap)) } };
  }
  shape.Chunks.insert(shape.Chunks.end(), { "Techniques/Bump.glsl", "Common/HorizonLight.glsl" });
  if (effects.Has(MesoEffect::Shading) && !mapped)
  {
    shape.Defines.emplace_back("MESO_SHADING", "");
  }
  if (technique == MesoTechnique::Parallax && effects.Has(MesoEffect::Occlusion))
  {
    const MesoParallaxSteps steps = MesoParallaxStepsOfQuality(this->Options.Quality);
    const bool offset = this->Options.Parallax == MesoParallaxKind::Offset;
    shape.Chunks.emplace_back("Techniques/Parallax.glsl");
    shape.Defines.emplace_back("MESO_OCCLUSION", "");
    shape.Defines.emplace_back(
      "MESO_PARALLAX_STEPS", std::to_string(offset ? steps.Offset : steps.Occlusion));
    if (offset)
    {
      shape.Defines.emplace_back("MESO_PARALLAX_OFFSET", "");
    }
  }
  if (technique == MesoTechnique::Horizon && effects.Has(MesoEffect::SelfShadow) &&
    this->Horizon.GetHorizonMap())
  {
    shape.Chunks.insert(shape.Chunks.end(), { "Kernels/Horizon.glsl", "Techniques/Horizon.glsl" });
    shape.Defines.emplace_back("MESO_SELF_SHADOW", "");
  }
  return shape;
}

std::string MesoBumpShader::Activate(vtkOpenGLRenderWindow* window)
{
  const std::string failure = this->Heights.Activate(window, this->Options.Wrap);
  return failure.empty() ? this->Horizon.Activate(window, this->Options.Wrap) : failure;
}

void MesoBumpShader::SetUniforms(vtkShaderProgram* program)
{
  this->Heights.SetUniforms(program);
  this->Horizon.SetUniforms(program);
  if (program->IsUniformUsed("mesoScale"))
  {
    program->SetUniformf("mesoScale", static_cast<float>(this->Options.Scale));
  }
  if (program->IsUniformUsed("mesoPenumbra"))
  {
    program->SetUniformf(
      "mesoPenumbra", static_cast<float>(vtkMath::RadiansFromDegrees(this->Options.Penumbra)));
  }
}

void MesoBumpShader::Deactivate()
{
  this->Heights.Deactivate();
  this->Horizon.Deactivate();
}

void MesoBumpShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Heights.ReleaseGraphicsResources(window);
  this->Horizon.ReleaseGraphicsResources(window);
}

std::size_t MesoBumpShader::GetGPUBytes() const
{
  return this->Heights.GetGPUBytes() + this->Horizon.GetGPUBytes();
}
