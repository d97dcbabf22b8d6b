// `meso render --stats`: the figures of cost.

#include "SceneFolder.h"

#include <nlohmann/json.hpp>

namespace
{
nlohmann::json StatsOf(SceneFolder& scene, std::vector<std::string> options = {})
{
  options.insert(options.end(), { "--stats", scene.PathOf("stats.json") });
  scene.Render(options);
  return nlohmann::json::parse(scene.Bytes("stats.json"), nullptr, false);
}

void ExpectTimes(const nlohmann::json& times)
{
  ASSERT_TRUE(times.is_object()) << times;
  EXPECT_LE(times.at("min"), times.at("median"));
  EXPECT_LE(times.at("median"), times.at("max"));
}
}

TEST(MesoRenderStats, HaveTheKeysOfTheContract)
{
  SceneFolder scene(LitBrickPlane());
  const nlohmann::json stats = StatsOf(scene);
  ASSERT_TRUE(stats.is_object()) << stats;
  for (const char* key :
    { "technique", "quality", "effects", "size", "gpu_ms", "frame_ms", "fetches_mean",
      "fetches_max", "gpu_bytes", "prepare_s", "triangles", "device", "version" })
  {
    ASSERT_TRUE(stats.contains(key)) << key;
  }
  ExpectTimes(stats["gpu_ms"]);
  ExpectTimes(stats["frame_ms"]);
  EXPECT_GT(stats["frame_ms"]["min"], 0.);
  EXPECT_EQ(stats["technique"], "relief");
  EXPECT_EQ(stats["quality"], "medium");
  nlohmann::json effects = stats["effects"];
  std::sort(effects.begin(), effects.end());
  EXPECT_EQ(effects, nlohmann::json({ "depth", "occlusion", "self_shadow", "shading" }));
  EXPECT_EQ(stats["size"], nlohmann::json({ 64, 48 }));
  EXPECT_GT(stats["fetches_mean"], 1.);
  EXPECT_GT(stats["fetches_max"], stats["fetches_mean"]);
  EXPECT_GE(stats["gpu_bytes"], 128 * 64) << "the map alone";
  EXPECT_GT(stats["prepare_s"], 0.);
  EXPECT_LT(stats["prepare_s"], 30.);
  EXPECT_EQ(stats["triangles"], 2);
  EXPECT_FALSE(stats["device"].get<std::string>().empty());
  EXPECT_FALSE(stats["version"].get<std::string>().empty());
}

TEST(MesoRenderStats, FetchesAreThoseOfTheAOVs)
{
  SceneFolder scene(LitBrickPlane());
  const nlohmann::json stats = StatsOf(scene, { "--aov", "coverage,fetches" });
  const MesoExrImage image = scene.AOVs({ "coverage", "fetches" });
  double covered = 0.;
  double sum = 0.;
  double most = 0.;
  for (std::size_t i = 0; i < image.Data.size(); i += 2)
  {
    covered += image.Data[i];
    sum += image.Data[i + 1];
    most = std::max(most, double(image.Data[i + 1]));
  }
  EXPECT_EQ(covered, 1600.); // 40 x 40 pixels
  EXPECT_NEAR(stats.at("fetches_mean"), sum / covered, 1e-6 * sum / covered);
  EXPECT_EQ(stats.at("fetches_max"), most);
}

TEST(MesoRenderStats, PlainFetchesNothing)
{
  SceneFolder scene(LitBrickPlane());
  const nlohmann::json stats = StatsOf(scene, { "--technique", "plain" });
  EXPECT_EQ(stats.at("technique"), "plain");
  EXPECT_EQ(stats.at("effects"), nlohmann::json::array());
  EXPECT_EQ(stats.at("fetches_mean"), 0.);
  EXPECT_EQ(stats.at("fetches_max"), 0.);
}

TEST(MesoRenderStats, CoverAllObjects)
{
  SceneFolder scene(R"("nodes": [
    {"mesh": {"shape": "plane", "segments": [3, 2]}},
    {"mesh": {"shape": "torus", "radius": 0.6, "tube": 0.2, "rings": 12, "sides": 8},
     "mesostructure": {"technique": "relief", "scale": 0.02, "quality": "low",
                       "effects": ["occlusion", "depth"],
                       "height_map": {"pattern": "noise", "size": [32, 32]}}}])");
  const nlohmann::json stats = StatsOf(scene);
  EXPECT_EQ(stats.at("technique"), nlohmann::json({ "plain", "relief" }));
  EXPECT_EQ(stats.at("triangles"), 2 * 3 * 2 + 2 * 12 * 8);
  nlohmann::json effects = stats.at("effects");
  std::sort(effects.begin(), effects.end());
  EXPECT_EQ(effects, nlohmann::json({ "depth", "occlusion" }));
}
