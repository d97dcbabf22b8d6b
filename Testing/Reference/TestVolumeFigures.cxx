// Wang2004, Figure 9, as the scenes of the documentation's pictures have it: what each is there for, in numbers
// against the truth. Smaller volumes and fewer, thicker links than in the pictures, to be baked in a second.

#include "DrawnAOVs.h"
#include "ReferenceWorld.h"

#include "MesoGeometryError.h"

namespace
{
constexpr int Width = 120;
constexpr int Height = 90;

MesoScene FigureScene(const std::string& name)
{
  MesoScene scene = MesoReadScene(std::string(MESO_SCENES) + "/" + name + ".json");
  MesoSceneNode& node = scene.Nodes.front();
  node.Mesostructure.Technique = MesoTechnique::GDM;
  node.Volume->Size = std::array<int, 3>{ 32, 32, 16 };
  return scene;
}

MesoAOVs Truth(const MesoScene& scene)
{
  return MesoAOVsOfImage(MesoReference(scene).Render(Width, Height).AOVs);
}

/// Of the pixels that the base mesh itself covers, the part in which nothing is drawn.
double SeenThrough(const MesoScene& scene)
{
  MesoScene bare = scene;
  bare.Nodes.front().Mesostructure = MesoMesostructureOptions();
  const MesoExrImage drawn = DrawnImage(scene, Width, Height);
  const MesoExrImage base = DrawnImage(bare, Width, Height);
  int covered = 0;
  int open = 0;
  for (int row = 0; row < Height; ++row)
  {
    for (int column = 0; column < Width; ++column)
    {
      const bool isBase = ValueAt(base, "coverage", column, row) > 0.5;
      covered += isBase;
      open += isBase && ValueAt(drawn, "coverage", column, row) < 0.5;
    }
  }
  std::cout << "seen through: " << double(open) / covered << "\n";
  return double(open) / covered;
}

MesoGeometryError ErrorOf(const char* name, const MesoScene& scene)
{
  const MesoGeometryError error =
    MesoCompareGeometry(Truth(scene), DrawnAOVs(scene, Width, Height));
  std::cout << name << ": iou " << error.CoverageIou << ", depth p95 " << error.Depth.P95
            << ", holes " << error.HolePixels << "\n";
  EXPECT_EQ(error.NanPixels, 0u) << name;
  return error;
}
}

TEST(VolumeFigures, TheVaseOfBarsIsSeenThrough)
{
  MesoScene scene = FigureScene("VolumeVase");
  scene.Nodes[0].Volume->Parameters = { { "bars", 2. } };
  const MesoGeometryError error = ErrorOf("vase", scene);
  EXPECT_GT(error.CoverageIou, 0.97);
  EXPECT_LT(error.Depth.P95, 0.5);
  EXPECT_GT(SeenThrough(scene), 0.1); // through both walls
}

TEST(VolumeFigures, TheChainsHangInTheAir)
{
  MesoScene scene = FigureScene("VolumeTorus");
  scene.Nodes[0].Volume->Parameters = { { "links", 2. }, { "rows", 2. }, { "depth", 0.5 } };
  const MesoGeometryError error = ErrorOf("torus", scene);
  EXPECT_GT(error.CoverageIou, 0.94);
  EXPECT_GT(SeenThrough(scene), 0.04);
}

TEST(VolumeFigures, TheWeaveFollowsAnyMesh)
{
  const MesoScene scene = FigureScene("GDMBlob");
  const MesoGeometryError error = ErrorOf("blob", scene);
  EXPECT_GT(error.CoverageIou, 0.98);
  EXPECT_LT(error.Texcoord.P50, 0.3);
}

TEST(VolumeFigures, ScalesStandOutWhereBumpsDoNot)
{
  MesoScene scene = FigureScene("GDMLizard");
  ASSERT_EQ(scene.Nodes.size(), 3u);
  const MesoExrImage image = DrawnImage(scene, Width, Height);
  const MesoExrImage plain = [&]()
  {
    MesoScene bare = scene;
    for (MesoSceneNode& node : bare.Nodes)
    {
      node.Mesostructure = MesoMesostructureOptions();
    }
    return DrawnImage(bare, Width, Height);
  }();
  // By object: pixels now and of the bare mesh.
  std::map<int, std::array<int, 2>> pixels;
  int legsAndHeadMoved = 0;
  for (int row = 0; row < Height; ++row)
  {
    for (int column = 0; column < Width; ++column)
    {
      const int drawn = static_cast<int>(ValueAt(image, "object", column, row));
      const int bare = static_cast<int>(ValueAt(plain, "object", column, row));
      ++pixels[drawn][0];
      ++pixels[bare][1];
      if (drawn > 1 && drawn == bare)
      {
        legsAndHeadMoved += std::abs(ValueAt(image, "depth", column, row) -
                              ValueAt(plain, "depth", column, row)) > 1e-4;
      }
    }
  }
  EXPECT_GT(pixels[1][0], 1.05 * pixels[1][1]); // the trunk grew by its scales
  for (const int part : { 2, 3 })
  {
    EXPECT_GT(pixels[part][1], 20) << part;
    EXPECT_LE(pixels[part][0], pixels[part][1]) << part; // which hide something of the others
  }
  EXPECT_EQ(legsAndHeadMoved, 0);

  // The scales are where the truth has them.
  scene.Nodes.resize(1);
  const MesoGeometryError error = ErrorOf("animal", scene);
  EXPECT_GT(error.CoverageIou, 0.97);
  EXPECT_LT(error.Depth.P95, 1.);
}
