// Volumes in scene files: files, meshes and built-in ones with their numbers, and what is refused.

#include "MessageOf.h"

#include "MesoScene.h"

#include <gtest/gtest.h>

namespace
{
MesoSceneVolume Parse(const std::string& mesostructure)
{
  const MesoScene scene = MesoParseScene(
    R"({"meso": 1, "nodes": [{"mesh": "a.obj", "mesostructure": {)" + mesostructure + "}}]}",
    "/scenes/one.json");
  return scene.Nodes.at(0).Volume.value();
}

std::string Refusal(const std::string& mesostructure)
{
  const std::string message = MessageOf([&]() { Parse(mesostructure); });
  const std::string place = "/scenes/one.json: nodes[0].mesostructure.";
  return message.compare(0, place.size(), place) == 0 ? message.substr(place.size()) : message;
}
}

TEST(SceneVolumes, AreFilesByTheirName)
{
  const MesoSceneVolume volume = Parse(R"("volume": "a.nrrd")");
  EXPECT_EQ(volume.File, "/scenes/a.nrrd");
  EXPECT_FALSE(volume.IsMesh);
  EXPECT_FALSE(volume.Size);
  EXPECT_FALSE(volume.Threshold);
  EXPECT_FALSE(volume.SolidBelow);
  EXPECT_EQ(volume.Blend, 0.);
}

TEST(SceneVolumes, AreFilesWithWhatTheirNumbersMean)
{
  const MesoSceneVolume volume = Parse(R"("volume": {"file": "a.nrrd", "threshold": 3.5,
    "solid": "below", "crop": [0, 8, 1, 9, 2, 10], "blend": 0.25, "size": [8, 16, 4]})");
  EXPECT_EQ(volume.Threshold, 3.5);
  EXPECT_TRUE(volume.SolidBelow);
  EXPECT_EQ((*volume.Crop)[5], 10.);
  EXPECT_EQ(volume.Blend, 0.25);
  EXPECT_EQ((*volume.Size)[1], 16);
}

TEST(SceneVolumes, AreBuiltInWithTheirNumbers)
{
  const MesoSceneVolume volume =
    Parse(R"("volume": {"pattern": "weave", "size": [32, 32, 16], "seed": 4, "threads": 6})");
  EXPECT_EQ(volume.Pattern, "weave");
  EXPECT_EQ((*volume.Size)[2], 16);
  EXPECT_EQ(volume.Seed, 4u);
  EXPECT_EQ(volume.Parameters.at("threads"), 6.);
  EXPECT_TRUE(volume.File.empty());
}

TEST(SceneVolumes, AreMeshesThatFillATile)
{
  EXPECT_TRUE(Parse(R"("tile_mesh": "t.obj")").IsMesh);
  const MesoSceneVolume volume =
    Parse(R"("tile_mesh": {"file": "t.obj", "box": [-1, 1, -1, 1, 0, 0.5], "size": [8, 8, 4]})");
  EXPECT_EQ(volume.File, "/scenes/t.obj");
  EXPECT_EQ((*volume.Crop)[0], -1.);
}

TEST(SceneVolumes, RefuseWhatMakesNoSense)
{
  EXPECT_NE(
    Refusal(R"("volume": {"pattern": "wool"})").find("volume.pattern: "), std::string::npos);
  EXPECT_NE(
    Refusal(R"("volume": {"pattern": "weave", "threads": 3})").find("even"), std::string::npos);
  EXPECT_NE(
    Refusal(R"("volume": {"pattern": "weave", "bars": 3})").find("volume.bars"), std::string::npos);
  EXPECT_NE(Refusal(R"("volume": {"pattern": "weave", "size": [1, 8, 8]})").find("volume.size"),
    std::string::npos);
  EXPECT_NE(
    Refusal(R"("volume": {"file": "a.nrrd", "crop": [0, 0, 0, 1, 0, 1]})").find("volume.crop"),
    std::string::npos);
  EXPECT_NE(Refusal(R"("volume": {"file": "a.nrrd", "blend": 0.6})").find("volume.blend"),
    std::string::npos);
  EXPECT_NE(Refusal(R"("volume": {"file": "a.nrrd", "solid": "left"})").find("volume.solid"),
    std::string::npos);
  EXPECT_NE(Refusal(R"("volume": {"size": [8, 8, 8]})").find("file or pattern"), std::string::npos);
  EXPECT_NE(
    Refusal(R"("volume": "a.nrrd", "height_map": "h.png", "scale": 1)").find("a volume already"),
    std::string::npos);
  EXPECT_NE(Refusal(R"("volume": "a.nrrd", "tile_mesh": "t.obj")").find("a volume already"),
    std::string::npos);
}
