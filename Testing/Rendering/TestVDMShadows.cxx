// Light that tables of view-dependent displacements let through and block.

#include "MesoTestVDM.h"
#include "VDMPlane.h"
#include "vtkMesoVDMMapper.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkLightCollection.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Size = 32;

/// Pixels in which one capture of a plane has shadow and another has none.
struct Differences
{
  int Darker = 0;  ///< blocked by the table alone
  int Lighter = 0; ///< blocked by the search alone
  int Shadows = 0; ///< blocked by the search
};

/// Light on a plane of a map by a table of few azimuths, beside a certified search's: so many degrees off the
/// normal, on a relief of so many tiles.
Differences OnAPlane(const char* pattern, double degrees, double depth)
{
  const auto heights = MesoTestScene::Pattern(pattern, Size, Size);
  const auto relief = CertifiedRelief(heights);
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(heights);
  MesoVDMLayout layout;
  layout.Width = layout.Height = Size;
  layout.Azimuths = 12;
  layout.Curvatures = 1;
  layout.FirstCurvature = layout.LastCurvature = 0.;
  layout.Depth = depth;
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(heights);
  filter->SetLayout(layout);
  filter->SetRanks(0, 0);
  filter->Update();
  vdm->SetTable(filter->GetOutput());
  VDMPlane plane(0., 0.7); // both meet the same points
  vtkLight* light = vtkLight::SafeDownCast(plane.Renderer->GetLights()->GetItemAsObject(0));
  light->SetPosition(-0.5, -0.7, std::hypot(0.5, 0.7) / std::tan(degrees * VDMPlane::Degree));
  plane.Capture(relief, depth / 2.);
  const std::vector<float> searched = plane.Values("shadow.0");
  plane.Capture(vdm, depth / 2.);
  const std::vector<float> looked = plane.Values("shadow.0");
  Differences differences;
  for (std::size_t i = 0; i < looked.size(); ++i)
  {
    differences.Darker += looked[i] > searched[i] ? 1 : 0;
    differences.Lighter += looked[i] < searched[i] ? 1 : 0;
    differences.Shadows += searched[i] > 0. ? 1 : 0;
  }
  return differences;
}
}

TEST(VDMShadows, TolerateWhatIsLostBetweenAnglesAndNoMore)
{
  // Of 10 000 pixels. A smooth map under flat light would be dotted with shadows without what interpolation
  // between angles is off by.
  const Differences smooth = OnAPlane("smooth", 70., 0.1);
  EXPECT_LT(smooth.Darker, 30);
  EXPECT_LT(smooth.Lighter, 10);
  // Bricks' shadows begin behind their edges, and are not to be taken for errors.
  const Differences brick = OnAPlane("brick", 40., 0.3);
  EXPECT_GT(brick.Shadows, 3000);
  EXPECT_LT(brick.Darker, 200);
  EXPECT_LT(brick.Lighter, 900);
}

TEST(VDMShadows, LightLeavesInTheFrameBelowTheHit)
{
  // A level blocks no light that its facets look to, in valleys neither: where the base has turned since the
  // pixel, the light's way out has as well.
  const auto level = MesoTestScene::Constant(0.25f);
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(level);
  vdm->SetTable(MesoSmallVDM(level, 0.3));
  vdm->SetInputData(
    MesoTestScene::Prepared(MesoTestScene::Shape("undulating"), MesoTechnique::VDM));
  vdm->SetTiles(4., 4.);
  vdm->SetScale(0.3);
  MesoTestScene scene(100, 100);
  vtkNew<vtkMesoAOVPass> pass;
  scene.Actor->SetMapper(vdm);
  scene.AddDirectionalLight(-1., -0.5, 0.);
  scene.LookFrom(3., 1.5, 3.);
  MesoCapture(scene, pass);
  const auto shadow = pass->GetChannel("shadow.0");
  const auto x = pass->GetChannel("normal.x");
  const auto y = pass->GetChannel("normal.y");
  int facing = 0;
  int blocked = 0;
  for (std::size_t i = 0; i < shadow.size(); ++i)
  {
    const bool faces = x[i] + 0.5 * y[i] > 0.05;
    facing += faces ? 1 : 0;
    blocked += faces && shadow[i] > 0.f ? 1 : 0;
  }
  EXPECT_GT(facing, 2000);
  EXPECT_LT(blocked, 10);
  pass->ReleaseGraphicsResources(scene.Window);
}

TEST(VDMShadows, TolerateTheErrorOfTheFactorsInUse)
{
  const auto heights = MesoTestScene::Pattern("brick");
  vtkNew<vtkMesoVDMMapper> vdm;
  vdm->SetHeightMap(heights);
  VDMPlane plane(40., 0.7);
  // The part of the picture that is blocked where the table says that one rank's error is large, and others' not.
  const auto blocked = [&](int large)
  {
    const auto table = MesoSmallVDM(heights, 0.2, 8);
    vtkDataArray* errors = table->GetFieldData()->GetArray("Errors");
    for (vtkIdType i = 0; i < errors->GetNumberOfTuples(); ++i)
    {
      errors->SetTuple1(i, i + 1 == large ? 10. : 1e-6);
    }
    errors->Modified();
    vdm->SetTable(table);
    MesoMesostructureOptions options = vdm->GetOptions();
    options.Rank = { 6, 4 };
    vdm->SetOptions(options);
    plane.Capture(vdm);
    const std::vector<float> shadow = plane.Values("shadow.0");
    return double(std::count(shadow.begin(), shadow.end(), 1.f)) / double(shadow.size());
  };
  const double exact = blocked(0);
  EXPECT_GT(exact, 0.05);
  EXPECT_LT(exact, 0.5);
  EXPECT_EQ(blocked(5), exact);
  EXPECT_EQ(blocked(7), exact);
  EXPECT_LT(blocked(6), 0.5 * exact); // facets that face away are left
}
