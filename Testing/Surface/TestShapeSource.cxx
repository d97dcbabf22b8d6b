// vtkMesoShapeSource: the surface is closed where it should be and faces outward, its arrays are
// those of the closed form, and what is unknown is refused in one line.

#include "ErrorRecorder.h"
#include "SurfaceArrays.h"

#include "MesoShape.h"
#include "vtkMesoShapeSource.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace
{
class ShapeSource : public ::testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    this->Recorder.Watch(this->Source);
    this->Source->SetShape(this->GetParam());
    if (this->GetParam() == std::string("plane"))
    {
      this->Source->SetParameter("segments", { 5., 3. });
    }
    this->Source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    this->Source->Update();
    this->Mesh = this->Source->GetOutput();
    ASSERT_GT(this->Mesh->GetNumberOfPolys(), 0);
  }

  ErrorRecorder Recorder;
  vtkNew<vtkMesoShapeSource> Source;
  vtkPolyData* Mesh = nullptr;
};

/// How many triangles run along an edge from one merged vertex to another.
std::map<std::array<double, 2>, int> DirectedEdges(vtkPolyData* mesh)
{
  std::map<std::array<double, 2>, int> edges;
  for (const auto& triangle : TrianglesOf(mesh))
  {
    for (int k = 0; k < 3; ++k)
    {
      const double from = TupleOf(mesh, "MesoVertex", triangle[k])[0];
      const double to = TupleOf(mesh, "MesoVertex", triangle[(k + 1) % 3])[0];
      ++edges[{ from, to }];
    }
  }
  return edges;
}
}

TEST_P(ShapeSource, TrianglesFaceOutwardAndHaveArea)
{
  for (const auto& triangle : TrianglesOf(this->Mesh))
  {
    const MesoVector a = PositionOf(this->Mesh, triangle[0]);
    const MesoVector normal = MesoCross(MesoDifference(PositionOf(this->Mesh, triangle[1]), a),
      MesoDifference(PositionOf(this->Mesh, triangle[2]), a));
    ASSERT_GT(MesoLength(normal), 1e-6);
    for (vtkIdType corner : triangle)
    {
      // 0.9: a facet of the coarsest shape here leans by less than 20 degrees from its corners.
      ASSERT_GT(MesoDot(normal, TupleOf(this->Mesh, "Normals", corner)), 0.9 * MesoLength(normal));
    }
  }
}

TEST_P(ShapeSource, IsWatertightByVertex)
{
  const auto edges = DirectedEdges(this->Mesh);
  int open = 0;
  for (const auto& [edge, count] : edges)
  {
    ASSERT_NE(edge[0], edge[1]);
    ASSERT_EQ(count, 1);
    open += edges.count({ edge[1], edge[0] }) == 0 ? 1 : 0;
  }
  const std::map<std::string, int> expected = { { "plane", 2 * (5 + 3) }, { "sphere", 0 },
    { "cylinder", 2 * 48 }, { "torus", 0 } };
  EXPECT_EQ(open, expected.at(this->GetParam()));
}

TEST_P(ShapeSource, VerticesNumberPositions)
{
  std::map<double, MesoVector> positions;
  std::set<MesoVector> different;
  for (vtkIdType i = 0; i < this->Mesh->GetNumberOfPoints(); ++i)
  {
    MesoVector position = PositionOf(this->Mesh, i);
    for (double& component : position)
    {
      component += 0.; // -0 becomes 0
    }
    const auto entry = positions.emplace(TupleOf(this->Mesh, "MesoVertex", i)[0], position).first;
    EXPECT_EQ(entry->second, position) << "point " << i;
    different.insert(position);
  }
  EXPECT_EQ(positions.size(), different.size());
  EXPECT_EQ(positions.begin()->first, 0.);
  EXPECT_EQ(positions.rbegin()->first, static_cast<double>(positions.size() - 1));
}

TEST_P(ShapeSource, TextureCoordinatesCoverTheUnitSquare)
{
  vtkDataArray* coordinates = this->Mesh->GetPointData()->GetTCoords();
  ASSERT_NE(coordinates, nullptr);
  EXPECT_STREQ(coordinates->GetName(), "TextureCoordinates");
  for (int k = 0; k < 2; ++k)
  {
    double range[2];
    coordinates->GetRange(range, k);
    EXPECT_EQ(range[0], 0.);
    EXPECT_EQ(range[1], 1.);
  }
  double area = 0.;
  for (const auto& triangle : TrianglesOf(this->Mesh))
  {
    const MesoVector a = TupleOf(this->Mesh, "TextureCoordinates", triangle[0]);
    const MesoVector b = TupleOf(this->Mesh, "TextureCoordinates", triangle[1]);
    const MesoVector c = TupleOf(this->Mesh, "TextureCoordinates", triangle[2]);
    const double part = 0.5 * MesoCross(MesoDifference(b, a), MesoDifference(c, a))[2];
    ASSERT_GT(part, 0.);
    area += part;
  }
  // A pole's triangles leave out half of their ring.
  const double missing = this->GetParam() == std::string("sphere") ? 1. / 24. : 0.;
  EXPECT_NEAR(area, 1. - missing, 1e-12);
}

