// Scenes become actors that face the right way and hold the right colours: mirrored nodes, meshes
// without texture coordinates, colour maps with alpha.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"

#include "MesoImageFile.h"
#include "MesoSceneBuilder.h"
#include "vtkMesoNormalMap.h"
#include "vtkMesoPatternSource.h"

#include "vtkPointData.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace
{
class SceneBuilder : public testing::Test
{
protected:
  MesoTestScene Scene{ 64, 64 };
  vtkNew<vtkMesoAOVPass> Pass;
  MesoSceneBuilder Builder;

  SceneBuilder() { this->Scene.Renderer->RemoveActor(this->Scene.Actor); }
  ~SceneBuilder() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  /// Builds a scene with one node and captures its pixels; gives the covered ones.
  int Capture(const std::string& node)
  {
    const std::string text = R"({ "meso": 1, "camera": {"position": [0.3, 0.2, 3]},
      "lights": [{"type": "directional", "direction": [-0.2, -0.3, -1]}], "nodes": [)" +
      node + "] }";
    this->Scene.Renderer->RemoveAllViewProps();
    this->Builder.Build(MesoParseScene(text, "test.json"), this->Scene.Renderer);
    MesoCapture(this->Scene, this->Pass);
    return MesoCheckEveryPixel(this->Pass);
  }

  /// The mean over the covered pixels.
  double Mean(const std::string& channel) const
  {
    double sum = 0.;
    double covered = 0.;
    const auto values = this->Pass->GetInterleaved({ "coverage", channel });
    for (std::size_t i = 0; i < values.size(); i += 2)
    {
      covered += values[i];
      sum += values[i + 1];
    }
    return sum / covered;
  }
};

const char* const Relief = R"("mesostructure": {"technique": "relief", "scale": 0.05,
  "height_map": {"pattern": "smooth", "size": [32, 32]}})";
}

TEST_F(SceneBuilder, MirroredNodesFaceTheEye)
{
  const std::string plane = std::string(R"({"mesh": {"shape": "plane"}, )") + Relief;
  const int still = this->Capture(plane + "}");
  EXPECT_GT(still, 500);
  EXPECT_GT(this->Mean("normal.z"), 0.9);
  for (const char* scale : { "[-1, 1, 1]", "[1, -1, 1]", "[-1, -1, 1]" })
  {
    this->Scene.Renderer->RemoveAllViewProps();
    const int covered = this->Capture(plane + R"(, "transform": {"scale": )" + scale + "}}");
    EXPECT_NEAR(covered, still, 3) << scale;
    EXPECT_GT(this->Mean("normal.z"), 0.9) << scale;
    EXPECT_GT(this->Mean("relief"), 0.2) << scale;
    EXPECT_EQ(this->Mean("shadow.0"), 0.) << scale;
  }
}

TEST_F(SceneBuilder, MeshesWithoutTextureCoordinatesHaveNormals)
{
  const auto file =
    std::filesystem::temp_directory_path() / ("meso-builder-" + std::to_string(getpid()) + ".obj");
  std::ofstream(file) << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
  {
    const int covered = this->Capture(R"({"mesh": ")" + file.string() + R"("})");
    EXPECT_GT(covered, 300);
    EXPECT_NEAR(this->Mean("normal.z"), 1., 1e-5);
    EXPECT_EQ(this->Mean("shadow.0"), 0.);
  }
  std::filesystem::remove(file);
}

TEST_F(SceneBuilder, FlatReliefIsSaid)
{
  this->Capture(R"({"mesh": {"shape": "plane"}, "mesostructure": {"technique": "relief",
    "scale": 0, "height_map": {"pattern": "noise"}}})");
  ASSERT_EQ(this->Builder.GetWarnings().size(), 1u);
  EXPECT_EQ(this->Builder.GetWarnings()[0],
    "test.json: nodes[0].mesostructure: scale is 0, so the relief is flat");
}

