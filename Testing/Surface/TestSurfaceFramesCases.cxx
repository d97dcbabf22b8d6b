// vtkMesoSurfaceFrames on the smallest meshes that show a case: no area in space or texture, seams,
// mirrored charts in one point, hard edges, doubled sheets, isolated points.

#include "SurfaceArrays.h"

#include "vtkMesoSurfaceFrames.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{
using Coordinates = std::vector<std::array<double, 2>>;
using Cells = std::vector<std::vector<vtkIdType>>;

vtkSmartPointer<vtkPolyData> FramesOf(vtkPolyData* mesh, double featureAngle = -1.)
{
  vtkNew<vtkMesoSurfaceFrames> filter;
  filter->SetInputData(mesh);
  if (featureAngle >= 0.)
  {
    filter->SplitNormalsOn();
    filter->SetFeatureAngle(featureAngle);
  }
  filter->Update();
  return filter->GetOutput();
}

double Valid(vtkPolyData* mesh, vtkIdType i)
{
  return TupleOf(mesh, "MesoFrameValid", i)[0];
}

void ExpectVector(vtkPolyData* mesh, const char* array, vtkIdType i, const MesoVector& expected)
{
  EXPECT_LT(DistanceOf(TupleOf(mesh, array, i), expected), 1e-12) << array << " of point " << i;
}

void ExpectFallback(vtkPolyData* mesh, vtkIdType i, const MesoVector& normal, double scale)
{
  EXPECT_EQ(Valid(mesh, i), 0.) << "point " << i;
  ExpectVector(mesh, "Normals", i, normal);
  const MesoVector tangent = TupleOf(mesh, "MesoTangent", i);
  EXPECT_NEAR(MesoLength(tangent), 1., 1e-12);
  EXPECT_NEAR(MesoDot(tangent, normal), 0., 1e-12);
  ExpectVector(mesh, "MesoBitangent", i, MesoCross(normal, tangent));
  ExpectVector(mesh, "MesoTileScale", i, { scale, scale, 0. });
}

/// The plane 2 x 1 as two squares side by side, with the points of a grid of 3 x 2.
const std::vector<MesoVector> TwoSquares = { { 0., 0., 0. }, { 1., 0., 0. }, { 2., 0., 0. },
  { 0., 1., 0. }, { 1., 1., 0. }, { 2., 1., 0. } };
const Cells TwoSquaresCells = { { 0, 1, 4 }, { 0, 4, 3 }, { 1, 2, 5 }, { 1, 5, 4 } };
const Coordinates TwoSquaresChart = { { 0., 0. }, { 0.5, 0. }, { 1., 0. }, { 0., 0.5 },
  { 0.5, 0.5 }, { 1., 0.5 } };
}

TEST(SurfaceFrames, TextureWithoutAreaHasNoFrame)
{
  Coordinates collapsed = TwoSquaresChart;
  for (auto& coordinate : collapsed)
  {
    coordinate[0] = 0.3;
  }
  const auto frames = FramesOf(MakeMesh(TwoSquares, collapsed, TwoSquaresCells));
  for (vtkIdType i = 0; i < 6; ++i)
  {
    ExpectFallback(frames, i, { 0., 0., 1. }, 1.);
  }
}

TEST(SurfaceFrames, TextureOnALineHasNoFrameInSpiteOfRounding)
{
  Coordinates line;
  for (const MesoVector& p : TwoSquares)
  {
    const double along = (0.37 * p[0] + 0.21 * p[1]) / 3.;
    line.push_back({ 0.1 * along, 0.7 * along });
  }
  const auto frames = FramesOf(MakeMesh(TwoSquares, line, TwoSquaresCells));
  for (vtkIdType i = 0; i < 6; ++i)
  {
    ExpectFallback(frames, i, { 0., 0., 1. }, 1.);
  }
}

