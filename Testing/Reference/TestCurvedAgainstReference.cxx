// The curved bases against the true displaced mesh: outlines and places of a torus, whose curvature
// changes along every ray.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Size = 160;

MesoScene Torus(const std::string& technique)
{
  const std::string text = R"({ "meso": 1,
    "camera": {"position": [0, 2.4, 2.6], "view_up": [0, 1, 0], "view_angle": 44},
    "lights": [{"type": "directional", "direction": [-0.5, -0.8, -0.6]}],
    "nodes": [{"mesh": {"shape": "torus", "rings": 80, "sides": 30}, "mesostructure": {)" +
    technique + R"(, "quality": "high", "scale": 0.12, "tiles": [8, 3],
      "height_map": {"pattern": "smooth", "size": [256, 256]}}}] })";
  return MesoParseScene(text, "torus.json");
}
}

TEST(CurvedAgainstReference, OnATorus)
{
  const std::string quadric = R"("technique": "relief-quadric")";
  const MesoAOVs truth = MesoAOVsOfImage(MesoReference(Torus(quadric)).Render(Size, Size).AOVs);
  const auto errorOf = [&](const std::string& technique)
  { return MesoCompareGeometry(truth, DrawnAOVs(Torus(technique), Size, Size)); };
  const MesoGeometryError parabola = errorOf(quadric);
  const MesoGeometryError exact = errorOf(R"("technique": "relief-quadric-exact")");
  const MesoGeometryError osculating = errorOf(quadric + R"(, "curved": "osculating")");
  const MesoGeometryError bent = errorOf(quadric + R"(, "curved": "bent")");
  const MesoGeometryError surface = errorOf(quadric + R"(, "curved": "surface")");
  for (const MesoGeometryError* error : { &parabola, &exact, &osculating, &bent, &surface })
  {
    EXPECT_EQ(error->NanPixels, 0u);
  }
  // Measured at 320 x 320: overlap .978, .984, .986, .997 and .997; texels at the 95th percentile 12,
  // 14, 8.3, 1.3 and .44. A quarter of the pixels doubles the outline's part of them.
  EXPECT_GT(parabola.CoverageIou, 0.965);
  EXPECT_GT(exact.CoverageIou, parabola.CoverageIou);
  EXPECT_GT(osculating.CoverageIou, parabola.CoverageIou);
  EXPECT_GT(bent.CoverageIou, 0.992);
  EXPECT_GT(surface.CoverageIou, 0.992);
  EXPECT_LT(osculating.Texcoord.P95, 0.8 * parabola.Texcoord.P95);
  EXPECT_LT(bent.Texcoord.P95, 2.5);
  EXPECT_LT(surface.Texcoord.P50, 0.05);
  EXPECT_LT(surface.Texcoord.P95, 1.);
  EXPECT_LT(surface.Depth.P95, 0.02);
  // Across the ray is not below the base: the report's more accurate distance places the relief worse.
  EXPECT_GT(exact.Texcoord.P50, 2. * parabola.Texcoord.P50);
  EXPECT_LT(surface.ShadowCast, 0.08);
}

