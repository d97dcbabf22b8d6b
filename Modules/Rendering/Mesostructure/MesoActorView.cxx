#include "vtk_glew.h" // must come first

#include "MesoActorView.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"

#include <algorithm>

MesoGridView MesoViewOfActor(vtkRenderer* renderer, vtkActor* actor)
{
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  int viewport[4];
  window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  vtkCamera* camera = renderer->GetActiveCamera();
  vtkNew<vtkMatrix4x4> modelToView;
  vtkMatrix4x4::Multiply4x4(camera->GetModelViewTransformMatrix(), actor->GetMatrix(), modelToView);
  vtkMatrix4x4* projection =
    camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1., 1.);
  MesoGridView view;
  std::copy_n(modelToView->GetData(), 16, view.ModelToView.begin());
  std::copy_n(projection->GetData(), 16, view.Projection.begin());
  view.Near = camera->GetClippingRange()[0];
  view.Height = viewport[3];
  return view;
}
