// Clipping planes cut the relief that is seen, not the base mesh above it.

#include "MesoAOVChecks.h"
#include "MesoTiltedPlane.h"

#include "MesoReference.h"
#include "MesoSceneBuilder.h"

#include "vtkPlane.h"

namespace
{
constexpr int Size = 90;

void Cut(vtkMesoReliefMapper* mapper, double x, double y, double z, double nx, double ny, double nz)
{
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(x, y, z);
  plane->SetNormal(nx, ny, nz);
  mapper->AddClippingPlane(plane);
}
}

TEST(ClippingPlanes, CutWhereTheRayHits)
{
  // Constant height 1/4: the hit lies 3/4 of the travel aside from the base.
  MesoTiltedPlane scene(50., 0.2, MesoTestScene::Constant(0.25f), Size);
  scene.Capture();
  const auto before = scene.Pass->GetChannel("coverage");
  Cut(scene.Mapper, 0.05, 0., 0., 1., 0., 0.);
  Cut(scene.Mapper, 0., 0.1, 0., 0., -2., 0.);
  scene.Capture();
  int kept = 0;
  for (int row = 0; row < Size; ++row)
  {
    for (int column = 0; column < Size; ++column)
    {
      const double x = scene.EntryU(column) - 0.5 + 0.75 * scene.TravelU();
      const double y = scene.EntryV(row) - 0.5;
      if (std::abs(x - 0.05) < 1e-4 || std::abs(y - 0.1) < 1e-4)
      {
        continue;
      }
      const bool expected = before[std::size_t(row) * Size + column] > 0.f && x > 0.05 && y < 0.1;
      EXPECT_EQ(scene.Pass->GetValue("coverage", column, row), expected ? 1.f : 0.f)
        << column << " " << row;
      kept += expected ? 1 : 0;
    }
  }
  EXPECT_GT(kept, 500);
}

TEST(ClippingPlanes, ThroughTheCutTheRayGoesOnToWhatLiesBehind)
{
  // A ridge of height 1 for u in [1/4, 1/2] over ground of height 0, cut open along its middle.
  auto ridge = MesoTestScene::Pattern("step", 64, 1);
  for (int i = 0; i < 64; ++i)
  {
    ridge->SetScalarComponentFromFloat(i, 0, 0, 0, i >= 16 && i < 32 ? 1.f : 0.f);
  }
  MesoTiltedPlane scene(50., 0.3, ridge, Size);
  scene.Capture();
  std::vector<int> onTop; // columns that see the part of the ridge's top that goes
  for (int column = 0; column < Size; ++column)
  {
    const double u = scene.EntryU(column);
    if (u > 0.26 && u < 0.37)
    {
      EXPECT_NEAR(scene.Pass->GetValue("relief", column, 40), 0., 1e-6) << column;
      onTop.push_back(column);
    }
  }
  ASSERT_GT(onTop.size(), 8u);
  Cut(scene.Mapper, -0.125, 0., 0., 1., 0., 0.);
  scene.Capture();
  for (const int column : onTop)
  {
    // The ray comes in below the surface, leaves the ridge at its far wall unseen, meets the ground.
    EXPECT_EQ(scene.Pass->GetValue("coverage", column, 40), 1.f) << column;
    EXPECT_NEAR(scene.Pass->GetValue("relief", column, 40), 1., 1e-6) << column;
    EXPECT_NEAR(
      scene.Pass->GetValue("texcoord.u", column, 40), scene.EntryU(column) + scene.TravelU(), 1e-5)
      << column;
  }
}

