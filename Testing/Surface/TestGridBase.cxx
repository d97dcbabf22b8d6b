// What triangles are cut into: grids of neighbours that are cut differently close without gap or fold, cut
// by the edge alone, no finer than picture and map ask for.

#include "MesoGridBase.h"
#include "MesoKernels.h"
#include "SurfaceArrays.h"
#include "vtkMesoShapeSource.h"

#include "vtkFloatArray.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace
{
vtkSmartPointer<vtkPolyData> Shape(const char* name, int rings, int sides)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape(name);
  source->SetParameter("rings", { double(rings) });
  source->SetParameter("sides", { double(sides) });
  source->Update();
  return source->GetOutput();
}

/// From (0, 0, distance) down the z axis, 400 pixels high, 90 degrees wide.
MesoGridView ViewFrom(double distance)
{
  MesoGridView view;
  view.ModelToView = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -distance, 0, 0, 0, 1 };
  view.Projection = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002, -0.2, 0, 0, -1, 0 };
  view.Near = 0.1;
  view.Height = 400.;
  return view;
}

/// A point of the surface: a vertex, a step on an edge, or a place inside a triangle.
using Place = std::array<std::int64_t, 4>;

struct Cut
{
  std::map<std::array<Place, 2>, int> Edges; ///< directed, and how often
  int Triangles = 0;
  int Folds = 0;
  int Open = 0;
};

/// Makes all triangles of the pieces as the vertex stage does.
Cut CutInto(const MesoGridBase& base, vtkPolyData* mesh, const MesoGridPieces& pieces)
{
  vtkDataArray* vertices = mesh->GetPointData()->GetArray("MesoVertex");
  const auto indices = MesoGridBase::MakeIndices();
  const MesoKernels::Float::Grid kernel;
  Cut cut;
  for (const MesoGridPieces::Group& group : pieces.Groups)
  {
    for (int piece = group.First; piece < group.First + group.Count; ++piece)
    {
      const float* numbers = &pieces.Numbers[8 * piece];
      const auto triangle = static_cast<std::int64_t>(numbers[0]);
      const int rows = int(numbers[3]);
      const auto vertex = [&](int corner) {
        return static_cast<std::int64_t>(
          vertices->GetTuple1(base.GetTriangles()[triangle][corner]));
      };
      std::array<double, 2> flat; // where the last point lies in the triangle
      const auto onEdge = [&](int k, int step) -> Place
      {
        const int segments = int(numbers[4 + k]);
        const int along = kernel.stepOnEdge(step, rows, segments);
        const int next = (k + 1) % 3;
        const int from = segments < 0 ? next : k;
        const int to = segments < 0 ? k : next;
        const double part = double(along) / std::abs(segments);
        const double corners[3][2] = { { 0., 0. }, { 1., 0. }, { 0., 1. } };
        for (int i = 0; i < 2; ++i)
        {
          flat[i] = corners[from][i] + part * (corners[to][i] - corners[from][i]);
        }
        if (along == 0 || along == std::abs(segments))
        {
          return { vertex(along == 0 ? from : to), -1, -1, -1 };
        }
        EXPECT_LT(vertex(from), vertex(to));
        return { vertex(from), vertex(to), along, std::abs(segments) };
      };
      const auto place = [&](int index) -> Place
      {
        const glm::ivec2 local = kernel.latticePoint(index);
        const int i = int(numbers[1]) + int(numbers[7]) * local.x;
        const int j = int(numbers[2]) + int(numbers[7]) * local.y;
        if (j == 0)
        {
          return onEdge(0, i);
        }
        if (i == 0)
        {
          return onEdge(2, rows - j);
        }
        if (i + j == rows)
        {
          return onEdge(1, j);
        }
        EXPECT_TRUE(i > 0 && j > 0 && i + j < rows);
        flat = { double(i) / rows, double(j) / rows };
        return { -1, triangle, i, j };
      };
      for (int first = 0; first < 3 * group.Rows * group.Rows; first += 3)
      {
        Place places[3];
        std::array<double, 2> at[3];
        for (int k = 0; k < 3; ++k)
        {
          places[k] = place(indices[first + k]);
          at[k] = flat;
        }
        const double area = (at[1][0] - at[0][0]) * (at[2][1] - at[0][1]) -
          (at[1][1] - at[0][1]) * (at[2][0] - at[0][0]);
        cut.Folds += area < -1e-9 ? 1 : 0;
        if (places[0] == places[1] || places[1] == places[2] || places[2] == places[0])
        {
          continue;
        }
        ++cut.Triangles;
        for (int k = 0; k < 3; ++k)
        {
          ++cut.Edges[{ places[k], places[(k + 1) % 3] }];
        }
      }
    }
  }
  for (const auto& edge : cut.Edges)
  {
    const auto back = cut.Edges.find({ edge.first[1], edge.first[0] });
    cut.Open += back == cut.Edges.end() || back->second != edge.second ? 1 : 0;
  }
  return cut;
}
}

