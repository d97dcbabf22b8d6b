#include "MesoShellShader.h"

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
}

MesoShaderShape MesoShellShader::GetShape() const
{
  const MesoEffects effects = MesoEffectsOn(this->Options);
  if (!this->GetVolume() || effects.Empty())
  {
    return MesoTechniqueShader::GetShape();
  }
  MesoShaderShape shape;
  shape.Traces = true;
  shape.Prisms = true;
  shape.WritesDepth = true;
  shape.Attributes = { { "mesoPrism", "MesoPrism" } };
  shape.Chunks = { "Common/VolumeAccess.glsl", "Kernels/Prism.glsl", "Kernels/Volume.glsl",
    "Common/PrismAccess.glsl", "Common/PrismShell.glsl", "Techniques/ShellSDF.glsl" };
  const Steps steps = StepsOf(this->Options.Quality);
  shape.Defines = { { "MESO_SEGMENTS", std::to_string(std::max(this->Options.Segments, 1)) },
    { "MESO_LEAST_STEP", steps.Least }, { "MESO_MOST_STEPS", steps.Most } };
  const std::pair<MesoEffect, const char*> names[] = { { MesoEffect::Shading, "MESO_SHADING" },
    { MesoEffect::Occlusion, "MESO_OCCLUSION" }, { MesoEffect::SelfShadow, "MESO_SELF_SHADOW" },
    { MesoEffect::Depth, "MESO_DEPTH" }, { MesoEffect::Silhouette, "MESO_SILHOUETTE" } };
  for (const auto& name : names)
  {
    if (effects.Has(name.first))
    {
      shape.Defines.emplace_back(name.second, "");
    }
  }
  return shape;
}

std::string MesoShellShader::Activate(vtkOpenGLRenderWindow* window)
{
  if (!this->ShellProblem.empty() || !this->GetVolume())
  {
    return this->ShellProblem;
  }
  const std::string failure = this->Prisms.Activate(window, MesoWrap::Repeat);
  return failure.empty() ? this->Volume.Activate(window, MesoWrap::Repeat) : failure;
}

void MesoShellShader::SetUniforms(vtkShaderProgram* program)
{
  this->Prisms.SetUniforms(program);
  this->Volume.SetUniforms(program);
}

void MesoShellShader::Deactivate()
{
  this->Prisms.Deactivate();
  this->Volume.Deactivate();
}

void MesoShellShader::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Prisms.ReleaseGraphicsResources(window);
  this->Volume.ReleaseGraphicsResources(window);
}

std::size_t MesoShellShader::GetGPUBytes() const
{
  return this->Prisms.GetGPUBytes() + this->Volume.GetGPUBytes();
}
