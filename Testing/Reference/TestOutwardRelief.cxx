// Relief that rises above its mesh (`reference` below 1): every technique draws the surface that the
// reference has, from a base moved to where height 1 lies.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"
#include "MesoTechniqueModel.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

MesoScene Torus(const std::string& technique, double reference, const std::string& scale = "1")
{
  return MesoParseScene(R"({"meso": 1, "camera": {"position": [0, 2.2, 4]},
    "lights": [{"type": "directional", "direction": [-1, -0.6, -0.8]}],
    "nodes": [{"transform": {"rotate": [20, 0.3, 1, 0.2], "scale": )" +
      scale + R"(}, "mesh": {"shape": "torus", "rings": 48, "sides": 24},
      "mesostructure": {"technique": ")" +
      technique + R"(", "quality": "high", "scale": 0.1, "tiles": [8, 3], "reference": )" +
      std::to_string(reference) + R"(,
        "height_map": {"pattern": "smooth", "size": [64, 64]}}}]})",
    "torus.json");
}

MesoAOVs TruthOf(const MesoScene& scene, MesoReference::Surface surface)
{
  return MesoAOVsOfImage(MesoReference(scene, surface).Render(Width, Height).AOVs);
}

void Print(const std::string& what, const MesoGeometryError& error)
{
  std::cout << what << ": iou " << error.CoverageIou << ", depth p95 " << error.Depth.P95
            << ", texel p50 " << error.Texcoord.P50 << " p95 " << error.Texcoord.P95 << ", normal "
            << error.Normal.Mean << ", boundary " << error.BoundaryPixels << "\n";
}
}

TEST(OutwardRelief, OnAPlaneIsThatOfAPlaneHigherUp)
{
  const auto scene = [](const std::string& keys, const std::string& z)
  {
    return MesoParseScene(R"({"meso": 1, "camera": {"position": [0.6, -0.8, 1.2], "view_angle": 40},
      "lights": [{"type": "point", "position": [-0.5, 0.4, 0.6]}],
      "nodes": [{"transform": {"translate": [0, 0, )" +
        z + R"(]}, "mesh": {"shape": "plane", "size": [1.5, 1.5], "segments": [3, 3]},
        "mesostructure": {"technique": "relief", "scale": 0.25, "tiles": [4, 4],)" +
        keys + R"("height_map": {"pattern": "brick", "size": [64, 64]}}}]})",
      "plane.json");
  };
  // 0.125 is exact, but a plane that is moved by its matrix is rounded in another place.
  const MesoAOVs moved = DrawnAOVs(scene("", "0.125"), Width, Height);
  const MesoAOVs outward = DrawnAOVs(scene(R"("reference": 0.5, )", "0"), Width, Height);
  const MesoGeometryError error = MesoCompareGeometry(moved, outward);
  EXPECT_EQ(error.CoverageIou, 1.);
  EXPECT_LT(error.Depth.P95, 1e-5);
  EXPECT_LT(error.Texcoord.P95, 1e-3);
  EXPECT_LT(error.ShadowCast, 1e-3);
  // The truth also.
  const MesoGeometryError truth =
    MesoCompareGeometry(TruthOf(scene("", "0.125"), MesoReference::Surface::Mesh),
      TruthOf(scene(R"("reference": 0.5, )", "0"), MesoReference::Surface::Mesh));
  EXPECT_EQ(truth.CoverageIou, 1.);
  EXPECT_LT(truth.Depth.Maximum, 1e-6);
}

TEST(OutwardRelief, OfEachTechniqueIsNearTheTruth)
{
  struct Case
  {
    const char* Technique;
    MesoReference::Surface Truth;
    double Coverage;
    double Depth; ///< p95, of D
  };
  const Case cases[] = { { "relief", MesoReference::Surface::Mesh, 0.88, 0.5 },
    { "relief-quadric", MesoReference::Surface::Smooth, 0.98, 0.2 },
    { "tessellated", MesoReference::Surface::Mesh, 0.999, 0.02 } };
  for (const Case& one : cases)
  {
    MesoGeometryError inward;
    for (double reference : { 1., 0.5, 0. })
    {
      const MesoScene scene = Torus(one.Technique, reference);
      const MesoGeometryError error =
        MesoCompareGeometry(TruthOf(scene, one.Truth), DrawnAOVs(scene, Width, Height));
      const std::string what = std::string(one.Technique) + " " + std::to_string(reference);
      Print(what, error);
      EXPECT_EQ(error.BoundaryPixels, 0u) << what;
      EXPECT_GT(error.CoverageIou, one.Coverage) << what;
      EXPECT_LT(error.Depth.P95, one.Depth) << what;
      if (reference == 1.)
      {
        inward = error;
      }
      // A base moved by nothing, or by all of D, would be off by half of D or more.
      EXPECT_LT(error.Depth.P95, 1.5 * inward.Depth.P95) << what;
    }
  }
}

TEST(OutwardRelief, ModelIsOfTheMovedMesh)
{
  for (const char* technique : { "relief", "relief-quadric" })
  {
    // Mirrored as well.
    const MesoScene scene = Torus(technique, 0.25, "[1, 1, -0.9]");
    const MesoAOVs model = MesoAOVsOfImage(MesoTechniqueModel(scene).Render(Width, Height));
    const MesoGeometryError error = MesoCompareGeometry(model, DrawnAOVs(scene, Width, Height));
    EXPECT_GT(error.CoverageIou, 0.9995) << technique;
    EXPECT_LT(error.Depth.P95, 1e-4) << technique;
    EXPECT_LT(error.Texcoord.P50, 1e-4) << technique;
  }
}

TEST(OutwardRelief, TurnsNothingWithoutRelief)
{
  // With no effects the base is drawn where it lies.
  MesoScene scene = Torus("relief", 0.);
  scene.Nodes[0].Mesostructure.Effects.Auto = false;
  MesoScene plain = scene;
  plain.Nodes[0].Mesostructure.Technique = MesoTechnique::Plain;
  const MesoGeometryError error =
    MesoCompareGeometry(DrawnAOVs(plain, Width, Height), DrawnAOVs(scene, Width, Height));
  EXPECT_EQ(error.CoverageIou, 1.);
  EXPECT_EQ(error.Depth.Maximum, 0.);
}