TEST(SurfaceFrames, ATriangleWithoutTextureAreaContributesNothing)
{
  Coordinates chart = TwoSquaresChart;
  chart[2] = { 0.5, 0.25 }; // the triangle 1 2 5 has none; 1 5 4 has
  chart[5] = { 0.5, 0.5 };
  chart[4] = { 0.4, 0.6 };
  const auto frames = FramesOf(MakeMesh(TwoSquares, chart, TwoSquaresCells));
  EXPECT_EQ(Valid(frames, 2), 0.);
  EXPECT_EQ(Valid(frames, 0), 1.);
  EXPECT_EQ(Valid(frames, 5), 1.);
  // dp/du and dp/dv of the triangle 1 5 4, the only one that counts at point 5, by hand.
  const MesoVector along = MesoSum(MesoScaled(TupleOf(frames, "MesoTangent", 5),
                                     TupleOf(frames, "MesoTileScale", 5)[0] * (0.4 - 0.5)),
    MesoScaled(
      TupleOf(frames, "MesoBitangent", 5), TupleOf(frames, "MesoTileScale", 5)[1] * (0.6 - 0.5)));
  EXPECT_LT(DistanceOf(along, { -1., 0., 0. }), 1e-12);
}

TEST(SurfaceFrames, TrianglesWithoutAreaContributeNothing)
{
  const auto clean = FramesOf(MakeMesh(TwoSquares, TwoSquaresChart, TwoSquaresCells));
  std::vector<MesoVector> positions = TwoSquares;
  Coordinates chart = TwoSquaresChart;
  positions.push_back({ 0.5, 0., 0. }); // on the line from point 0 to point 1
  chart.push_back({ 0.9, 0.7 });
  Cells cells = TwoSquaresCells;
  cells.push_back({ 0, 6, 1 });
  cells.push_back({ 4, 4, 5 });
  cells.push_back({ 3, 3, 3 });
  const auto frames = FramesOf(MakeMesh(positions, chart, cells));
  for (vtkIdType i = 0; i < 6; ++i)
  {
    EXPECT_EQ(Valid(frames, i), 1.);
    for (const char* array : { "Normals", "MesoTangent", "MesoBitangent", "MesoTileScale" })
    {
      ExpectVector(frames, array, i, TupleOf(clean, array, i));
    }
  }
  ExpectVector(frames, "MesoTileScale", 4, { 2., 2., 0. });
  ExpectFallback(frames, 6, { 0., 0., 1. }, 2.);
  EXPECT_EQ(frames->GetNumberOfPoints(), 7);
  EXPECT_EQ(frames->GetNumberOfPolys(), 7);
}

// Floats of 1e+6 are 1/16 apart: a square of that size is exact there, and no sliver.
TEST(SurfaceFrames, SmallTrianglesFarFromTheOriginInFloatHaveFrames)
{
  std::vector<MesoVector> positions;
  for (const MesoVector& p : TwoSquares)
  {
    positions.push_back(MesoSum(MesoScaled(p, 1. / 16.), { 1e+6, 1e+6, 1e+6 }));
  }
  const auto mesh = MakeMesh(positions, TwoSquaresChart, TwoSquaresCells);
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->DeepCopy(mesh->GetPoints());
  ASSERT_EQ(floats->GetDataType(), VTK_FLOAT);
  mesh->SetPoints(floats);
  const auto frames = FramesOf(mesh);
  for (vtkIdType i = 0; i < 6; ++i)
  {
    EXPECT_EQ(Valid(frames, i), 1.);
    ExpectVector(frames, "MesoTangent", i, { 1., 0., 0. });
    ExpectVector(frames, "MesoTileScale", i, { 0.125, 0.125, 0. });
  }
}

