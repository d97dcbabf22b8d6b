// Slices parallel to the projection plane: they do not come apart where the eye looks along the shell, lie behind
// what they cut by less than their spacing, go on from prism to prism, and cost more the more there are.

#include "DrawnAOVs.h"
#include "ReferenceWorld.h"

#include "MesoGeometryError.h"

namespace
{
constexpr int Size = 96;

MesoScene Scene(const std::string& mesh, const std::string& mesostructure,
  const std::string& camera, const std::string& stack = "screen")
{
  return SceneOf(R"("camera": {)" + camera +
    R"(}, "lights": [{"type": "directional", "direction": [-0.3, -0.6, -1]}], "nodes": [{"mesh": )" +
    mesh + R"(, "mesostructure": {"technique": "slices", "stack": ")" + stack + "\", " +
    mesostructure + "}}]");
}

MesoExrImage Truth(const MesoScene& scene)
{
  return MesoReference(scene).Render(Size, Size).AOVs;
}

double Mean(const MesoExrImage& image, const char* channel)
{
  double sum = 0.;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    sum += ValueAt(image, channel, pixel % Size, pixel / Size);
  }
  return sum / (Size * Size);
}
}

TEST(SlicesOnScreen, DoNotComeApartAlongTheShell)
{
  const auto scene = [](const char* stack)
  {
    return Scene(R"({"shape": "undulating"})",
      R"("volume": {"pattern": "weave", "size": [32, 32, 16]}, "scale": 0.15, "tiles": [3, 3])",
      R"("position": [2, -2.5, 0.5], "view_up": [0, 0, 1])", stack);
  };
  const MesoAOVs truth = MesoAOVsOfImage(Truth(scene("screen")));
  const auto error = [&](const char* stack)
  {
    const MesoGeometryError result =
      MesoCompareGeometry(truth, DrawnAOVs(scene(stack), Size, Size));
    std::cout << stack << ": iou " << result.CoverageIou << ", holes " << result.HolePixels
              << ", depth p95 " << result.Depth.P95 << "\n";
    EXPECT_EQ(result.NanPixels, 0u) << stack;
    return result;
  };
  const MesoGeometryError prism = error("prism");
  const MesoGeometryError screen = error("screen");
  EXPECT_GT(screen.CoverageIou, 0.98);
  EXPECT_LT(1. - screen.CoverageIou, 0.5 * (1. - prism.CoverageIou));
  EXPECT_LT(screen.Depth.P95, 0.2 * prism.Depth.P95);
}

TEST(SlicesOnScreen, LieBehindTheSurfaceByLessThanTheirSpacing)
{
  // A solid below gentle heights: behind the surface there is matter as far as the next slice. On a flat base rays
  // are straight in texture space, and the truth is exact.
  const std::string solid =
    R"("height_map": {"pattern": "smooth", "size": [8, 8]}, "scale": 0.2, "tiles": [2, 2])";
  const std::string plane = R"({"shape": "plane", "size": [2, 2], "segments": [3, 3]})";
  for (const char* camera :
    { R"("position": [0.4, -1.2, 2.5])", R"("position": [0.4, -1.2, 2.5], "parallel_scale": 0.8)" })
  {
    for (const auto& [quality, slices] :
      std::initializer_list<std::pair<const char*, int>>{ { "draft", 8 }, { "medium", 32 } })
    {
      const MesoScene scene = Scene(plane, solid + R"(, "quality": ")" + quality + "\"", camera);
      const MesoExrImage truth = Truth(scene);
      const MesoExrImage drawn = DrawnImage(scene, Size, Size);
      const double spacing = 0.2 / slices;
      int both = 0;
      int off = 0;
      double most = 0.;
      for (int pixel = 0; pixel < Size * Size; ++pixel)
      {
        const auto at = [&](const MesoExrImage& image, const char* channel)
        { return ValueAt(image, channel, pixel % Size, pixel / Size); };
        if (at(truth, "coverage") > 0.5 && at(drawn, "coverage") > 0.5)
        {
          const double behind = at(drawn, "depth") - at(truth, "depth");
          ++both;
          off += behind < -1e-3 * spacing - 1e-5 || behind > 1.001 * spacing + 1e-5 ? 1 : 0;
          most = std::max(most, behind);
        }
      }
      EXPECT_GT(both, 5000) << quality;
      EXPECT_LT(off, both / 200) << quality; // rays that leave a crest before the next slice
      EXPECT_GT(most, 0.9 * spacing) << quality;
    }
  }
}

