// vtkMesoDirectionLines: where lines are, along what, and where there is none.

#include "CurvedMeshes.h"
#include "ErrorRecorder.h"

#include "vtkMesoDirectionLines.h"
#include "vtkMesoPrincipalCurvatures.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
vtkSmartPointer<vtkPolyData> WithCurvatures(vtkPolyData* mesh)
{
  vtkNew<vtkMesoPrincipalCurvatures> filter;
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> LinesOf(vtkPolyData* mesh, vtkMesoDirectionLines* filter)
{
  filter->SetInputData(mesh);
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> LinesOf(vtkPolyData* mesh)
{
  return LinesOf(mesh, vtkNew<vtkMesoDirectionLines>());
}
}

TEST(DirectionLines, LieAlongBothDirectionsAtEveryPointOfATorus)
{
  const CurvedMesh torus = SampleNamed("torus", 2000, 0.);
  const auto mesh = WithCurvatures(torus.Mesh);
  vtkNew<vtkMesoDirectionLines> filter;
  filter->SetLength(0.05);
  const auto lines = LinesOf(mesh, filter);
  const vtkIdType points = mesh->GetNumberOfPoints();
  ASSERT_EQ(lines->GetNumberOfLines(), 2 * points);
  ASSERT_EQ(lines->GetNumberOfPoints(), 4 * points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < points; ++i)
  {
    const MesoVector normal = TupleOf(mesh, "Normals", i);
    const MesoVector middle = MesoSum(PositionOf(mesh, i), MesoScaled(normal, 0.1 * 0.05));
    for (int k = 0; k < 2; ++k)
    {
      lines->GetLines()->GetCellAtId(2 * i + k, ids);
      const MesoVector a = PositionOf(lines, ids->GetId(0));
      const MesoVector b = PositionOf(lines, ids->GetId(1));
      EXPECT_LT(DistanceOf(MesoScaled(MesoSum(a, b), 0.5), middle), 1e-12);
      EXPECT_NEAR(DistanceOf(a, b), 0.05, 1e-12);
      // Along the exact direction of c_max, or at right angles to it: sine or cosine are small.
      const MesoVector unit = MesoScaled(MesoDifference(b, a), 1. / 0.05);
      const MesoVector& exact = torus.Directions[i];
      EXPECT_LT(k == 0 ? MesoLength(MesoCross(unit, exact)) : std::abs(MesoDot(unit, exact)), 0.02);
      EXPECT_EQ(lines->GetPointData()->GetScalars()->GetComponent(ids->GetId(1), 0),
        mesh->GetPointData()->GetArray("MesoCurvature")->GetComponent(i, k));
    }
  }
}

TEST(DirectionLines, OneOfTheTwoIsEnough)
{
  const auto mesh = WithCurvatures(SampleNamed("saddle", 400, 0.).Mesh);
  vtkNew<vtkMesoDirectionLines> filter;
  const vtkIdType both = LinesOf(mesh, filter)->GetNumberOfLines();
  ASSERT_GT(both, 700);
  const auto expectSigns = [&](double sign)
  {
    const auto lines = LinesOf(mesh, filter);
    EXPECT_EQ(lines->GetNumberOfLines(), both / 2);
    const double* range = lines->GetPointData()->GetScalars()->GetRange();
    EXPECT_GT(sign * range[0], 0.);
    EXPECT_GT(sign * range[1], 0.);
  };
  filter->MinimumOff();
  expectSigns(1.);
  filter->MinimumOn();
  filter->MaximumOff();
  expectSigns(-1.);
}

TEST(DirectionLines, UmbilicsAndPlanesHaveNone)
{
  for (const char* name : { "sphere", "plane" })
  {
    const auto mesh = WithCurvatures(SampleNamed(name, 1000, 0.2).Mesh);
    EXPECT_EQ(LinesOf(mesh)->GetNumberOfLines(), 0) << name;
  }
  // A surface that turns by a hundred thousandth of a radian from end to end is a plane to the eye.
  const CurvedMesh saddle = SampleNamed("saddle", 400, 0.);
  for (const double bend : { 1e-3, 1e-6 })
  {
    vtkNew<vtkPolyData> mesh;
    mesh->DeepCopy(saddle.Mesh);
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const MesoVector p = PositionOf(mesh, i);
      mesh->GetPoints()->SetPoint(i, p[0], p[1], bend * p[2]);
    }
    EXPECT_EQ(LinesOf(WithCurvatures(mesh))->GetNumberOfLines() > 0, bend == 1e-3) << bend;
  }
}

TEST(DirectionLines, PointsWithoutConfidenceHaveNone)
{
  // A cube's eight corners belong to three sides each.
  const std::vector<MesoVector> corners = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 },
    { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 }, { 1, 1, 1 } };
  const auto cube = WithCurvatures(MakeMesh(corners, {},
    { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 }, { 0, 4, 6, 2 },
      { 1, 3, 7, 5 } }));
  EXPECT_EQ(LinesOf(cube)->GetNumberOfLines(), 0);

  const auto saddle = WithCurvatures(SampleNamed("saddle", 400, 0.).Mesh);
  vtkDataArray* confidences = saddle->GetPointData()->GetArray("MesoCurvatureConfidence");
  vtkNew<vtkMesoDirectionLines> filter;
  filter->SetMinimumConfidence(0.7);
  vtkIdType sure = 0;
  for (vtkIdType i = 0; i < saddle->GetNumberOfPoints(); ++i)
  {
    sure += confidences->GetComponent(i, 0) > 0.7 ? 1 : 0;
  }
  ASSERT_GT(sure, 100);
  ASSERT_LT(sure, saddle->GetNumberOfPoints());
  EXPECT_EQ(LinesOf(saddle, filter)->GetNumberOfLines(), 2 * sure);
}

TEST(DirectionLines, WhatIsNotFiniteHasNone)
{
  const auto mesh = WithCurvatures(SampleNamed("saddle", 400, 0.).Mesh);
  const vtkIdType all = LinesOf(mesh)->GetNumberOfLines();
  const double bad = std::numeric_limits<double>::quiet_NaN();
  mesh->GetPointData()->GetArray("MesoCurvature")->SetComponent(100, 1, bad);
  mesh->GetPointData()->GetArray("MesoPrincipalDirections")->SetComponent(150, 4, bad);
  mesh->GetPointData()->GetArray("MesoCurvatureConfidence")->SetComponent(200, 0, bad);
  mesh->Modified();
  EXPECT_EQ(LinesOf(mesh)->GetNumberOfLines(), all - 6);
}

TEST(DirectionLines, MissingArraysAreSaidInOneLine)
{
  const auto mesh = WithCurvatures(SampleNamed("saddle", 100, 0.).Mesh);
  mesh->GetPointData()->RemoveArray("MesoPrincipalDirections");
  vtkNew<vtkMesoDirectionLines> filter;
  ErrorRecorder recorder;
  recorder.Watch(filter);
  EXPECT_EQ(LinesOf(mesh, filter)->GetNumberOfPoints(), 0);
  ASSERT_EQ(recorder.Errors.size(), 1u);
  EXPECT_NE(recorder.Errors[0].find("the input has no point array MesoPrincipalDirections (6 "
                                    "components): vtkMesoPrincipalCurvatures makes it"),
    std::string::npos);
  recorder.Clear();
  EXPECT_EQ(LinesOf(vtkNew<vtkPolyData>(), filter)->GetNumberOfPoints(), 0);
  EXPECT_TRUE(recorder.Errors.empty());
}
