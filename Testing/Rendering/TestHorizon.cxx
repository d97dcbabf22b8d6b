// Horizon mapping: the shadow of a wall in closed form on any chart, its soft edge, other depths than the
// table's, and the null cases.

#include "MesoBaseline.h"
#include "MesoChartPlane.h"

#include "vtkMesoBumpMapper.h"
#include "vtkMesoHorizonMap.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Size = 64;
constexpr double Wall = 0.75; // where the wall begins along u; it is a texel's slope wide

vtkSmartPointer<vtkImageData> WallMap()
{
  return MesoHeightsOf(Size, Size, [](double u, double) { return u < Wall ? 0. : 1.; });
}

void Use(vtkMesoBumpMapper* mapper, vtkImageData* heights, double depth, double penumbra,
  double tableDepth = 0.2)
{
  vtkNew<vtkMesoHorizonMap> horizons;
  horizons->SetInputData(heights);
  horizons->SetAzimuths(32);
  horizons->SetScale(tableDepth);
  horizons->Update();
  MesoMesostructureOptions options;
  options.Technique = MesoTechnique::Horizon;
  options.Scale = depth;
  options.Penumbra = penumbra;
  mapper->SetOptions(options);
  mapper->SetHeightMap(heights);
  mapper->SetHorizonMap(horizons->GetOutput(), tableDepth);
}

class HorizonOnChart : public testing::TestWithParam<MesoChart>
{
};
}

TEST_P(HorizonOnChart, AWallsShadowIsAsLongAsTheLightIsLow)
{
  const MesoChart chart = GetParam();
  constexpr double depth = 0.15;
  // Way over the map towards the light: mostly along +u, so over the wall.
  for (const std::array<double, 2> towards :
    { std::array<double, 2>{ 1., 0. }, { 1., 0.7 }, { 0.8, -0.9 } })
  {
    const double x = chart.A * towards[0] + chart.B * towards[1];
    const double y = chart.C * towards[0] + chart.D * towards[1];
    constexpr double rise = 0.5; // in object units, over that way
    MesoChartPlane plane;
    plane.AddDirectionalLight(-x, -y, -rise);
    vtkNew<vtkMesoBumpMapper> mapper;
    mapper->SetInputData(MesoChartMesh(chart));
    Use(mapper, WallMap(), depth, 0.);
    plane.Actor->SetMapper(mapper);
    plane.Capture();
    // The wall's top is a texel's half behind its border; the ray from height 0 gets to D over this
    // part of u.
    const double top = Wall + 0.5 / Size;
    const double shadow = depth / rise * towards[0];
    int judged = 0;
    int wrong = 0;
    plane.ForEachPixel(
      [&](int column, int row)
      {
        const double u = plane.Pass->GetValue("texcoord.u", column, row);
        const double off = u - (top - shadow); // > 0: in the shadow
        if (u > 1. / Size && u < Wall - 1. / Size && std::abs(off) > 0.5 / Size)
        {
          ++judged;
          wrong += plane.Pass->GetValue("shadow.0", column, row) == (off > 0. ? 1.f : 0.f) ? 0 : 1;
        }
      });
    EXPECT_GT(judged, 800);
    EXPECT_EQ(wrong, 0) << towards[0] << " " << towards[1];
  }
}

INSTANTIATE_TEST_SUITE_P(Charts, HorizonOnChart, testing::ValuesIn(MesoCharts),
  [](const testing::TestParamInfo<MesoChart>& info) { return std::string(info.param.Name); });

TEST(Horizon, DoesNotDependOnTheTablesDepth)
{
  // Slopes are those of the map, whatever depth angles were measured over.
  const auto shadowsOf = [](double tableDepth)
  {
    MesoChartPlane plane;
    plane.AddDirectionalLight(-1., -0.4, -0.25);
    vtkNew<vtkMesoBumpMapper> mapper;
    mapper->SetInputData(MesoChartMesh(MesoCharts[0]));
    Use(mapper, MesoTestScene::Pattern("smooth"), 0.2, 0., tableDepth);
    plane.Actor->SetMapper(mapper);
    plane.Capture();
    std::vector<float> shadows;
    plane.ForEachPixel([&](int column, int row)
      { shadows.push_back(plane.Pass->GetValue("shadow.0", column, row)); });
    return shadows;
  };
  const auto a = shadowsOf(0.1);
  const auto b = shadowsOf(0.3);
  ASSERT_EQ(a.size(), b.size());
  std::size_t different = 0;
  std::size_t dark = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    different += a[i] == b[i] ? 0 : 1;
    dark += a[i] > 0.5f ? 1 : 0;
  }
  EXPECT_GT(dark, a.size() / 20);
  EXPECT_LT(different, a.size() / 50); // angles between texels and azimuths are interpolated
}

TEST(Horizon, TheEdgeFadesOverThePenumbra)
{
  MesoChartPlane plane;
  plane.AddDirectionalLight(-1., 0., -0.5);
  vtkNew<vtkMesoBumpMapper> mapper;
  mapper->SetInputData(MesoChartMesh(MesoCharts[0]));
  Use(mapper, WallMap(), 0.15, 6.);
  plane.Actor->SetMapper(mapper);
  plane.Capture();
  const double light = std::atan(0.5);
  const double radius = 3. * std::acos(-1.) / 180.;
  int fading = 0;
  plane.ForEachPixel(
    [&](int column, int row)
    {
      const double u = plane.Pass->GetValue("texcoord.u", column, row);
      const double shadow = plane.Pass->GetValue("shadow.0", column, row);
      if (u < 2. / Size || u > Wall - 2. / Size)
      {
        return;
      }
      const double horizon = std::atan(0.15 / (Wall + 0.5 / Size - u));
      if (std::abs(horizon - light) > radius * 1.05)
      {
        EXPECT_EQ(shadow, horizon > light ? 1. : 0.) << u;
      }
      else if (std::abs(horizon - light) < radius * 0.9)
      {
        ++fading;
        EXPECT_GT(shadow, 0.) << u;
        EXPECT_LT(shadow, 1.) << u;
        EXPECT_EQ(shadow > 0.52, horizon > light + 0.04 * radius || shadow > 0.52) << u;
      }
    });
  EXPECT_GT(fading, 100);
}

TEST(Horizon, WithoutReliefIsTheBaseMesh)
{
  MesoTestScene scene;
  const auto torus = MesoTestScene::Shape("torus");
  vtkNew<vtkMesoPolyDataMapper> plain;
  plain->SetInputData(torus);
  vtkNew<vtkMesoBumpMapper> mapper;
  mapper->SetInputData(torus);
  scene.AddDirectionalLight(-1., -2., -1.);
  scene.AddHeadlight();
  scene.Actor->GetProperty()->SetSpecular(0.3);
  scene.LookFrom(1., 3., 5.);
  scene.Actor->SetMapper(plain);
  const auto expected = MesoGrabWindow(scene.Window);
  scene.Actor->SetMapper(mapper);
  const auto same = [&]()
  {
    return MesoCompareImages(MesoGrabWindow(scene.Window), expected, MesoImageLimits::Exact())
      .Within;
  };
  Use(mapper, MesoTestScene::Constant(0.4f), 0.1, 2.);
  EXPECT_TRUE(same()) << "a flat map";
  Use(mapper, MesoTestScene::Pattern("brick"), 0., 2.);
  EXPECT_TRUE(same()) << "no depth";
  Use(mapper, MesoTestScene::Pattern("brick"), 0.1, 2.);
  EXPECT_FALSE(same());
  mapper->SetHeightMap(nullptr);
  EXPECT_TRUE(same()) << "no map";
}