TEST(ClippingPlanes, WhatIsCutAwayCastsNoShadow)
{
  // The same kind of ridge, seen from above, in light from its side: 0.3 of ground beside it are dark.
  auto ridge = MesoTestScene::Pattern("step", 64, 1);
  for (int i = 0; i < 64; ++i)
  {
    ridge->SetScalarComponentFromFloat(i, 0, 0, 0, i >= 16 && i < 32 ? 1.f : 0.f);
  }
  MesoTiltedPlane scene(0., 0.3, ridge, Size);
  scene.AddDirectionalLight(1., 0., -1.);
  const auto expectShadow = [&](float expected)
  {
    scene.Capture();
    int pixels = 0;
    for (int column = 0; column < Size; ++column)
    {
      const double u = scene.EntryU(column);
      if (u > 0.54 && u < 0.76)
      {
        EXPECT_NEAR(scene.Pass->GetValue("relief", column, 40), 1., 1e-6) << u;
        EXPECT_EQ(scene.Pass->GetValue("shadow.0", column, 40), expected) << u;
        ++pixels;
      }
    }
    EXPECT_GT(pixels, 20);
  };
  expectShadow(1.f);
  Cut(scene.Mapper, 0.02, 0., 0., 1., 0., 0.); // all of the ridge is gone
  expectShadow(0.f);
}

TEST(ClippingPlanes, OfASceneCutTheReferenceAndTheTechniqueAlike)
{
  const std::string text = R"({ "meso": 1,
    "camera": {"position": [0.4, -1.6, 1.3], "view_angle": 40},
    "lights": [{"type": "directional", "direction": [-1, 1, -1]}],
    "clipping_planes": [[[0.1, 0, 0], [-1, 0.3, 0.2]], [[0, -0.2, 0], [0, 2, 1]],
      [[-0.5, 0, 0], [1, 0, 0]], [[0, 0.5, 0], [0, -1, 0.3]]],
    "nodes": [{"mesh": {"shape": "plane", "size": [4, 4]},
      "mesostructure": {"technique": "relief", "quality": "high", "scale": 0.25, "tiles": [3, 3],
        "height_map": {"pattern": "smooth", "size": [64, 64]}}}] })";
  const MesoScene scene = MesoParseScene(text, "test.json");
  constexpr int size = 120;
  MesoTestScene drawn(size, size);
  drawn.Renderer->RemoveAllViewProps();
  MesoSceneBuilder builder;
  builder.Build(scene, drawn.Renderer);
  vtkNew<vtkMesoAOVPass> pass;
  MesoCapture(drawn, pass);
  MesoReference reference(scene);
  const MesoExrImage truth = reference.Render(size, size).AOVs;
  const auto place = [&](const char* channel)
  {
    const auto& names = truth.ChannelNames;
    return static_cast<std::size_t>(std::find(names.begin(), names.end(), channel) - names.begin());
  };
  int covered = 0;
  int uncovered = 0;
  int different = 0;
  int apart = 0;
  int shadowed = 0;
  for (int row = 0; row < size; ++row)
  {
    for (int column = 0; column < size; ++column)
    {
      const float* pixel =
        &truth.Data[truth.ChannelNames.size() * (std::size_t(row) * size + column)];
      const bool hit = pixel[place("coverage")] > 0.f;
      covered += hit ? 1 : 0;
      uncovered += hit ? 0 : 1;
      if (hit != (pass->GetValue("coverage", column, row) > 0.f))
      {
        ++different;
        continue;
      }
      const double depth = pass->GetValue("depth", column, row);
      apart += hit && std::abs(depth - pixel[place("depth")]) > 0.005 ? 1 : 0;
      shadowed +=
        hit && std::abs(pass->GetValue("shadow.0", column, row) - pixel[place("shadow.0")]) > 0.5f
        ? 1
        : 0;
    }
  }
  EXPECT_GT(covered, size * size / 16);
  EXPECT_GT(uncovered, size * size / 6);
  // A search by 128 steps misses a few rims by a step, and so do the shadows' edges.
  EXPECT_LT(different, covered / 100);
  EXPECT_LT(apart, covered / 100);
  EXPECT_LT(shadowed, covered / 25);
  pass->ReleaseGraphicsResources(drawn.Window);
}
