// relief-quadric on a map of constant height, where everything has a closed form: outlines, depth,
// normals and shadows on a sphere, and on a cylinder whose chart runs along it, around it and at 45
// degrees to it.

#include "MesoAOVChecks.h"

#include "vtkMesoQuadricFit.h"
#include "vtkMesoSurfaceFrames.h"

#include "vtkDoubleArray.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Size = 200;
constexpr double HalfHeight = 1.1;               ///< of what the screen shows
constexpr double Pixel = 2. * HalfHeight / Size; ///< object units
constexpr double Radius = 1.;

class ReliefQuadricOutline : public testing::Test
{
protected:
  MesoTestScene Scene{ Size, Size };
  vtkNew<vtkMesoReliefMapper> Mapper;
  vtkNew<vtkMesoAOVPass> Pass;

  void SetUp() override
  {
    this->Mapper->SetHeightMap(MesoTestScene::Constant(0.5f));
    this->Scene.Actor->SetMapper(this->Mapper);
    this->Scene.AddDirectionalLight(-1., 0., -0.5);
    vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(HalfHeight);
    camera->SetPosition(0., 0., 5.);
    camera->SetFocalPoint(0., 0., 0.);
    camera->SetViewUp(0., 1., 0.);
  }

  ~ReliefQuadricOutline() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  /// Draws the mesh with the surface `depth` below it.
  void Draw(vtkPolyData* mesh, double depth)
  {
    MesoUse(this->Mapper, MesoTechnique::ReliefQuadric, mesh);
    this->Mapper->SetScale(2. * depth);
    this->Scene.Renderer->ResetCameraClippingRange();
    MesoCapture(this->Scene, this->Pass);
    MesoCheckEveryPixel(this->Pass);
  }

  /// Where the quadric of a round base of radius R has its outline with the surface at a depth d
  /// below it: a ray at the angle a to the normal gets R / (2 tan^2 a) deep before it comes back.
  static double ModelRadius(double depth) { return Radius / std::sqrt(1. + 2. * depth / Radius); }

  static double ScreenX(int column) { return (column + 0.5) * Pixel - HalfHeight; }

  /// Half the width that is covered in the middle of the screen, to within half a pixel.
  double HalfWidth() const
  {
    int covered = 0;
    for (int column = 0; column < Size; ++column)
    {
      covered += this->Pass->GetValue("coverage", column, Size / 2) > 0.f ? 1 : 0;
    }
    return 0.5 * covered * Pixel;
  }

  /// A cylinder of radius 1 whose texture is turned against it, with frames from the texture.
  static vtkSmartPointer<vtkPolyData> Cylinder(double degrees)
  {
    const auto shape = MesoTestScene::Shape("cylinder",
      { { "radius", { Radius } }, { "height", { 3. } }, { "sides", { 128. } },
        { "rings", { 32. } } });
    vtkNew<vtkDoubleArray> coordinates;
    coordinates->SetName("TextureCoordinates");
    coordinates->SetNumberOfComponents(2);
    const double turn = degrees * Pi / 180.;
    for (vtkIdType i = 0; i < shape->GetNumberOfPoints(); ++i)
    {
      double uv[2];
      shape->GetPointData()->GetTCoords()->GetTuple(i, uv);
      const double around = 2. * Pi * Radius * uv[0];
      const double along = 3. * uv[1];
      coordinates->InsertNextTuple2(std::cos(turn) * around + std::sin(turn) * along,
        -std::sin(turn) * around + std::cos(turn) * along);
    }
    vtkNew<vtkPolyData> bare;
    bare->SetPoints(shape->GetPoints());
    bare->SetPolys(shape->GetPolys());
    bare->GetPointData()->SetTCoords(coordinates);
    vtkNew<vtkMesoSurfaceFrames> frames;
    frames->SetInputData(bare);
    frames->Update();
    return frames->GetOutput();
  }
};

vtkSmartPointer<vtkPolyData> Sphere()
{
  return MesoTestScene::Shape("sphere", { { "rings", { 96. } }, { "sides", { 192. } } });
}
}

TEST_F(ReliefQuadricOutline, OfASphereIsTheModels)
{
  for (double depth : { 0.02, 0.05, 0.1 })
  {
    this->Draw(Sphere(), depth);
    const auto coverage = this->Pass->GetChannel("coverage");
    const double radius =
      std::sqrt(std::count(coverage.begin(), coverage.end(), 1.f) * Pixel * Pixel / Pi);
    EXPECT_NEAR(radius, ModelRadius(depth), 0.2 * Pixel) << depth;
    // The model is the truth but for 3/2 d^2 / R.
    EXPECT_LT(std::abs(radius - (Radius - depth)), 1.6 * depth * depth + 0.2 * Pixel) << depth;
  }
}

