#include "MesoShellShader.h"

#include "vtkImageData.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
/// Shortest step, in voxels, and the most of them on a piece of a ray's way.
struct Steps
{
  const char* Least;
  const char* Most;
};

Steps StepsOf(MesoQuality quality)
{
  switch (quality)
  {
    case MesoQuality::Draft:
      return { "1.0", "64" };
    case MesoQuality::Low:
      return { "0.5", "128" };
    case MesoQuality::Medium:
      return { "0.25", "256" };
    default:
      return { "0.125", "512" };
  }
}

/// Steps of the volume's own distance after a look-up in the table.
const char* CorrectionsOf(MesoQuality quality)
{
  switch (quality)
  {
    case MesoQuality::Draft:
    case MesoQuality::Full:
      return "0";
    case MesoQuality::Low:
      return "1";
    case MesoQuality::Medium:
      return "2";
    default:
      return "4";
  }
}
}

int MesoSlicesOf(vtkImageData& volume, MesoQuality quality)
{
  return std::max(1, static_cast<int>(volume.GetDimensions()[2] * MesoFacetsPerTexel(quality)));
}

void MesoShellShader::SetVolume(vtkImageData* volume)
{
  this->Volume.SetVolume(volume);
  this->Colors.SetVolume(volume);
}

MesoShaderShape MesoShellShader::GetShape() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  if (!this->GetVolume() || (this->UsesTable() && !this->GetTable()) || effects.Empty())
  {
    return MesoTechniqueShader::GetShape();
  }
  MesoShaderShape shape;
  shape.Traces = true;
  shape.Prisms = true;
  shape.WritesDepth = true;
  shape.MatterColored = this->Colors.HasColors();
  shape.Attributes = { { "mesoPrism", "MesoPrism" } };
  shape.Chunks = { "Common/VolumeAccess.glsl", "Kernels/Prism.glsl", "Kernels/Volume.glsl",
    "Common/PrismAccess.glsl", "Common/PrismMatter.glsl" };
  const auto add = [&](const std::initializer_list<const char*>& chunks)
  { shape.Chunks.insert(shape.Chunks.end(), chunks.begin(), chunks.end()); };
  const auto define = [&](const char* name, const std::string& value)
  { shape.Defines.emplace_back(name, value); };
  if (this->Prisms.HasEnds())
  {
    define("MESO_SHELL_ENDS", "");
  }
  if (this->UsesTable())
  {
    const int groups = this->Table.GetGroups();
    define("MESO_GDM_GROUPS", std::to_string(groups));
    define("MESO_CORRECTIONS", CorrectionsOf(this->Options.Quality));
    add({ "Common/GDMAccess.glsl",
      groups > 0 ? "Common/GDMFactorsAccess.glsl" : "Common/GDMWholeAccess.glsl",
      "Kernels/GDMTable.glsl", groups > 0 ? "Kernels/GDMFactors.glsl" : "Kernels/GDMWhole.glsl" });
  }
  else
  {
    const Steps steps = StepsOf(this->Options.Quality);
    define("MESO_LEAST_STEP", steps.Least);
    define("MESO_MOST_STEPS", steps.Most);
  }
  if (this->Options.Technique == MesoTechnique::Slices)
  {
    add({ "Common/SliceMatter.glsl" });
    if (this->Options.Stack == MesoStack::Screen)
    {
      add({ "Common/PrismShell.glsl", "Common/PrismWalk.glsl", "Techniques/SlicesOnScreen.glsl" });
    }
    else
    {
      add({ "Techniques/Slices.glsl" });
    }
  }
  else
  {
    define("MESO_SEGMENTS", std::to_string(std::max(this->Options.Segments, 1)));
    const bool interpolated = this->Options.Exits == MesoExits::Interpolated;
    if (interpolated)
    {
      define("MESO_EXITS", "");
      shape.VertexChunks = { "Common/PrismVertex.glsl", "Kernels/Prism.glsl",
        "Common/PrismAccess.glsl" };
    }
    add({ "Common/PrismShell.glsl",
      interpolated ? "Common/PrismExits.glsl" : "Common/PrismWalk.glsl", "Common/PrismPieces.glsl",
      this->UsesTable() ? "Techniques/GDM.glsl" : "Techniques/ShellSDF.glsl" });
  }
  // Prisms bend with the mesh by themselves.
  shape.DefineEffects(effects.Without({ MesoEffect::Curvature }));
  return shape;
}

std::string MesoShellShader::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->ShellProblem.empty() || !this->GetVolume())
  {
    return this->ShellProblem;
  }
  std::string failure = this->UsesTable() ? this->TableProblem : std::string();
  for (MesoMapTexture* texture : this->Textures())
  {
    failure = failure.empty() ? texture->Activate(window, MesoWrap::Repeat) : failure;
  }
  return failure;
}

std::vector<MesoMapTexture*> MesoShellShader::Textures()
{
  std::vector<MesoMapTexture*> textures = { &this->Prisms, &this->Volume, &this->Colors };
  if (this->UsesTable())
  {
    textures.push_back(&this->Table);
  }
  return textures;
}

void MesoShellShader::SetUniforms(vtkShaderProgram* program)
{
  for (MesoMapTexture* texture : this->Textures())
  {
    texture->SetUniforms(program);
  }
  if (program->IsUniformUsed("mesoSliceSpacing"))
  {
    const int slices = MesoSlicesOf(*this->GetVolume(), this->Options.Quality);
    program->SetUniformf("mesoSliceSpacing", static_cast<float>(this->Options.Scale / slices));
  }
}

void MesoShellShader::Deactivate()
{
  for (MesoMapTexture* texture : this->Textures())
  {
    texture->Deactivate();
  }
}

void MesoShellShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Prisms.ReleaseGraphicsResources(window);
  this->Volume.ReleaseGraphicsResources(window);
  this->Colors.ReleaseGraphicsResources(window);
  this->Table.ReleaseGraphicsResources(window);
}

std::size_t MesoShellShader::GetGPUBytes() const
{
  return this->Prisms.GetGPUBytes() + this->Volume.GetGPUBytes() + this->Colors.GetGPUBytes() +
    this->Table.GetGPUBytes();
}