// The point on an edge is there but for a float's rounding: its triangle leans where that leads.
TEST(SurfaceFrames, ASliverOfRoundingContributesNothing)
{
  std::vector<MesoVector> positions = { { 0.1, 0.1, 0. }, { 0.9, 0.7, 0. }, { 0.1, 0.7, 0. },
    { 0.5, 0.4, 2e-8 } };
  const auto mesh = MakeMesh(
    positions, { { 0., 0. }, { 1., 0. }, { 0., 1. }, { 0.5, -0.5 } }, { { 0, 1, 2 }, { 0, 3, 1 } });
  vtkNew<vtkPoints> floats;
  floats->SetDataTypeToFloat();
  floats->DeepCopy(mesh->GetPoints());
  mesh->SetPoints(floats);
  const auto frames = FramesOf(mesh);
  EXPECT_EQ(Valid(frames, 3), 0.);
  ExpectVector(frames, "Normals", 0, { 0., 0., 1. });
  EXPECT_EQ(Valid(frames, 0), 1.);
}

TEST(SurfaceFrames, PointsOfNoTriangleHaveTheMeshsScale)
{
  std::vector<MesoVector> positions = TwoSquares;
  Coordinates chart = TwoSquaresChart;
  positions.push_back({ 5., 5., 5. });
  chart.push_back({ 0., 0. });
  const auto frames = FramesOf(MakeMesh(positions, chart, TwoSquaresCells));
  ExpectFallback(frames, 6, { 0., 0., 1. }, 2.);
  EXPECT_EQ(Valid(frames, 5), 1.);
}

TEST(SurfaceFrames, AChartThatMeetsItsMirrorImageSplitsThePoint)
{
  Coordinates mirrored = TwoSquaresChart;
  mirrored[2][0] = 0.;
  mirrored[5][0] = 0.;
  const auto frames = FramesOf(MakeMesh(TwoSquares, mirrored, TwoSquaresCells));
  ASSERT_EQ(frames->GetNumberOfPoints(), 8);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    EXPECT_EQ(Valid(frames, i), 1.);
    ExpectVector(frames, "MesoTileScale", i, { 2., 2., 0. });
    ExpectVector(frames, "MesoBitangent", i, { 0., 1., 0. });
  }
  const auto triangles = TrianglesOf(frames);
  for (std::size_t t = 0; t < 4; ++t)
  {
    for (vtkIdType corner : triangles[t])
    {
      ExpectVector(frames, "MesoTangent", corner, { t < 2 ? 1. : -1., 0., 0. });
    }
  }
  for (vtkIdType i : { 6, 7 })
  {
    EXPECT_EQ(PositionOf(frames, i)[0], 1.);
    ExpectVector(frames, "uv", i, { 0., 0., 0. }); // has the contract's name now
    EXPECT_EQ(TupleOf(frames, "TextureCoordinates", i)[0], 0.5);
    EXPECT_EQ(TupleOf(frames, "MesoVertex", i)[0], i == 6 ? 1. : 4.);
  }
}

TEST(SurfaceFrames, ASeamIsNoEdgeOfTheSurface)
{
  // A roof of two squares that bend by 60 degrees along a seam: its points are there twice.
  const double s = std::sqrt(0.75);
  const std::vector<MesoVector> roof = { { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. },
    { 0., 1., 0. }, { 1., 0., 0. }, { 1.5, 0., -s }, { 1.5, 1., -s }, { 1., 1., 0. } };
  const Coordinates chart = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. }, { 0., 0. },
    { 0.5, 0. }, { 0.5, 1. }, { 0., 1. } };
  const Cells cells = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } };
  const auto smooth = FramesOf(MakeMesh(roof, chart, cells));
  ASSERT_EQ(smooth->GetNumberOfPoints(), 8);
  for (vtkIdType i : { 1, 2, 4, 7 })
  {
    ExpectVector(smooth, "Normals", i, { 0.5, 0., s });
    ExpectVector(smooth, "MesoTangent", i, { s, 0., -0.5 });
    // Projected by 30 degrees: each chart keeps its own scale.
    ExpectVector(smooth, "MesoTileScale", i, { (i < 4 ? 1. : 2.) * s, 1., 0. });
  }
  EXPECT_EQ(TupleOf(smooth, "MesoVertex", 4)[0], TupleOf(smooth, "MesoVertex", 1)[0]);
  EXPECT_EQ(TupleOf(smooth, "MesoVertex", 7)[0], TupleOf(smooth, "MesoVertex", 2)[0]);
  const auto sharp = FramesOf(MakeMesh(roof, chart, cells), 59.);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    ExpectVector(sharp, "Normals", i, i < 4 ? MesoVector{ 0., 0., 1. } : MesoVector{ s, 0., 0.5 });
    ExpectVector(sharp, "MesoTileScale", i, { i < 4 ? 1. : 2., 1., 0. });
  }
  const auto stillSmooth = FramesOf(MakeMesh(roof, chart, cells), 60.);
  ExpectVector(stillSmooth, "Normals", 1, { 0.5, 0., s });
}

