// Figures 9, 14, 15 and 17 of Oliveira2005: outlines that are those of the relief, and the meshes that they
// differ from. Documentation/Techniques/ReliefFigures.md shows the pictures.

#include "PaperFigure.h"

#include "MesoOutline.h"

#include <cmath>

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Pixels of the mesh that a rendering leaves out.
std::size_t LeftOut(const MesoAOVs& mesh, const MesoAOVs& drawn)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.NumberOfPixels(); ++i)
  {
    count += Covers(mesh, i) && !Covers(drawn, i) ? 1 : 0;
  }
  return count;
}

/// The same count for the truth, the quadric and the tangent plane.
struct Fragments
{
  std::size_t Truth;
  std::size_t Quadric;
  std::size_t Plane;
  std::size_t OffTruth; ///< left out, away by more than three pixels from what the truth leaves out
};

Fragments FragmentsOf(const PaperFigure& figure)
{
  const MesoAOVs mesh = figure.Drawn(MesoTechnique::Plain);
  const MesoAOVs quadric = figure.Drawn(MesoTechnique::ReliefQuadric);
  std::vector<bool> covered;
  for (std::size_t i = 0; i < mesh.NumberOfPixels(); ++i)
  {
    covered.push_back(Covers(figure.Truth(), i));
  }
  const MesoOutline outline(covered, figure.Width, figure.Height);
  std::size_t off = 0;
  for (int row = 0; row < figure.Height; ++row)
  {
    for (int column = 0; column < figure.Width; ++column)
    {
      const std::size_t i = std::size_t(row) * figure.Width + column;
      off += Covers(mesh, i) && !Covers(quadric, i) && covered[i] &&
          outline.DistanceOfPixel(column, row) > 3.
        ? 1
        : 0;
    }
  }
  const Fragments result = { LeftOut(mesh, figure.Truth()), LeftOut(mesh, quadric),
    LeftOut(mesh, figure.Drawn(MesoTechnique::Relief)), off };
  std::cout << "pixels of the mesh that are left out: truth " << result.Truth << ", relief-quadric "
            << result.Quadric << ", relief " << result.Plane << ", away from the truth's outline "
            << result.OffTruth << "\n";
  return result;
}

void Print(const char* what, const MesoGeometryError& error)
{
  std::cout << what << ": iou " << error.CoverageIou << ", outline " << error.SilhouetteMean
            << " px, texel p50 " << error.Texcoord.P50 << " p95 " << error.Texcoord.P95
            << ", depth p95 " << error.Depth.P95 << ", holes " << error.HolePixels << "\n";
}
}

TEST(PaperOutlines, Figure9OfACylinderAndATeapotChangeWithTheQuadric)
{
  for (const char* name : { "FigureCylinder", "FigureTeapot" })
  {
    const PaperFigure figure(name);
    const MesoGeometryError plane = figure.ErrorOf(figure.Drawn(MesoTechnique::Relief));
    const MesoGeometryError quadric = figure.ErrorOf(figure.Drawn(MesoTechnique::ReliefQuadric));
    Print((std::string(name) + " relief").c_str(), plane);
    Print((std::string(name) + " relief-quadric").c_str(), quadric);
    EXPECT_GT(quadric.CoverageIou, 0.9) << name;
    EXPECT_LT(1. - quadric.CoverageIou, 0.8 * (1. - plane.CoverageIou)) << name;
    EXPECT_LT(quadric.SilhouetteMean, 0.7 * plane.SilhouetteMean) << name;

    const Fragments fragments = FragmentsOf(figure);
    EXPECT_EQ(fragments.Plane, 0u) << name; // the mesh's own outline
    EXPECT_GT(fragments.Quadric, 100u) << name;
    EXPECT_TRUE(MesoCompareWithMeshPicture(figure.Scene, std::string(name) + "Mesh", 240, 180))
      << name;
  }
}

TEST(PaperOutlines, Figure14OfASaddleRegion)
{
  const PaperFigure figure("FigureSaddle");
  const MesoAOVs plane = figure.Drawn(MesoTechnique::Relief);
  const MesoAOVs quadric = figure.Drawn(MesoTechnique::ReliefQuadric);
  const MesoGeometryError planeError = figure.ErrorOf(plane);
  const MesoGeometryError quadricError = figure.ErrorOf(quadric);
  Print("relief", planeError);
  Print("relief-quadric", quadricError);
  EXPECT_LT(1. - quadricError.CoverageIou, 0.5 * (1. - planeError.CoverageIou));

  EXPECT_LT(quadricError.Texcoord.P95, 0.8 * planeError.Texcoord.P95);

  // The outline is that of a saddle: what the quadric leaves out of the mesh lies on the side of its tube
  // that looks at its axis, and as much of it as in truth.
  const double tiles = figure.Scene.Nodes[0].Mesostructure.Tiles[1];
  std::size_t ofTruth = 0;
  std::size_t ofQuadric = 0;
  std::size_t elsewhere = 0;
  for (std::size_t i = 0; i < plane.NumberOfPixels(); ++i)
  {
    if (!Covers(plane, i))
    {
      continue;
    }
    const bool isSaddle =
      std::cos(2. * Pi * double(plane.Texcoord[1][i]) / tiles) > 0.; // 0 looks at the axis
    ofTruth += isSaddle && !Covers(figure.Truth(), i) ? 1 : 0;
    ofQuadric += isSaddle && !Covers(quadric, i) ? 1 : 0;
    elsewhere += !isSaddle && !Covers(quadric, i) ? 1 : 0;
  }
  std::cout << "left out where the curvature is negative: truth " << ofTruth << ", relief-quadric "
            << ofQuadric << " (elsewhere " << elsewhere << ")\n";
  EXPECT_GT(ofTruth, 150u);
  EXPECT_NEAR(double(ofQuadric), double(ofTruth), 0.15 * double(ofTruth));
  EXPECT_TRUE(MesoCompareWithMeshPicture(figure.Scene, "FigureSaddleMesh", 240, 180));
}

TEST(PaperOutlines, Figure15TheMeshOfATorusShowsFragmentsThatAreNotDrawn)
{
  const PaperFigure figure("FigureTorus");
  const Fragments fragments = FragmentsOf(figure);
  EXPECT_EQ(fragments.Plane, 0u);
  EXPECT_GT(fragments.Truth, 300u);
  EXPECT_NEAR(double(fragments.Quadric), double(fragments.Truth), 0.15 * double(fragments.Truth));
  EXPECT_EQ(fragments.OffTruth, 0u);
  EXPECT_TRUE(MesoCompareWithMeshPicture(figure.Scene, "FigureTorusMesh", 320, 240));
}

TEST(PaperOutlines, Figure17MeshesOverSeveralObjects)
{
  const PaperFigure figure("FigureObjects", 200, 75);
  const MesoGeometryError plane = figure.ErrorOf(figure.Drawn(MesoTechnique::Relief));
  const MesoGeometryError quadric = figure.ErrorOf(figure.Drawn(MesoTechnique::ReliefQuadric));
  Print("relief", plane);
  Print("relief-quadric", quadric);
  EXPECT_LT(1. - quadric.CoverageIou, 0.5 * (1. - plane.CoverageIou));
  const Fragments fragments = FragmentsOf(figure);
  EXPECT_EQ(fragments.Plane, 0u);
  EXPECT_NEAR(double(fragments.Quadric), double(fragments.Truth), 0.2 * double(fragments.Truth));
  EXPECT_LE(fragments.OffTruth, 3u);
  EXPECT_TRUE(MesoCompareWithMeshPicture(figure.Scene, "FigureObjectsMesh", 400, 150));
}
