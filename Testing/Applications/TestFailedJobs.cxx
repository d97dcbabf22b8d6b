// A job that fails: exit code 1, one line that names file, place and reason, and nothing left.

#include "RunMeso.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace
{
const std::string Plane = R"({"meso": 1, "nodes": [{"name": "wall", "mesh": {"shape": "plane"}}]})";

std::string Relief(const std::string& mesostructure)
{
  return R"({"meso": 1, "nodes": [{"name": "wall", "mesh": {"shape": "plane"},
    "mesostructure": {"technique": "relief", "scale": 0.1, )" +
    mesostructure + "}}]}";
}

class FailedJob : public testing::Test
{
protected:
  TemporaryFolder Folder;
  std::string Output = this->Folder.PathOf("x.png");
  std::string Stats = this->Folder.PathOf("x.json");

  /// Renders this scene with AOVs and figures of cost; it must fail by a line with these parts.
  void Expect(const std::string& scene, const std::vector<std::string>& parts)
  {
    this->Folder.Write("scene.json", scene);
    this->ExpectOfFile("scene.json", parts);
  }

  void ExpectOfFile(const std::string& scene, const std::vector<std::string>& parts)
  {
    const std::vector<std::string> before = this->Names();
    const std::vector<std::string> arguments = { "render", this->Folder.PathOf(scene), "-o",
      this->Output, "--size", "16x12", "--aov", "all", "--stats", this->Stats };
    const MesoRun run = RunMeso(arguments);
    EXPECT_EQ(run.ExitCode, 1);
    EXPECT_EQ(run.Output, "");
    EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
    EXPECT_EQ(run.Messages.rfind("meso: ", 0), 0u) << run.Messages;
    for (const std::string& part : parts)
    {
      EXPECT_NE(run.Messages.find(part), std::string::npos) << part << "\nis not in\n"
                                                            << run.Messages;
    }
    EXPECT_EQ(this->Names(), before) << "something was left behind";
  }

private:
  std::vector<std::string> Names() const
  {
    std::vector<std::string> names = this->Folder.Names();
    std::sort(names.begin(), names.end());
    return names;
  }
};
}

TEST_F(FailedJob, NoScene)
{
  this->ExpectOfFile("none.json", { "none.json", "no such file" });
}

TEST_F(FailedJob, AResultThatWouldGoOverTheScene)
{
  this->Stats = this->Folder.PathOf("scene.json");
  this->Expect(Plane, { "scene.json", "is read" });
  EXPECT_EQ(std::filesystem::file_size(this->Stats), Plane.size());
}

TEST_F(FailedJob, SceneThatIsNoJson)
{
  this->Expect("{\n \"meso\": 1,,\n}", { "scene.json", "line 2" });
  this->Expect("", { "scene.json" });
}

TEST_F(FailedJob, UnknownKeyIsNamedWithItsPlace)
{
  this->Expect(Relief(R"("hieght_map": {"pattern": "brick"})"),
    { "scene.json", "nodes[0].mesostructure", "hieght_map" });
}

TEST_F(FailedJob, ColorByAnArrayThatIsNotThere)
{
  this->Expect(R"({"meso": 1, "nodes": [{"mesh": {"shape": "plane"},
    "material": {"color_by": "temperature"}}]})",
    { "scene.json: nodes[0].material.color_by: the mesh has no point array \"temperature\"",
      "there are: MesoBitangent, MesoCurvature, " });
}

// The truth of a picture whose colours it lacks would be none.
TEST_F(FailedJob, ReferenceOfColorsThatItDoesNotShow)
{
  this->Folder.Write("scene.json", R"({"meso": 1, "nodes": [{"name": "wall",
    "mesh": {"shape": "plane"}, "material": {"color_by": "TextureCoordinates[0]"}}]})");
  const MesoRun run =
    RunMeso({ "reference", this->Folder.PathOf("scene.json"), "-o", this->Output });
  EXPECT_EQ(run.ExitCode, 1);
  EXPECT_EQ(run.Messages,
    "meso: node 1 'wall': the reference does not show colors by arrays or heights (color_by)\n");
  EXPECT_EQ(this->Folder.Names(), std::vector<std::string>{ "scene.json" });
}

TEST_F(FailedJob, NoMesh)
{
  this->Expect(R"({"meso": 1, "nodes": [{"mesh": "none.obj"}]})", { "none.obj" });
}

TEST_F(FailedJob, MeshThatIsNoMesh)
{
  this->Folder.Write("bad.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n");
  this->Expect(R"({"meso": 1, "nodes": [{"mesh": "bad.obj"}]})", { "bad.obj" });
}

TEST_F(FailedJob, NoImage)
{
  this->Expect(Relief(R"("height_map": "none.png")"), { "none.png" });
}

TEST_F(FailedJob, ImageThatIsNoImage)
{
  this->Folder.Write("bad.png", "no picture");
  this->Expect(Relief(R"("height_map": "bad.png")"), { "bad.png" });
}

TEST_F(FailedJob, EffectThatIsNotProvided)
{
  this->Expect(R"({"meso": 1, "nodes": [{"mesh": {"shape": "plane"},
    "mesostructure": {"technique": "plain", "effects": ["self_shadow"]}}]})",
    { "scene.json", "effects", "self_shadow" });
}

TEST_F(FailedJob, AOVsOfTranslucentObjects)
{
  this->Expect(R"({"meso": 1, "nodes": [{"name": "glass", "mesh": {"shape": "plane"},
    "material": {"opacity": 0.5}}]})",
    { "glass", "translucent" });
}

TEST_F(FailedJob, PlaceWithoutAFolder)
{
  this->Output = this->Folder.PathOf("nowhere/x.png");
  this->Expect(Plane, { this->Output, "no folder" });
}

TEST_F(FailedJob, PlaceThatCannotBeWritten)
{
  this->Output = "/proc/x.png"; // not even root makes a file there
  this->Expect(Plane, { "/proc/x.", "cannot be written" });
}

TEST_F(FailedJob, PlaceThatIsAFolder)
{
  const TemporaryFolder other;
  this->Stats = other.PathOf(".");
  this->Expect(Plane, { this->Stats, "is not a file" });
}

TEST_F(FailedJob, LeavesAnEarlierPictureAsItWas)
{
  this->Folder.Write("x.png", "earlier");
  this->Stats = this->Folder.PathOf("nowhere/x.json");
  this->Expect(Plane, { this->Stats, "no folder" });
  std::ifstream file(this->Output);
  std::string content;
  file >> content;
  EXPECT_EQ(content, "earlier");
}
