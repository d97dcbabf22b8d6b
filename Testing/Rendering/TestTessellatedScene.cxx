// The technique `tessellated` in a scene: what a node's options make of its mesh, and what is refused.

#include "MesoAOVChecks.h"
#include "MesoBaseline.h"

#include "MesoSceneBuilder.h"

#include "vtkPointData.h"

namespace
{
class TessellatedScene : public testing::Test
{
protected:
  MesoTestScene Scene{ 96, 96 };
  vtkNew<vtkMesoAOVPass> Pass;
  MesoSceneBuilder Builder;
  std::string Tiles = "[6, 3]";
  std::string Map = R"({"pattern": "brick", "size": [32, 32]})";

  TessellatedScene() { this->Scene.Renderer->RemoveActor(this->Scene.Actor); }
  ~TessellatedScene() override { this->Pass->ReleaseGraphicsResources(this->Scene.Window); }

  /// A node with these keys of mesostructure and others of its own.
  void Build(const std::string& keys, const std::string& mesh = R"({"shape": "torus"})",
    const std::string& others = "")
  {
    this->Scene.Renderer->RemoveAllViewProps();
    const std::string text =
      R"({ "meso": 1, "camera": {"position": [0.5, 2, 4]}, "lights": [{"type": "directional",
      "direction": [-0.2, -0.6, -1]}], "nodes": [{"name": "pot", "mesh": )" +
      mesh + others + R"(, "mesostructure": {"scale": 0.1, "tiles": )" + this->Tiles +
      R"(, "height_map": )" + this->Map + ", " + keys + "}}] }";
    this->Builder.Build(MesoParseScene(text, "s.json"), this->Scene.Renderer);
  }

  std::string RefusalOf(const std::string& keys, const std::string& mesh = R"({"shape": "torus"})")
  {
    try
    {
      this->Build(keys, mesh);
    }
    catch (const MesoInputError& error)
    {
      return error.what();
    }
    return "";
  }

  /// What is drawn.
  vtkPolyData* Mesh() const { return this->Builder.GetObjects().at(0).Mapper->GetInput(); }
};
}

TEST_F(TessellatedScene, QualityIsFacetsPerTexel)
{
  // Edges of 4 texels around and along; 4 times as many triangles from quality to quality.
  vtkIdType before = 0;
  for (const char* quality : { "draft", "low", "medium", "high" })
  {
    this->Build(std::string(R"("technique": "tessellated", "quality": ")") + quality + "\"");
    const vtkIdType triangles = this->Mesh()->GetNumberOfPolys();
    EXPECT_TRUE(before == 0 || triangles == 4 * before) << quality << " " << triangles;
    before = triangles;
    EXPECT_TRUE(this->Builder.GetWarnings().empty());
  }
  EXPECT_EQ(before, 2 * 48 * 24 * 8 * 8);
  // The base is still there, for whoever displaces it in another way.
  EXPECT_EQ(this->Builder.GetObjects().at(0).Mesh->GetNumberOfPolys(), 2 * 48 * 24);
}

TEST_F(TessellatedScene, TooManyTrianglesAreRefusedWithTheNode)
{
  this->Tiles = "[600, 300]";
  const std::string refusal = this->RefusalOf(R"("technique": "tessellated", "quality": "high")");
  EXPECT_EQ(refusal.rfind("s.json: nodes[0].mesostructure: dicing into ", 0), 0u) << refusal;
  EXPECT_NE(refusal.find("more than the limit of 20000000"), std::string::npos) << refusal;
}

TEST_F(TessellatedScene, EffectsComeTogether)
{
  for (const char* effects : { R"(["shading"])", R"(["occlusion", "depth"])", R"(["silhouette"])" })
  {
    const std::string refusal =
      this->RefusalOf(std::string(R"("technique": "tessellated", "effects": )") + effects);
    EXPECT_EQ(refusal.rfind("s.json: nodes[0].mesostructure: technique tessellated shows", 0), 0u)
      << effects << ": " << refusal;
  }
  EXPECT_NE(this->RefusalOf(R"("technique": "tessellated", "effects": ["self_shadow"])")
              .find("technique tessellated does not provide self_shadow"),
    std::string::npos);
}

TEST_F(TessellatedScene, WithoutShadingNormalsAreTheBases)
{
  this->Build(R"("technique": "tessellated", "effects": ["occlusion", "depth", "silhouette"])",
    R"({"shape": "plane"})");
  vtkDataArray* normals = this->Mesh()->GetPointData()->GetNormals();
  for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
  {
    ASSERT_EQ(normals->GetComponent(i, 2), 1.);
  }
  double bounds[6];
  this->Mesh()->GetBounds(bounds);
  EXPECT_LT(bounds[4], -0.05);
}

