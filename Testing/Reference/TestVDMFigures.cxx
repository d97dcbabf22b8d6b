// What figures 1 and 9 of Wang2003 show, in numbers, with meshes of our own: what each technique shows of a
// relief on a teapot, and view-dependent displacements on a torus, a vase and a branch.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"
#include "SceneTable.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

MesoScene SceneOf(const std::string& name)
{
  return MesoReadScene(std::string(MESO_SCENES) + "/Documentation/" + name + ".json");
}

/// A smaller table than the technique's own, by which what is asserted here can be told as well.
SceneTable TableOf(const MesoScene& scene, int texels)
{
  MesoVDMLayout layout;
  layout.Width = layout.Height = texels;
  layout.Azimuths = 16;
  layout.Curvatures = 6; // 0 is one of them
  return { scene, layout, 8 };
}

MesoAOVs TruthOf(const MesoScene& scene)
{
  return MesoAOVsOfImage(MesoReference(scene).Render(Width, Height).AOVs);
}
}

TEST(VDMFigures, TechniquesOnATeapot)
{
  MesoScene scene = SceneOf("VDMTeapot");
  const SceneTable table = TableOf(scene, 128);
  const MesoAOVs truth = TruthOf(scene);
  const auto errorOf = [&](MesoTechnique technique)
  {
    scene.Nodes[0].Mesostructure.Technique = technique;
    scene.Nodes[0].Baked = technique == MesoTechnique::VDM ? table.GetFile() : std::string();
    const MesoGeometryError error = MesoCompareGeometry(truth, DrawnAOVs(scene, Width, Height));
    std::printf("%-12s overlap %.4f, texels %.2f / %.2f, shadows %.4f\n", MesoName(technique),
      error.CoverageIou, error.Texcoord.P50, error.Texcoord.P95, error.ShadowCast);
    EXPECT_EQ(error.NanPixels, 0u) << MesoName(technique);
    return error;
  };
  const MesoGeometryError bump = errorOf(MesoTechnique::Bump);
  const MesoGeometryError horizon = errorOf(MesoTechnique::Horizon);
  const MesoGeometryError displaced = errorOf(MesoTechnique::Displacement);
  const MesoGeometryError vdm = errorOf(MesoTechnique::VDM);
  // Bump mapping: no shadows, no occlusion, no outline; horizon mapping: shadows.
  EXPECT_EQ(horizon.CoverageIou, bump.CoverageIou);
  EXPECT_EQ(horizon.Texcoord.P95, bump.Texcoord.P95);
  EXPECT_LT(horizon.ShadowCast, bump.ShadowCast);
  // Displacement: occlusion and outlines; and so the table of displacements.
  for (const MesoGeometryError* error : { &displaced, &vdm })
  {
    EXPECT_GT(error->CoverageIou, bump.CoverageIou);
    EXPECT_LT(error->Texcoord.P95, bump.Texcoord.P95);
    EXPECT_LT(error->ShadowCast, bump.ShadowCast);
  }
}

TEST(VDMFigures, ATorusAVaseAndABranch)
{
  struct Figure
  {
    const char* Scene;
    vtkIdType Triangles; ///< the paper's, or as near as the shape comes
  };
  for (const Figure& figure : { Figure{ "VDMPaperTorus", 4800 }, Figure{ "VDMPaperVase", 8640 },
         Figure{ "VDMPaperBranch", 5856 } })
  {
    MesoScene scene = SceneOf(figure.Scene);
    const SceneTable table = TableOf(scene, 64);
    scene.Nodes[0].Baked = table.GetFile();
    const MesoAOVs truth = TruthOf(scene);
    const MesoExrImage image = DrawnImage(scene, Width, Height,
      [&](const MesoSceneBuilder& builder) {
        EXPECT_EQ(builder.GetObjects()[0].Mesh->GetNumberOfCells(), figure.Triangles)
          << figure.Scene;
      });
    const MesoGeometryError vdm = MesoCompareGeometry(truth, MesoAOVsOfImage(image));
    scene.Nodes[0].Mesostructure.Technique = MesoTechnique::Bump;
    scene.Nodes[0].Baked.clear();
    const MesoGeometryError bump = MesoCompareGeometry(truth, DrawnAOVs(scene, Width, Height));
    std::printf("%-16s overlap %.4f, of bump %.4f, texels %.2f / %.2f, of bump %.2f / %.2f\n",
      figure.Scene, vdm.CoverageIou, bump.CoverageIou, vdm.Texcoord.P50, vdm.Texcoord.P95,
      bump.Texcoord.P50, bump.Texcoord.P95);
    EXPECT_GT(vdm.CoverageIou, bump.CoverageIou) << figure.Scene;
    EXPECT_LT(vdm.Texcoord.P50, 0.5 * bump.Texcoord.P50) << figure.Scene;
    EXPECT_LT(vdm.Texcoord.P95, bump.Texcoord.P95) << figure.Scene;
  }
}