TEST_F(SceneBuilder, NormalMapsThatContradictTheHeightsAreSaid)
{
  vtkNew<vtkMesoPatternSource> pattern;
  pattern->SetPattern("smooth");
  pattern->SetSize(32, 32);
  vtkNew<vtkMesoNormalMap> normals;
  normals->SetInputConnection(pattern->GetOutputPort());
  normals->Update();
  const auto file =
    std::filesystem::temp_directory_path() / ("meso-normals-" + std::to_string(getpid()) + ".png");
  std::vector<float> values;
  vtkDataArray* tuples = normals->GetOutput()->GetPointData()->GetScalars();
  for (int row = 31; row >= 0; --row)
  {
    for (int i = 0; i < 32 * 3; ++i)
    {
      const double component = tuples->GetComponent(row * 32 + i / 3, i % 3);
      values.push_back(static_cast<float>(0.5 * component + 0.5));
    }
  }
  MesoWriteImage(file.string(), 32, 32, 3, MesoImageHeader::Type::UnsignedShort, values.data());
  const auto warnings = [&](const std::string& kind, const std::string& y)
  {
    this->Scene.Renderer->RemoveAllViewProps();
    this->Capture(R"({"mesh": {"shape": "plane"}, "material": {"normal_map": ")" + file.string() +
      R"(", "normal_map_y": ")" + y + R"("}, "mesostructure": {"technique": "relief",
        "scale": 0.05, ")" +
      kind + R"(": {"pattern": "smooth", "size": [32, 32]}}})");
    return this->Builder.GetWarnings();
  };
  EXPECT_TRUE(warnings("height_map", "up").empty());
  EXPECT_TRUE(warnings("height_map", "down").empty()) << "u and v say different things";
  EXPECT_EQ(warnings("depth_map", "up"),
    std::vector<std::string>{ "test.json: nodes[0].mesostructure: the material's normal map says "
                              "that this is a height_map, not a depth_map" });
  std::filesystem::remove(file);
}

// A mesh in two parts is the mesh: normals and frames are those of the whole.
TEST_F(SceneBuilder, PartsDrawTheWholeMesh)
{
  const std::string torus =
    R"("mesh": {"shape": "torus", "radius": 0.5, "tube": 0.2}, )" + std::string(Relief);
  const std::vector<std::string> channels = { "coverage", "depth", "normal.x", "normal.y",
    "normal.z", "texcoord.u", "texcoord.v", "relief" };
  const int covered = this->Capture("{" + torus + "}");
  const auto whole = this->Pass->GetInterleaved(channels);
  EXPECT_EQ(this->Capture("{\"part\": {\"by\": \"x\", \"range\": [-9, 0.1]}, " + torus +
              "}, {\"part\": {\"by\": \"x\", \"range\": [0.1, 9]}, " + torus + "}"),
    covered);
  EXPECT_EQ(this->Pass->GetInterleaved(channels), whole);
  const int half =
    this->Capture("{\"part\": {\"by\": \"x\", \"range\": [-9, 0.1]}, " + torus + "}");
  EXPECT_GT(half, covered / 4);
  EXPECT_LT(half, covered * 3 / 4);
}

TEST_F(SceneBuilder, PartsThatAreNotThereAreSaid)
{
  const auto refusal = [this](const std::string& part) -> std::string
  {
    try
    {
      this->Capture(R"({"mesh": {"shape": "torus"}, "part": )" + part + "}");
    }
    catch (const MesoInputError& problem)
    {
      return problem.what();
    }
    return "nothing refused";
  };
  EXPECT_EQ(refusal(R"({"by": "z", "range": [7, 8]})"),
    "test.json: nodes[0].part: no triangle of the mesh has its z in [7, 8)");
  EXPECT_NE(
    refusal(R"({"by": "heat", "range": [0, 1]})").find("part.by: the mesh has no point array"),
    std::string::npos);
  EXPECT_NE(refusal(R"({"by": "MesoTangent[3]", "range": [0, 1]})").find("there is no [3]"),
    std::string::npos);
}
