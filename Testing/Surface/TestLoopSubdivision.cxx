// Loop subdivision: an icosahedron becomes nearly a ball, flat stays flat, seams are no edges and borders
// are their own curve.

#include "ErrorRecorder.h"
#include "SurfaceArrays.h"
#include "vtkMesoLoopSubdivision.h"
#include "vtkMesoShapeSource.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkPlatonicSolidSource.h"
#include "vtkPoints.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace
{
vtkSmartPointer<vtkPolyData> Subdivided(vtkPolyData* mesh, int levels)
{
  vtkNew<vtkMesoLoopSubdivision> filter;
  filter->SetInputData(mesh);
  filter->SetLevels(levels);
  filter->Update();
  EXPECT_EQ(filter->GetErrorMessage(), "");
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> Shape(
  const char* name, const std::map<std::string, std::vector<double>>& parameters)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape(name);
  for (const auto& parameter : parameters)
  {
    source->SetParameter(parameter.first, parameter.second);
  }
  source->Update();
  return source->GetOutput();
}

std::array<double, 3> PointOf(vtkPolyData* mesh, vtkIdType i)
{
  std::array<double, 3> p;
  mesh->GetPoint(i, p.data());
  return p;
}
}

TEST(LoopSubdivision, AnIcosahedronBecomesNearlyABall)
{
  vtkNew<vtkPlatonicSolidSource> source;
  source->SetSolidTypeToIcosahedron();
  source->Update();
  const auto corners = Subdivided(source->GetOutput(), 0);
  // The limit of a vertex of valence 5 is (w v + sum) / (w + 5), w = 3 / (8 beta); of an icosahedron the
  // neighbours sum to 5 / sqrt(5) of the vertex.
  const double cosine = 0.375 + 0.25 * std::cos(0.4 * std::acos(-1.));
  const double weight = 0.375 / ((0.625 - cosine * cosine) / 5.);
  const double limit = (weight + std::sqrt(5.)) / (weight + 5.);
  const double radius = MesoLength(PointOf(source->GetOutput(), 0)) * limit;
  EXPECT_NEAR(MesoLength(PointOf(corners, 0)), radius, 1e-6);
  const auto fine = Subdivided(source->GetOutput(), 4);
  EXPECT_EQ(fine->GetNumberOfPolys(), 20 * 256);
  EXPECT_EQ(fine->GetNumberOfPoints(), 10 * 256 + 2);
  double least = 1e9;
  double greatest = 0.;
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    const double size = MesoLength(PointOf(fine, i));
    least = std::min(least, size);
    greatest = std::max(greatest, size);
  }
  EXPECT_GT(least / greatest, 0.97); // of the icosahedron it is 0.79
  // Points that were there stay where they were: on the limit.
  EXPECT_NEAR(MesoLength(PointOf(fine, 0)), radius, 1e-6);
}

TEST(LoopSubdivision, FlatStaysFlatAndEven)
{
  const auto plane = Shape("plane", { { "segments", { 8., 8. } } });
  const auto fine = Subdivided(plane, 2);
  EXPECT_EQ(fine->GetNumberOfPolys(), 16 * 128);
  vtkDataArray* coordinates = fine->GetPointData()->GetTCoords();
  ASSERT_TRUE(coordinates);
  int inside = 0;
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    const auto p = PointOf(fine, i);
    EXPECT_EQ(p[2], 0.);
    const double uv[2] = { coordinates->GetComponent(i, 0), coordinates->GetComponent(i, 1) };
    // Off the border, whose corners are rounded, a regular grid is the spline of itself.
    if (uv[0] > 0.3 && uv[0] < 0.7 && uv[1] > 0.3 && uv[1] < 0.7)
    {
      ++inside;
      EXPECT_NEAR(p[0], uv[0] - 0.5, 1e-6);
      EXPECT_NEAR(p[1], uv[1] - 0.5, 1e-6);
    }
  }
  EXPECT_GT(inside, 50);
}

TEST(LoopSubdivision, SeamsOfTheTextureAreNoEdges)
{
  const auto torus = Shape("torus", { { "rings", { 12. } }, { "sides", { 8. } } });
  const auto fine = Subdivided(torus, 2);
  vtkDataArray* vertices = fine->GetPointData()->GetArray("MesoVertex");
  std::map<double, std::array<double, 3>> places;
  int split = 0;
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    const auto found = places.emplace(vertices->GetTuple1(i), PointOf(fine, i));
    split += found.second ? 0 : 1;
    EXPECT_EQ(found.first->second, PointOf(fine, i));
  }
  EXPECT_EQ(split, 4 * 12 + 4 * 8 + 1);
  // Turned by a ring it is the same surface: the seam has left no trace.
  std::map<std::pair<int, int>, double> distances; // from the axis, by place on the tube
  vtkDataArray* coordinates = fine->GetPointData()->GetTCoords();
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
  {
    const auto p = PointOf(fine, i);
    const int along = int(std::lround(coordinates->GetComponent(i, 0) * 48.)) % 4;
    const int around = int(std::lround(coordinates->GetComponent(i, 1) * 32.)) % 32;
    const auto found = distances.emplace(std::make_pair(along, around), std::hypot(p[0], p[2]));
    EXPECT_NEAR(found.first->second, std::hypot(p[0], p[2]), 1e-6);
  }
}

TEST(LoopSubdivision, BordersAreCurvesOfTheirOwn)
{
  // Two triangles over the same border, of which one mesh rises inside: the border stays the same.
  const auto rising = [](double height)
  {
    auto mesh = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 6; ++i)
    {
      points->InsertNextPoint(
        std::cos(i * std::acos(-1.) / 3.), std::sin(i * std::acos(-1.) / 3.), 0.);
    }
    points->InsertNextPoint(0., 0., height);
    mesh->SetPoints(points);
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < 6; ++i)
    {
      const vtkIdType ids[] = { 6, i, (i + 1) % 6 };
      cells->InsertNextCell(3, ids);
    }
    mesh->SetPolys(cells);
    return mesh;
  };
  const auto low = Subdivided(rising(0.), 1);
  const auto high = Subdivided(rising(1.), 1);
  for (vtkIdType i = 0; i < 6; ++i)
  {
    EXPECT_EQ(PointOf(low, i), PointOf(high, i));
    // (1, 4, 1) / 6 of a hexagon's corners.
    EXPECT_NEAR(MesoLength(PointOf(low, i)), 5. / 6., 1e-6);
  }
  EXPECT_GT(PointOf(high, 6)[2], 0.3);
}

TEST(LoopSubdivision, RefusesWhatItCannotRead)
{
  const auto torus = Shape("torus", { { "rings", { 400. } }, { "sides", { 200. } } });
  vtkNew<vtkMesoLoopSubdivision> filter;
  ErrorRecorder errors;
  errors.Watch(filter);
  filter->SetInputData(torus);
  filter->SetLevels(5);
  filter->Update();
  EXPECT_EQ(filter->GetErrorMessage(),
    "subdivision into 163840000 triangles is more than the limit of 20000000");
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(Shape("torus", {}));
  broken->GetPoints()->SetPoint(3, 0., INFINITY, 0.);
  filter->SetInputData(broken);
  filter->SetLevels(1);
  filter->Update();
  EXPECT_EQ(filter->GetErrorMessage(), "the position of point 3 is not finite (0, inf, 0)");
}