TEST(SurfaceFrames, HardEdgesSplitSharedPoints)
{
  // Two squares that share the points 1 and 4 of one chart, bent by 90 degrees there.
  std::vector<MesoVector> bent = TwoSquares;
  bent[2] = { 1., 0., -1. };
  bent[5] = { 1., 1., -1. };
  const auto sharp = FramesOf(MakeMesh(bent, TwoSquaresChart, TwoSquaresCells), 45.);
  ASSERT_EQ(sharp->GetNumberOfPoints(), 8);
  const auto triangles = TrianglesOf(sharp);
  for (std::size_t t = 0; t < 4; ++t)
  {
    for (vtkIdType corner : triangles[t])
    {
      ExpectVector(
        sharp, "Normals", corner, t < 2 ? MesoVector{ 0., 0., 1. } : MesoVector{ 1., 0., 0. });
      ExpectVector(
        sharp, "MesoTangent", corner, t < 2 ? MesoVector{ 1., 0., 0. } : MesoVector{ 0., 0., -1. });
      ExpectVector(sharp, "MesoTileScale", corner, { 2., 2., 0. });
    }
  }
  EXPECT_EQ(
    FramesOf(MakeMesh(bent, TwoSquaresChart, TwoSquaresCells), 90.)->GetNumberOfPoints(), 6);
}

TEST(SurfaceFrames, CubeHasFaceNormalsOrCornerNormals)
{
  std::vector<MesoVector> positions;
  Coordinates chart;
  Cells cells;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2;
    const double side = face % 2 ? 1. : -1.;
    const auto first = static_cast<vtkIdType>(positions.size());
    for (const auto& [a, b] :
      { std::array<double, 2>{ -1., -1. }, { 1., -1. }, { 1., 1. }, { -1., 1. } })
    {
      MesoVector p;
      p[axis] = side;
      p[(axis + 1) % 3] = a * side;
      p[(axis + 2) % 3] = b;
      positions.push_back(p);
      chart.push_back({ 0.5 + 0.5 * a, 0.5 + 0.5 * b });
    }
    cells.push_back({ first, first + 1, first + 2, first + 3 });
  }
  const auto cube = MakeMesh(positions, chart, cells);
  const auto sharp = FramesOf(cube, 30.);
  const auto smooth = FramesOf(cube);
  ASSERT_EQ(sharp->GetNumberOfPoints(), 24);
  ASSERT_EQ(smooth->GetNumberOfPoints(), 24);
  for (vtkIdType i = 0; i < 24; ++i)
  {
    MesoVector normal = { 0., 0., 0. };
    MesoVector tangent = { 0., 0., 0. };
    const int axis = static_cast<int>(i / 8);
    normal[axis] = (i / 4) % 2 ? 1. : -1.;
    tangent[(axis + 1) % 3] = normal[axis];
    ExpectVector(sharp, "Normals", i, normal);
    ExpectVector(sharp, "MesoTangent", i, tangent);
    ExpectVector(sharp, "MesoBitangent", i, MesoCross(normal, tangent));
    ExpectVector(sharp, "MesoTileScale", i, { 2., 2., 0. });
    EXPECT_EQ(Valid(sharp, i), 1.);
    // However its faces are cut, three right angles meet in each corner.
    ExpectVector(smooth, "Normals", i, MesoScaled(PositionOf(smooth, i), std::sqrt(1. / 3.)));
    EXPECT_EQ(Valid(smooth, i), 1.);
  }
}