TEST(SlicesOnScreen, ShowTheCutWhereTheShellEnds)
{
  // Foam reaches the shell's top, and the sheet's open edges cut through it: there the truth shows its cut, in the light.
  const MesoScene scene = Scene(R"({"shape": "plane", "size": [2, 2], "segments": [3, 3]})",
    R"("volume": {"pattern": "foam", "size": [16, 16, 8]}, "scale": 0.5, "tiles": [2, 2],
      "quality": "draft")",
    R"("position": [0.6, 3.2, 2.2], "view_up": [0, 0, 1])");
  const MesoExrImage truth = Truth(scene);
  const MesoExrImage drawn = DrawnImage(scene, Size, Size);
  std::array<int, 2> cuts = { 0, 0 }; // by the open edge at y = 1, by the top
  int missed = 0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const auto at = [&](const MesoExrImage& image, const char* channel)
    { return ValueAt(image, channel, pixel % Size, pixel / Size); };
    const bool isEdge = at(truth, "texcoord.v") > 2. - 1e-5 && at(truth, "normal.y") > 0.999;
    const bool isTop = at(truth, "relief") < 1e-5 && at(truth, "normal.z") > 0.999;
    if (at(truth, "coverage") > 0.5 && (isEdge || isTop))
    {
      ++cuts[isEdge ? 0 : 1];
      bool isSame = std::abs(at(drawn, "depth") - at(truth, "depth")) < 1e-4;
      for (const char* channel : { "normal.x", "normal.y", "normal.z", "shadow.0" })
      {
        isSame = isSame && std::abs(at(drawn, channel) - at(truth, channel)) < 1e-4;
      }
      missed += isSame ? 0 : 1;
    }
  }
  std::cout << cuts[0] << " pixels of cuts at the edge, " << cuts[1] << " at the top, " << missed
            << " missed\n";
  EXPECT_GT(cuts[0], 300);
  EXPECT_GT(cuts[1], 300);
  EXPECT_LE(missed, (cuts[0] + cuts[1]) / 100); // along the cuts' outlines
}

TEST(SlicesOnScreen, GoOnFromPrismToPrism)
{
  // A solid: a slice that one prism lacks would be a hole, or a step of a spacing.
  for (const char* shape : { "torus", "sphere" })
  {
    const MesoScene scene = Scene(std::string(R"({"shape": ")") + shape + "\"}",
      R"("height_map": {"pattern": "smooth", "size": [8, 8]}, "scale": 0.1, "tiles": [8, 4],
        "quality": "low")",
      R"("position": [1, 2, 3.5])");
    const MesoGeometryError error =
      MesoCompareGeometry(MesoAOVsOfImage(Truth(scene)), DrawnAOVs(scene, Size, Size));
    std::cout << shape << ": iou " << error.CoverageIou << ", depth p95 " << error.Depth.P95
              << "\n";
    EXPECT_EQ(error.HolePixels, 0u) << shape;
    EXPECT_GT(error.CoverageIou, 0.99) << shape;
    EXPECT_LT(error.Depth.P95, 1.2 / 16.) << shape;
  }
}

TEST(SlicesOnScreen, AreTheSameInAllPrisms)
{
  const auto drawn = [](const char* segments)
  {
    return DrawnImage(
      Scene(std::string(R"({"shape": "plane", "size": [2, 2], "segments": )") + segments + "}",
        R"("volume": {"pattern": "weave", "size": [16, 16, 8]}, "scale": 0.3, "tiles": [2, 2],
          "quality": "draft")",
        R"("position": [0.4, -1.9, 1.5], "view_up": [0, 0, 1])"),
      Size, Size);
  };
  const MesoExrImage one = drawn("[1, 1]");
  const MesoExrImage many = drawn("[7, 5]");
  int same = 0;
  int covered = 0;
  for (int pixel = 0; pixel < Size * Size; ++pixel)
  {
    const double depth = ValueAt(one, "depth", pixel % Size, pixel / Size);
    covered += depth > 0. ? 1 : 0;
    same +=
      depth > 0. && std::abs(ValueAt(many, "depth", pixel % Size, pixel / Size) - depth) < 1e-4;
  }
  EXPECT_GT(covered, 1500);
  EXPECT_GT(same, 0.995 * covered); // the other rays graze
}

TEST(SlicesOnScreen, AreMetOneAfterTheOther)
{
  // Twice as many slices are twice as many look-ups, less those at what is met.
  const auto samples = [](const char* quality)
  {
    const MesoScene scene = Scene(R"({"shape": "torus", "rings": 24, "sides": 12})",
      R"("volume": {"pattern": "weave", "size": [16, 16, 16]}, "scale": 0.15, "tiles": [6, 3],
        "quality": ")" +
        std::string(quality) + "\"",
      R"("position": [1, 2, 3.5])");
    return Mean(DrawnImage(scene, Size, Size), "iterations");
  };
  const double few = samples("medium");
  const double many = samples("high");
  std::cout << few << " samples, " << many << "\n";
  EXPECT_GT(many, 1.7 * few);
  EXPECT_LT(many, 2.1 * few);
}