TEST_F(TessellatedScene, WithoutEffectsItIsThePlainMesh)
{
  this->Build(R"("technique": "plain")");
  const auto plain = MesoGrabWindow(this->Scene.Window);
  this->Build(R"("technique": "tessellated", "effects": "none")");
  EXPECT_TRUE(
    MesoCompareImages(MesoGrabWindow(this->Scene.Window), plain, MesoImageLimits::Exact()).Within);
  EXPECT_TRUE(this->Builder.GetObjects().at(0).Mapper->GetEffectsDrawn().Empty());
  this->Build(R"("technique": "tessellated")");
  EXPECT_FALSE(MesoCompareImages(MesoGrabWindow(this->Scene.Window), plain).Within);
}

TEST_F(TessellatedScene, NoReliefIsThePlainMesh)
{
  this->Build(R"("technique": "plain")");
  const auto plain = MesoGrabWindow(this->Scene.Window);
  this->Map = R"({"pattern": "step", "size": [8, 8], "low": 1})";
  this->Build(R"("technique": "tessellated", "quality": "low")");
  // Diced, so that rounding differs: positions of floats, normals interpolated in smaller pieces.
  const auto difference =
    MesoCompareImages(MesoGrabWindow(this->Scene.Window), plain, MesoImageLimits());
  EXPECT_TRUE(difference.Within) << difference.Describe();
}

TEST_F(TessellatedScene, TearsAreSaid)
{
  this->Build(R"("technique": "tessellated")", R"({"shape": "sphere"})");
  ASSERT_EQ(this->Builder.GetWarnings().size(), 1u);
  const std::string warning = this->Builder.GetWarnings()[0];
  EXPECT_EQ(warning.rfind("s.json: nodes[0].mesostructure: the surface is torn along ", 0), 0u)
    << warning;
}

TEST_F(TessellatedScene, ColorsFollow)
{
  // By an array of the base, interpolated to the diced points; by the relief's height.
  const std::string plain = R"("technique": "tessellated")";
  this->Build(plain);
  const auto uncolored = MesoGrabWindow(this->Scene.Window);
  this->Build(plain, R"({"shape": "torus"})", R"(, "material": {"color_by": "MesoCurvature[0]"})");
  const auto curvatures = MesoGrabWindow(this->Scene.Window);
  EXPECT_FALSE(MesoCompareImages(curvatures, uncolored).Within);
  vtkDataArray* carried = this->Mesh()->GetPointData()->GetArray("MesoCurvature");
  ASSERT_NE(carried, nullptr);
  EXPECT_EQ(carried->GetNumberOfTuples(), this->Mesh()->GetNumberOfPoints());
  this->Build(plain, R"({"shape": "torus"})", R"(, "material": {"color_by": "height"})");
  const auto heights = MesoGrabWindow(this->Scene.Window);
  EXPECT_FALSE(MesoCompareImages(heights, uncolored).Within);
  EXPECT_FALSE(MesoCompareImages(heights, curvatures).Within);
  this->Build(plain, R"({"shape": "torus"})", R"(, "material": {"color_by": "Normals[2]"})");
  EXPECT_FALSE(MesoCompareImages(MesoGrabWindow(this->Scene.Window), uncolored).Within);
}

TEST_F(TessellatedScene, MirroredNodesFaceTheEye)
{
  for (const char* scale : { "[1, 1, 1]", "[-1, 1, 1]", "[-1, -1, 1]" })
  {
    this->Build(R"("technique": "tessellated", "quality": "low")", R"({"shape": "plane"})",
      std::string(R"(, "transform": {"scale": )") + scale + "}");
    MesoCapture(this->Scene, this->Pass);
    EXPECT_GT(MesoCheckEveryPixel(this->Pass), 1000) << scale;
    const auto values = this->Pass->GetInterleaved({ "coverage", "normal.z" });
    for (std::size_t i = 0; i < values.size(); i += 2)
    {
      ASSERT_TRUE(values[i] == 0.f || values[i + 1] > 0.f) << scale;
    }
  }
}

TEST_F(TessellatedScene, SceneWithoutMapOrScaleIsRefused)
{
  const auto refusal = [](const std::string& mesostructure)
  {
    try
    {
      MesoParseScene(R"({"meso": 1, "nodes": [{"mesh": {"shape": "plane"}, "mesostructure": {)" +
          mesostructure + "}}]}",
        "s.json");
    }
    catch (const MesoInputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(R"("technique": "tessellated", "scale": 1)")
              .find("technique tessellated needs a height_map or a depth_map"),
    std::string::npos);
  EXPECT_NE(refusal(R"("technique": "tessellated", "height_map": {"pattern": "step"})")
              .find("technique tessellated needs scale"),
    std::string::npos);
}
