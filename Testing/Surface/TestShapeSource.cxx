// vtkMesoShapeSource: the surface is closed where it should be and faces outward, its arrays are
// those of the closed form, and what is unknown is refused in one line.

#include "ErrorRecorder.h"
#include "SurfaceArrays.h"

#include "MesoShape.h"
#include "vtkMesoShapeSource.h"

#include <gtest/gtest.h>

#include "vtkStaticPointLocator.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>

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
      // A facet of the coarsest shape leans by less than 25 degrees from its corners; at the lip of
      // the teapot's spout, which folds over within two quads, by less than 79.
      const double least = this->GetParam() == std::string("teapot") ? 0.2 : 0.9;
      ASSERT_GT(
        MesoDot(normal, TupleOf(this->Mesh, "Normals", corner)), least * MesoLength(normal));
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
  const std::map<std::string, int> expected = { { "plane", 2 * (5 + 3) }, { "cylinder", 2 * 48 },
    { "cone", 48 }, { "vase", 2 * 72 }, { "undulating", 4 * 48 },
    // Rim and lid, both ends of handle and spout; where shoots begin.
    { "teapot", 2 * 4 * 8 + 4 * 2 * 8 }, { "branch", 2 * 16 } };
  const auto known = expected.find(this->GetParam());
  EXPECT_EQ(open, known == expected.end() ? 0 : known->second);
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

TEST_P(ShapeSource, TextureCoordinatesCoverTheirChartsOnce)
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
  double expected = 0.;
  const std::vector<MesoShapeChart> charts = MesoShape(this->GetParam()).Charts();
  for (const MesoShapeChart& chart : charts)
  {
    const double cell = (chart.High[0] - chart.Low[0]) * (chart.High[1] - chart.Low[1]);
    // A pole's triangles leave out half of their ring.
    const double poles = (chart.PoleAtStart ? 0.5 : 0.) + (chart.PoleAtEnd ? 0.5 : 0.);
    expected += cell * (1. - poles / chart.Segments[1]);
  }
  EXPECT_NEAR(area, expected, 1e-12);
  // Cells of different charts meet in no more than their edges.
  for (std::size_t i = 0; i < charts.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      bool apart = false;
      for (int k = 0; k < 2; ++k)
      {
        apart = apart || charts[i].Low[k] >= charts[j].High[k] - 1e-15 ||
          charts[j].Low[k] >= charts[i].High[k] - 1e-15;
      }
      EXPECT_TRUE(apart) << i << " " << j;
    }
  }
}

TEST_P(ShapeSource, FramesAreThoseOfFiniteDifferences)
{
  const MesoShape shape(this->GetParam());
  const double h = 1e-5; // the error of central differences is then about 1e-9
  std::mt19937 engine(7);
  const auto random = [&] { return 0.001 + 0.998 * static_cast<double>(engine()) / 4294967296.; };
  for (std::size_t chart = 0; chart < shape.Charts().size(); ++chart)
  {
    const MesoShapeChart& cell = shape.Charts()[chart];
    for (int i = 0; i < 100; ++i)
    {
      const double a = random();
      const double b = random();
      const auto along = [&](double da, double db, double width)
      {
        return MesoScaled(MesoDifference(shape.InChart(chart, a + da, b + db).Position,
                            shape.InChart(chart, a - da, b - db).Position),
          0.5 / h / width);
      };
      const MesoVector pu = along(h, 0., cell.High[0] - cell.Low[0]);
      const MesoVector pv = along(0., h, cell.High[1] - cell.Low[1]);
      const MesoShapePoint point = shape.InChart(chart, a, b);
      const double size = point.Scale[0] + point.Scale[1];
      ASSERT_LT(DistanceOf(pu, MesoScaled(point.Tangent, point.Scale[0])), 1e-7 * size)
        << chart << " " << a << " " << b;
      ASSERT_LT(DistanceOf(pv, MesoScaled(point.Bitangent, point.Scale[1])), 1e-7 * size)
        << chart << " " << a << " " << b;
      const MesoVector normal = MesoCross(pu, pv);
      // Near a pole dp/du is known less well.
      const double known = 1e-7 * size / std::min(point.Scale[0], point.Scale[1]);
      ASSERT_LT(DistanceOf(MesoScaled(normal, 1. / MesoLength(normal)), point.Normal), known)
        << chart << " " << a << " " << b;
      ASSERT_NEAR(MesoLength(point.Normal), 1., 1e-14);
    }
  }
}

TEST_P(ShapeSource, ArraysAreThoseOfTheShape)
{
  const MesoShape shape(this->GetParam());
  for (vtkIdType i = 0; i < this->Mesh->GetNumberOfPoints(); ++i)
  {
    for (const char* array : { "Normals", "MesoTangent", "MesoBitangent" })
    {
      ASSERT_NEAR(MesoLength(TupleOf(this->Mesh, array, i)), 1., 1e-14) << array << " " << i;
    }
    ASSERT_GT(TupleOf(this->Mesh, "MesoTileScale", i)[0], 0.) << i;
    ASSERT_GT(TupleOf(this->Mesh, "MesoTileScale", i)[1], 0.) << i;
    ASSERT_EQ(TupleOf(this->Mesh, "MesoFrameValid", i)[0], 1.);
  }
  if (shape.Charts().size() == 1)
  {
    for (vtkIdType i = 0; i < this->Mesh->GetNumberOfPoints(); i += 7)
    {
      const MesoVector uv = TupleOf(this->Mesh, "TextureCoordinates", i);
      EXPECT_EQ(shape.At(uv[0], uv[1]).Position, PositionOf(this->Mesh, i));
    }
  }
}

