// The model of a technique, solved apart from it: where the model is the truth it is the reference's
// picture; and what the mapper draws differs from it by no more than its search and float allow, in
// hits, normals and shadows, less so with more steps.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"
#include "MesoTechniqueModel.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

std::string Torus(
  const std::string& technique, const std::string& map, const std::string& more = "")
{
  return R"({"meso": 1, "camera": {"position": [0, 2.2, 4]},
    "lights": [{"type": "directional", "direction": [-1, -0.6, -0.8]},
               {"type": "point", "position": [1.2, 1.5, 1.0], "intensity": 0.5}],
    "nodes": [{"transform": {"rotate": [20, 0.3, 1, 0.2], "scale": [1, 0.8, 1.1]},
      "mesh": {"shape": "torus", "rings": 48, "sides": 24}, "mesostructure": {"technique": ")" +
    technique + R"(", "scale": 0.07, "tiles": [8, 3], "height_map": {"pattern": ")" + map +
    R"(", "size": [64, 64]})" + more + "}}]}";
}

MesoAOVs ModelOf(const MesoScene& scene)
{
  return MesoAOVsOfImage(MesoTechniqueModel(scene).Render(Width, Height));
}
}

TEST(TechniqueModel, OfReliefOnAPlaneIsTheTruth)
{
  const MesoScene scene = MesoParseScene(
    R"({"meso": 1, "camera": {"position": [0.6, -0.8, 1], "view_angle": 20},
      "lights": [{"type": "directional", "direction": [0.8, -0.5, -1]},
                 {"type": "point", "position": [-0.5, 0.4, 0.6]}],
      "nodes": [{"mesh": {"shape": "plane", "size": [3, 3]},
        "mesostructure": {"technique": "relief", "scale": 0.04, "tiles": [4, 4],
                          "height_map": {"pattern": "brick", "size": [64, 64]}}}]})",
    "plane.json");
  const MesoAOVs truth = MesoAOVsOfImage(MesoReference(scene).Render(Width, Height).AOVs);
  const MesoGeometryError error = MesoCompareGeometry(truth, ModelOf(scene));
  EXPECT_EQ(error.CoverageIou, 1.);
  // The mesh's points and frames are of float.
  EXPECT_LT(error.Depth.Maximum, 1e-4);
  EXPECT_LT(error.Texcoord.Maximum, 1e-2);
  EXPECT_LT(error.Normal.Mean, 1e-3);
  EXPECT_LT(error.ShadowCast, 1e-3);
}

TEST(TechniqueModel, OfBumpIsWhatIsDrawn)
{
  const MesoScene scene = MesoParseScene(Torus("bump", "smooth"), "torus.json");
  const MesoGeometryError error =
    MesoCompareGeometry(ModelOf(scene), DrawnAOVs(scene, Width, Height));
  EXPECT_GT(error.CoverageIou, 0.999);
  // Nothing is searched: what is left is float's rounding.
  EXPECT_LT(error.Texcoord.P99, 1e-2);
  EXPECT_LT(error.Normal.P99, 0.02);
  EXPECT_LT(error.ShadowCast, 2e-3);
}

TEST(TechniqueModel, HasNoGapsBetweenTrianglesThatAreSmallBesideTheScene)
{
  // Of a radius of 500 a float knows 3e-5, a hundredth of these triangles' sides.
  const MesoScene scene = MesoParseScene(R"({"meso": 1,
    "camera": {"position": [0, 0, 2], "parallel_scale": 0.4}, "nodes": [
      {"transform": {"rotate": [7, 0, 0, 1]},
       "mesh": {"shape": "plane", "size": [2, 2], "segments": [600, 600]}},
      {"transform": {"translate": [1000, 0, 0]}, "mesh": {"shape": "plane"}}]})",
    "far.json");
  const MesoAOVs model = ModelOf(scene);
  EXPECT_EQ(std::count(model.Coverage.begin(), model.Coverage.end(), 1.f), Width * Height);
}

