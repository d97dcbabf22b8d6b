#include "MesoVDMShader.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
constexpr int Four = 4;
constexpr int MostGroups = 3;
}

MesoVDMShader::MesoVDMShader()
{
  for (int group = 0; group < MostGroups; ++group)
  {
    for (const auto kind : { MesoVDMPart::Kind::Weights, MesoVDMPart::Kind::Functions,
           MesoVDMPart::Kind::AngleFunctions })
    {
      this->Parts.push_back(std::make_unique<MesoVDMPart>(kind, group));
    }
  }
  for (const auto kind : { MesoVDMPart::Kind::Table, MesoVDMPart::Kind::Angles })
  {
    this->Parts.push_back(std::make_unique<MesoVDMPart>(kind, 0));
  }
}

void MesoVDMShader::SetHeightMap(vtkImageData* heights)
{
  this->Heights.SetHeightMap(heights);
}

vtkImageData* MesoVDMShader::GetHeightMap() const
{
  return this->Heights.GetHeightMap();
}

std::string MesoVDMShader::SetTable(vtkImageData* table)
{
  this->Table = nullptr;
  if (table)
  {
    try
    {
      this->Layout = MesoVDMLayout::Read(table);
    }
    catch (const std::runtime_error& problem)
    {
      return problem.what();
    }
    const std::string problem = MesoVDMProblem(table, this->Layout);
    if (!problem.empty())
    {
      return problem;
    }
  }
  this->Table = table;
  this->SetParts();
  return {};
}

void MesoVDMShader::SetOptions(const MesoMesostructureOptions& options)
{
  this->Options = options;
  this->Heights.SetMipmaps(options.Filter == MesoFilter::Auto);
  this->SetParts();
}

std::array<int, 2> MesoVDMShader::RanksOf(const MesoMesostructureOptions& options)
{
  if (options.Rank)
  {
    return *options.Rank;
  }
  switch (options.Quality)
  {
    case MesoQuality::Draft:
      return { 2, 2 };
    case MesoQuality::Low:
      return { 4, 4 };
    case MesoQuality::Medium:
      return { 8, 4 };
    case MesoQuality::High:
    case MesoQuality::Certified:
      return { 12, 4 };
    case MesoQuality::Full:
      return { 0, 0 };
  }
  return { 8, 4 };
}

void MesoVDMShader::SetParts()
{
  this->Ranks = { 0, 0 };
  this->Error =
    this->Table ? this->Table->GetFieldData()->GetArray("AngularError")->GetTuple1(0) : 0.;
  if (this->Table && !this->Table->GetPointData()->GetArray("VDM"))
  {
    vtkFieldData* data = this->Table->GetFieldData();
    const std::array<int, 2> wanted = RanksOf(this->Options);
    const char* const names[] = { "VDMFunctions", "MVMFunctions" };
    for (int i = 0; i < 2; ++i)
    {
      const int most =
        std::min(data->GetArray(names[i])->GetNumberOfComponents(), Four * MostGroups);
      this->Ranks[i] = wanted[i] > 0 ? std::min(wanted[i], most) : most;
    }
    this->Error = std::hypot(this->Error, data->GetArray("Errors")->GetTuple1(this->Ranks[0] - 1));
  }
  for (const auto& part : this->Parts)
  {
    part->SetTable(this->Table, this->Layout, this->Ranks);
  }
}

