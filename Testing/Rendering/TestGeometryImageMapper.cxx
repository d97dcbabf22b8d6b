// The technique `geometry-image` as it is drawn: about the mesh that the image is of, at the level that the
// picture asks for, and the input itself where there is no image.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"
#include "MesoExpectedMessages.h"

#include "vtkMesoGeometryImage.h"
#include "vtkMesoGeometryImageMapper.h"

#include "vtkPlane.h"

#include <cmath>

namespace
{
class GeometryImageMapper : public testing::Test
{
protected:
  MesoTestScene Scene;
  vtkNew<vtkMesoGeometryImageMapper> Mapper;
  vtkNew<vtkMesoPolyDataMapper> Plain;
  vtkNew<vtkMesoAOVPass> Pass;
  vtkSmartPointer<vtkPolyData> Mesh;

  GeometryImageMapper()
  {
    this->Mesh = MesoTestScene::Shape("torus", { { "rings", { 48. } }, { "sides", { 24. } } });
    this->Plain->SetInputData(this->Mesh);
    this->Mapper->SetInputData(this->Mesh);
    this->Mapper->SetGeometryImage(this->ImageOf(this->Mesh, 128));
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.LookFrom(1., 3., 5.);
  }
  ~GeometryImageMapper() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  static vtkSmartPointer<vtkImageData> ImageOf(vtkPolyData* mesh, int size)
  {
    vtkNew<vtkMesoGeometryImage> filter;
    filter->SetInputData(mesh);
    filter->SetSize(size);
    filter->Update();
    return filter->GetOutput();
  }

  vtkSmartPointer<vtkImageData> Grab(vtkMapper* mapper)
  {
    this->Scene.Actor->SetMapper(mapper);
    return MesoGrabWindow(this->Scene.Window);
  }

  void SetFacetPixels(double pixels)
  {
    MesoMesostructureOptions options = this->Mapper->GetOptions();
    options.FacetPixels = pixels;
    this->Mapper->SetOptions(options);
  }

  /// About the plain mesh: triangles of the image cut its corners.
  void ExpectMesh(const char* what)
  {
    MesoImageLimits limits;
    limits.SmallDifference = 8;
    limits.SmallFraction = 0.02;
    limits.LargeFraction = 0.01;
    const auto difference =
      MesoCompareImages(this->Grab(this->Mapper), this->Grab(this->Plain), limits);
    EXPECT_TRUE(difference.Within) << what << ": " << difference.Describe();
    EXPECT_TRUE(this->Mapper->GetWhyPlain().empty()) << this->Mapper->GetWhyPlain();
  }
};
}

TEST_F(GeometryImageMapper, ShowsTheMesh)
{
  this->ExpectMesh("as it is");
  EXPECT_GT(this->Mapper->GetNumberOfTrianglesDrawn(), 20000);
  this->Scene.Actor->GetProperty()->SetSpecular(0.3);
  this->Scene.Actor->SetScale(-1., 0.7, 1.2);
  this->Scene.Actor->RotateX(40.);
  this->ExpectMesh("moved and mirrored");
  vtkNew<vtkPlane> plane;
  plane->SetNormal(1., 0.3, 0.);
  this->Mapper->AddClippingPlane(plane);
  this->Plain->AddClippingPlane(plane);
  this->ExpectMesh("clipped");
}

TEST_F(GeometryImageMapper, EveryPixelIsSound)
{
  const auto capture = [&](vtkMapper* mapper)
  {
    this->Scene.Actor->SetMapper(mapper);
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  };
  const int covered = capture(this->Plain);
  const auto depths = this->Pass->GetChannel("depth");
  const auto places = this->Pass->GetChannel("texcoord.u");
  EXPECT_NEAR(capture(this->Mapper), covered, 0.01 * covered);
  const auto ours = this->Pass->GetChannel("depth");
  const auto ourPlaces = this->Pass->GetChannel("texcoord.u");
  int apart = 0;
  int displaced = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
  {
    apart += ours[i] > 0.f && depths[i] > 0.f && std::abs(ours[i] - depths[i]) > 0.02f ? 1 : 0;
    const float du = std::abs(ourPlaces[i] - places[i]);
    displaced += ours[i] > 0.f && depths[i] > 0.f && std::min(du, 1.f - du) > 0.01f ? 1 : 0;
  }
  EXPECT_LT(apart, covered / 100);
  EXPECT_LT(displaced, covered / 100);
}

TEST_F(GeometryImageMapper, TakesTheLevelThatThePictureAsksFor)
{
  this->SetFacetPixels(2.);
  int before = -1;
  for (const double distance : { 1., 3., 9., 27. })
  {
    this->Scene.LookFrom(distance, 3. * distance, 5. * distance);
    this->Grab(this->Mapper);
    EXPECT_GT(this->Mapper->GetLevelDrawn(), before) << distance;
    before = this->Mapper->GetLevelDrawn();
  }
  EXPECT_LT(this->Mapper->GetNumberOfTrianglesDrawn(), 1000);
  this->SetFacetPixels(0.);
  this->Grab(this->Mapper);
  EXPECT_EQ(this->Mapper->GetLevelDrawn(), 0);
}

TEST_F(GeometryImageMapper, CoarseLevelsAreClosedToo)
{
  // From inside of the tube there is surface all around, at each level.
  this->Scene.Actor->GetProperty()->BackfaceCullingOff();
  this->Scene.Actor->SetMapper(this->Mapper);
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  camera->SetViewAngle(70.);
  for (const int size : { 128, 64, 32, 16 })
  {
    this->Mapper->SetGeometryImage(this->ImageOf(this->Mesh, size));
    this->SetFacetPixels(0.);
    for (int turn = 0; turn < 8; ++turn)
    {
      const double angle = 0.8 * turn;
      camera->SetPosition(std::cos(angle), 0., std::sin(angle));
      camera->SetFocalPoint(std::cos(angle) + std::cos(3. * turn), 0.3 * std::sin(5. * turn),
        std::sin(angle) + std::sin(3. * turn));
      camera->SetClippingRange(0.005, 10.);
      MesoCapture(this->Scene, this->Pass);
      EXPECT_EQ(MesoCheckEveryPixel(this->Pass), 150 * 150) << size << " " << turn;
    }
  }
}

TEST_F(GeometryImageMapper, WithoutAnImageItIsTheInput)
{
  const auto expected = this->Grab(this->Plain);
  const auto drawn = this->Grab(this->Mapper);
  this->Mapper->SetGeometryImage(nullptr);
  EXPECT_TRUE(
    MesoCompareImages(this->Grab(this->Mapper), expected, MesoImageLimits::Exact()).Within);
  this->Mapper->SetGeometryImage(this->ImageOf(this->Mesh, 128));
  EXPECT_TRUE(MesoCompareImages(this->Grab(this->Mapper), drawn, MesoImageLimits::Exact()).Within);
  MesoMesostructureOptions none = this->Mapper->GetOptions();
  none.Effects.Auto = false;
  this->Mapper->SetOptions(none);
  EXPECT_TRUE(
    MesoCompareImages(this->Grab(this->Mapper), expected, MesoImageLimits::Exact()).Within);
}

TEST_F(GeometryImageMapper, SaysWhatIsNoGeometryImage)
{
  const auto expected = this->Grab(this->Plain);
  this->Mapper->SetGeometryImage(MesoTestScene::Constant(1.f));
  const MesoExpectedMessages messages("MesoLevels among its field data");
  EXPECT_TRUE(
    MesoCompareImages(this->Grab(this->Mapper), expected, MesoImageLimits::Exact()).Within);
}
