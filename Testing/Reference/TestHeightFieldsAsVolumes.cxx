// Height maps drawn by the techniques of volumes: the same relief as by the others, and open edges, which vdm
// does not have (Wang2004, Figure 8).

#include "DrawnAOVs.h"
#include "ReferenceWorld.h"

#include "MesoGeometryError.h"
#include "MesoHeightVolume.h"
#include "MesoVolume.h"

namespace
{
constexpr int Size = 96;

MesoScene Scene(const std::string& mesh, const std::string& technique, const std::string& camera,
  const std::string& more = "")
{
  return SceneOf(R"("camera": {)" + camera +
    R"(}, "lights": [{"type": "directional", "direction": [-0.3, -0.6, -1]}], "nodes": [{"mesh": )" +
    mesh +
    R"(, "mesostructure": {"height_map": {"pattern": "smooth", "size": [16, 16]}, "technique": ")" +
    technique + "\"" + more + "}}]");
}

MesoAOVs Truth(const MesoScene& scene)
{
  return MesoAOVsOfImage(MesoReference(scene).Render(Size, Size).AOVs);
}

double At(const MesoVolumeField& field, double x, double y, double z)
{
  return field.At({ x, y, z });
}
}

TEST(HeightFieldsAsVolumes, HaveTheBilinearHeightsAsTheirSurface)
{
  // Heights from texel to texel so different that any other rule between them would show.
  constexpr int texels = 8;
  const auto heights = HeightsOf(texels, texels,
    [](int column, int row) { return 0.2 + 0.6 * ((3 * column + 5 * row) % 8) / 7.; });
  std::vector<std::string> warnings;
  const auto volume = MesoVolumeOfHeights(heights, "test", warnings);
  EXPECT_TRUE(warnings.empty());
  ASSERT_EQ(MesoVolumeProblem(volume), "");
  const MesoVolumeField field(volume);
  EXPECT_EQ(field.GetSize(), (std::array<int, 3>{ texels, texels, 32 }));
  const auto* height = static_cast<const float*>(heights->GetScalarPointer());
  for (int row = 0; row < texels; ++row)
  {
    for (int column = 0; column < texels; ++column)
    {
      // On the column's own axis the surface is at the texel's height to a part of a voxel.
      const double x = (column + 0.5) / texels;
      const double y = (row + 0.5) / texels;
      const double here = 0.5 + (1. - 1.1 / 32.) * (height[row * texels + column] - 0.5);
      EXPECT_LT(At(field, x, y, here - 0.3 / 32.), 0.) << column << " " << row;
      EXPECT_GT(At(field, x, y, here + 0.3 / 32.), 0.) << column << " " << row;
    }
  }
}

TEST(HeightFieldsAsVolumes, HaveGroundAndATop)
{
  for (const double h : { 0., 1. })
  {
    std::vector<std::string> warnings;
    const auto volume =
      MesoVolumeOfHeights(HeightsOf(1, 1, [h](int, int) { return h; }), "test", warnings);
    const MesoVolumeField field(volume);
    EXPECT_EQ(field.GetSize()[0], 2); // of which a table can be made
    EXPECT_LT(At(field, 0.3, 0.3, 0.), 0.) << h;
    EXPECT_GT(At(field, 0.3, 0.3, 1.), 0.) << h; // no cut there
    EXPECT_EQ(At(field, 0.3, 0.3, 0.5) < 0., h == 1.);
  }
}

TEST(HeightFieldsAsVolumes, AreAveragedDownWhereMapsAreLarge)
{
  // Stripes of one texel in 200 are a plain at their mean.
  std::vector<std::string> warnings;
  const auto volume = MesoVolumeOfHeights(
    HeightsOf(200, 1, [](int column, int) { return column % 2; }), "test", warnings);
  const MesoVolumeField field(volume);
  EXPECT_EQ(field.GetSize(), (std::array<int, 3>{ 64, 2, 32 }));
  for (double x = 0.1; x < 1.; x += 0.13)
  {
    EXPECT_LT(At(field, x, 0.5, 0.4), 0.);
    EXPECT_GT(At(field, x, 0.5, 0.6), 0.);
  }
}

