#include "vtk_glew.h" // must come first

#include "vtkMesoShellMapper.h"

#include "MesoShellShader.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

vtkStandardNewMacro(vtkMesoShellMapper);

namespace
{
vtkOpenGLState* StateOf(vtkRenderer* renderer)
{
  return static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
}

/// Whether a part of an actor's box may lie before the near plane, so that prisms may be cut by it.
bool ReachesNearPlane(vtkRenderer* renderer, vtkActor* actor)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double bounds[6];
  actor->GetBounds(bounds);
  for (int corner = 0; corner < 8; ++corner)
  {
    const double place[4] = { bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
      bounds[4 + ((corner >> 2) & 1)], 1. };
    double seen[4];
    camera->GetModelViewTransformMatrix()->MultiplyPoint(place, seen);
    if (-seen[2] <= camera->GetClippingRange()[0])
    {
      return true;
    }
  }
  return false;
}
}

vtkMesoShellMapper::vtkMesoShellMapper()
  : Shell(std::make_unique<MesoShellShader>())
{
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::ShellSDF;
  this->SetOptions(options);
}

vtkMesoShellMapper::~vtkMesoShellMapper() = default;

void vtkMesoShellMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Volume: " << this->Shell->GetVolume() << "\n";
  os << indent << "Table: " << this->Shell->GetTable() << "\n";
}

void vtkMesoShellMapper::SetVolume(vtkImageData* volume)
{
  if (volume != this->Shell->GetVolume())
  {
    this->Shell->SetVolume(volume);
    this->Modified();
  }
}

vtkImageData* vtkMesoShellMapper::GetVolume()
{
  return this->Shell->GetVolume();
}

void vtkMesoShellMapper::SetTable(vtkImageData* table)
{
  if (table != this->Shell->GetTable())
  {
    this->Shell->SetTable(table);
    this->Modified();
  }
}

vtkImageData* vtkMesoShellMapper::GetTable()
{
  return this->Shell->GetTable();
}

vtkMTimeType vtkMesoShellMapper::GetDetailMTime()
{
  vtkImageData* volume = this->GetVolume();
  return std::max(this->Superclass::GetDetailMTime(), volume ? volume->GetMTime() : 0);
}

void vtkMesoShellMapper::ShallowCopy(vtkAbstractMapper* mapper)
{
  if (auto* other = vtkMesoShellMapper::SafeDownCast(mapper))
  {
    this->SetVolume(other->GetVolume());
    this->SetTable(other->GetTable());
  }
  this->Superclass::ShallowCopy(mapper);
}

void vtkMesoShellMapper::RenderPieceStart(vtkRenderer* renderer, vtkActor* actor)
{
  this->Shell->SetShell(this->CurrentInput);
  this->Superclass::RenderPieceStart(renderer, actor);
  // Backs of faces answer for rays that start within a prism, and only for those. Slices of prisms have no backs.
  const MesoMesostructureOptions& options = this->GetOptions();
  const bool sliced =
    options.Technique == MesoTechnique::Slices && options.Stack == MesoStack::Prism;
  if (sliced || ReachesNearPlane(renderer, actor))
  {
    StateOf(renderer)->vtkglDisable(GL_CULL_FACE);
  }
  else
  {
    StateOf(renderer)->vtkglCullFace(GL_BACK);
    StateOf(renderer)->vtkglEnable(GL_CULL_FACE);
  }
}

void vtkMesoShellMapper::RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::RenderPieceFinish(renderer, actor);
  StateOf(renderer)->vtkglDisable(GL_CULL_FACE);
}

MesoTechniqueShader* vtkMesoShellMapper::GetTechnique()
{
  return this->Shell.get();
}

MesoTechnique vtkMesoShellMapper::TechniqueOf(const MesoMesostructureOptions& options) const
{
  return MesoUsesVolume(options.Technique) ? options.Technique : MesoTechnique::ShellSDF;
}

void vtkMesoShellMapper::OptionsChanged()
{
  MesoMesostructureOptions options = this->GetOptions();
  options.Technique = this->TechniqueOf(options); // whose effects "auto" means
  this->Shell->SetOptions(options);
}

void vtkMesoShellMapper::SetCameraShaderParameters(
  vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor)
{
  this->Superclass::SetCameraShaderParameters(cellBO, renderer, actor);
  if (cellBO.Program->IsUniformUsed("mesoNearVC"))
  {
    cellBO.Program->SetUniformf(
      "mesoNearVC", static_cast<float>(renderer->GetActiveCamera()->GetClippingRange()[0]));
  }
}
