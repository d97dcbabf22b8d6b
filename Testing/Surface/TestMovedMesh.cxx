// vtkMesoMovedMesh: points and frames are those of the closed form, seams stay closed, hard edges
// come apart as the true surface does, and what cannot be moved is refused in one line.

#include "DicedMeshes.h"
#include "ErrorRecorder.h"

#include "vtkMesoMovedMesh.h"
#include "vtkMesoSurfaceFrames.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
vtkSmartPointer<vtkPolyData> Moved(vtkPolyData* mesh, double distance)
{
  vtkNew<vtkMesoMovedMesh> filter;
  filter->SetInputData(mesh);
  filter->SetDistance(distance);
  filter->Update();
  return filter->GetOutput();
}
}

TEST(MovedMesh, OfATorusHasAThickerTube)
{
  // At the circle of radius R + r cos b the torus turns by u once: |dp/du| = 2 pi (R + r cos b), and
  // |dp/dv| = 2 pi r; both grow with r.
  const std::map<std::string, std::vector<double>> numbers = { { "rings", { 64. } },
    { "sides", { 48. } } };
  auto thick = numbers;
  thick["tube"] = { 0.55 };
  const auto torus = ShapeMesh("torus", numbers);
  const auto wanted = ShapeMesh("torus", thick);
  const auto moved = Moved(torus, 0.15);
  ASSERT_EQ(moved->GetNumberOfPoints(), wanted->GetNumberOfPoints());
  double scaleError = 0.;
  double directionError = 0.;
  for (vtkIdType i = 0; i < wanted->GetNumberOfPoints(); ++i)
  {
    ASSERT_LT(DistanceOf(PositionOf(moved, i), PositionOf(wanted, i)), 1e-14);
    ASSERT_EQ(TupleOf(moved, "Normals", i), TupleOf(wanted, "Normals", i));
    ASSERT_EQ(TupleOf(moved, "MesoVertex", i), TupleOf(wanted, "MesoVertex", i));
    ASSERT_EQ(TupleOf(moved, "MesoFrameValid", i)[0], 1.);
    const MesoVector scale = TupleOf(moved, "MesoTileScale", i);
    const MesoVector exact = TupleOf(wanted, "MesoTileScale", i);
    scaleError = std::max(
      { scaleError, std::abs(scale[0] / exact[0] - 1.), std::abs(scale[1] / exact[1] - 1.) });
    directionError = std::max({ directionError,
      DistanceOf(TupleOf(moved, "MesoTangent", i), TupleOf(wanted, "MesoTangent", i)),
      DistanceOf(TupleOf(moved, "MesoBitangent", i), TupleOf(wanted, "MesoBitangent", i)) });
  }
  // The frames of the mesh that was not moved would be off by 0.15 / 0.55.
  EXPECT_LT(scaleError, 0.01);
  EXPECT_LT(directionError, 0.01);
  EXPECT_EQ(MergedEdges(moved).Wrong, 0);
}

TEST(MovedMesh, PolesStayClosed)
{
  const auto moved = Moved(ShapeMesh("sphere", {}, vtkAlgorithm::SINGLE_PRECISION), 0.3);
  EXPECT_EQ(moved->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(MergedEdges(moved).Wrong, 0);
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    ASSERT_NEAR(MesoLength(PositionOf(moved, i)), 1.3, 2e-7);
    ASSERT_GT(TupleOf(moved, "MesoTileScale", i)[0], 0.);
  }
}

TEST(MovedMesh, HardEdgesComeApart)
{
  // A ridge of two squares at a right angle, its normals split.
  const std::vector<MesoVector> points = { { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. },
    { 0., 1., 0. }, { 1., 0., -1. }, { 1., 1., -1. } };
  const std::vector<std::array<double, 2>> uv = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. },
    { 2., 0. }, { 2., 1. } };
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputData(MakeMesh(points, uv, { { 0, 1, 2, 3 }, { 1, 4, 5, 2 } }));
  frames->SplitNormalsOn();
  frames->Update();
  ASSERT_EQ(frames->GetOutput()->GetNumberOfPoints(), 8);
  const auto moved = Moved(frames->GetOutput(), 0.25);
  std::set<double> vertices;
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const MesoVector normal = TupleOf(moved, "Normals", i);
    const MesoVector from = PositionOf(frames->GetOutput(), i);
    EXPECT_LT(DistanceOf(PositionOf(moved, i), MesoSum(from, MesoScaled(normal, 0.25))), 1e-15);
    vertices.insert(TupleOf(moved, "MesoVertex", i)[0]);
  }
  EXPECT_EQ(vertices.size(), 8u);
}

TEST(MovedMesh, RefusalsAreOneLineAndGiveNothing)
{
  ErrorRecorder recorder;
  vtkNew<vtkMesoMovedMesh> filter;
  recorder.Watch(filter);
  const auto expect = [&](vtkPolyData* mesh, const char* part)
  {
    recorder.Clear();
    filter->SetInputData(mesh);
    filter->Update();
    ASSERT_EQ(recorder.Errors.size(), 1u) << part;
    EXPECT_NE(recorder.Errors[0].find(part), std::string::npos) << recorder.Errors[0];
    EXPECT_NE(filter->GetErrorMessage().find(part), std::string::npos);
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  const std::vector<MesoVector> points = { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. } };
  expect(MakeMesh(points, { { 0., 0. }, { 1., 0. }, { 0., 1. } }, { { 0, 1, 2 } }),
    "the mesh has no normals to move along");
  const auto plane = ShapeMesh("plane", {});
  plane->GetPointData()->GetNormals()->SetTuple3(2, 0., 0., 0.);
  expect(plane, "the normal of point 2 has length 0");
  const auto bare = ShapeMesh("plane", {});
  bare->GetPointData()->SetTCoords(nullptr);
  bare->GetPointData()->RemoveArray("TextureCoordinates");
  expect(bare, "texture coordinates");
  filter->SetDistance(std::numeric_limits<double>::infinity());
  expect(ShapeMesh("plane", {}), "Distance must be finite");
  filter->SetDistance(1.);
  recorder.Clear();
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  filter->Update();
  EXPECT_TRUE(recorder.Errors.empty());
  EXPECT_EQ(filter->GetErrorMessage(), "");
}
