#ifndef EGLTestScene_h
#define EGLTestScene_h

/**
 * @file EGLTestScene.h
 * @brief What the tests of the EGL window draw: a ball of one colour on a ground of another.
 */

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <array> // for pixels

using Pixel = std::array<int, 3>;
constexpr Pixel BallColor = { 255, 128, 0 };
constexpr Pixel GroundColor = { 0, 0, 255 };

/// A ball of radius 1 that fills two thirds of the picture's height.
struct EGLTestScene
{
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;

  EGLTestScene()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.);
    sphere->SetThetaResolution(32);
    sphere->SetPhiResolution(32);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->SetColor(1., 128. / 255., 0.);
    this->Actor->GetProperty()->SetLighting(false);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->SetBackground(0., 0., 1.);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0., 0., 10.);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.5);
    this->Renderer->ResetCameraClippingRange();
  }

  void ShowIn(vtkRenderWindow* window, int width, int height)
  {
    window->SetSize(width, height);
    window->AddRenderer(this->Renderer);
  }
};

inline Pixel PixelAt(vtkRenderWindow* window, int x, int y)
{
  vtkNew<vtkUnsignedCharArray> data;
  if (window->GetPixelData(x, y, x, y, 1, data, 0) != VTK_OK || data->GetNumberOfValues() != 3)
  {
    return { -1, -1, -1 };
  }
  return { data->GetValue(0), data->GetValue(1), data->GetValue(2) };
}

inline Pixel CentrePixel(vtkRenderWindow* window)
{
  const int* size = window->GetSize();
  return PixelAt(window, size[0] / 2, size[1] / 2);
}

#endif
