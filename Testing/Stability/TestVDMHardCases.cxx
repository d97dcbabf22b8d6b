// Views, lights, charts and maps that strain the technique vdm: every pixel's numbers stay finite, a plane has
// no holes, and what must not change the picture does not.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"
#include "MesoTestScene.h"
#include "MesoTestVDM.h"
#include "vtkMesoSurfaceFrames.h"
#include "vtkMesoVDMMapper.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkTransform.h"

#include <cmath>
#include <tuple>

namespace
{
const double Pi = std::acos(-1.);

/// The table itself or factors, and curvatures at pixels or vertices.
class VDMHardCases : public testing::TestWithParam<std::tuple<int, MesoCurvatureAt>>
{
protected:
  MesoTestScene Scene{ 96, 96 };
  vtkNew<vtkMesoVDMMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  void SetUp() override
  {
    this->UseMap(MesoTestScene::Pattern("brick"));
    MesoMesostructureOptions options = this->Mapper->GetOptions();
    options.CurvatureAt = std::get<1>(this->GetParam());
    this->Mapper->SetOptions(options);
    this->Mapper->SetScale(0.08);
    this->Mapper->SetTiles(4., 4.);
    this->UseShape("plane");
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
  }
  void TearDown() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  void UseMap(vtkImageData* heights)
  {
    this->Mapper->SetHeightMap(heights);
    this->Mapper->SetTable(MesoSmallVDM(heights, 0.2, std::get<0>(this->GetParam())));
  }
  void UseShape(const std::string& shape)
  {
    this->Plane = shape == "plane";
    this->Use(MesoTestScene::Shape(shape));
  }
  /// With frames of its texture coordinates.
  void Use(vtkPolyData* mesh)
  {
    vtkNew<vtkMesoSurfaceFrames> frames;
    frames->SetInputData(mesh);
    frames->Update();
    mesh = frames->GetOutput();
    this->Mapper->SetInputData(MesoTestScene::Prepared(mesh, MesoTechnique::VDM));
  }

  /// Checks every pixel: the relief covers no more than its base, and of a plane no less. Returns how many.
  int Check()
  {
    const double scale = this->Mapper->GetScale();
    this->Mapper->SetScale(0.);
    MesoCapture(this->Scene, this->Pass);
    const auto base = this->Pass->GetChannel("coverage");
    this->Mapper->SetScale(scale);
    MesoCapture(this->Scene, this->Pass);
    const int covered = MesoCheckEveryPixel(this->Pass);
    const auto relief = this->Pass->GetChannel("coverage");
    int holes = 0;
    for (std::size_t i = 0; i < base.size(); ++i)
    {
      EXPECT_LE(relief[i], base[i]);
      holes += relief[i] < base[i] ? 1 : 0;
    }
    if (this->Plane)
    {
      EXPECT_EQ(holes, 0);
    }
    return covered;
  }

  /// Seen from an elevation above the plane, in degrees.
  void LookAt(double elevation, double distance = 1.5)
  {
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    const double angle = elevation * Pi / 180.;
    camera->SetPosition(0., -distance * std::cos(angle), distance * std::sin(angle));
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., elevation > 89. ? 1. : 0., elevation > 89. ? 0. : 1.);
    this->Scene.Renderer->ResetCameraClippingRange();
  }

  /// Equal within 2/255 on 99 % of the pixels.
  static void ExpectSame(vtkImageData* image, vtkImageData* expected, const std::string& what)
  {
    MesoImageLimits limits;
    limits.SmallDifference = 2;
    limits.SmallFraction = 0.01;
    limits.LargeDifference = 255;
    const auto difference = MesoCompareImages(image, expected, limits);
    EXPECT_TRUE(difference.Within) << what << ": " << difference.Describe();
  }

  bool Plane = true;
};
}

TEST_P(VDMHardCases, AlongTheNormalAndGrazing)
{
  for (const double elevation : { 90., 5., 1., 0.1, 0.01 })
  {
    this->LookAt(elevation);
    EXPECT_GE(this->Check(), elevation > 4. ? 500 : 0) << elevation;
  }
}

