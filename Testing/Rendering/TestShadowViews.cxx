// Depth and shadows between objects in the cases that are easily got wrong, against the truth.

#include "MesoBaseline.h"
#include "MesoImageDifference.h"
#include "ShadowComparison.h"
#include "vtkMesoPolyDataMapper.h"

#include "vtkCameraPass.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"

#include <cmath>

namespace
{
std::string Scene(const std::string& camera, const std::string& light, const std::string& nodes)
{
  return R"("camera": {)" + camera + R"(}, "lights": [)" + light + R"(], "nodes": [)" + nodes + "]";
}

/// A sheet of relief that lies flat, 4 by 4, facing up.
std::string Sheet(const char* technique, const char* place = "[0, 0, 0]")
{
  return std::string(R"({"transform": {"rotate": [-90, 1, 0, 0], "translate": )") + place +
    R"(}, "mesh": {"shape": "plane", "size": [4, 4]}, "mesostructure": {"technique": ")" +
    technique + R"(", "scale": 0.1, "tiles": [2, 2], "quality": "high",
      "height_map": {"pattern": "smooth", "size": [128, 128]}}})";
}

const char* const Ball = R"({"transform": {"translate": [0, 0.9, 0]},
  "mesh": {"shape": "sphere", "radius": 0.5, "rings": 64, "sides": 128}})";

const char* const FromAbove =
  R"("position": [-0.5, 3.2, 5], "focal_point": [0.2, 0.3, 0], "view_angle": 38)";
}

TEST(DepthBetweenObjects, CoincidentCylindersShowWhichIsNearer)
{
  const auto cylinder = [](const char* pattern, double scale)
  {
    return R"({"mesh": {"shape": "cylinder", "radius": 0.8, "height": 4, "sides": 96},
      "mesostructure": {"technique": "relief-quadric", "scale": )" +
      std::to_string(scale) + R"(, "tiles": [3, 3], "quality": "high",
        "height_map": {"pattern": ")" +
      pattern + R"(", "size": [256, 256]}}})";
  };
  ShadowComparison scene(
    Scene(R"("position": [0.3, 0.5, 4.4], "focal_point": [0, 0, 0], "view_angle": 26)",
      R"({"type": "directional", "direction": [0.7, -0.7, -0.9]})",
      cylinder("brick", 0.12) + "," + cylinder("smooth", 0.16)),
    200, 200);
  const std::vector<float> truth = ChannelOf(scene.Truth.AOVs, "object");
  const std::vector<float> drawn = scene.Drawn.Pass->GetChannel("object");
  for (const float object : { 1.f, 2.f })
  {
    const auto trues = double(std::count(truth.begin(), truth.end(), object));
    const auto shown = double(std::count(drawn.begin(), drawn.end(), object));
    EXPECT_GT(trues, 2000.);
    EXPECT_NEAR(shown / trues, 1., 0.02) << "object " << object;
  }
}

TEST(ShadowViews, LightFromBehindASheetIsKeptOffByIt)
{
  for (const char* technique : { "plain", "relief", "relief-quadric" })
  {
    ShadowComparison scene(
      Scene(FromAbove, R"({"type": "directional", "direction": [0.15, 1, 0.1]})",
        Sheet(technique) + "," + Ball),
      160, 160);
    const ShadowCount onBall = scene.Count(2);
    EXPECT_GT(onBall.Pixels, 1000);
    EXPECT_EQ(onBall.Missing, 0) << technique << ": " << onBall;
    EXPECT_EQ(scene.Count(1).Missing, 0) << technique;
  }
}

