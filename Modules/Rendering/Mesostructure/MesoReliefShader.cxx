#include "MesoReliefShader.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

MesoReliefShader::MesoReliefShader() = default;

MesoReliefShader::~MesoReliefShader() = default;

void MesoReliefShader::SetHeightMap(vtkImageData* heights)
{
  this->HeightMap = heights;
  this->UploadedTime = 0;
}

MesoShaderShape MesoReliefShader::GetShape() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  MesoShaderShape shape;
  if (!this->HeightMap || effects.Empty())
  {
    return MesoTechniqueShader::GetShape();
  }
  shape.Traces = true;
  shape.UsesFrame = true;
  shape.WritesDepth = effects.Has(MesoEffect::Depth);
  shape.Attributes = { { "mesoTangent", "MesoTangent" }, { "mesoBitangent", "MesoBitangent" },
    { "mesoTileScale", "MesoTileScale" } };
  shape.Chunks = { "Common/HeightAccess.glsl", "Kernels/Frame.glsl", "Kernels/HeightField.glsl",
    "Kernels/LinearBinarySearch.glsl", "Common/ReliefSurface.glsl" };
  const MesoSearchSteps steps = MesoStepsOfQuality(this->Options.Quality);
  shape.Defines = { { "MESO_LINEAR_STEPS", std::to_string(steps.Linear) },
    { "MESO_BINARY_STEPS", std::to_string(steps.Binary) },
    { "MESO_WRAP", std::to_string(static_cast<int>(this->Options.Wrap)) } };
  if (this->Options.Technique == MesoTechnique::ReliefQuadric)
  {
    shape.Chunks.insert(
      shape.Chunks.end(), { "Kernels/Quadric.glsl", "Techniques/ReliefQuadric.glsl" });
    shape.Defines.emplace_back("MESO_QUADRIC", "");
    if (effects.Has(MesoEffect::Curvature))
    {
      shape.VertexChunks = { "Kernels/Quadric.glsl" };
      shape.Attributes.emplace_back("mesoQuadric", "MesoQuadric");
    }
  }
  else
  {
    shape.Chunks.emplace_back("Techniques/Relief.glsl");
  }
  const std::pair<MesoEffect, const char*> names[] = { { MesoEffect::Shading, "MESO_SHADING" },
    { MesoEffect::Occlusion, "MESO_OCCLUSION" }, { MesoEffect::SelfShadow, "MESO_SELF_SHADOW" },
    { MesoEffect::Depth, "MESO_DEPTH" }, { MesoEffect::Silhouette, "MESO_SILHOUETTE" },
    { MesoEffect::Curvature, "MESO_CURVATURE" } };
  for (const auto& name : names)
  {
    if (effects.Has(name.first))
    {
      shape.Defines.emplace_back(name.second, "");
    }
  }
  return shape;
}

std::string MesoReliefShader::Upload(vtkOpenGLRenderWindow* window)
{
  vtkDataArray* heights = this->HeightMap->GetPointData()->GetScalars();
  if (!heights || heights->GetDataType() != VTK_FLOAT || heights->GetNumberOfComponents() != 1)
  {
    return "the height map must have one component of float";
  }
  int size[3];
  this->HeightMap->GetDimensions(size);
  const int limit = vtkTextureObject::GetMaximumTextureSize(window);
  if (size[0] > limit || size[1] > limit)
  {
    return "the height map of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
      " is larger than the " + std::to_string(limit) + " that this device takes";
  }
  const int wraps[] = { vtkTextureObject::Repeat, vtkTextureObject::ClampToEdge,
    vtkTextureObject::MirroredRepeat };
  const int wrap = wraps[static_cast<int>(this->Options.Wrap)];
  vtkTextureObject* texture = this->HeightTexture;
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetWrapS(wrap);
  texture->SetWrapT(wrap);
  texture->SetMinificationFilter(vtkTextureObject::Linear);
  texture->SetMagnificationFilter(vtkTextureObject::Linear);
  if (!texture->Create2DFromRaw(static_cast<unsigned int>(size[0]),
        static_cast<unsigned int>(size[1]), 1, VTK_FLOAT, heights->GetVoidPointer(0)))
  {
    return "the height map could not be made a texture";
  }
  this->UploadedTime = this->HeightMap->GetMTime();
  this->UploadedWrap = this->Options.Wrap;
  return {};
}

std::string MesoReliefShader::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->HeightMap)
  {
    return {};
  }
  if (this->HeightTexture->GetHandle() == 0 || this->HeightTexture->GetContext() != window ||
    this->UploadedTime != this->HeightMap->GetMTime() || this->UploadedWrap != this->Options.Wrap)
  {
    const std::string failure = this->Upload(window);
    if (!failure.empty())
    {
      return failure;
    }
  }
  this->HeightTexture->Activate();
  return {};
}

void MesoReliefShader::SetUniforms(vtkShaderProgram* program)
{
  if (program->IsUniformUsed("mesoHeightMap"))
  {
    program->SetUniformi("mesoHeightMap", this->HeightTexture->GetTextureUnit());
  }
  if (program->IsUniformUsed("mesoScale"))
  {
    program->SetUniformf("mesoScale", static_cast<float>(this->Options.Scale));
  }
}

void MesoReliefShader::Deactivate()
{
  if (this->HeightTexture->GetHandle() != 0)
  {
    this->HeightTexture->Deactivate();
  }
}

void MesoReliefShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->HeightTexture->ReleaseGraphicsResources(window);
}

std::size_t MesoReliefShader::GetGPUBytes() const
{
  if (this->HeightTexture->GetHandle() == 0)
  {
    return 0;
  }
  return std::size_t(this->HeightTexture->GetWidth()) * this->HeightTexture->GetHeight() *
    sizeof(float);
}
