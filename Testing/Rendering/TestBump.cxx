// Bump mapping: normals in closed form on any chart, filtered heights where texels are smaller than
// pixels, and the null cases.

#include "MesoBaseline.h"
#include "MesoChartPlane.h"
#include "MesoExpectedMessages.h"

#include "vtkMesoBumpMapper.h"

#include "vtkMatrix4x4.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace
{
const double Pi = std::acos(-1.);

/// A cosine hill that repeats, higher along u than along v.
double Hill(double u, double v)
{
  return 0.5 + 0.3 * std::cos(2. * Pi * u) + 0.2 * std::cos(4. * Pi * v);
}

class BumpOnChart : public testing::TestWithParam<MesoChart>
{
};

class BumpNullCases : public testing::Test
{
protected:
  MesoTestScene Scene;
  vtkNew<vtkMesoPolyDataMapper> Plain;
  vtkNew<vtkMesoBumpMapper> Bump;

  void SetUp() override
  {
    const auto torus = MesoTestScene::Shape("torus");
    this->Plain->SetInputData(torus);
    this->Bump->SetInputData(torus);
    this->Bump->SetHeightMap(MesoTestScene::Pattern("brick"));
    this->Bump->SetScale(0.1);
    this->Bump->SetTiles(6., 3.);
    this->Scene.AddDirectionalLight(-1., -2., -1.);
    this->Scene.AddHeadlight();
    this->Scene.Actor->GetProperty()->SetSpecular(0.3);
    this->Scene.LookFrom(1., 3., 5.);
  }

  MesoImageDifference Compare(const MesoImageLimits& limits)
  {
    this->Scene.Actor->SetMapper(this->Plain);
    const auto plain = MesoGrabWindow(this->Scene.Window);
    this->Scene.Actor->SetMapper(this->Bump);
    return MesoCompareImages(MesoGrabWindow(this->Scene.Window), plain, limits);
  }
};

/// Mean of a picture's red channel.
double Brightness(vtkImageData* picture)
{
  const auto* bytes = static_cast<const unsigned char*>(picture->GetScalarPointer());
  const int components = picture->GetNumberOfScalarComponents();
  const vtkIdType pixels = picture->GetNumberOfPoints();
  double sum = 0.;
  for (vtkIdType i = 0; i < pixels; ++i)
  {
    sum += bytes[i * components];
  }
  return sum / static_cast<double>(pixels);
}
}

TEST_P(BumpOnChart, GivesTheNormalOfTheHeightField)
{
  const MesoChart chart = GetParam();
  constexpr double depth = 0.1;
  for (const std::array<double, 2> tiles : { std::array<double, 2>{ 1., 1. }, { 3., 2. } })
  {
    MesoChartPlane plane;
    vtkNew<vtkMesoBumpMapper> mapper;
    mapper->SetInputData(MesoChartMesh(chart));
    mapper->SetHeightMap(MesoHeightsOf(128, 128, Hill));
    mapper->SetScale(depth);
    mapper->SetTiles(tiles[0], tiles[1]);
    plane.Actor->SetMapper(mapper);
    plane.Capture();
    double worst = 0.;
    double steepest = 0.;
    const int covered = plane.ForEachPixel(
      [&](int column, int row)
      {
        const double u = plane.Pass->GetValue("texcoord.u", column, row);
        const double v = plane.Pass->GetValue("texcoord.v", column, row);
        const double slopeU = -tiles[0] * 0.6 * Pi * std::sin(2. * Pi * u);
        const double slopeV = -tiles[1] * 0.8 * Pi * std::sin(4. * Pi * v);
        const auto expected = chart.Normal(slopeU, slopeV, depth);
        worst = std::max(worst, MesoDegreesBetween(plane.NormalAt(column, row), expected));
        steepest = std::max(steepest, MesoDegreesBetween(expected, { 0., 0., 1. }));
        EXPECT_NEAR(plane.Pass->GetValue("relief", column, row), 1. - Hill(u, v), 2e-3);
        EXPECT_NEAR(plane.Pass->GetValue("depth", column, row), 3., 1e-5); // nothing moves
      });
    EXPECT_GT(covered, 1500);
    EXPECT_GT(steepest, 15.);
    // Differences over 1/128 of a cosine of 2 periods, interpolated: a part of at most
    // (2 pi 2 / 128)^2 (1/6 + 1/8) of the slope.
    EXPECT_LT(worst, 0.09) << "tiles " << tiles[0] << " " << tiles[1];
  }
}

