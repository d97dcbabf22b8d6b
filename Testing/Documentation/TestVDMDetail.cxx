// Wang2003, Figures 7 and 8, on a torus of weave: the meshes that tables of displacements and displaced meshes
// take for a like picture, and what is left of it by few factors.

#include "PaperFigure.h"

#include "MesoFlip.h"
#include "MesoPicture.h"
#include "SceneTable.h"

#include <numeric>

namespace
{
/// Of the torus: half the paper's texels and azimuths, and a third of its curvatures.
MesoVDMLayout DetailLayout()
{
  MesoVDMLayout layout;
  layout.Width = layout.Height = 64;
  layout.Azimuths = 16;
  layout.Curvatures = 5;
  layout.FirstCurvature = -0.8;
  layout.LastCurvature = 2.;
  return layout;
}

MesoScene DetailOf(const PaperFigure& figure, MesoQuality quality, const SceneTable& table)
{
  MesoScene scene = figure.With(MesoTechnique::VDM);
  scene.Nodes[0].Mesostructure.Quality = quality;
  scene.Nodes[0].Baked = table.GetFile();
  return scene;
}

void Report(const char* name, const MesoGeometryError& error)
{
  std::printf("%-10s overlap %.4f, texels %.2f / %.2f, depth %.2f, cast shadows %.3f\n", name,
    error.CoverageIou, error.Texcoord.P50, error.Texcoord.P95, error.Depth.P95, error.ShadowCast);
}
}

TEST(VDMDetail, MeshesForALikePicture)
{
  const PaperFigure figure("VDMDetail");
  const SceneTable table(figure.Scene, DetailLayout(), 8);
  const MesoScene coarse = DetailOf(figure, MesoQuality::Medium, table);
  vtkIdType triangles = 0;
  const auto errorOf = [&](const char* name, const MesoScene& scene)
  {
    const MesoGeometryError error = figure.ErrorOf(DrawnAOVs(scene, figure.Width, figure.Height,
      [&](const MesoSceneBuilder& builder)
      { triangles = builder.GetObjects()[0].Mapper->GetInput()->GetNumberOfCells(); }));
    Report(name, error);
    return error;
  };
  const MesoGeometryError vdm = errorOf("vdm", coarse);
  EXPECT_EQ(triangles, 4800);
  MesoScene diced = figure.With(MesoTechnique::Tessellated);
  diced.Nodes[0].Mesostructure.Quality = MesoQuality::Draft;
  const MesoGeometryError draft = errorOf("draft", diced);
  const vtkIdType fewer = triangles;
  diced.Nodes[0].Mesostructure.Quality = MesoQuality::Low;
  const MesoGeometryError low = errorOf("low", diced);
  std::printf(
    "%lld and %lld triangles\n", static_cast<long long>(fewer), static_cast<long long>(triangles));
  // Ten times the triangles do not do, thirty times do.
  EXPECT_EQ(fewer, 10 * 4800);
  EXPECT_GT(draft.Texcoord.P95, 1.5 * vdm.Texcoord.P95);
  EXPECT_EQ(triangles, 34 * 4800);
  EXPECT_LT(low.Texcoord.P95, vdm.Texcoord.P95);

  for (MesoScene scene : { coarse, diced })
  {
    const bool isDiced = scene.Nodes[0].Mesostructure.Technique == MesoTechnique::Tessellated;
    const std::string name = isDiced ? "VDMMeshDisplaced" : "VDMMesh";
    EXPECT_TRUE(MesoCompareWithMeshPicture(scene, name, 240, 180));
    scene.Camera.FocalPoint = { 0.75, 0.2, 1. };
    scene.Camera.ViewAngle = 6.;
    EXPECT_TRUE(MesoCompareWithMeshPicture(scene, name + "Zoom", 240, 180));
  }
}

TEST(VDMDetail, FewFactorsKeepTheAppearance)
{
  const PaperFigure figure("VDMDetail");
  const SceneTable whole(figure.Scene, DetailLayout(), 0);
  const SceneTable factors(figure.Scene, DetailLayout(), 8);
  constexpr int Width = 240;
  constexpr int Height = 180;
  const auto draw = [&](const MesoScene& scene, const char* name)
  {
    const auto image = DrawnPicture(scene, Width, Height);
    EXPECT_TRUE(
      MesoCompareWithBaseline(image, name, MesoImageLimits(), { MESO_IMAGES, MESO_OUTPUT_FOLDER }));
    return MesoPictureOfImage(image);
  };
  const MesoScene scene = DetailOf(figure, MesoQuality::Full, whole);
  const MesoGeometryError best = figure.ErrorOf(DrawnAOVs(scene, figure.Width, figure.Height));
  const MesoPicture uncompressed = draw(scene, "VDMFull");
  Report("full", best);
  double before = 1.;
  double error = 0.;
  for (const auto& [quality, name] : { std::pair{ MesoQuality::Draft, "VDMDraft" },
         { MesoQuality::Low, "VDMLow" }, { MesoQuality::Medium, "VDMMedium" } })
  {
    const MesoScene compressed = DetailOf(figure, quality, factors);
    const MesoGeometryError left =
      figure.ErrorOf(DrawnAOVs(compressed, figure.Width, figure.Height));
    const std::vector<float> flip = MesoFlip(uncompressed, draw(compressed, name));
    const double mean = std::accumulate(flip.begin(), flip.end(), 0.) / double(flip.size());
    Report(MesoName(quality), left);
    std::printf("  FLIP to the uncompressed %.4f\n", mean);
    EXPECT_LT(mean, before);
    before = mean;
    error = left.Texcoord.P95;
  }
  // Of eight factors: next to nothing.
  EXPECT_LT(before, 0.05);
  EXPECT_LT(error, 1.1 * best.Texcoord.P95);
}