class SolverError : public testing::TestWithParam<const char*>
{
};

TEST_P(SolverError, IsSmallAndFallsWithTheSteps)
{
  for (const char* map : { "smooth", "brick" })
  {
    MesoScene scene = MesoParseScene(Torus(GetParam(), map), "torus.json");
    const MesoAOVs model = ModelOf(scene);
    double before = 0.;
    for (MesoQuality quality : { MesoQuality::High, MesoQuality::Medium, MesoQuality::Low })
    {
      scene.Nodes[0].Mesostructure.Quality = quality;
      const MesoGeometryError error = MesoCompareGeometry(model, DrawnAOVs(scene, Width, Height));
      if (quality == MesoQuality::High)
      {
        // An outline's pixel here and there, and what a step passes over; else float's rounding.
        EXPECT_GT(error.CoverageIou, 0.9995) << map;
        EXPECT_EQ(error.HolePixels, 0u) << map;
        EXPECT_LT(error.Texcoord.P50, 1e-4) << map;
        EXPECT_LT(error.Depth.P95, 1e-4) << map;
        EXPECT_LT(error.Normal.P95, 0.01) << map;
        // Crossings between the shadow ray's 128 samples; facets edge-on to the light.
        EXPECT_LT(error.ShadowCast, 0.002) << map;
        EXPECT_LT(error.ShadowAttached, 0.01) << map;
      }
      EXPECT_GE(error.Texcoord.P99 * 1.01, before) << map << " " << MesoName(quality);
      before = error.Texcoord.P99;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Techniques, SolverError, testing::Values("relief", "relief-quadric"),
  [](const testing::TestParamInfo<const char*>& info)
  { return std::string(info.param) == "relief" ? "Relief" : "ReliefQuadric"; });

TEST(TechniqueModel, LeavesOutEffectsThatAreOff)
{
  const MesoScene all = MesoParseScene(Torus("relief-quadric", "brick"), "torus.json");
  const MesoScene flat =
    MesoParseScene(Torus("relief-quadric", "brick", R"(, "effects": ["shading"])"), "torus.json");
  const MesoScene plain = MesoParseScene(Torus("plain", "brick"), "torus.json");
  const MesoGeometryError bump = MesoCompareGeometry(ModelOf(plain), ModelOf(flat));
  EXPECT_EQ(bump.CoverageIou, 1.);
  EXPECT_EQ(bump.Depth.Maximum, 0.);
  EXPECT_GT(bump.Normal.Mean, 3.);
  EXPECT_LT(MesoCompareGeometry(ModelOf(plain), ModelOf(all)).CoverageIou, 0.99);
  EXPECT_LT(MesoCompareGeometry(ModelOf(flat), DrawnAOVs(flat, Width, Height)).Normal.P95, 0.1);
}

TEST(TechniqueModel, RefusesWhatHasNoModel)
{
  MesoMesostructureOptions options;
  for (const MesoTechnique technique :
    { MesoTechnique::Tessellated, MesoTechnique::ReliefQuadricExact })
  {
    options.Technique = technique;
    EXPECT_FALSE(MesoTechniqueModel::HasModel(options)) << MesoName(technique);
  }
  options.Technique = MesoTechnique::ReliefQuadric;
  EXPECT_TRUE(MesoTechniqueModel::HasModel(options));
  options.Curved = MesoCurvedKind::Osculating;
  EXPECT_FALSE(MesoTechniqueModel::HasModel(options));
  const MesoScene scene = MesoParseScene(Torus("tessellated", "smooth"), "torus.json");
  try
  {
    const MesoTechniqueModel model(scene);
    FAIL() << "not refused";
  }
  catch (const MesoInputError& problem)
  {
    EXPECT_STREQ(problem.what(),
      "node 1 '': the technique tessellated has no model that could be solved apart from it");
  }
}
