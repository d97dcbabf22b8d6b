// View-dependent displacement mapping against the true displaced torus: factors and the paper's shortcuts.

#include "DrawnAOVs.h"
#include "MesoBakedFile.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"
#include "TemporaryFolder.h"
#include "vtkImageData.h"
#include "vtkMesoPatternSource.h"
#include "vtkMesoVDM.h"
#include "vtkMesoVDMMapper.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Size = 160;

/// A small table of the scenes' map, as a file.
void WriteTable(const std::string& file)
{
  vtkNew<vtkMesoPatternSource> source;
  source->SetPattern("smooth");
  source->SetSize(64, 64);
  MesoVDMLayout layout;
  layout.Width = layout.Height = 64;
  layout.Azimuths = 16;
  layout.Curvatures = 6; // 0 is one of them
  layout.FirstCurvature = -1.;
  layout.LastCurvature = 1.5;
  layout.Depth = 0.1;
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetLayout(layout);
  filter->Update();
  MesoBaked baked;
  baked.Kind = "vdm";
  baked.Table = filter->GetOutput();
  MesoWriteBaked(file, baked);
}

MesoScene Torus(const std::string& table, const std::string& quality)
{
  const std::string text = R"({ "meso": 1,
    "camera": {"position": [0, 2.4, 2.6], "view_up": [0, 1, 0], "view_angle": 44},
    "lights": [{"type": "directional", "direction": [-0.5, -0.8, -0.6]}],
    "nodes": [{"mesh": {"shape": "torus", "rings": 80, "sides": 30},
      "mesostructure": {"technique": "vdm", "quality": ")" +
    quality + R"(", "baked": ")" + table + R"(", "scale": 0.06, "tiles": [10, 4],
      "height_map": {"pattern": "smooth", "size": [64, 64]}}}] })";
  return MesoParseScene(text, "torus.json");
}

vtkMesoVDMMapper* MapperOf(const MesoSceneBuilder& builder)
{
  return vtkMesoVDMMapper::SafeDownCast(builder.GetObjects().front().Mapper);
}
}

TEST(VDMAgainstReference, OnATorus)
{
  const TemporaryFolder folder;
  const std::string table = folder.PathOf("smooth.vdm.vti");
  WriteTable(table);
  const MesoAOVs truth = MesoAOVsOfImage(
    MesoReference(Torus(table, "full"), MesoReference::Surface::Smooth).Render(Size, Size).AOVs);
  const auto report = [](const char* name, const MesoGeometryError& error)
  {
    std::printf("%-16s overlap %.4f, texels %.3f / %.2f, shadows %.4f\n", name, error.CoverageIou,
      error.Texcoord.P50, error.Texcoord.P95, error.ShadowCast);
  };
  const auto errorOf = [&](const char* name, const std::string& quality,
                         const std::function<void(const MesoSceneBuilder&)>& change = {})
  {
    const MesoGeometryError error =
      MesoCompareGeometry(truth, DrawnAOVs(Torus(table, quality), Size, Size, change));
    report(name, error);
    EXPECT_EQ(error.NanPixels, 0u) << name;
    return error;
  };
  const MesoGeometryError factors = errorOf("8 factors", "medium");
  const MesoGeometryError draft = errorOf("2 factors", "draft");
  const MesoGeometryError flat = errorOf("flat shadows", "medium",
    [](const MesoSceneBuilder& builder) { MapperOf(builder)->SetFlatShadows(true); });
  const MesoGeometryError nearest = errorOf("nearest outline", "medium",
    [](const MesoSceneBuilder& builder) { MapperOf(builder)->SetNearestOutlines(true); });
  MesoScene atVertices = Torus(table, "medium");
  atVertices.Nodes[0].Mesostructure.CurvatureAt = MesoCurvatureAt::Vertex;
  const MesoGeometryError vertices = MesoCompareGeometry(truth, DrawnAOVs(atVertices, Size, Size));
  report("at vertices", vertices);
  EXPECT_NE(vertices.Texcoord.P95, factors.Texcoord.P95);
  EXPECT_GT(vertices.CoverageIou, 0.98);
  EXPECT_LT(vertices.Texcoord.P50, 0.5);
  EXPECT_GT(factors.CoverageIou, 0.99);
  EXPECT_LT(factors.Texcoord.P50, 0.5);
  EXPECT_LT(factors.Texcoord.P95, 4.);
  EXPECT_LT(factors.ShadowCast, 0.1);
  EXPECT_GT(draft.Texcoord.P50, factors.Texcoord.P50);
  EXPECT_NE(flat.ShadowCast, factors.ShadowCast);
  EXPECT_EQ(flat.Texcoord.P95, factors.Texcoord.P95);
  EXPECT_NE(nearest.CoverageIou, factors.CoverageIou);
  EXPECT_GT(nearest.CoverageIou, 0.98);
}
