// Where view-dependent displacements break (Documentation/Techniques/VDM.md): by how much, no less and no more,
// against the truth of the same scenes, smaller.

#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"
#include "SceneTable.h"

#include <gtest/gtest.h>

namespace
{
/// A scene of the documentation, its truth, and what techniques draw of it.
class Break
{
public:
  /// layout: of the table, whose size the map has too unless that is larger.
  Break(const std::string& name, const MesoVDMLayout& layout)
    : Scene(MesoReadScene(std::string(MESO_SCENES) + "/Documentation/" + name + ".json"))
  {
    std::array<int, 2>& size = this->Scene.Nodes[0].Map->Size;
    size = size[0] > 128 ? size : std::array<int, 2>{ layout.Width, layout.Height };
    this->Table = std::make_unique<SceneTable>(this->Scene, layout, 8);
    this->Truth = MesoAOVsOfImage(
      MesoReference(this->Scene, MesoReference::Surface::Smooth).Render(Width, Height).AOVs);
  }

  MesoGeometryError ErrorOf(MesoTechnique technique, MesoQuality quality) const
  {
    MesoScene scene = this->Scene;
    scene.Nodes[0].Mesostructure.Technique = technique;
    scene.Nodes[0].Mesostructure.Quality = quality;
    scene.Nodes[0].Baked = technique == MesoTechnique::VDM ? this->Table->GetFile() : "";
    const MesoGeometryError error =
      MesoCompareGeometry(this->Truth, DrawnAOVs(scene, Width, Height));
    std::printf("%-14s overlap %.4f, texels %.2f / %.2f, cast shadows %.4f, extra %zu, void %zu\n",
      MesoName(technique), error.CoverageIou, error.Texcoord.P50, error.Texcoord.P95,
      error.ShadowCast, error.ExtraPixels, error.VoidPixels);
    EXPECT_EQ(error.NanPixels, 0u);
    return error;
  }
  MesoGeometryError OfTable() const
  {
    return this->ErrorOf(MesoTechnique::VDM, MesoQuality::Medium);
  }
  MesoGeometryError OfSearch() const
  {
    return this->ErrorOf(MesoTechnique::ReliefQuadric, MesoQuality::Certified);
  }

private:
  static constexpr int Width = 120;
  static constexpr int Height = 90;

  MesoScene Scene;
  std::unique_ptr<SceneTable> Table;
  MesoAOVs Truth;
};

/// The paper's, of a plane.
MesoVDMLayout FlatLayout()
{
  MesoVDMLayout layout;
  layout.Curvatures = 1;
  layout.FirstCurvature = layout.LastCurvature = 0.;
  return layout;
}

/// Half as fine over the map.
MesoVDMLayout CurvedLayout(double first, int curvatures, int azimuths)
{
  MesoVDMLayout layout;
  layout.Width = layout.Height = 64;
  layout.Azimuths = azimuths;
  layout.Curvatures = curvatures;
  layout.FirstCurvature = first;
  return layout;
}

void ExpectWithin(double value, double low, double high)
{
  EXPECT_GT(value, low);
  EXPECT_LT(value, high);
}
}

TEST(VDMBreaks, AtAnOpenBoundary)
{
  const Break at("VDMOpenBoundary", FlatLayout());
  const MesoGeometryError table = at.OfTable();
  const MesoGeometryError search = at.OfSearch();
  // Rays go on over tiles that are not there: the base is covered, where the truth ends.
  ExpectWithin(table.CoverageIou, 0.89, 0.92);
  EXPECT_EQ(table.VoidPixels, 0u);
  ExpectWithin(double(table.ExtraPixels), 150., 260.);
  // No search knows better; but it places rays of 77 degrees, between which the table is interpolated.
  EXPECT_EQ(search.ExtraPixels, table.ExtraPixels);
  ExpectWithin(table.Texcoord.P50, 2., 4.);
  ExpectWithin(table.Texcoord.P95, 8., 15.);
  EXPECT_LT(search.Texcoord.P95, 0.1);
}

TEST(VDMBreaks, WhereCurvatureChanges)
{
  const Break at("VDMCurvatureChange", CurvedLayout(-1., 6, 16));
  const MesoGeometryError table = at.OfTable();
  const MesoGeometryError search = at.OfSearch();
  ExpectWithin(table.CoverageIou, 0.95, 0.975);
  ExpectWithin(search.CoverageIou, table.CoverageIou + 0.008, 0.99);
  ExpectWithin(table.Texcoord.P95, 1.3 * search.Texcoord.P95, 4.);
}

TEST(VDMBreaks, OnAStretchedChart)
{
  const Break at("VDMStretchedChart", CurvedLayout(0., 4, 32));
  const MesoGeometryError table = at.OfTable();
  const MesoGeometryError search = at.OfSearch();
  ExpectWithin(table.CoverageIou, 0.965, 0.985);
  EXPECT_GT(search.CoverageIou, table.CoverageIou);
  ExpectWithin(table.Texcoord.P95, 1.8 * search.Texcoord.P95, 8.);
}

TEST(VDMBreaks, CloserThanTheTable)
{
  const Break at("VDMCloseUp", FlatLayout());
  const MesoGeometryError table = at.OfTable();
  EXPECT_EQ(table.CoverageIou, 1.);
  ExpectWithin(table.Texcoord.P95, 5., 11.); // four of the map's texels are one of the table's
  ExpectWithin(table.ShadowCast, 0.04, 0.1);
  const MesoGeometryError search = at.OfSearch();
  EXPECT_LT(search.Texcoord.P95, 0.1);
  EXPECT_LT(search.ShadowCast, 0.01);
}
