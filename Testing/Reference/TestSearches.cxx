// What the mapper draws by each search, against the technique's own model, solved exactly apart from it.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoTechniqueModel.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

/// A plane of tiles half a unit wide, a tenth as deep, seen at an angle off its normal.
MesoScene Plane(double degrees, const std::string& map, const std::string& more)
{
  const double angle = degrees * std::acos(-1.) / 180.;
  return MesoParseScene("{\"meso\": 1, \"camera\": {\"position\": [0, " +
      std::to_string(-10. * std::sin(angle)) + ", " + std::to_string(10. * std::cos(angle)) +
      R"(], "focal_point": [0, 0, 0], "view_up": [0, 1, 0.01], "parallel_scale": 0.5},
    "lights": [{"type": "directional", "direction": [0.8, -0.7, -0.5]}],
    "nodes": [{"mesh": {"shape": "plane", "size": [2, 14]},
      "mesostructure": {"technique": "relief", "scale": 0.05, "tiles": [4, 28], "height_map": )" +
      map + more + "}}]}",
    "plane.json");
}

MesoScene Torus(const std::string& technique, const std::string& more)
{
  return MesoParseScene(R"({"meso": 1, "camera": {"position": [0, 2.2, 4]},
    "lights": [{"type": "directional", "direction": [-1, -0.6, -0.8]},
               {"type": "point", "position": [1.2, 1.5, 1.0], "intensity": 0.5}],
    "nodes": [{"mesh": {"shape": "torus", "rings": 48, "sides": 24},
      "mesostructure": {"technique": ")" +
      technique +
      R"(", "scale": 0.07, "tiles": [8, 3],
        "height_map": {"pattern": "brick", "size": [60, 44]})" +
      more + "}}]}",
    "torus.json");
}

MesoGeometryError ErrorOf(const MesoScene& scene)
{
  return MesoCompareGeometry(MesoAOVsOfImage(MesoTechniqueModel(scene).Render(Width, Height)),
    DrawnAOVs(scene, Width, Height));
}
}

class CertifiedOnAPlane : public testing::TestWithParam<double>
{
};

TEST_P(CertifiedOnAPlane, IsTheModel)
{
  // Among them what steps over: walls one texel wide, and noise as fine as texels.
  for (const char* map : { R"({"pattern": "brick", "size": [128, 128]})",
         R"({"pattern": "step", "size": [64, 64], "position": 0.03125})",
         R"({"pattern": "noise", "size": [64, 100], "frequency": 16})" })
  {
    for (const char* wrap : { "repeat", "mirror", "clamp" })
    {
      const MesoGeometryError error = ErrorOf(Plane(
        GetParam(), map, std::string(R"(, "quality": "certified", "wrap": ")") + wrap + "\""));
      EXPECT_EQ(error.CoverageIou, 1.) << map << wrap;
      EXPECT_LT(error.Texcoord.P99, 0.05) << map << wrap;
      EXPECT_LT(error.Depth.P99, 1e-3) << map << wrap;
      EXPECT_EQ(error.NanPixels, 0u) << map << wrap;
      // Facets edge-on to the light alone.
      EXPECT_LT(error.ShadowCast, 0.001) << map << wrap;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Angles, CertifiedOnAPlane, testing::Values(0., 45., 75., 85.),
  [](const testing::TestParamInfo<double>& info) { return std::to_string(int(info.param)); });

TEST(Searches, CertifiedIsTheModelOverQuadrics)
{
  for (const char* technique : { "relief", "relief-quadric" })
  {
    const MesoGeometryError error = ErrorOf(Torus(technique, R"(, "quality": "certified")"));
    EXPECT_GT(error.CoverageIou, 0.9995) << technique;
    EXPECT_LT(error.Texcoord.P99, 0.01) << technique;
    EXPECT_LT(error.ShadowCast, 0.001) << technique;
  }
}

TEST(Searches, EveryOneDrawsTheModelAtHighQuality)
{
  for (const char* technique : { "relief", "relief-quadric" })
  {
    for (const std::string& search : MesoSearchNames())
    {
      const MesoGeometryError error =
        ErrorOf(Torus(technique, R"(, "quality": "high", "search": ")" + search + "\""));
      EXPECT_LT(error.Texcoord.P95, 0.01) << technique << " " << search;
      EXPECT_LT(error.ShadowCast, 0.003) << technique << " " << search;
    }
  }
}

TEST(Searches, NoMoreStepsAreEverWorse)
{
  for (const std::string& search : MesoSearchNames())
  {
    double before = 0.;
    for (const char* quality : { "high", "medium", "low", "draft" })
    {
      const MesoGeometryError error =
        ErrorOf(Plane(75., R"({"pattern": "brick", "size": [64, 64]})",
          std::string(R"(, "search": ")") + search + R"(", "quality": ")" + quality + "\""));
      EXPECT_GE(error.Texcoord.P99 * 1.01, before) << search << " " << quality;
      before = error.Texcoord.P99;
    }
  }
}
