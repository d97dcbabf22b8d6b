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

std::size_t Covered(const MesoScene& scene)
{
  const MesoExrImage image = DrawnImage(scene, Width, Height);
  std::size_t count = 0;
  for (int row = 0; row < Height; ++row)
  {
    for (int column = 0; column < Width; ++column)
    {
      count += ValueAt(image, "coverage", column, row) > 0.5 ? 1 : 0;
    }
  }
  return count;
}

/// The base mesh as it is.
std::size_t CoveredByBase(MesoScene scene)
{
  scene.Nodes.front().Mesostructure = MesoMesostructureOptions();
  return Covered(scene);
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
  // Though the bars stand out over the base, between them one sees through both walls.
  EXPECT_LT(Covered(scene), CoveredByBase(scene));
}

TEST(VolumeFigures, TheChainsHangInTheAir)
{
  MesoScene scene = FigureScene("VolumeTorus");
  scene.Nodes[0].Volume->Parameters = { { "links", 2. }, { "rows", 2. }, { "depth", 0.5 } };
  const MesoGeometryError error = ErrorOf("torus", scene);
  EXPECT_GT(error.CoverageIou, 0.94);
  EXPECT_LT(Covered(scene), CoveredByBase(scene));
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