TEST_P(ShapeSource, FramesAreThoseOfFiniteDifferences)
{
  const MesoShape shape(this->GetParam());
  const double h = 1e-5; // the error of central differences is then about 1e-9
  for (vtkIdType i = 0; i < this->Mesh->GetNumberOfPoints(); i += 7)
  {
    const MesoVector uv = TupleOf(this->Mesh, "TextureCoordinates", i);
    const auto along = [&](double du, double dv)
    {
      return MesoScaled(MesoDifference(shape.At(uv[0] + du, uv[1] + dv).Position,
                          shape.At(uv[0] - du, uv[1] - dv).Position),
        0.5 / h);
    };
    const MesoVector scale = TupleOf(this->Mesh, "MesoTileScale", i);
    const bool pole = this->GetParam() == std::string("sphere") && (uv[1] == 0. || uv[1] == 1.);
    if (!pole)
    {
      const MesoVector tangent = MesoScaled(TupleOf(this->Mesh, "MesoTangent", i), scale[0]);
      EXPECT_LT(DistanceOf(along(h, 0.), tangent), 1e-6) << "point " << i;
      EXPECT_LT(
        DistanceOf(along(0., h), MesoScaled(TupleOf(this->Mesh, "MesoBitangent", i), scale[1])),
        1e-6)
        << "point " << i;
      const MesoVector normal = MesoCross(along(h, 0.), along(0., h));
      EXPECT_LT(
        DistanceOf(MesoScaled(normal, 1. / MesoLength(normal)), TupleOf(this->Mesh, "Normals", i)),
        1e-6)
        << "point " << i;
    }
    EXPECT_GT(scale[0], 0.);
    EXPECT_EQ(TupleOf(this->Mesh, "MesoFrameValid", i)[0], 1.);
  }
}

INSTANTIATE_TEST_SUITE_P(
  All, ShapeSource, ::testing::Values("plane", "sphere", "cylinder", "torus"));

TEST(ShapeSourcePoles, HaveAPointASegmentAndTheScaleOfHalfARingAway)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape("sphere");
  source->SetParameter("sides", { 8. });
  source->SetParameter("rings", { 6. });
  source->Update();
  vtkPolyData* mesh = source->GetOutput();
  EXPECT_EQ(mesh->GetNumberOfPoints(), 2 * 8 + 5 * 9);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2 * 8 * 5);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  const double scale = MesoShape("sphere").At(0., 0.5 / 6.).Scale[0];
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const vtkIdType north = mesh->GetNumberOfPoints() - 8 + i;
    EXPECT_NEAR(TupleOf(mesh, "TextureCoordinates", i)[0], (i + 0.5) / 8., 1e-7);
    EXPECT_EQ(TupleOf(mesh, "MesoVertex", i)[0], 0.);
    EXPECT_EQ(TupleOf(mesh, "MesoVertex", north)[0], 1. + 5. * 8.);
    EXPECT_NEAR(TupleOf(mesh, "MesoTileScale", i)[0], scale, 1e-6);
    EXPECT_NEAR(TupleOf(mesh, "MesoTileScale", north)[0], scale, 1e-6);
  }
}

TEST(ShapeSourceErrors, AreOneLineAndGiveNothing)
{
  ErrorRecorder recorder;
  vtkNew<vtkMesoShapeSource> source;
  recorder.Watch(source);
  const auto expect = [&](const char* part)
  {
    recorder.Clear();
    source->Update();
    ASSERT_EQ(recorder.Errors.size(), 1u);
    EXPECT_NE(recorder.Errors[0].find(part), std::string::npos) << recorder.Errors[0];
    EXPECT_NE(source->GetErrorMessage().find(part), std::string::npos);
    EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_EQ(source->GetOutput()->GetNumberOfCells(), 0);
  };
  source->Update();
  EXPECT_EQ(source->GetOutput()->GetNumberOfPolys(), 2);
  source->SetShape("teapot");
  expect("unknown shape 'teapot'");
  source->SetShape(nullptr);
  expect("unknown shape ''");
  source->SetShape("sphere");
  source->SetParameter("tube", { 1. });
  expect("unknown key 'tube'");
  source->ClearParameters();
  source->SetParameter("rings", { 1.5 });
  expect("'rings' is 1.5");
  source->SetParameter("rings", { 4. });
  recorder.Clear();
  source->Update();
  EXPECT_TRUE(recorder.Errors.empty());
  EXPECT_GT(source->GetOutput()->GetNumberOfPolys(), 0);
}

TEST(ShapeSourceTime, ChangesWithValuesOnly)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetParameter("size", { 2., 3. });
  const vtkMTimeType time = source->GetMTime();
  source->SetShape("plane");
  source->SetParameter("size", { 2., 3. });
  EXPECT_EQ(source->GetMTime(), time);
  source->SetParameter("size", { 2., 4. });
  EXPECT_GT(source->GetMTime(), time);
  source->Update();
  EXPECT_DOUBLE_EQ(source->GetOutput()->GetBounds()[3], 2.);
}
