#ifndef MesoTiltedPlane_h
#define MesoTiltedPlane_h

/**
 * @file MesoTiltedPlane.h
 * @brief A plane of 1 x 1 with relief under a parallel camera, where each pixel's ray is known.
 *
 * The plane lies in z = 0, u along x. The camera looks along V = (sin a, 0, -cos a), y up, from 5
 * away, so the ray of a pixel enters at (u, v) = (x / cos a + 1/2, y + 1/2), x and y being the
 * pixel's place on the screen, and moves u by D tan a while it goes down by D.
 */

#include "MesoTestScene.h"

#include "vtkMesoAOVPass.h"
#include "vtkMesoReliefMapper.h"

#include <cmath>

struct MesoTiltedPlane : public MesoTestScene
{
  static constexpr double Distance = 5.;
  static constexpr double HalfHeight = 0.3; ///< of what the screen shows

  double Angle; ///< off the normal, radians
  double Scale;
  vtkNew<vtkMesoReliefMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  MesoTiltedPlane(double degrees, double scale, vtkImageData* heights, int size)
    : MesoTestScene(size, size)
    , Angle(degrees * std::acos(-1.) / 180.)
    , Scale(scale)
  {
    this->Mapper->SetInputData(Shape("plane"));
    this->Mapper->SetHeightMap(heights);
    this->Mapper->SetScale(scale);
    MesoMesostructureOptions options = this->Mapper->GetOptions();
    options.Quality = MesoQuality::High;
    this->Mapper->SetOptions(options);
    this->Actor->SetMapper(this->Mapper);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(HalfHeight);
    camera->SetPosition(-Distance * std::sin(this->Angle), 0., Distance * std::cos(this->Angle));
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., 1., 0.);
    this->Renderer->ResetCameraClippingRange();
  }

  ~MesoTiltedPlane() { this->Pass->ReleaseGraphicsResources(this->Window); }

  void Capture()
  {
    this->Renderer->SetPass(this->Pass);
    this->Window->Render();
    this->Renderer->SetPass(nullptr);
  }

  double ScreenX(int column) const
  {
    return ((column + 0.5) / this->Window->GetSize()[0] * 2. - 1.) * HalfHeight;
  }
  double ScreenY(int row) const
  {
    return (1. - (row + 0.5) / this->Window->GetSize()[1] * 2.) * HalfHeight;
  }
  double EntryU(int column) const { return this->ScreenX(column) / std::cos(this->Angle) + 0.5; }
  double EntryV(int row) const { return this->ScreenY(row) + 0.5; }
  /// How far u moves from the top of the relief to its bottom.
  double TravelU() const { return this->Scale * std::tan(this->Angle); }
};

#endif
