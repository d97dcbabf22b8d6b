// Shadows that objects cast on each other (vtkMesoShadowMapPass), against the ray traced truth.

#include "MesoBaseline.h"
#include "MesoImageDifference.h"
#include "ShadowComparison.h"

#include <cmath>
#include <ostream>

namespace
{
const char* const Floor = R"({"transform": {"rotate": [-90, 1, 0, 0]},
  "mesh": {"shape": "plane", "size": [6, 6]}})";

const char* const ReliefFloor = R"({"transform": {"rotate": [-90, 1, 0, 0]},
  "mesh": {"shape": "plane", "size": [6, 6]},
  "mesostructure": {"technique": "relief", "scale": 0.12, "tiles": [3, 3], "quality": "high",
    "height_map": {"pattern": "smooth", "size": [128, 128]}}})";

const char* const Ball = R"({"transform": {"translate": [0, 1.1, 0]},
  "mesh": {"shape": "sphere", "radius": 0.6, "rings": 96, "sides": 192}})";

/// Bumps deep enough for the column's shadow to show them, and its open end out of sight.
std::string Column(const char* technique = "relief-quadric")
{
  return std::string(R"({"transform": {"translate": [0, 4, 0]},
    "mesh": {"shape": "cylinder", "radius": 0.6, "height": 8, "sides": 96},
    "mesostructure": {"technique": ")") +
    technique + R"(", "scale": 0.12, "tiles": [3, 6], "quality": "high",
      "height_map": {"pattern": "smooth", "size": [128, 128], "frequency": 2}}})";
}

struct Case
{
  const char* Name;
  const char* Light;
  int Width;
  int Height;
};

void PrintTo(const Case& one, std::ostream* stream)
{
  *stream << one.Width << "x" << one.Height;
}

const char* const Directional = R"({"type": "directional", "direction": [0.8, -1, 0.35]})";
const char* const Spot = R"({"type": "spot", "position": [-2.8, 4, -1.5],
  "focal_point": [0.3, 0.6, 0.2], "cone_angle": 50})";
const char* const Point = R"({"type": "point", "position": [-2, 3.2, -1]})";

const Case Cases[] = { { "Directional", Directional, 200, 200 },
  { "DirectionalWide", Directional, 280, 140 }, { "DirectionalTall", Directional, 140, 280 },
  { "Spot", Spot, 200, 200 }, { "SpotWide", Spot, 280, 140 }, { "PointWide", Point, 280, 140 } };

class Shadows : public testing::TestWithParam<Case>
{
protected:
  static std::string SceneText(const std::string& nodes)
  {
    return R"("camera": {"position": [-1.2, 4.2, 5.5], "focal_point": [0.6, 0.4, 0.3],
      "view_angle": 40}, "lights": [)" +
      std::string(GetParam().Light) + R"(], "nodes": [)" + nodes + "]";
  }

  static ShadowComparison Compare(const std::string& nodes)
  {
    return { SceneText(nodes), GetParam().Width, GetParam().Height };
  }
};
}

TEST_P(Shadows, OfAReliefColumnOnAPlane)
{
  const ShadowComparison scene = Compare(std::string(Floor) + "," + Column());
  const ShadowCount onFloor = scene.Count(1);
  EXPECT_GT(onFloor.Both, 700) << onFloor;
  EXPECT_GT(onFloor.Iou(), 0.97) << onFloor;

  // The outline of the column's detail, not that of its mesh: that is worse by far.
  const ShadowComparison bare(ShadowSceneOf(SceneText(std::string(Floor) + "," + Column())),
    ShadowSceneOf(SceneText(std::string(Floor) + "," + Column("relief"))), GetParam().Width,
    GetParam().Height);
  EXPECT_LT(bare.Count(1).Iou(), onFloor.Iou() - 0.02) << bare.Count(1);
}

TEST_P(Shadows, OfAPlainBallOnRelief)
{
  const ShadowComparison scene = Compare(std::string(ReliefFloor) + "," + Ball);
  EXPECT_GT(scene.Count(1).Both, 700) << scene.Count(1);
  EXPECT_GT(scene.Count(1).Iou(), 0.96) << scene.Count(1);
}

TEST_P(Shadows, OfReliefOnRelief)
{
  const ShadowComparison scene = Compare(std::string(ReliefFloor) + "," + Column());
  EXPECT_GT(scene.Count(1).Both, 700) << scene.Count(1);
  EXPECT_GT(scene.Count(1).Iou(), 0.95) << scene.Count(1);
}

INSTANTIATE_TEST_SUITE_P(Lights, Shadows, testing::ValuesIn(Cases),
  [](const auto& info) { return std::string(info.param.Name); });