TEST(GridBase, EvenTexelsGiveEvenGrids)
{
  const auto mesh = Shape("torus", 12, 6);
  const MesoGridBase base(mesh);
  MesoGridSize size;
  size.Texels = { 12. * 8., 6. * 8. }; // 8 texels along each side of the quads
  const MesoGridPieces pieces = base.PiecesFor(size, nullptr);
  EXPECT_EQ(pieces.Groups.size(), 1u);
  EXPECT_EQ(pieces.Triangles, 2 * 12 * 6 * 64);
  const Cut cut = CutInto(base, mesh, pieces);
  EXPECT_EQ(cut.Triangles, pieces.Triangles);
  EXPECT_EQ(cut.Open, 0);
  EXPECT_EQ(cut.Folds, 0);
}

TEST(GridBase, LatticesOfManyRowsAreCutIntoPieces)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape("plane");
  source->Update();
  const MesoGridBase base(source->GetOutput());
  MesoGridSize size;
  for (const double texels : { 64., 65., 96., 127., 256. })
  {
    size.Texels = { texels, texels };
    const MesoGridPieces pieces = base.PiecesFor(size, nullptr);
    for (const auto& group : pieces.Groups)
    {
      EXPECT_LE(group.Rows, MesoGridBase::MostRows);
    }
    // 65 and 127 have no divisor that would do: a row is added.
    const double rows = texels == 65. || texels == 127. ? texels + 1. : texels;
    EXPECT_EQ(pieces.Triangles, std::int64_t(2 * rows * rows)) << texels;
    const Cut cut = CutInto(base, source->GetOutput(), pieces);
    EXPECT_EQ(cut.Folds, 0) << texels;
    EXPECT_EQ(cut.Open, 4 * int(texels)) << texels; // the plane's own edge
  }
}

TEST(GridBase, NeighboursOfDifferentLevelsClose)
{
  for (const char* shape : { "torus", "sphere" })
  {
    const auto mesh = Shape(shape, 12, 7);
    const MesoGridBase base(mesh);
    MesoGridSize size;
    size.Texels = { 400., 300. };
    size.FacetPixels = 6.;
    for (const double distance : { 1.6, 2.5, 20. })
    {
      MesoGridView view = ViewFrom(distance);
      const MesoGridPieces all = base.PiecesFor(size, nullptr);
      // The whole surface, from a lens so wide that all is inside.
      view.Projection[0] = 1e-3;
      view.Projection[5] = 1e-3;
      view.Height = 4e5;
      const MesoGridPieces pieces = base.PiecesFor(size, &view);
      std::set<int> rows;
      for (const auto& group : pieces.Groups)
      {
        rows.insert(group.Rows);
      }
      if (distance < 2.)
      {
        EXPECT_GT(rows.size(), 4u) << "the levels are mixed";
      }
      EXPECT_LT(pieces.Triangles, all.Triangles);
      const Cut cut = CutInto(base, mesh, pieces);
      EXPECT_EQ(cut.Open, 0) << shape << " " << distance;
      EXPECT_EQ(cut.Folds, 0) << shape << " " << distance;
    }
  }
}

TEST(GridBase, SegmentsAreNoLongerOnTheScreenThanAsked)
{
  const auto mesh = Shape("torus", 12, 7);
  const MesoGridBase base(mesh);
  MesoGridSize size;
  size.Texels = { 1e4, 1e4 };
  size.FacetPixels = 4.;
  const MesoGridView view = ViewFrom(4.);
  const MesoGridPieces pieces = base.PiecesFor(size, &view);
  int tooLong = 0;
  int needless = 0;
  for (std::size_t piece = 0; piece < pieces.Numbers.size() / 8; ++piece)
  {
    const float* numbers = &pieces.Numbers[8 * piece];
    const auto& corners = base.GetTriangles()[std::size_t(numbers[0])];
    for (int k = 0; k < 3; ++k)
    {
      const MesoVector& a = base.GetPositions()[corners[k]];
      const MesoVector& b = base.GetPositions()[corners[(k + 1) % 3]];
      const double nearer = 4. - std::max(a[2], b[2]);
      const double pixels = MesoLength(MesoDifference(a, b)) * 200. / nearer;
      const double ofSegment = pixels / std::abs(numbers[4 + k]);
      tooLong += ofSegment > 4.01 ? 1 : 0;
      needless += std::abs(numbers[4 + k]) > 2 && ofSegment < 2. ? 1 : 0;
    }
  }
  EXPECT_GT(pieces.Numbers.size(), 100u);
  EXPECT_EQ(tooLong, 0);
  EXPECT_EQ(needless, 0);
}