TEST(HeightFieldsAsVolumes, AreTheReliefOnAClosedBase)
{
  // Inward, as maps are; on a sphere, against the displaced mesh itself.
  const std::string sphere = R"({"shape": "sphere"})";
  const std::string camera = R"("position": [0, 1, 4])";
  const std::string more = R"(, "scale": 0.12, "tiles": [6, 3])";
  const MesoAOVs truth = Truth(Scene(sphere, "relief", camera, more));
  for (const char* technique : { "shell-sdf", "gdm" })
  {
    const MesoGeometryError error =
      MesoCompareGeometry(truth, DrawnAOVs(Scene(sphere, technique, camera, more), Size, Size));
    std::cout << technique << ": iou " << error.CoverageIou << ", depth p95 " << error.Depth.P95
              << ", texel p95 " << error.Texcoord.P95 << "\n";
    const bool isTable = std::string(technique) == "gdm";
    EXPECT_EQ(error.NanPixels, 0u) << technique;
    EXPECT_GT(error.CoverageIou, 0.995) << technique;
    EXPECT_LT(error.Depth.P95, isTable ? 0.12 : 0.04) << technique;
    EXPECT_LT(error.Texcoord.P95, isTable ? 1.5 : 0.5) << technique;
  }
}

TEST(HeightFieldsAsVolumes, HaveOpenEdgesWhichVDMHasNot)
{
  const std::string sheet = R"({"shape": "undulating"})";
  const std::string camera = R"("position": [1.7, -2.7, 1.0], "view_up": [0, 0, 1])";
  const std::string more = R"(, "scale": 0.14, "tiles": [3, 3])";
  const MesoAOVs truth = Truth(Scene(sheet, "gdm", camera, more));
  std::map<std::string, MesoGeometryError> errors;
  for (const std::string technique : { "shell-sdf", "gdm", "vdm" })
  {
    errors[technique] =
      MesoCompareGeometry(truth, DrawnAOVs(Scene(sheet, technique, camera, more), Size, Size));
    std::cout << technique << ": iou " << errors[technique].CoverageIou << ", both "
              << errors[technique].BothPixels << ", boundary " << errors[technique].BoundaryPixels
              << ", extra " << errors[technique].ExtraPixels << ", void "
              << errors[technique].VoidPixels << "\n";
  }
  // The sheet's sides are solid: what vdm leaves out is a good part of the picture.
  EXPECT_GT(errors["shell-sdf"].CoverageIou, 0.99);
  EXPECT_GT(errors["gdm"].CoverageIou, 0.98);
  EXPECT_LT(errors["vdm"].CoverageIou, 0.9);
  EXPECT_GT(errors["vdm"].VoidPixels, 10 * errors["gdm"].VoidPixels);
}

TEST(HeightFieldsAsVolumes, RepeatAndAreRefusedOtherwise)
{
  MesoScene scene =
    Scene(R"({"shape": "sphere"})", "shell-sdf", R"("position": [0, 1, 4])", R"(, "scale": 0.12)");
  EXPECT_EQ(scene.Nodes[0].Mesostructure.Reference, 1.); // a map's, not a volume's
  scene.Nodes[0].Mesostructure.Wrap = MesoWrap::Clamp;
  MesoSceneBuilder builder;
  vtkNew<vtkRenderer> renderer;
  try
  {
    builder.Build(scene, renderer);
    FAIL() << "was built";
  }
  catch (const MesoInputError& problem)
  {
    EXPECT_NE(std::string(problem.what()).find("nodes[0].mesostructure.wrap: a volume repeats"),
      std::string::npos)
      << problem.what();
  }
}
