#include "MesoReliefShader.h"

#include "vtkImageData.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
constexpr int MostHalvingsOverBase = 3;

/// What a ray's way is made of, and the technique around it: chunks of Shaders/.
struct Way
{
  std::vector<std::string> Kernels; ///< up to the struct HeightPath
  std::vector<std::string> Technique;
};

Way WayOf(const MesoMesostructureOptions& options)
{
  if (!MesoBendsRelief(options.Technique))
  {
    return { { "Kernels/HeightPath.glsl" }, { "Techniques/Relief.glsl" } };
  }
  if (MesoNeedsBaseImage(options))
  {
    return { { "Kernels/Quadric.glsl", "Common/BaseAccess.glsl", "Kernels/BaseSurface.glsl",
               "Kernels/CubicPath.glsl" },
      { "Techniques/ReliefOnBase.glsl" } };
  }
  if (options.Technique == MesoTechnique::ReliefQuadricExact)
  {
    return { { "Kernels/Quadric.glsl", "Kernels/QuadricExact.glsl", "Kernels/AcrossPath.glsl" },
      { "Common/ReliefShell.glsl", "Techniques/ReliefQuadricExact.glsl" } };
  }
  if (options.Curved == MesoCurvedKind::Osculating)
  {
    return { { "Kernels/Quadric.glsl", "Kernels/CirclePath.glsl" },
      { "Common/ReliefShell.glsl", "Techniques/ReliefOsculating.glsl" } };
  }
  return { { "Kernels/Quadric.glsl", "Kernels/HeightPath.glsl" },
    { "Common/ReliefShell.glsl", "Techniques/ReliefQuadric.glsl" } };
}
}

void MesoReliefShader::SetHeightMap(vtkImageData* heights)
{
  this->Heights.SetHeightMap(heights);
}

vtkImageData* MesoReliefShader::GetHeightMap() const
{
  return this->Heights.GetHeightMap();
}

void MesoReliefShader::SetBaseImage(vtkImageData* image)
{
  this->Base.SetBaseImage(image);
}

vtkImageData* MesoReliefShader::GetBaseImage() const
{
  return this->Base.GetImage();
}

void MesoReliefShader::SetOptions(const MesoMesostructureOptions& options)
{
  this->Options = options;
  this->Heights.SetMipmaps(options.Filter == MesoFilter::Auto);
}

bool MesoReliefShader::UsesCones() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  const MesoSearch search = MesoSearchOf(this->Options);
  return this->GetHeightMap() && (search == MesoSearch::Cone || search == MesoSearch::Certified) &&
    (effects.Has(MesoEffect::Occlusion) || effects.Has(MesoEffect::SelfShadow));
}

bool MesoReliefShader::UsesLevels() const
{
  return this->UsesCones() && this->Options.Filter == MesoFilter::Auto;
}

std::string MesoReliefShader::PrepareCones()
{
  if (!this->UsesLevels())
  {
    const vtkSmartPointer<vtkImageData> map = this->GetHeightMap();
    return this->Cones.Prepare({ map }, this->Options.Wrap);
  }
  this->Levels.Prepare(this->GetHeightMap());
  return this->Cones.Prepare(this->Levels.GetLevels(), this->Options.Wrap);
}