TEST_P(VDMHardCases, EyeAtTheSurfaceInsideAndBehind)
{
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  for (const double height : { 1e-3, 0., -0.05 })
  {
    camera->SetPosition(0., -0.2, height);
    camera->SetFocalPoint(0., 1., height - 0.02);
    camera->SetViewUp(0., 0., 1.);
    camera->SetClippingRange(0.001, 10.);
    this->Check();
  }
  this->LookAt(30., 0.3);
  camera->SetClippingRange(0.25, 10.); // across the near plane
  EXPECT_GT(this->Check(), 1000);
  this->Scene.Actor->GetProperty()->BackfaceCullingOff();
  this->LookAt(-40.);
  EXPECT_GT(this->Check(), 1000);
}

TEST_P(VDMHardCases, WideFarNearAndParallel)
{
  this->LookAt(40., 20.);
  EXPECT_GT(this->Check(), 5);
  this->LookAt(60., 0.004); // one texel fills the screen
  this->Scene.Renderer->GetActiveCamera()->SetClippingRange(1e-4, 1.);
  EXPECT_EQ(this->Check(), 96 * 96);
  this->LookAt(40., 0.5);
  this->Scene.Renderer->GetActiveCamera()->SetViewAngle(170.);
  this->Scene.Renderer->ResetCameraClippingRange();
  this->Check();
  this->LookAt(30.);
  this->Scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Scene.Renderer->GetActiveCamera()->SetParallelScale(0.4);
  this->Scene.Renderer->ResetCameraClippingRange();
  EXPECT_GT(this->Check(), 3000);
}

TEST_P(VDMHardCases, UmbilicsPolesAndAllCurvatures)
{
  // A sphere is an umbilic everywhere, seen along its normal in the middle; at its poles the chart collapses.
  for (const char* shape : { "sphere", "torus", "undulating", "cone", "teapot" })
  {
    this->UseShape(shape);
    for (const auto& from :
      { std::array<double, 3>{ 0., 4.5, 0. }, { 0., -4.5, 0. }, { 0., 0.3, 4. }, { 3., 2., 1. } })
    {
      this->Scene.LookFrom(from[0], from[1], from[2]);
      EXPECT_GE(this->Check(), 0) << shape;
    }
  }
  this->UseShape("sphere");
  this->Scene.LookFrom(0., 0., 4.5);
  EXPECT_GT(this->Check(), 2000);
}

TEST_P(VDMHardCases, LightsFromEverywhere)
{
  this->LookAt(50.);
  this->Scene.Renderer->RemoveAllLights();
  const double directions[][3] = { { 0., 0., -1. }, { 0., 0., 1. }, { 1., 0., 0. },
    { 1., 0., -1e-6 }, { 1., 0., 1e-6 }, { 1., 1., -1. } };
  for (const auto& direction : directions)
  {
    this->Scene.AddDirectionalLight(direction[0], direction[1], direction[2]);
  }
  for (const double z : { -0.05, 0., 1. })
  {
    vtkLight* light = this->Scene.AddDirectionalLight(0., 0., -1.);
    light->PositionalOn();
    light->SetConeAngle(z > 0. ? 20. : 90.);
    light->SetPosition(0., 0., z);
    light->SetFocalPoint(0., 0., z - 1.);
  }
  EXPECT_GT(this->Check(), 1000);
  // Along the normal next to nothing is in shadow; from behind, everything is.
  const auto coverage = this->Pass->GetChannel("coverage");
  const auto along = this->Pass->GetChannel("shadow.0");
  int lit = 0;
  int covered = 0;
  for (std::size_t i = 0; i < coverage.size(); ++i)
  {
    covered += coverage[i] > 0.f ? 1 : 0;
    lit += coverage[i] > 0.f && along[i] == 0.f ? 1 : 0;
  }
  EXPECT_GT(lit, 0.95 * covered);
  EXPECT_EQ(this->Pass->GetChannel("shadow.1"), coverage);
  this->UseShape("torus");
  this->Scene.LookFrom(1., 3., 5.);
  EXPECT_GT(this->Check(), 1000);
}

