// Displacement in the vertex stage beside the truth, from which it shares no code but the reading of the
// map: places, depths, outlines; normals with and without the base's curvature; heights both ways.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

std::string Torus(const std::string& options)
{
  return R"({"meso": 1, "camera": {"position": [0, 1.8, 3.2]},
    "lights": [{"type": "directional", "direction": [-1, -0.6, -0.5]}],
    "nodes": [{"mesh": {"shape": "torus", "rings": 32, "sides": 16},
    "transform": {"rotate": [20, 1, 0.3, 0], "scale": [-1, 1, 1]},
    "mesostructure": {"technique": "displacement", "facet_pixels": 0, "tiles": [6, 3], )" +
    options + "}}]}";
}

MesoGeometryError ErrorOf(const std::string& text, bool solid = true)
{
  const MesoScene scene = MesoParseScene(text, "test.json");
  const MesoAOVs truth = MesoAOVsOfImage(MesoReference(scene).Render(Width, Height).AOVs);
  const MesoGeometryError error = MesoCompareGeometry(truth, DrawnAOVs(scene, Width, Height));
  EXPECT_EQ(error.NanPixels, 0);
  if (solid)
  {
    EXPECT_EQ(error.HolePixels, 0);
  }
  return error;
}

const char* const Smooth =
  R"(, "height_map": {"pattern": "smooth", "size": [32, 32]}, "effects": ["shading", "occlusion",
     "depth", "silhouette")";
}

TEST(DisplacementAgainstReference, ErrorsFallWithTheQuality)
{
  double before = 1e9;
  for (const char* quality : { "draft", "low", "medium", "high" })
  {
    const MesoGeometryError error = ErrorOf(Torus(std::string(R"("scale": 0.1, "quality": ")") +
      quality + R"(", "height_map": {"pattern": "smooth", "size": [32, 32]})"));
    std::cout << quality << ": texcoord p95 " << error.Texcoord.P95 << ", depth p95 "
              << error.Depth.P95 << ", normal " << error.Normal.Mean << ", overlap "
              << error.CoverageIou << "\n";
    EXPECT_LT(error.Texcoord.P95, 0.6 * before) << quality;
    before = error.Texcoord.P95;
    EXPECT_GT(error.CoverageIou, 0.99) << quality;
  }
  EXPECT_LT(before, 0.05);
}

TEST(DisplacementAgainstReference, HeightsBothWaysLieWhereTheyBelong)
{
  for (const char* reference : { "0", "0.4", "1" })
  {
    const MesoGeometryError error =
      ErrorOf(Torus(std::string(R"("scale": 0.15, "quality": "high", "reference": )") + reference +
        Smooth + R"(, "curvature"])"));
    EXPECT_LT(error.Texcoord.P95, 0.05) << reference;
    EXPECT_LT(error.Depth.P95, 0.005) << reference;
    EXPECT_GT(error.CoverageIou, 0.998) << reference;
    EXPECT_LT(error.Normal.Mean, 0.5) << reference;
  }
}

TEST(DisplacementAgainstReference, CurvatureOfTheBaseMattersWhereReliefIsThick)
{
  // On a tube of radius 0.4 the term that Marschner2008 neglects grows with D over that.
  double withoutIt[2];
  int i = 0;
  for (const char* scale : { "0.02", "0.2" })
  {
    const std::string start =
      std::string(R"("quality": "high", "reference": 0, "scale": )") + scale;
    const MesoGeometryError with = ErrorOf(Torus(start + Smooth + R"(, "curvature"])"));
    const MesoGeometryError without = ErrorOf(Torus(start + Smooth + "]"));
    std::cout << "D " << scale << ": normals off by " << with.Normal.Mean << " degrees, without it "
              << without.Normal.Mean << "\n";
    EXPECT_LT(with.Normal.Mean, 0.7);
    withoutIt[i++] = without.Normal.Mean - with.Normal.Mean;
  }
  EXPECT_GT(withoutIt[0], 0.);
  EXPECT_LT(withoutIt[0], 0.5);
  EXPECT_GT(withoutIt[1], 3.);
}

TEST(DisplacementAgainstReference, HorizonsBringShadowsNearTheTruth)
{
  const auto brick = [](const char* effects)
  {
    return Torus(std::string(R"("scale": 0.06, "penumbra": 0,
      "height_map": {"pattern": "brick", "size": [64, 64]}, "effects": )") +
      effects);
  };
  const MesoGeometryError with = ErrorOf(brick("\"all\""));
  const MesoGeometryError without =
    ErrorOf(brick(R"(["shading", "occlusion", "depth", "silhouette", "curvature"])"));
  std::cout << "shadow_cast " << with.ShadowCast << ", without horizons " << without.ShadowCast
            << "\n";
  EXPECT_LT(with.ShadowCast, 0.6 * without.ShadowCast);
}
