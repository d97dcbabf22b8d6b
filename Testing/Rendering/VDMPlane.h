#ifndef VDMPlane_h
#define VDMPlane_h

// A plane for tests of tables of view-dependent displacements.

#include "MesoAOVChecks.h"
#include "MesoTestScene.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoReliefMapper.h"

#include <algorithm>
#include <cmath>

/// Relief mapping of a map by the search that misses nothing.
inline vtkSmartPointer<vtkMesoReliefMapper> CertifiedRelief(vtkImageData* heights)
{
  auto relief = vtkSmartPointer<vtkMesoReliefMapper>::New();
  relief->SetHeightMap(heights);
  MesoMesostructureOptions options = relief->GetOptions();
  options.Quality = MesoQuality::Certified;
  relief->SetOptions(options);
  return relief;
}

/// A plane of 2 x 2 with 4 x 4 tiles, seen from an angle off its normal and an azimuth by a parallel camera.
struct VDMPlane : public MesoTestScene
{
  static constexpr double Degree = 0.017453292519943295;
  vtkNew<vtkMesoAOVPass> Pass;

  VDMPlane(double degrees, double azimuth)
    : MesoTestScene(100, 100)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(0.2 * std::cos(degrees * Degree));
    const double sine = std::sin(degrees * Degree);
    camera->SetPosition(-5. * sine * std::cos(azimuth), -5. * sine * std::sin(azimuth),
      5. * std::cos(degrees * Degree));
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(std::sin(azimuth), -std::cos(azimuth), 0.);
    this->AddDirectionalLight(0.5, 0.7, -1.);
    this->Renderer->ResetCameraClippingRange();
  }
  ~VDMPlane() { this->Pass->ReleaseGraphicsResources(this->Window); }

  void Capture(vtkMesoPolyDataMapper* mapper, double scale = 0.05)
  {
    mapper->SetInputData(Prepared(Shape("plane", { { "size", { 2., 2. } } }), MesoTechnique::VDM));
    mapper->SetScale(scale);
    mapper->SetTiles(4., 4.);
    this->Actor->SetMapper(mapper);
    MesoCapture(*this, this->Pass);
  }

  std::vector<float> Values(const char* channel) const { return this->Pass->GetChannel(channel); }
};

#endif