TEST(GridBase, WhatLiesOutsideOfThePictureIsLeftOut)
{
  const auto mesh = Shape("torus", 24, 12);
  const MesoGridBase base(mesh);
  MesoGridSize size;
  size.FacetPixels = 50.;
  MesoGridView view = ViewFrom(3.);
  const auto triangles = [&]()
  {
    std::set<int> drawn;
    const MesoGridPieces pieces = base.PiecesFor(size, &view);
    for (std::size_t piece = 0; piece < pieces.Numbers.size() / 8; ++piece)
    {
      drawn.insert(int(pieces.Numbers[8 * piece]));
    }
    return drawn.size();
  };
  EXPECT_EQ(triangles(), 2u * 24 * 12);
  view.ModelToView[3] = 2.5; // to the right
  const std::size_t part = triangles();
  EXPECT_GT(part, 100u);
  EXPECT_LT(part, 450u);
  view.ModelToView[3] = 30.;
  EXPECT_EQ(triangles(), 0u);
  size.Reach = 40.; // what is displaced as far may be seen
  EXPECT_GT(triangles(), 0u);
  size.Reach = 0.;
  view = ViewFrom(-3.); // behind the eye
  EXPECT_EQ(triangles(), 0u);
}

TEST(GridBase, PointsOfAVertexAreOne)
{
  const auto mesh = Shape("torus", 12, 6);
  // As another program may write them: apart by roundings at the seam.
  vtkNew<vtkPolyData> rounded;
  rounded->DeepCopy(mesh);
  auto* normals = vtkFloatArray::SafeDownCast(rounded->GetPointData()->GetNormals());
  ASSERT_TRUE(normals);
  vtkDataArray* vertices = rounded->GetPointData()->GetArray("MesoVertex");
  std::map<double, std::vector<vtkIdType>> points;
  for (vtkIdType i = 0; i < rounded->GetNumberOfPoints(); ++i)
  {
    points[vertices->GetTuple1(i)].push_back(i);
    normals->SetComponent(i, 0, normals->GetComponent(i, 0) + (i % 2 ? 6e-8 : 0.));
  }
  const MesoGridBase base(rounded);
  int shared = 0;
  for (const auto& vertex : points)
  {
    for (const vtkIdType point : vertex.second)
    {
      shared += point != vertex.second[0] ? 1 : 0;
      EXPECT_EQ(base.GetNormals()[point], base.GetNormals()[vertex.second[0]]);
      EXPECT_EQ(base.GetPositions()[point], base.GetPositions()[vertex.second[0]]);
    }
  }
  EXPECT_GT(shared, 10);
}

TEST(GridBase, RefusesWhatItCannotCut)
{
  const auto mesh = Shape("torus", 12, 6);
  const auto message = [](const auto& work) -> std::string
  {
    try
    {
      work();
    }
    catch (const std::invalid_argument& problem)
    {
      return problem.what();
    }
    return "nothing";
  };
  vtkNew<vtkPolyData> bare;
  bare->DeepCopy(mesh);
  bare->GetPointData()->SetTCoords(nullptr);
  bare->GetPointData()->RemoveArray("TextureCoordinates");
  EXPECT_EQ(message([&] { MesoGridBase base(bare); }), "the mesh has no texture coordinates");
  vtkNew<vtkPolyData> dark;
  dark->DeepCopy(mesh);
  dark->GetPointData()->RemoveArray("Normals");
  EXPECT_EQ(message([&] { MesoGridBase base(dark); }), "the mesh has no normals");
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(mesh);
  broken->GetPoints()->SetPoint(5, std::nan(""), 0., 0.);
  EXPECT_EQ(message([&] { MesoGridBase base(broken); }),
    "the position of point 5 is not finite (nan, 0, 0)");
  MesoGridSize size;
  size.Texels = { 1e5, 1e5 };
  EXPECT_EQ(message([&] { MesoGridBase(mesh).PiecesFor(size, nullptr); }),
    "the surface would be cut into more than 100000000 triangles; take fewer facets a texel or "
    "more "
    "pixels a facet");
  size.Texels = { 1e9, 1e9 };
  EXPECT_EQ(message([&] { MesoGridBase(mesh).PiecesFor(size, nullptr); }),
    "an edge of the mesh would be cut into more than 1000000 segments");
}

TEST(GridBase, AnEmptyMeshHasNoPieces)
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  empty->GetPointData()->SetNormals(normals);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  empty->GetPointData()->SetTCoords(coordinates);
  const MesoGridBase base(empty);
  EXPECT_TRUE(base.PiecesFor({}, nullptr).Groups.empty());
}