TEST_P(BumpOnChart, GivesTheNormalUnderAStretchedAndMirroredNode)
{
  // The chart's matrix as the node's: the same points in the world, and the same depth.
  const MesoChart chart = GetParam();
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 0, chart.A);
  matrix->SetElement(0, 1, chart.B);
  matrix->SetElement(1, 0, chart.C);
  matrix->SetElement(1, 1, chart.D);
  MesoChartPlane plane;
  vtkNew<vtkMesoBumpMapper> mapper;
  const MesoChart unit = { "", 1., 0., 0., 1. };
  // A mirror turns the triangles' winding, by which front and back are told.
  mapper->SetInputData(MesoChartMesh(unit, 1, chart.Determinant() < 0.));
  mapper->SetHeightMap(MesoHeightsOf(128, 128, Hill));
  mapper->SetScale(0.1);
  plane.Actor->SetMapper(mapper);
  plane.Actor->SetUserMatrix(matrix);
  plane.Capture();
  double worst = 0.;
  const int covered = plane.ForEachPixel(
    [&](int column, int row)
    {
      const double u = plane.Pass->GetValue("texcoord.u", column, row);
      const double v = plane.Pass->GetValue("texcoord.v", column, row);
      worst = std::max(worst,
        MesoDegreesBetween(plane.NormalAt(column, row),
          chart.Normal(-0.6 * Pi * std::sin(2. * Pi * u), -0.8 * Pi * std::sin(4. * Pi * v), 0.1)));
    });
  EXPECT_GT(covered, 1500);
  EXPECT_LT(worst, 0.09);
}

INSTANTIATE_TEST_SUITE_P(Charts, BumpOnChart, testing::ValuesIn(MesoCharts),
  [](const testing::TestParamInfo<MesoChart>& info) { return std::string(info.param.Name); });

TEST(Bump, FiltersHeightsThatAreFinerThanPixels)
{
  // 64 tiles of a cosine over 50 pixels: what can be seen of it is the mean of its shading, which for
  // small slopes is that of the plane. Unfiltered slopes alias into stripes.
  MesoChartPlane plane(50);
  plane.AddDirectionalLight(1., 0., -1.);
  vtkNew<vtkMesoBumpMapper> mapper;
  mapper->SetInputData(MesoChartMesh(MesoCharts[0]));
  mapper->SetHeightMap(
    MesoHeightsOf(32, 32, [](double u, double) { return 0.5 + 0.5 * std::cos(2. * Pi * u); }));
  mapper->SetTiles(79., 79.);
  mapper->SetScale(0.002);
  plane.Actor->SetMapper(mapper);
  const auto bumped = MesoGrabWindow(plane.Window);
  mapper->SetScale(0.);
  const auto flat = MesoGrabWindow(plane.Window);
  const auto difference = MesoCompareImages(bumped, flat, { 8, 0., 16, 0. });
  EXPECT_TRUE(difference.Within) << difference.Describe();
  EXPECT_NEAR(Brightness(bumped), Brightness(flat), 1.);
  EXPECT_GT(Brightness(flat), 50.);
}

TEST_F(BumpNullCases, BumpIsSeenAtAll)
{
  EXPECT_FALSE(this->Compare({}).Within);
}

TEST_F(BumpNullCases, ZeroScale)
{
  this->Bump->SetScale(0.);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_F(BumpNullCases, AnyConstantMap)
{
  this->Bump->SetHeightMap(MesoTestScene::Constant(0.3f));
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_F(BumpNullCases, NoHeightMap)
{
  this->Bump->SetHeightMap(nullptr);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_F(BumpNullCases, NoEffects)
{
  MesoMesostructureOptions options = this->Bump->GetOptions();
  options.Effects.Auto = false;
  this->Bump->SetOptions(options);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_F(BumpNullCases, SeenFromBehind)
{
  const auto plane = MesoTestScene::Shape("plane");
  this->Plain->SetInputData(plane);
  this->Bump->SetInputData(plane);
  this->Scene.Actor->GetProperty()->BackfaceCullingOff();
  this->Scene.LookFrom(0.5, 0.4, -2.);
  this->Scene.AddDirectionalLight(0.3, 0.2, 1.);
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_F(BumpNullCases, MissingFramesAreSaidOnce)
{
  this->Bump->GetInput()->GetPointData()->RemoveArray("MesoTangent");
  MesoExpectedMessages expected("lacks MesoTangent");
  const auto difference = this->Compare(MesoImageLimits::Exact());
  EXPECT_TRUE(difference.Within) << difference.Describe();
  this->Scene.Window->Render();
  EXPECT_EQ(expected.GetCount(), 1);
}

TEST_F(BumpNullCases, NothingMovesNeitherDoBounds)
{
  double plain[6];
  double bump[6];
  this->Plain->GetBounds(plain);
  this->Bump->GetBounds(bump);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(bump[i], plain[i]);
  }
}
