#include "MesoReliefShader.h"

#include "vtkShaderProgram.h"

void MesoReliefShader::SetHeightMap(vtkImageData* heights)
{
  this->Heights.SetHeightMap(heights);
}

vtkImageData* MesoReliefShader::GetHeightMap() const
{
  return this->Heights.GetHeightMap();
}

bool MesoReliefShader::UsesCones() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  const MesoSearch search = MesoSearchOf(this->Options);
  return this->GetHeightMap() && (search == MesoSearch::Cone || search == MesoSearch::Certified) &&
    (effects.Has(MesoEffect::Occlusion) || effects.Has(MesoEffect::SelfShadow));
}

std::string MesoReliefShader::Prepare()
{
  return this->UsesCones() ? this->Cones.Prepare(this->GetHeightMap(), this->Options.Wrap)
                           : std::string();
}

MesoShaderShape MesoReliefShader::GetShape() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  MesoShaderShape shape;
  if (!this->GetHeightMap() || effects.Empty())
  {
    return MesoTechniqueShader::GetShape();
  }
  shape.Traces = true;
  shape.UsesFrame = true;
  shape.WritesDepth = effects.Has(MesoEffect::Depth);
  shape.Attributes = { { "mesoTangent", "MesoTangent" }, { "mesoBitangent", "MesoBitangent" },
    { "mesoTileScale", "MesoTileScale" } };
  shape.Chunks = { "Common/HeightAccess.glsl", "Kernels/Frame.glsl", "Kernels/HeightField.glsl",
    "Kernels/HeightPath.glsl", "Kernels/PathCut.glsl" };
  const MesoSearch search = MesoSearchOf(this->Options);
  const MesoSearchSteps steps = this->Steps.value_or(MesoStepsOfQuality(this->Options.Quality));
  const int refining = search == MesoSearch::LinearSecant ? (steps.Binary + 1) / 2 : steps.Binary;
  const std::vector<std::string> chunksOfSearch[] = { { "Kernels/LinearSearch.glsl",
                                                        "Kernels/LinearBinarySearch.glsl" },
    { "Kernels/LinearSearch.glsl", "Kernels/LinearSecantSearch.glsl" },
    { "Common/ConeAccess.glsl", "Kernels/LinearSearch.glsl", "Kernels/HeightCone.glsl",
      "Kernels/ConeSearch.glsl" },
    { "Common/ConeAccess.glsl", "Kernels/HeightCone.glsl", "Kernels/CertifiedSearch.glsl" } };
  const auto& searchChunks = chunksOfSearch[static_cast<int>(search)];
  shape.Chunks.insert(shape.Chunks.end(), searchChunks.begin(), searchChunks.end());
  shape.Chunks.insert(shape.Chunks.end(),
    { "Common/ReliefSearch.glsl", "Common/ReliefFrame.glsl", "Common/ReliefSurface.glsl" });
  shape.Defines = { { "MESO_SEARCH", std::to_string(static_cast<int>(search)) },
    { "MESO_LINEAR_STEPS", std::to_string(steps.Linear) },
    { "MESO_REFINING_STEPS", std::to_string(refining) },
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

std::string MesoReliefShader::Activate(vtkOpenGLRenderWindow* window)
{
  const std::string failure = this->Heights.Activate(window, this->Options.Wrap);
  if (!failure.empty() || !this->UsesCones())
  {
    return failure;
  }
  return this->Cones.Activate(window, this->GetHeightMap(), this->Options.Wrap);
}

void MesoReliefShader::SetUniforms(vtkShaderProgram* program)
{
  this->Heights.SetUniforms(program);
  this->Cones.SetUniforms(program);
  if (program->IsUniformUsed("mesoScale"))
  {
    program->SetUniformf("mesoScale", static_cast<float>(this->Options.Scale));
  }
}

void MesoReliefShader::Deactivate()
{
  this->Heights.Deactivate();
  this->Cones.Deactivate();
}

void MesoReliefShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Heights.ReleaseGraphicsResources(window);
  this->Cones.ReleaseGraphicsResources(window);
}

std::size_t MesoReliefShader::GetGPUBytes() const
{
  return this->Heights.GetGPUBytes() + this->Cones.GetGPUBytes();
}
