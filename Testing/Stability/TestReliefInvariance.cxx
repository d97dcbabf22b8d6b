// Changes that must not change the picture: moving the whole scene with its camera, scaling it all,
// shifting texture coordinates by whole tiles, drawing twice; mirroring mesh, map and light mirrors it, and a
// slow pan moves it evenly.

#include "MesoBaseline.h"
#include "MesoReliefTechniques.h"

#include "vtkMesoSurfaceFrames.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageFlip.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>
#include <iterator>

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

TEST_P(ReliefInvariance, MirroredMeshWithMirroredMapIsTheMirrorImage)
{
  // Points and light go over to -x; u, which runs the other way round then, is turned back with the map.
  this->Scene.LookFrom(0., 3., 5.);
  const auto image = MesoGrabWindow(this->Scene.Window);
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->DeepCopy(MesoTestScene::Shape("torus"));
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  bare->GetPointData()->SetTCoords(mesh->GetPointData()->GetTCoords());
  for (vtkIdType i = 0; i < bare->GetNumberOfPoints(); ++i)
  {
    double p[3];
    bare->GetPoint(i, p);
    bare->GetPoints()->SetPoint(i, -p[0], p[1], p[2]);
    vtkDataArray* coordinates = bare->GetPointData()->GetTCoords();
    coordinates->SetComponent(i, 0, 1. - coordinates->GetComponent(i, 0));
  }
  vtkNew<vtkCellArray> turned; // so that the outside stays outside
  vtkIdType count;
  const vtkIdType* points;
  for (bare->GetPolys()->InitTraversal(); bare->GetPolys()->GetNextCell(count, points);)
  {
    const std::vector<vtkIdType> backwards(
      std::make_reverse_iterator(points + count), std::make_reverse_iterator(points));
    turned->InsertNextCell(count, backwards.data());
  }
  bare->SetPolys(turned);
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputData(bare);
  frames->Update();
  auto map = vtkSmartPointer<vtkImageData>::New();
  map->DeepCopy(MesoTestScene::Pattern("brick"));
  auto* value = static_cast<float*>(map->GetScalarPointer());
  for (int row = 0; row < 64; ++row)
  {
    std::reverse(value + 64 * row, value + 64 * (row + 1));
  }
  this->Mapper->SetHeightMap(map);
  MesoUse(this->Mapper, this->GetParam(), frames->GetOutput());
  this->Scene.Renderer->RemoveAllLights();
  this->Scene.AddDirectionalLight(1., -2., -1.);
  const auto other = MesoGrabWindow(this->Scene.Window);
  vtkNew<vtkImageFlip> mirror;
  mirror->SetInputData(other);
  mirror->SetFilteredAxis(0);
  mirror->Update();
  // Frames are made from the mesh here and are the shape's own there.
  MesoImageLimits limits;
  limits.SmallDifference = 8;
  limits.SmallFraction = 0.03;
  limits.LargeDifference = 64;
  limits.LargeFraction = 0.005;
  const auto difference = MesoCompareImages(mirror->GetOutput(), image, limits);
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_P(ReliefInvariance, ASlowPanMovesThePictureEvenly)
{
  // Frames an eighth of a pixel apart: no frame jumps, and the last is the first moved by
  // one pixel.
  MesoMesostructureOptions options = this->Mapper->GetOptions();
  options.Quality = MesoQuality::Draft;
  this->Mapper->SetOptions(options);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(1.5);
  camera->SetPosition(0., 3., 5.);
  camera->SetFocalPoint(0., 0., 0.);
  const double pixel = 3. / 128.;
  const auto first = MesoGrabWindow(this->Scene.Window);
  const auto sumOf = [](vtkImageData* picture, vtkImageData* earlier)
  {
    const auto* a = static_cast<const unsigned char*>(picture->GetScalarPointer());
    const auto* b = static_cast<const unsigned char*>(earlier->GetScalarPointer());
    double sum = 0.;
    for (int i = 0; i < 3 * 128 * 128; ++i)
    {
      sum += std::abs(double(a[i]) - double(b[i]));
    }
    return sum;
  };
  vtkSmartPointer<vtkImageData> before = first;
  double total = 0.;
  double most = 0.;
  constexpr int Frames = 8;
  for (int frame = 1; frame <= Frames; ++frame)
  {
    const double x = pixel * frame / Frames;
    camera->SetPosition(x, 3., 5.);
    camera->SetFocalPoint(x, 0., 0.);
    const auto picture = MesoGrabWindow(this->Scene.Window);
    const double change = sumOf(picture, before);
    total += change;
    most = std::max(most, change);
    before = picture;
  }
  EXPECT_LT(most, 2. * total / Frames) << "a frame jumps";
  auto shifted = vtkSmartPointer<vtkImageData>::New();
  shifted->DeepCopy(first);
  auto* value = static_cast<unsigned char*>(shifted->GetScalarPointer());
  for (int row = 0; row < 128; ++row)
  {
    unsigned char* line = value + 3 * 128 * row;
    std::copy(line + 3, line + 3 * 128, line);
  }
  ExpectSame(before, shifted, "moved by a pixel");
}

MESO_FOR_RELIEF_ARMS(ReliefInvariance);
