// `meso reference`: picture, AOVs and figures of the true surface, and what it refuses.

#include "SceneFolder.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numeric>

namespace
{
void ExpectRefused(
  const std::vector<std::string>& arguments, int code, const std::vector<std::string>& parts)
{
  const MesoRun run = RunMeso(arguments);
  EXPECT_EQ(run.ExitCode, code) << run.Messages;
  EXPECT_EQ(run.Output, "");
  EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
  for (const std::string& part : parts)
  {
    EXPECT_NE(run.Messages.find(part), std::string::npos) << part << "\nis not in\n"
                                                          << run.Messages;
  }
}
}

TEST(MesoReferenceCommand, WritesWhatIsAskedFor)
{
  SceneFolder scene(LitBrickPlane());
  scene.Run("reference", {}, "x");
  EXPECT_EQ(scene.Names(), (std::vector<std::string>{ "scene.json", "x.png" }));
  scene.Run("reference", { "--aov", "depth,base", "--stats", scene.PathOf("x.json") }, "x");
  EXPECT_EQ(
    scene.Names(), (std::vector<std::string>{ "scene.json", "x.aov.exr", "x.json", "x.png" }));
  auto names = scene.AOVs().ChannelNames;
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{ "base", "depth" }));
  const auto stats = nlohmann::json::parse(scene.Bytes("x.json"));
  EXPECT_EQ(stats["surface"], "mesh");
  EXPECT_EQ(stats["size"], nlohmann::json({ 64, 48 }));
  EXPECT_GE(stats["rays"], 64 * 48);
  EXPECT_GT(stats["rays_per_second"], 0.);
  EXPECT_GT(stats["memory_bytes"], 128 * 64 * 4);
  EXPECT_LT(stats["largest_residual"], 1e-12);
  EXPECT_EQ(stats["unresolved_cells"], 0);
  EXPECT_EQ(stats["degenerate_triangles"], 0);
  EXPECT_EQ(stats["triangles"], 2);
}

TEST(MesoReferenceCommand, HasTheChannelsAndAttributesOfRender)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({ "--aov", "all" }, "drawn");
  scene.Run("reference", { "--aov", "all" }, "truth");
  const MesoExrImage drawn = scene.AOVs({}, "drawn");
  const MesoExrImage truth = scene.AOVs(drawn.ChannelNames, "truth");
  for (const auto& attribute : drawn.Attributes)
  {
    if (attribute.first.rfind("meso.", 0) == 0)
    {
      ASSERT_EQ(truth.Attributes.count(attribute.first), 1u) << attribute.first;
      EXPECT_EQ(truth.Attributes.at(attribute.first), attribute.second) << attribute.first;
    }
  }
  // The joints and faces lie in the same places.
  const auto depth = std::find(drawn.ChannelNames.begin(), drawn.ChannelNames.end(), "depth");
  int apart = 0;
  for (int row = 0; row < drawn.Height; ++row)
  {
    for (int column = 0; column < drawn.Width; ++column)
    {
      const std::size_t channel = depth - drawn.ChannelNames.begin();
      apart +=
        std::abs(drawn.At(column, row, channel) - truth.At(column, row, channel)) > 1e-4f ? 1 : 0;
    }
  }
  EXPECT_LE(apart, 15);
}

TEST(MesoReferenceCommand, PictureIsThatOfRenderOnAPlainMesh)
{
  SceneFolder scene(R"("background": [0.2, 0.3, 0.4],
    "nodes": [{"mesh": {"shape": "sphere"}, "material": {"color": [0.9, 0.5, 0.2]}}])");
  scene.Render({ "--samples", "4" }, "drawn");
  scene.Run("reference", { "--samples", "4" }, "truth");
  for (int row = 0; row < SceneFolder::Height; row += 3)
  {
    for (int column = 0; column < SceneFolder::Width; column += 3)
    {
      const auto a = scene.Color(column, row, "drawn");
      const auto b = scene.Color(column, row, "truth");
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(a[k], b[k], 2) << column << ", " << row;
      }
    }
  }
}

TEST(MesoReferenceCommand, SmoothIsRounderThanTheMesh)
{
  SceneFolder scene(R"("nodes": [{"mesh": {"shape": "sphere", "rings": 4, "sides": 6}}])");
  const auto covered = [&](const char* surface)
  {
    scene.Run("reference", { "--surface", surface, "--aov", "coverage" }, surface);
    const MesoExrImage image = scene.AOVs({ "coverage" }, surface);
    return std::accumulate(image.Data.begin(), image.Data.end(), 0.f);
  };
  // Radius 1, pixels of 0.05: pi / 0.0025 of them.
  EXPECT_NEAR(covered("smooth"), 3.14159f / 0.0025f, 20.f);
  EXPECT_LT(covered("mesh"), covered("smooth") - 50.f);
}

TEST(MesoReferenceCommand, RefusesInOneLine)
{
  const TemporaryFolder folder;
  folder.Write("scene.json",
    R"({"meso": 1, "nodes": [{"name": "glass", "mesh": {"shape": "plane"}, "material": {"opacity": 0.5}}]})");
  const std::string scene = folder.PathOf("scene.json");
  const std::string picture = folder.PathOf("x.png");
  ExpectRefused({ "reference", scene, "-o", picture }, 1, { "node 1 'glass'", "translucent" });
  ExpectRefused({ "reference", folder.PathOf("none.json"), "-o", picture }, 1, { "none.json" });
  ExpectRefused({ "reference", scene }, 2, { "--output", "meso reference --help" });
  ExpectRefused({ "reference", scene, "-o", picture, "--surface", "round" }, 2,
    { "--surface", "'round'", "mesh, smooth" });
  ExpectRefused(
    { "reference", scene, "-o", picture, "--aov", "uv" }, 2, { "--aov", "'uv'", "base" });
  ExpectRefused({ "reference", scene, "-o", picture, "--stats", picture }, 1, { "one file" });
  ExpectRefused({ "reference", scene, "-o", picture, "--stats", scene }, 1, { "is read" });
  const std::string part = folder.Write("part.json",
    R"({"meso": 1, "nodes": [{"name": "half", "mesh": {"shape": "sphere"}, "part": {"by": "x", "range": [0, 9]}}]})");
  ExpectRefused(
    { "reference", part, "-o", picture, "--surface", "smooth" }, 1, { "node 'half'", "part" });
  EXPECT_EQ(folder.Names().size(), 2u); // nothing was left beside the scenes
}

TEST(MesoReferenceCommand, HelpHasAnExample)
{
  const MesoRun run = RunMeso({ "reference", "--help" });
  EXPECT_EQ(run.ExitCode, 0);
  for (const char* part : { "Example: meso reference ", "--surface", "--aov", "--samples", "base" })
  {
    EXPECT_NE(run.Output.find(part), std::string::npos) << part << "\n" << run.Output;
  }
}
