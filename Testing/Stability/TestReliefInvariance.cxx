// Changes that must not change the picture: moving the whole scene with its camera, scaling it all,
// shifting texture coordinates by whole tiles, drawing twice.

#include "MesoBaseline.h"
#include "MesoReliefTechniques.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{
class ReliefInvariance : public testing::TestWithParam<MesoReliefArm>
{
protected:
  MesoTestScene Scene{ 128, 128 };
  vtkNew<vtkMesoReliefMapper> Mapper;

  void SetUp() override
  {
    this->Mapper->SetHeightMap(MesoTestScene::Pattern("brick"));
    MesoUse(this->Mapper, this->GetParam(), MesoTestScene::Shape("torus"));
    this->Mapper->SetScale(0.08);
    this->Mapper->SetTiles(6., 3.);
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.Actor->GetProperty()->SetSpecular(0.3);
    this->Scene.Actor->GetProperty()->SetSpecularPower(20.);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.LookFrom(1., 3., 5.);
  }

  /// The scene with its light and camera, all moved by a transform.
  vtkSmartPointer<vtkImageData> Moved(vtkTransform* transform)
  {
    vtkRenderer* renderer = this->Scene.Renderer;
    this->Scene.Actor->SetUserTransform(transform);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(transform->TransformDoublePoint(1., 3., 5.));
    camera->SetFocalPoint(transform->TransformDoublePoint(0., 0., 0.));
    camera->SetViewUp(transform->TransformDoubleVector(0., 1., 0.));
    const double* travel = transform->TransformDoubleVector(-1., -2., -1.);
    const double direction[3] = { travel[0], travel[1], travel[2] };
    renderer->RemoveAllLights();
    this->Scene.AddDirectionalLight(direction[0], direction[1], direction[2]);
    renderer->ResetCameraClippingRange();
    return MesoGrabWindow(this->Scene.Window);
  }

  /// Equal within 1/255 on 99.9 % of the pixels.
  static void ExpectSame(vtkImageData* image, vtkImageData* expected, const std::string& what)
  {
    MesoImageLimits limits;
    limits.SmallDifference = 1;
    limits.LargeDifference = 64;
    const auto difference = MesoCompareImages(image, expected, limits);
    EXPECT_TRUE(difference.Within) << what << ": " << difference.Describe();
  }
};
}

TEST_P(ReliefInvariance, TwiceIsTheSame)
{
  const auto first = MesoGrabWindow(this->Scene.Window);
  const auto second = MesoGrabWindow(this->Scene.Window);
  EXPECT_TRUE(MesoCompareImages(second, first, MesoImageLimits::Exact()).Within);
}

TEST_P(ReliefInvariance, RigidMotion)
{
  const auto still = MesoGrabWindow(this->Scene.Window);
  vtkNew<vtkTransform> motion;
  motion->Translate(3., -7., 11.);
  motion->RotateWXYZ(70., 1., 2., -0.5);
  ExpectSame(this->Moved(motion), still, "moved and turned");
}

TEST_P(ReliefInvariance, UniformScale)
{
  const auto still = MesoGrabWindow(this->Scene.Window);
  for (double size : { 1e-4, 1e4 })
  {
    vtkNew<vtkTransform> scale;
    scale->Scale(size, size, size);
    ExpectSame(this->Moved(scale), still, "scale " + std::to_string(size));
  }
}

TEST_P(ReliefInvariance, WholeTiles)
{
  const auto still = MesoGrabWindow(this->Scene.Window);
  vtkDataArray* coordinates = this->Mapper->GetInput()->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    coordinates->SetComponent(i, 0, coordinates->GetComponent(i, 0) + 2.);
    coordinates->SetComponent(i, 1, coordinates->GetComponent(i, 1) - 3.);
  }
  coordinates->Modified();
  this->Mapper->GetInput()->Modified();
  ExpectSame(MesoGrabWindow(this->Scene.Window), still, "shifted by whole tiles");
}

MESO_FOR_RELIEF_ARMS(ReliefInvariance);
