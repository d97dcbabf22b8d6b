#include "vtkMesoPicker.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkMesoPicker);

namespace
{
vtkActor* ActorOf(vtkAssemblyPath* path)
{
  return vtkActor::SafeDownCast(path->GetLastNode()->GetViewProp());
}

/// Actors that are drawn as opaque until this goes out of scope: only those are written as numbers.
class AllOpaque
{
public:
  explicit AllOpaque(const std::vector<vtkSmartPointer<vtkAssemblyPath>>& paths)
  {
    for (vtkAssemblyPath* path : paths)
    {
      vtkActor* actor = ActorOf(path);
      if (!actor->GetForceOpaque() && actor->HasTranslucentPolygonalGeometry())
      {
        actor->ForceOpaqueOn();
        this->Changed.push_back(actor);
      }
    }
  }
  ~AllOpaque()
  {
    for (vtkActor* actor : this->Changed)
    {
      actor->ForceOpaqueOff();
    }
  }
  AllOpaque(const AllOpaque&) = delete;
  void operator=(const AllOpaque&) = delete;

private:
  std::vector<vtkActor*> Changed;
};

/// The point on a pixel's ray at a distance from the camera along its axis, world space.
void PointAtDepth(vtkRenderer* renderer, int column, int row, double depth, double point[3])
{
  int size[2];
  renderer->GetTiledSize(&size[0], &size[1]);
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> toWorld;
  toWorld->DeepCopy(
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1., 1.));
  toWorld->Invert();
  vtkMatrix4x4* view = camera->GetViewTransformMatrix();
  double ends[2][4];
  double depths[2];
  for (int i = 0; i < 2; ++i)
  {
    const double clip[4] = { 2. * (column + 0.5) / size[0] - 1., 2. * (row + 0.5) / size[1] - 1.,
      i == 0 ? -1. : 1., 1. };
    toWorld->MultiplyPoint(clip, ends[i]);
    double inView[4];
    view->MultiplyPoint(ends[i], inView);
    depths[i] = -inView[2] / ends[i][3];
  }
  const double part = (depth - depths[0]) / (depths[1] - depths[0]);
  for (int k = 0; k < 3; ++k)
  {
    const double near = ends[0][k] / ends[0][3];
    point[k] = near + part * (ends[1][k] / ends[1][3] - near);
  }
}
}

vtkMesoPicker::vtkMesoPicker() = default;

vtkMesoPicker::~vtkMesoPicker() = default;

void vtkMesoPicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HasMap: " << this->HasMap << "\n";
  os << indent << "MapCoordinate: " << this->MapCoordinate[0] << " " << this->MapCoordinate[1]
     << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "MapNumber: " << this->MapNumber << "\n";
  os << indent << "PickNormal: " << this->PickNormal[0] << " " << this->PickNormal[1] << " "
     << this->PickNormal[2] << "\n";
}

void vtkMesoPicker::Initialize()
{
  this->Superclass::Initialize();
  this->HasMap = false;
  this->Height = 0.;
  this->MapNumber = 0.;
  std::fill_n(this->MapCoordinate, 2, 0.);
  std::fill_n(this->PickNormal, 3, 0.);
}

std::vector<vtkSmartPointer<vtkAssemblyPath>> vtkMesoPicker::Capture(vtkRenderer* renderer)
{
  std::vector<vtkSmartPointer<vtkAssemblyPath>> paths;
  vtkCollectionSimpleIterator iterator;
  renderer->GetViewProps()->InitTraversal(iterator);
  while (vtkProp* prop = renderer->GetViewProps()->GetNextProp(iterator))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      if (ActorOf(path))
      {
        vtkNew<vtkAssemblyPath> kept; // the prop's own paths change with the next traversal
        kept->ShallowCopy(path);
        paths.emplace_back(kept);
        this->Pass->SetObjectNumber(ActorOf(path), static_cast<int>(paths.size()));
      }
    }
  }
  const AllOpaque opaque(paths);
  vtkSmartPointer<vtkRenderPass> drawn = renderer->GetPass();
  vtkRenderWindow* window = renderer->GetRenderWindow();
  renderer->SetPass(this->Pass);
  window->Start();
  renderer->Render(); // into the pass's own buffers; the window's picture stays
  window->End();
  renderer->SetPass(drawn);
  return paths;
}

void vtkMesoPicker::TakeNumbers(vtkMesoPolyDataMapper* mapper, int column, int row)
{
  const auto value = [&](const char* channel)
  { return this->Pass->GetValue(channel, column, row); };
  this->PickNormal[0] = value("normal.x");
  this->PickNormal[1] = value("normal.y");
  this->PickNormal[2] = value("normal.z");
  if (!mapper)
  {
    return;
  }
  this->HasMap = !mapper->GetEffectsDrawn().Without({ MesoEffect::CastShadow }).Empty();
  if (this->HasMap)
  {
    this->MapCoordinate[0] = value("texcoord.u");
    this->MapCoordinate[1] = value("texcoord.v");
    this->Height = 1. - value("relief");
    const auto& numbers = mapper->GetMapNumbers();
    this->MapNumber = numbers[0] + this->Height * (numbers[1] - numbers[0]);
  }
}

int vtkMesoPicker::Pick(
  double selectionX, double selectionY, double selectionZ, vtkRenderer* renderer)
{
  this->Initialize();
  this->Renderer = renderer;
  this->SelectionPoint[0] = selectionX;
  this->SelectionPoint[1] = selectionY;
  this->SelectionPoint[2] = selectionZ;
  if (!renderer || !renderer->GetRenderWindow())
  {
    vtkErrorMacro("Picking needs a renderer in a window");
    return 0;
  }
  this->InvokeEvent(vtkCommand::StartPickEvent, nullptr);
  int picked = 0;
  const auto paths = this->Capture(renderer);
  int size[2];
  int origin[2];
  renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  const int column = static_cast<int>(std::floor(selectionX)) - origin[0];
  const int rowFromBottom = static_cast<int>(std::floor(selectionY)) - origin[1];
  const int row = size[1] - 1 - rowFromBottom; // the numbers' rows run from the top
  const float number = this->Pass->GetValue("object", column, row); // NaN outside
  const float depth = this->Pass->GetValue("depth", column, row);
  if (number >= 1.f && number <= static_cast<float>(paths.size()))
  {
    vtkAssemblyPath* path = paths[static_cast<std::size_t>(number) - 1];
    vtkActor* actor = ActorOf(path);
    if (path->GetFirstNode()->GetViewProp()->GetPickable() && actor->GetPickable())
    {
      picked = 1;
      this->SetPath(path);
      PointAtDepth(renderer, column, rowFromBottom, depth, this->PickPosition);
      this->TakeNumbers(vtkMesoPolyDataMapper::SafeDownCast(actor->GetMapper()), column, row);
      actor->Pick();
      this->InvokeEvent(vtkCommand::PickEvent, nullptr);
    }
  }
  this->InvokeEvent(vtkCommand::EndPickEvent, nullptr);
  return picked;
}

void vtkMesoPicker::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Pass->ReleaseGraphicsResources(window);
}
