// A coarse teapot, of patches with creases, seams and poles, over every curved base: how many pixels are missing
// within its outline, and where they are. Documentation/Techniques/CurvedRelief.md says why.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
MesoScene Teapot(const std::string& base)
{
  const std::string text = R"({ "meso": 1,
    "camera": {"position": [0.8, 2.4, 4.4], "focal_point": [0.1, 0.6, 0], "view_up": [0, 1, 0],
               "view_angle": 32},
    "lights": [{"type": "directional", "direction": [-0.5, -0.8, -0.6]}],
    "nodes": [{"mesh": {"shape": "teapot", "segments": 4}, "mesostructure": {
      "technique": "relief-quadric", "curved": ")" +
    base + R"(", "quality": "high", "scale": 0.03, "tiles": [2, 2],
      "height_map": {"pattern": "smooth", "size": [256, 256]}}}] })";
  return MesoParseScene(text, "teapot.json");
}

/// The neck of the lid's knob, whose curvature the vertices lend to the facets beside it.
bool OnNeck(const std::array<double, 3>& point)
{
  return point[1] > 0.5 && point[1] < 0.65 && std::hypot(point[0], point[2]) < 0.12;
}

/// Where the handle goes into the body.
bool OnHandle(const std::array<double, 3>& point)
{
  return point[0] < -0.6 && point[1] < 0.4;
}
}

TEST(TeapotHoles, AreFewAndWhereTheyAreSaidToBe)
{
  constexpr int Size = 320;
  struct Arm
  {
    const char* Base;
    std::size_t Most;
    double Coverage;
    bool (*Place)(const std::array<double, 3>& point);
  };
  const Arm arms[] = { { "quadric", 60, 0.962, OnNeck }, { "osculating", 115, 0.958, OnNeck },
    { "bent", 0, 0.967, OnNeck }, { "surface", 4, 0.973, OnHandle } };
  const MesoAOVs truth = MesoAOVsOfImage(MesoReference(Teapot("quadric")).Render(Size, Size).AOVs);
  for (const Arm& arm : arms)
  {
    const MesoGeometryError error =
      MesoCompareGeometry(truth, DrawnAOVs(Teapot(arm.Base), Size, Size));
    std::cout << arm.Base << ": " << error.HolePixels << " holes, coverage " << error.CoverageIou
              << "\n";
    EXPECT_EQ(error.NanPixels, 0u) << arm.Base;
    EXPECT_LE(error.HolePixels, arm.Most) << arm.Base;
    EXPECT_GT(error.CoverageIou, arm.Coverage) << arm.Base;
    for (std::size_t i = 0; i < error.Classes.size(); ++i)
    {
      if (error.Classes[i] == MesoPixelClass::Hole)
      {
        const std::array<double, 3> point = truth.PointAt(i);
        EXPECT_TRUE(arm.Place(point))
          << arm.Base << ": " << point[0] << " " << point[1] << " " << point[2];
      }
    }
  }
}