MesoShaderShape MesoVDMShader::GetShape() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  if (!this->GetHeightMap() || !this->Table || effects.Empty())
  {
    return MesoTechniqueShader::GetShape();
  }
  MesoShaderShape shape;
  shape.Traces = true;
  shape.UseFrame();
  shape.WritesDepth = effects.Has(MesoEffect::Depth);
  shape.Chunks = { "Common/HeightAccess.glsl", "Common/HeightLevels.glsl", "Kernels/Frame.glsl",
    "Kernels/HeightField.glsl", "Kernels/HeightBilinear.glsl", "Kernels/LevelChoice.glsl",
    "Kernels/RoughRelief.glsl", "Common/HeightSurface.glsl", "Kernels/Quadric.glsl",
    "Kernels/VDMTable.glsl", "Common/VDMAccess.glsl", "Common/ReliefFrame.glsl",
    "Common/ReliefSurface.glsl", "Techniques/VDM.glsl" };
  const MesoVDMLayout& layout = this->Layout;
  shape.Defines = { { "MESO_WRAP", std::to_string(static_cast<int>(this->Options.Wrap)) },
    { "MESO_SURFACE_HEIGHTS", "" }, { "MESO_VDM_AZIMUTHS", std::to_string(layout.Azimuths) },
    { "MESO_VDM_POLARS", std::to_string(layout.Polars) },
    { "MESO_VDM_CURVATURES", std::to_string(layout.Curvatures) },
    { "MESO_VDM_STORES", std::to_string(static_cast<int>(layout.Stores)) },
    { "MESO_VDM_NODES", std::to_string(static_cast<int>(layout.Nodes)) }, { "MESO_QUADRIC", "" } };
  if (this->Ranks[0] > 0)
  {
    const auto groups = [](int rank) { return std::to_string((rank + Four - 1) / Four); };
    shape.Defines.emplace_back("MESO_VDM_GROUPS", groups(this->Ranks[0]));
    shape.Defines.emplace_back("MESO_MVM_GROUPS", groups(this->Ranks[1]));
  }
  if (this->Options.Filter == MesoFilter::Auto)
  {
    shape.Defines.emplace_back("MESO_FILTER", "");
  }
  if (this->FlatShadows)
  {
    shape.Defines.emplace_back("MESO_VDM_FLAT_SHADOW", "");
  }
  if (this->NearestOutlines)
  {
    shape.Defines.emplace_back("MESO_VDM_NEAREST", "");
  }
  if (effects.Has(MesoEffect::Curvature))
  {
    shape.VertexChunks = { "Kernels/Quadric.glsl" };
    shape.Attributes.emplace_back("mesoQuadric", "MesoQuadric");
    if (this->Options.CurvatureAt == MesoCurvatureAt::Vertex)
    {
      shape.VertexChunks = { "Kernels/Frame.glsl", "Kernels/Quadric.glsl",
        "Techniques/VDMVertex.glsl" };
      shape.Defines.emplace_back("MESO_CURVATURE_AT_VERTEX", "");
    }
  }
  shape.DefineEffects(effects);
  return shape;
}

std::string MesoVDMShader::Activate(vtkOpenGLRenderWindow* window)
{
  std::string failure = this->Heights.Activate(window, this->Options.Wrap);
  for (const auto& part : this->Parts)
  {
    if (failure.empty())
    {
      failure = part->Activate(window, MesoWrap::Repeat);
    }
  }
  return failure;
}

void MesoVDMShader::SetUniforms(vtkShaderProgram* program)
{
  this->Heights.SetUniforms(program);
  for (const auto& part : this->Parts)
  {
    if (part->GetImage())
    {
      part->SetUniforms(program);
    }
  }
  const auto set = [&](const char* name, double value)
  {
    if (program->IsUniformUsed(name))
    {
      program->SetUniformf(name, static_cast<float>(value));
    }
  };
  const auto setPair = [&](const char* name, double first, double second)
  {
    if (program->IsUniformUsed(name))
    {
      const float pair[] = { static_cast<float>(first), static_cast<float>(second) };
      program->SetUniform2f(name, pair);
    }
  };
  set("mesoScale", this->Options.Scale);
  set("mesoVDMDepth", this->Layout.Depth);
  set("mesoVDMRange", this->Layout.Range());
  set("mesoVDMError", this->Error * this->Layout.Range());
  setPair("mesoVDMCurvatures", this->Layout.FirstCurvature, this->Layout.LastCurvature);
  setPair("mesoVDMTexels", this->Layout.Width, this->Layout.Height);
}

void MesoVDMShader::Deactivate()
{
  this->Heights.Deactivate();
  for (const auto& part : this->Parts)
  {
    part->Deactivate();
  }
}

void MesoVDMShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Heights.ReleaseGraphicsResources(window);
  for (const auto& part : this->Parts)
  {
    part->ReleaseGraphicsResources(window);
  }
}

std::size_t MesoVDMShader::GetGPUBytes() const
{
  std::size_t bytes = this->Heights.GetGPUBytes();
  for (const auto& part : this->Parts)
  {
    bytes += part->GetImage() ? part->GetGPUBytes() : 0;
  }
  return bytes;
}