TEST_F(ReliefQuadricOutline, IsTheMeshsWithoutTheEffect)
{
  MesoMesostructureOptions options = this->Mapper->GetOptions();
  options.Technique = MesoTechnique::ReliefQuadric;
  options.Effects.Auto = false;
  options.Effects.Named =
    MesoEffectsOfTechnique(MesoTechnique::ReliefQuadric).Without({ MesoEffect::Silhouette });
  this->Mapper->SetOptions(options);
  this->Draw(Sphere(), 0.1);
  const auto coverage = this->Pass->GetChannel("coverage");
  const double radius =
    std::sqrt(std::count(coverage.begin(), coverage.end(), 1.f) * Pixel * Pixel / Pi);
  EXPECT_NEAR(radius, Radius, 0.2 * Pixel);
}

TEST_F(ReliefQuadricOutline, OfACylinderInAnyChart)
{
  for (double degrees : { 0., 90., 45., -30. })
  {
    this->Draw(Cylinder(degrees), 0.1);
    EXPECT_NEAR(this->HalfWidth(), ModelRadius(0.1), Pixel) << degrees;
  }
}

TEST_F(ReliefQuadricOutline, OfADiagonalQuadricNeedsAChartAlongTheCurvature)
{
  const auto halfWidth = [this](double degrees)
  {
    vtkNew<vtkMesoQuadricFit> fit; // as the paper has it
    fit->FullOff();
    fit->SlopesOff();
    fit->SetRings(1);
    fit->NormalEquationsOn();
    fit->SetInputData(Cylinder(degrees));
    fit->Update();
    this->Mapper->SetInputData(fit->GetOutput());
    this->Mapper->SetScale(0.2);
    this->Scene.Renderer->ResetCameraClippingRange();
    MesoCapture(this->Scene, this->Pass);
    return this->HalfWidth();
  };
  MesoMesostructureOptions options = this->Mapper->GetOptions();
  options.Technique = MesoTechnique::ReliefQuadric;
  this->Mapper->SetOptions(options);
  EXPECT_NEAR(halfWidth(0.), ModelRadius(0.1), Pixel);
  // At 45 degrees it is c alone that tells the direction around the cylinder from the one along it:
  // without it the cylinder comes out too little curved, and too wide.
  EXPECT_GT(halfWidth(45.), ModelRadius(0.1) + 3. * Pixel);
}

TEST_F(ReliefQuadricOutline, DepthAndNormalAreThoseOfTheInnerSphere)
{
  const double depth = 0.05;
  const double inner = Radius - depth;
  this->Draw(Sphere(), depth);
  std::vector<double> depths;
  std::vector<double> fromModel;
  std::vector<double> angles;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      const double x = ScreenX(column);
      const double y = -ScreenX(row);
      const double fromAxis = std::hypot(x, y);
      if (fromAxis > 0.95 * inner)
      {
        continue;
      }
      const auto value = [&](const char* channel)
      { return double(this->Pass->GetValue(channel, column, row)); };
      ASSERT_EQ(value("coverage"), 1.);
      ASSERT_NEAR(value("relief"), 0.5, 1e-4);
      const double z = std::sqrt(inner * inner - fromAxis * fromAxis);
      depths.push_back(std::abs(value("depth") - (5. - z)));
      // The model's ray is c t - s^2 t^2 / 2 R deep, with c and s of its angle to the normal.
      const double cosine2 = Radius * Radius - fromAxis * fromAxis;
      const double slope = std::sqrt(cosine2);
      const double travelled =
        2. * depth / (slope + std::sqrt(cosine2 - 2. * depth * fromAxis * fromAxis));
      fromModel.push_back(std::abs(value("depth") - (5. - slope + travelled)));
      const double cosine =
        (x * value("normal.x") + y * value("normal.y") + z * value("normal.z")) / inner;
      angles.push_back(std::acos(std::min(1., cosine)) * 180. / Pi);
    }
  }
  std::sort(depths.begin(), depths.end());
  std::sort(fromModel.begin(), fromModel.end());
  std::sort(angles.begin(), angles.end());
  const auto at = [](const std::vector<double>& values, double part)
  { return values[std::size_t(part * double(values.size() - 1))]; };
  // The model's own error grows as (d / R)^2 tan^4 of the view's angle: at .95 R it is half of d.
  EXPECT_LT(at(fromModel, 0.5), 3e-4);
  EXPECT_LT(at(fromModel, 0.95), 3e-3);
  EXPECT_LT(at(depths, 0.5), 0.002);
  EXPECT_LT(at(depths, 0.95), 0.3 * depth);
  EXPECT_LT(at(angles, 0.5), 0.5);
  EXPECT_LT(at(angles, 0.95), 4.);
}

TEST_F(ReliefQuadricOutline, ASphereShadesItselfOnlyWhereItFacesAway)
{
  this->Draw(Sphere(), 0.05);
  // The light comes from (1, 0, 1/2).
  const double length = std::sqrt(1.25);
  int wrong = 0;
  int lit = 0;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      const auto value = [&](const char* channel)
      { return double(this->Pass->GetValue(channel, column, row)); };
      const double facing = (value("normal.x") + 0.5 * value("normal.z")) / length;
      if (value("coverage") == 0. || std::abs(facing) < 0.01)
      {
        continue;
      }
      lit += value("shadow.0") == 0. ? 1 : 0;
      wrong += (value("shadow.0") > 0.) != (facing < 0.) ? 1 : 0;
    }
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(lit, 5000);
}