TEST_P(ShapeSource, BendsBoundDerivativesOfTheShape)
{
  const MesoShape shape(this->GetParam());
  if (!shape.HasBends())
  {
    EXPECT_TRUE(shape.IsFlat() || shape.Charts().size() > 1);
    return;
  }
  const double h = 1e-4;
  std::mt19937 engine(11);
  const auto random = [&](double low, double high)
  { return low + (high - low) * static_cast<double>(engine()) / 4294967296.; };
  double tightest = 0.;
  for (int i = 0; i < 300; ++i)
  {
    const double half[2] = { random(0.001, 0.1), random(0.001, 0.1) };
    const double u = random(half[0] + 0.001, 0.999 - half[0]);
    const double v = random(half[1] + 0.001, 0.999 - half[1]);
    const MesoShapeBends bends = shape.BendsAround(shape.At(u, v), u, v, half[0], half[1]);
    // The normal's derivatives in the middle, and all second ones anywhere.
    const auto first = [&](auto member, double x, double y, double du, double dv)
    {
      return MesoScaled(
        MesoDifference(shape.At(x + du, y + dv).*member, shape.At(x - du, y - dv).*member),
        0.5 / h);
    };
    const auto second = [&](auto member, double x, double y, double du, double dv)
    {
      const MesoVector ends =
        MesoSum(shape.At(x + du, y + dv).*member, shape.At(x - du, y - dv).*member);
      return MesoLength(MesoDifference(ends, MesoScaled(shape.At(x, y).*member, 2.))) / (h * h);
    };
    const auto mixed = [&](auto member, double x, double y)
    {
      return MesoLength(MesoScaled(
        MesoDifference(first(member, x + h, y, 0., h), first(member, x - h, y, 0., h)), 0.5 / h));
    };
    const auto n = &MesoShapePoint::Normal;
    const auto p = &MesoShapePoint::Position;
    ASSERT_LT(DistanceOf(first(n, u, v, h, 0.), bends.NormalU), 1e-4) << u << " " << v;
    ASSERT_LT(DistanceOf(first(n, u, v, 0., h), bends.NormalV), 1e-4) << u << " " << v;
    for (int k = 0; k < 5; ++k)
    {
      const double x = u + random(-half[0], half[0]);
      const double y = v + random(-half[1], half[1]);
      const double slack = 1e-4; // of differences, for numbers of size 1 to 100
      ASSERT_LE(second(p, x, y, h, 0.), bends.Puu * (1. + slack) + slack);
      ASSERT_LE(second(p, x, y, 0., h), bends.Pvv * (1. + slack) + slack);
      ASSERT_LE(mixed(p, x, y), bends.Puv * (1. + slack) + slack);
      ASSERT_LE(MesoLength(first(n, x, y, h, 0.)), bends.Nu * (1. + slack) + slack);
      ASSERT_LE(MesoLength(first(n, x, y, 0., h)), bends.Nv * (1. + slack) + slack);
      ASSERT_LE(second(n, x, y, h, 0.), bends.Nuu * (1. + slack) + slack);
      ASSERT_LE(second(n, x, y, 0., h), bends.Nvv * (1. + slack) + slack);
      ASSERT_LE(mixed(n, x, y), bends.Nuv * (1. + slack) + slack);
      tightest = std::max(tightest, second(p, x, y, h, 0.) / bends.Puu);
    }
  }
  EXPECT_GT(tightest, 0.8) << "bounds that are far too wide";
}

INSTANTIATE_TEST_SUITE_P(All, ShapeSource,
  ::testing::Values("plane", "cube", "sphere", "cylinder", "cone", "torus", "vase", "teapot",
    "undulating", "branch"));

TEST(ShapeSourceCounts, AreNearThoseOfThePapers)
{
  const auto triangles = [](const char* name)
  {
    vtkNew<vtkMesoShapeSource> source;
    source->SetShape(name);
    source->Update();
    return source->GetOutput()->GetNumberOfPolys();
  };
  EXPECT_EQ(triangles("teapot"), 4032); // as in Wang2003
  EXPECT_EQ(triangles("vase"), 8640);
  EXPECT_NEAR(static_cast<double>(triangles("branch")), 5888., 50.);
}

TEST(ShapeSourceTeapot, IsTheMeshThatWasMadeOfItBefore)
{
  // Data/Meshes/teapot.obj: each patch at 8 x 8 places, the original's size.
  std::ifstream file(std::string(MESO_MESHES) + "/teapot.obj");
  ASSERT_TRUE(file);
  std::vector<MesoVector> points;
  for (std::string line; std::getline(file, line);)
  {
    if (line.rfind("v ", 0) == 0)
    {
      std::istringstream numbers(line.substr(2));
      MesoVector p;
      numbers >> p[0] >> p[1] >> p[2];
      points.push_back(p);
    }
  }
  ASSERT_GT(points.size(), 1500u);
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape("teapot");
  source->SetParameter("radius", { 2. });
  source->SetParameter("segments", { 7. });
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(source->GetOutput());
  locator->BuildLocator();
  double low = 1e9;
  for (const MesoVector& p : points)
  {
    low = std::min(low, p[1]);
  }
  for (MesoVector p : points)
  {
    p[1] -= low + 1.575;
    const vtkIdType nearest = locator->FindClosestPoint(p.data());
    // The knob's arcs are wider by 0.0025 in the published points; else the file's five digits.
    const double known = p[1] > 1.575 - 0.45 ? 5e-4 : 2e-5;
    ASSERT_LT(DistanceOf(PositionOf(source->GetOutput(), nearest), p), known)
      << p[0] << " " << p[1] << " " << p[2];
  }
}

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
  source->SetShape("kettle");
  expect("unknown shape 'kettle'");
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