TEST(CurvedAgainstReference, WithBicubicHeights)
{
  // Close to the torus, texels of some ten pixels: the reference's own spline, displaced over the mesh.
  const auto close = [](const std::string& technique, MesoInterpolation interpolation)
  {
    MesoScene scene = Torus(technique);
    scene.Camera.FocalPoint = { 0.2, 0.1, 0.9 };
    scene.Camera.Position = { 0.6, 1.6, 2.4 };
    scene.Camera.ViewAngle = 34.;
    scene.Nodes[0].Map->Pattern = "noise";
    scene.Nodes[0].Map->Size = { 24, 24 };
    scene.Nodes[0].Mesostructure.Scale = 0.08;
    scene.Nodes[0].Mesostructure.Interpolation = interpolation;
    return scene;
  };
  const std::string quadric = R"("technique": "relief-quadric")";
  const MesoAOVs truth = MesoAOVsOfImage(
    MesoReference(close(quadric, MesoInterpolation::Bicubic)).Render(Size, Size).AOVs);
  struct Arm
  {
    std::string Technique;
    double Coverage;
    double Texels; ///< p50
    double Depth;  ///< p95, of D
    double Normal; ///< mean, degrees
  };
  const Arm arms[] = { { quadric, 0.985, 0.12, 0.16, 2.8 },
    { quadric + R"(, "curved": "osculating")", 0.985, 0.07, 0.11, 2.1 },
    { quadric + R"(, "curved": "bent")", 0.994, 0.03, 0.07, 0.8 },
    { quadric + R"(, "curved": "surface")", 0.996, 0.005, 0.04, 0.4 } };
  for (const Arm& arm : arms)
  {
    const auto errorOf = [&](MesoInterpolation interpolation) {
      return MesoCompareGeometry(truth, DrawnAOVs(close(arm.Technique, interpolation), Size, Size));
    };
    const MesoGeometryError cubic = errorOf(MesoInterpolation::Bicubic);
    const MesoGeometryError bilinear = errorOf(MesoInterpolation::Bilinear);
    std::cout << arm.Technique << ": bicubic iou " << cubic.CoverageIou << ", texels p50 "
              << cubic.Texcoord.P50 << " p95 " << cubic.Texcoord.P95 << ", depth p95 "
              << cubic.Depth.P95 << ", normal " << cubic.Normal.Mean << "; bilinear normal "
              << bilinear.Normal.Mean << ", depth p50 " << bilinear.Depth.P50 << "\n";
    EXPECT_EQ(cubic.NanPixels, 0u) << arm.Technique;
    EXPECT_EQ(cubic.HolePixels, 0u) << arm.Technique;
    EXPECT_GT(cubic.CoverageIou, arm.Coverage) << arm.Technique;
    EXPECT_LT(cubic.Texcoord.P50, arm.Texels) << arm.Technique;
    EXPECT_LT(cubic.Depth.P95, arm.Depth) << arm.Technique;
    EXPECT_LT(cubic.Normal.Mean, arm.Normal) << arm.Technique;
    EXPECT_GT(bilinear.Normal.Mean, 1.5 * cubic.Normal.Mean) << arm.Technique;
  }
}

TEST(CurvedAgainstReference, CutByPlanes)
{
  // Half a torus and the inside of its tube behind the cut: planes cut what is seen, at the hit, whatever
  // the base is taken for.
  const auto cut = [](const std::string& technique)
  {
    MesoScene scene = Torus(technique);
    scene.ClippingPlanes = { { { 0., 0., 0.1 }, { 0.2, 0.3, -1. } },
      { { 0.3, 0., 0. }, { -1., 0., 0. } } };
    return scene;
  };
  const std::string quadric = R"("technique": "relief-quadric")";
  const MesoAOVs truth = MesoAOVsOfImage(MesoReference(cut(quadric)).Render(Size, Size).AOVs);
  const MesoAOVs whole = MesoAOVsOfImage(MesoReference(Torus(quadric)).Render(Size, Size).AOVs);
  EXPECT_LT(MesoCompareGeometry(whole, truth).CoverageIou, 0.7); // much is gone
  const std::pair<std::string, double> arms[] = { { quadric, 0.94 },
    { R"("technique": "relief-quadric-exact")", 0.945 },
    { quadric + R"(, "curved": "osculating")", 0.96 }, { quadric + R"(, "curved": "bent")", 0.985 },
    { quadric + R"(, "curved": "surface")", 0.985 } };
  for (const auto& arm : arms)
  {
    const MesoGeometryError error =
      MesoCompareGeometry(truth, DrawnAOVs(cut(arm.first), Size, Size));
    std::cout << arm.first << ": iou " << error.CoverageIou << ", texcoord p50 "
              << error.Texcoord.P50 << "\n";
    EXPECT_EQ(error.NanPixels, 0u) << arm.first;
    EXPECT_GT(error.CoverageIou, arm.second) << arm.first;
  }
}