std::string MesoReliefShader::Prepare()
{
  return this->UsesCones() ? this->PrepareCones() : std::string();
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
  const Way way = WayOf(this->Options);
  const bool filtered = this->Options.Filter == MesoFilter::Auto;
  const bool bicubic = this->Options.Interpolation == MesoInterpolation::Bicubic;
  shape.Chunks = { "Common/HeightAccess.glsl", "Common/HeightLevels.glsl", "Kernels/Frame.glsl",
    "Kernels/HeightField.glsl",
    bicubic ? "Kernels/HeightBicubic.glsl" : "Kernels/HeightBilinear.glsl" };
  const MesoSearch search = MesoSearchOf(this->Options);
  if (search == MesoSearch::Cone || search == MesoSearch::Certified)
  {
    shape.Chunks.insert(
      shape.Chunks.end(), { "Common/ConeAccess.glsl", "Kernels/HeightLevels.glsl" });
  }
  shape.Chunks.insert(shape.Chunks.end(),
    { "Kernels/LevelChoice.glsl", "Kernels/RoughRelief.glsl", "Common/HeightSurface.glsl" });
  shape.Chunks.insert(shape.Chunks.end(), way.Kernels.begin(), way.Kernels.end());
  shape.Chunks.insert(shape.Chunks.end(), { "Kernels/HeightHit.glsl", "Kernels/PathCut.glsl" });
  const MesoSearchSteps steps = this->Steps.value_or(MesoStepsOfQuality(this->Options.Quality));
  // Over the mesh itself a last step onto it follows, which makes up for what halvings leave.
  const bool ontoBase =
    MesoNeedsBaseImage(this->Options) && this->Options.Curved == MesoCurvedKind::Surface;
  const int halvings = ontoBase ? std::min(steps.Binary, MostHalvingsOverBase) : steps.Binary;
  const int refining = search == MesoSearch::LinearSecant ? (halvings + 1) / 2 : halvings;
  const char* bounds =
    MesoNeedsBaseImage(this->Options) ? "Kernels/CubicCone.glsl" : "Kernels/HeightCone.glsl";
  const std::vector<std::string> chunksOfSearch[] = { { "Kernels/LinearSearch.glsl",
                                                        "Kernels/LinearBinarySearch.glsl" },
    { "Kernels/LinearSearch.glsl", "Kernels/LinearSecantSearch.glsl" },
    { "Kernels/ConeTexel.glsl", bounds, "Kernels/LinearSearch.glsl", "Kernels/ConeSearch.glsl" },
    { "Kernels/ConeTexel.glsl", bounds, "Kernels/CertifiedSearch.glsl" } };
  const auto& searchChunks = chunksOfSearch[static_cast<int>(search)];
  shape.Chunks.insert(shape.Chunks.end(), searchChunks.begin(), searchChunks.end());
  shape.Chunks.insert(shape.Chunks.end(),
    { "Common/ReliefSearch.glsl", "Common/ReliefFrame.glsl", "Common/ReliefSurface.glsl" });
  shape.Defines = { { "MESO_SEARCH", std::to_string(static_cast<int>(search)) },
    { "MESO_LINEAR_STEPS", std::to_string(steps.Linear) },
    { "MESO_REFINING_STEPS", std::to_string(refining) },
    { "MESO_WRAP", std::to_string(static_cast<int>(this->Options.Wrap)) },
    { "MESO_SURFACE_HEIGHTS", "" } };
  if (filtered)
  {
    shape.Defines.emplace_back("MESO_FILTER", "");
  }
  if (this->UsesLevels())
  {
    shape.Defines.emplace_back("MESO_CONE_LEVELS", "");
  }
  if (bicubic)
  {
    shape.Defines.emplace_back("MESO_BICUBIC", "");
  }
  shape.Chunks.insert(shape.Chunks.end(), way.Technique.begin(), way.Technique.end());
  if (MesoBendsRelief(this->Options.Technique))
  {
    shape.Defines.emplace_back("MESO_QUADRIC", "");
    if (effects.Has(MesoEffect::Curvature))
    {
      shape.VertexChunks = { "Kernels/Quadric.glsl" };
      shape.Attributes.emplace_back("mesoQuadric", "MesoQuadric");
    }
  }
  if (MesoNeedsBaseImage(this->Options))
  {
    shape.Defines.emplace_back("MESO_BASE_TURN", "0.5");
    if (this->Options.Curved == MesoCurvedKind::Bent)
    {
      shape.Defines.emplace_back("MESO_BASE_BENT", "");
    }
  }
  shape.DefineEffects(effects);
  return shape;
}

std::string MesoReliefShader::Activate(vtkOpenGLRenderWindow* window)
{
  const std::string failure = this->Heights.Activate(window, this->Options.Wrap);
  if (!failure.empty() || !this->GetHeightMap())
  {
    return failure;
  }
  if (MesoNeedsBaseImage(this->Options))
  {
    const std::string problem = this->Base.GetImage()
      ? this->Base.Activate(window, this->Options.Wrap)
      : std::string("there is no image of the base, which vtkMesoBaseImage makes");
    if (!problem.empty())
    {
      return problem;
    }
  }
  if (!this->UsesCones())
  {
    return {};
  }
  std::string problem = this->PrepareCones();
  if (problem.empty() && this->UsesLevels())
  {
    problem = this->Levels.Activate(window, this->Options.Wrap);
  }
  return problem.empty() ? this->Cones.Activate(window, this->Options.Wrap) : problem;
}

void MesoReliefShader::SetUniforms(vtkShaderProgram* program)
{
  this->Heights.SetUniforms(program);
  this->Levels.SetUniforms(program);
  this->Cones.SetUniforms(program);
  this->Base.SetUniforms(program);
  if (program->IsUniformUsed("mesoScale"))
  {
    program->SetUniformf("mesoScale", static_cast<float>(this->Options.Scale));
  }
}

const double* MesoReliefShader::GetCentre() const
{
  return this->Base.GetCentre().data();
}

void MesoReliefShader::Deactivate()
{
  this->Heights.Deactivate();
  this->Levels.Deactivate();
  this->Cones.Deactivate();
  this->Base.Deactivate();
}

void MesoReliefShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Heights.ReleaseGraphicsResources(window);
  this->Levels.ReleaseGraphicsResources(window);
  this->Cones.ReleaseGraphicsResources(window);
  this->Base.ReleaseGraphicsResources(window);
}

std::size_t MesoReliefShader::GetGPUBytes() const
{
  return this->Heights.GetGPUBytes() + this->Levels.GetGPUBytes() + this->Cones.GetGPUBytes() +
    this->Base.GetGPUBytes();
}