TEST_P(VDMHardCases, HugeTinyAndTurnedScenesLookTheSame)
{
  this->UseShape("torus");
  this->Scene.LookFrom(1., 3., 5.);
  const auto expected = MesoGrabWindow(this->Scene.Window);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  for (const double scale : { 1e-4, 1e4, 1. })
  {
    vtkNew<vtkTransform> transform;
    transform->RotateWXYZ(scale == 1. ? 50. : 0., 1., 2., 3.);
    transform->Scale(scale, scale, scale);
    this->Scene.Actor->SetUserTransform(transform);
    camera->SetPosition(transform->TransformDoublePoint(1., 3., 5.));
    camera->SetFocalPoint(transform->TransformDoublePoint(0., 0., 0.));
    camera->SetViewUp(transform->TransformDoubleVector(0., 1., 0.));
    this->Scene.Renderer->ResetCameraClippingRange();
    const double* travel = transform->TransformDoubleVector(-1., -2., -1.);
    const double direction[3] = { travel[0], travel[1], travel[2] };
    this->Scene.Renderer->RemoveAllLights();
    this->Scene.AddDirectionalLight(direction[0], direction[1], direction[2]);
    ExpectSame(MesoGrabWindow(this->Scene.Window), expected, std::to_string(scale));
  }
}

TEST_P(VDMHardCases, AMirroredChartWithAMirroredMapLooksTheSame)
{
  const auto heights = MesoTestScene::Pattern("smooth", 24, 24);
  vtkNew<vtkImageData> mirrored;
  mirrored->DeepCopy(heights);
  for (int row = 0; row < 24; ++row)
  {
    for (int column = 0; column < 24; ++column)
    {
      mirrored->SetScalarComponentFromDouble(
        column, row, 0, 0, heights->GetScalarComponentAsDouble(23 - column, row, 0, 0));
    }
  }
  const auto mesh = MesoTestScene::Shape("torus");
  this->UseMap(heights);
  this->Use(mesh);
  this->Scene.LookFrom(1., 3., 5.);
  const auto expected = MesoGrabWindow(this->Scene.Window);
  vtkNew<vtkPolyData> turned;
  turned->DeepCopy(mesh);
  vtkDataArray* coordinates = turned->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    coordinates->SetComponent(i, 0, 1. - coordinates->GetComponent(i, 0));
  }
  this->UseMap(mirrored);
  this->Use(turned);
  ExpectSame(MesoGrabWindow(this->Scene.Window), expected, "mirrored");
}

TEST_P(VDMHardCases, ShearedAndStretchedCharts)
{
  const auto mesh = MesoTestScene::Shape("torus");
  for (const double shear : { 0.9, -3., 30. })
  {
    vtkNew<vtkPolyData> sheared;
    sheared->DeepCopy(mesh);
    vtkDataArray* coordinates = sheared->GetPointData()->GetTCoords();
    for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
    {
      coordinates->SetComponent(
        i, 1, coordinates->GetComponent(i, 1) + shear * coordinates->GetComponent(i, 0));
    }
    this->Plane = false;
    this->Use(sheared);
    this->Scene.LookFrom(1., 3., 5.);
    EXPECT_GT(this->Check(), 1000) << shear;
  }
}

TEST_P(VDMHardCases, MapsOfAllKinds)
{
  for (const char* pattern : { "spikes", "checkerboard", "step", "pits" })
  {
    this->UseMap(MesoTestScene::Pattern(pattern, 32, 17));
    this->UseShape("torus");
    this->Scene.LookFrom(1., 3., 5.);
    EXPECT_GT(this->Check(), 800) << pattern;
  }
  for (const float height : { 0.f, 0.5f })
  {
    this->UseMap(MesoTestScene::Constant(height));
    this->UseShape("plane");
    this->LookAt(30.);
    EXPECT_GT(this->Check(), 1000);
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, VDMHardCases,
  testing::Combine(
    testing::Values(0, 8), testing::Values(MesoCurvatureAt::Pixel, MesoCurvatureAt::Vertex)),
  [](const auto& info)
  {
    return std::string(std::get<0>(info.param) > 0 ? "Factors" : "Table") +
      (std::get<1>(info.param) == MesoCurvatureAt::Vertex ? "Vertex" : "Pixel");
  });
