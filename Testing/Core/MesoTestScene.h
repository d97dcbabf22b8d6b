#ifndef MesoTestScene_h
#define MesoTestScene_h

/**
 * @file MesoTestScene.h
 * @brief One shape before one camera, for tests of mappers: set it up, change it, look at it.
 */

#include "MesoOptions.h"
#include "vtkMesoBaseImage.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoPatternSource.h"
#include "vtkMesoQuadricFit.h"
#include "vtkMesoShapeSource.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

struct MesoTestScene
{
  vtkNew<vtkMesoEGLRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkActor> Actor;

  explicit MesoTestScene(int width = 150, int height = 150)
  {
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.1, 0.15, 0.2);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddActor(this->Actor);
    vtkProperty* property = this->Actor->GetProperty();
    property->SetColor(0.8, 0.7, 0.6);
    property->SetInterpolationToPhong();
    property->BackfaceCullingOn();
  }

  static vtkSmartPointer<vtkPolyData> Shape(
    const std::string& name, const std::map<std::string, std::vector<double>>& parameters = {})
  {
    vtkNew<vtkMesoShapeSource> source;
    source->SetShape(name.c_str());
    for (const auto& parameter : parameters)
    {
      source->SetParameter(parameter.first, parameter.second);
    }
    source->Update();
    return source->GetOutput();
  }

  /// The mesh with what a technique needs: MesoQuadric for the techniques that bend the relief.
  static vtkSmartPointer<vtkPolyData> Prepared(vtkPolyData* mesh, MesoTechnique technique)
  {
    if (!MesoEffectsOfTechnique(technique).Has(MesoEffect::Curvature))
    {
      return mesh;
    }
    vtkNew<vtkMesoQuadricFit> fit;
    fit->SetInputData(mesh);
    fit->Update();
    return fit->GetOutput();
  }

  /// The mesh's image, for the bases that are looked up in one.
  static vtkSmartPointer<vtkImageData> BaseImage(vtkPolyData* mesh)
  {
    vtkNew<vtkMesoBaseImage> image;
    image->SetSizeFor(mesh);
    image->SetInputData(mesh);
    image->Update();
    return image->GetOutput();
  }

  static vtkSmartPointer<vtkImageData> Pattern(const std::string& name, int width = 64,
    int height = 64, const std::map<std::string, double>& parameters = {})
  {
    vtkNew<vtkMesoPatternSource> source;
    source->SetPattern(name.c_str());
    source->SetSize(width, height);
    for (const auto& parameter : parameters)
    {
      source->SetParameter(parameter.first, parameter.second);
    }
    source->Update();
    return source->GetOutput();
  }

  /// A height map of the same value everywhere.
  static vtkSmartPointer<vtkImageData> Constant(float height)
  {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(4, 4, 1);
    image->AllocateScalars(VTK_FLOAT, 1);
    std::fill_n(static_cast<float*>(image->GetScalarPointer()), 16, height);
    return image;
  }

  /// A light that travels along a direction.
  vtkLight* AddDirectionalLight(double x, double y, double z)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(-x, -y, -z);
    light->SetFocalPoint(0., 0., 0.);
    this->Renderer->AddLight(light);
    return light;
  }

  void AddHeadlight()
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToHeadlight();
    this->Renderer->AddLight(light);
  }

  /// Look at the origin from a point, up being y (or -z where the view is along y).
  void LookFrom(double x, double y, double z, double viewAngle = 30.)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(x, y, z);
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., x == 0. && z == 0. ? 0. : 1., x == 0. && z == 0. ? -1. : 0.);
    camera->SetViewAngle(viewAngle);
    this->Renderer->ResetCameraClippingRange();
  }
};

#endif