TEST(SurfaceFrames, ChartsThatMeetInOnePointByChanceAreSplit)
{
  // Three faces of a cube around a corner, each with its own chart that is (0, 0) there.
  const std::vector<MesoVector> corner = { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. },
    { 0., 0., 1. } };
  const Coordinates chart = { { 0., 0. }, { 1., 0. }, { 0., 1. } };
  const std::vector<MesoVector> positions = { corner[0], corner[1], corner[2], corner[2], corner[3],
    corner[3], corner[1] };
  const auto frames = FramesOf(
    MakeMesh(positions, { chart[0], chart[1], chart[2], chart[1], chart[2], chart[1], chart[2] },
      { { 0, 1, 2 }, { 0, 3, 4 }, { 0, 5, 6 } }));
  ASSERT_EQ(frames->GetNumberOfPoints(), 9);
  const auto triangles = TrianglesOf(frames);
  for (const auto& triangle : triangles)
  {
    EXPECT_EQ(Valid(frames, triangle[0]), 1.);
    // dp/du runs along the triangle's first edge, seen in the plane at right angles to (1, 1, 1).
    const MesoVector along = PositionOf(frames, triangle[1]);
    const MesoVector projected = MesoDifference(along, { 1. / 3., 1. / 3., 1. / 3. });
    ExpectVector(
      frames, "MesoTangent", triangle[0], MesoScaled(projected, 1. / MesoLength(projected)));
  }
}

TEST(SurfaceFrames, SidesOfADoubledSheetHaveTheirOwnNormals)
{
  std::vector<MesoVector> positions(TwoSquares.begin(), TwoSquares.end());
  positions.insert(positions.end(), TwoSquares.begin(), TwoSquares.end());
  Coordinates chart = TwoSquaresChart;
  chart.insert(chart.end(), TwoSquaresChart.begin(), TwoSquaresChart.end());
  Cells cells = TwoSquaresCells;
  for (const auto& cell : TwoSquaresCells)
  {
    cells.push_back({ cell[0] + 6, cell[2] + 6, cell[1] + 6 });
  }
  const auto frames = FramesOf(MakeMesh(positions, chart, cells));
  ASSERT_EQ(frames->GetNumberOfPoints(), 12);
  for (vtkIdType i = 0; i < 12; ++i)
  {
    ExpectVector(frames, "Normals", i, { 0., 0., i < 6 ? 1. : -1. });
    ExpectVector(frames, "MesoTangent", i, { 1., 0., 0. });
    EXPECT_EQ(Valid(frames, i), 1.);
  }
}

TEST(SurfaceFrames, TheCentreOfAPolarChartHasNoFrame)
{
  const int sides = 12;
  std::vector<MesoVector> positions = { { 0., 0., 0. } };
  Coordinates chart = { { 0.5, 0. } };
  Cells cells;
  for (int i = 0; i <= sides; ++i)
  {
    const double angle = 2. * std::acos(-1.) * (i % sides) / sides;
    positions.push_back({ std::cos(angle), std::sin(angle), 0. });
    chart.push_back({ static_cast<double>(i) / sides, 1. });
    if (i > 0)
    {
      cells.push_back({ 0, i, i + 1 });
    }
  }
  const auto frames = FramesOf(MakeMesh(positions, chart, cells));
  EXPECT_EQ(Valid(frames, 0), 0.);
  EXPECT_EQ(Valid(frames, 3), 1.);
  ExpectVector(frames, "Normals", 0, { 0., 0., 1. });
}