TEST(ShadowViews, GrazingLightDrawsLongShadows)
{
  ShadowComparison scene(
    Scene(FromAbove, R"({"type": "directional", "direction": [1, -0.16, 0.1]})",
      Sheet("relief") + R"(, {"transform": {"translate": [-1.2, 0.3, 0]},
        "mesh": {"shape": "sphere", "radius": 0.25, "rings": 64, "sides": 128}})"),
    200, 200);
  const ShadowCount onSheet = scene.Count(1);
  EXPECT_GT(onSheet.Both, 1000) << onSheet;
  EXPECT_GT(onSheet.Iou(), 0.9) << onSheet;
}

TEST(ShadowViews, CameraAndLightAmongTheObjects)
{
  // Eye and point light between two sheets, close to a ball: nothing is seen from outside.
  ShadowComparison scene(
    Scene(R"("position": [-1.2, 0.8, 1.1], "focal_point": [0.2, 0.5, 0], "view_angle": 70)",
      R"({"type": "point", "position": [-0.9, 1.5, 0.8]})",
      Sheet("relief") + "," + Ball +
        R"(, {"transform": {"rotate": [90, 1, 0, 0], "translate": [0, 2.2, 0]},
          "mesh": {"shape": "plane", "size": [4, 4]}})"),
    200, 120);
  EXPECT_EQ(scene.Drawn.Shadows()->GetNumberOfMaps(), 6);
  EXPECT_GT(scene.Count(1).Iou(), 0.93) << scene.Count(1);
  // Nothing lies between the light and the sheet above it.
  const ShadowCount above = scene.Count(3);
  EXPECT_GT(above.Pixels, 300);
  EXPECT_EQ(above.Both + above.Missing + above.Extra, 0) << above;
}

TEST(ShadowViews, VTKsPassesSeeTheDetail)
{
  // The surface lies up to D below its mesh: a map that held the mesh would put it into the mesh's
  // shadow, most where it is deepest.
  const std::string text =
    Scene(FromAbove, R"({"type": "directional", "direction": [0.3, -1, 0.2], "shadow": false})",
      R"({"transform": {"rotate": [-90, 1, 0, 0]}, "mesh": {"shape": "plane", "size": [4, 4]},
      "mesostructure": {"technique": "relief", "scale": 0.4,
        "height_map": {"pattern": "smooth", "size": [128, 128], "frequency": 1}}})");
  DrawnScene scene(ShadowSceneOf(text), 120, 120);
  const auto bare = MesoGrabWindow(scene.Window);
  vtkCollectionSimpleIterator cursor;
  scene.Renderer->GetLights()->InitTraversal(cursor);
  scene.Renderer->GetLights()->GetNextLight(cursor)->SetShadowAttenuation(1.f);
  vtkNew<vtkShadowMapPass> shadows;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  scene.Renderer->SetPass(camera);
  const auto shadowed = MesoGrabWindow(scene.Window);
  camera->ReleaseGraphicsResources(scene.Window);
  scene.Renderer->SetPass(nullptr);
  EXPECT_TRUE(scene.Builder.GetObjects()[0].Mapper->GetWhyPlain().empty());
  const auto difference = MesoCompareImages(shadowed, bare);
  // Of 14400; VTK's maps are blurred by their bilinear exponentials where the relief is steep.
  EXPECT_LT(difference.LargePixels, 1500) << "the surface lies in its own shadow";
}

TEST(ShadowViews, ARoomOfRelief)
{
  const MesoScene room = MesoReadScene(MESO_SCENES "/room.json");
  ShadowComparison scene(room, room, 150, 112);
  EXPECT_EQ(scene.Drawn.Shadows()->GetNumberOfMaps(), 2);
  const ShadowCount columnOnWall = scene.Count(3, 0);
  EXPECT_GT(columnOnWall.Both, 50) << columnOnWall;
  EXPECT_GT(columnOnWall.Iou(), 0.8) << columnOnWall;
  const ShadowCount ringOnFloor = scene.Count(1, 1);
  EXPECT_GT(ringOnFloor.Both, 100) << ringOnFloor;
  EXPECT_GT(ringOnFloor.Iou(), 0.93) << ringOnFloor;
}
