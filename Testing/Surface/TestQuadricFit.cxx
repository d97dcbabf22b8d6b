// vtkMesoQuadricFit and MesoFitQuadric: exact quadrics, axes, what is 0, and how it is solved.

#include "CurvedMeshes.h"
#include "ErrorRecorder.h"

#include "MesoQuadric.h"
#include "vtkMesoQuadricFit.h"
#include "vtkMesoShapeSource.h"
#include "vtkMesoSurfaceFrames.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
const double Pi = std::acos(-1.);
const MesoVector X = { 1., 0., 0. };
const MesoVector Y = { 0., 1., 0. };
const MesoVector N = { 0., 0., 1. };

/// Neighbours on z = -(a x^2 + b y^2 + c x y), outside below.
std::vector<MesoVector> Around(double a, double b, double c, int size, double width = 1.)
{
  std::vector<MesoVector> offsets;
  for (int i = 0; i < size; ++i)
  {
    const double angle = 2. * Pi * i / size + 0.3;
    const double r = 0.1 + 0.01 * i;
    const double x = r * std::cos(angle);
    const double y = width * r * std::sin(angle);
    offsets.push_back({ x, y, -(a * x * x + b * y * y + c * x * y) });
  }
  return offsets;
}

void SetArray(vtkPolyData* mesh, const char* name, const MesoVector& tuple)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    array->InsertNextTuple(tuple.data());
  }
  mesh->GetPointData()->AddArray(array);
}
}

TEST(QuadricFit, FindsTheQuadricThatThereIs)
{
  for (const MesoQuadricSolver solver :
    { MesoQuadricSolver::QR, MesoQuadricSolver::NormalEquations })
  {
    for (const bool slopes : { false, true })
    {
      MesoQuadricOptions options;
      options.Solver = solver;
      options.Slopes = slopes;
      const MesoQuadric q = MesoFitQuadric(Around(2., -3., 0.5, 8), X, Y, N, options);
      EXPECT_NEAR(q.A, 2., 1e-10);
      EXPECT_NEAR(q.B, -3., 1e-10);
      EXPECT_NEAR(q.C, 0.5, 1e-10);
      EXPECT_GE(q.Condition, 1.);
      EXPECT_LT(q.Condition, 50.);
      options.Full = false;
      const MesoQuadric diagonal = MesoFitQuadric(Around(2., -3., 0., 8), X, Y, N, options);
      EXPECT_NEAR(diagonal.A, 2., 1e-10);
      EXPECT_NEAR(diagonal.B, -3., 1e-10);
      EXPECT_EQ(diagonal.C, 0.);
    }
  }
}

TEST(QuadricFit, SlopesMakeUpForANormalThatIsOff)
{
  const double tilt = 0.01;
  const MesoVector n = { std::sin(tilt), 0., std::cos(tilt) };
  const MesoVector x = { std::cos(tilt), 0., -std::sin(tilt) };
  MesoQuadricOptions options;
  const std::vector<MesoVector> offsets = Around(1., 2., 0., 7);
  const double without = std::abs(MesoFitQuadric(offsets, x, Y, n, options).A - 1.);
  options.Slopes = true;
  const double with = std::abs(MesoFitQuadric(offsets, x, Y, n, options).A - 1.);
  EXPECT_LT(with, 0.01);
  EXPECT_GT(without, 3. * with);
}

TEST(QuadricFit, GivesZeroWhereNeighboursDoNotDetermineIt)
{
  const MesoQuadricOptions full;
  for (int size : { 0, 1, 2 })
  {
    const MesoQuadric q = MesoFitQuadric(Around(1., 1., 0., size), X, Y, N, full);
    EXPECT_EQ(q.A, 0.);
    EXPECT_EQ(q.Condition, 0.) << size;
  }
  // On one line, along an axis and across both, and all in one point.
  for (const MesoVector& line : { X, Y, MesoVector{ 0.6, 0.8, 0. }, MesoVector{ 0., 0., 0. } })
  {
    std::vector<MesoVector> offsets;
    for (int i = -4; i <= 4; ++i)
    {
      offsets.push_back(MesoSum(MesoScaled(line, 0.1 * i), { 0., 0., -0.01 * i * i }));
    }
    const MesoQuadric q = MesoFitQuadric(offsets, X, Y, N, full);
    EXPECT_EQ(q.A, 0.);
    EXPECT_EQ(q.B, 0.);
    EXPECT_EQ(q.C, 0.);
    EXPECT_EQ(q.Condition, 0.);
  }
}

TEST(QuadricFit, PlanesAreZeroAndNotNoise)
{
  MesoQuadricOptions options;
  options.Rounding = 1e-7;
  std::vector<MesoVector> offsets = Around(0., 0., 0., 8);
  for (std::size_t i = 0; i < offsets.size(); ++i)
  {
    offsets[i][2] = i % 2 == 0 ? 1e-7 : -1e-7;
  }
  const MesoQuadric q = MesoFitQuadric(offsets, X, Y, N, options);
  EXPECT_EQ(q.A, 0.);
  EXPECT_EQ(q.B, 0.);
  EXPECT_EQ(q.C, 0.);
  EXPECT_GT(q.Condition, 0.); // it is determined
  offsets[0][2] = 1e-5;
  EXPECT_NE(MesoFitQuadric(offsets, X, Y, N, options).A, 0.);
}

TEST(QuadricFit, NormalEquationsLoseTwiceTheDigits)
{
  // The narrower the strip at 45 degrees to the axes, the more alike are x^2, y^2 and x y.
  const double h = std::sqrt(0.5);
  double condition = 0.;
  double worst = 0.;
  for (const double width : { 1e-1, 1e-2, 3e-3 })
  {
    std::vector<MesoVector> offsets = Around(0., 0., 0., 9, width);
    for (MesoVector& q : offsets)
    {
      const double x = h * (q[0] - q[1]);
      const double y = h * (q[0] + q[1]);
      q = { x, y, -(x * x + 2. * y * y - x * y) };
    }
    MesoQuadricOptions options;
    const MesoQuadric qr = MesoFitQuadric(offsets, X, Y, N, options);
    options.Solver = MesoQuadricSolver::NormalEquations;
    const MesoQuadric normal = MesoFitQuadric(offsets, X, Y, N, options);
    EXPECT_GT(qr.Condition, condition);
    condition = qr.Condition;
    EXPECT_NEAR(qr.B, 2., 1e-14 * condition);
    worst = std::max(worst, std::abs(normal.B - 2.) / std::abs(qr.B - 2.));
    EXPECT_NEAR(normal.B, 2., 1e-14 * condition * condition);
  }
  EXPECT_GT(condition, 1e4);
  EXPECT_GT(worst, 100.);
}

TEST(QuadricFit, TorusInItsTangentFrame)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape("torus");
  source->SetParameter("rings", { 96. });
  source->SetParameter("sides", { 48. });
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  vtkNew<vtkMesoQuadricFit> fit;
  fit->SetInputConnection(source->GetOutputPort());
  for (const bool full : { false, true })
  {
    fit->SetFull(full);
    fit->Update();
    vtkPolyData* output = fit->GetOutput();
    EXPECT_EQ(fit->GetNumberOfPointsWithout(), 0);
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const MesoVector p = PositionOf(output, i);
      const double w = std::hypot(p[0], p[2]);
      const MesoVector q = TupleOf(output, "MesoQuadric", i);
      EXPECT_NEAR(q[0], 0.5 * (w - 1.) / 0.4 / w, 0.03); // x runs around the hole
      EXPECT_NEAR(q[1], 0.5 / 0.4, 0.03);
      EXPECT_NEAR(q[2], 0., full ? 0.03 : 0.);
      EXPECT_GE(TupleOf(output, "MesoQuadricCondition", i)[0], 1.);
    }
  }
}

TEST(QuadricFit, AxesFollowTheTangentEvenInMirroredCharts)
{
  // A cylinder around z with its tangent turned by 30 degrees in its surface: c has the sign of
  // (x . around) (y . around).
  const CurvedMesh cylinder = SampleNamed("cylinder", 4000, 0.);
  vtkPolyData* mesh = cylinder.Mesh;
  vtkNew<vtkDoubleArray> tangent;
  tangent->SetName("MesoTangent");
  tangent->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const MesoVector around = cylinder.Directions[i];
    const MesoVector t = MesoSum(MesoScaled(around, std::cos(Pi / 6.)), { 0., 0., 0.5 });
    tangent->InsertNextTuple(t.data());
  }
  mesh->GetPointData()->AddArray(tangent);
  vtkNew<vtkMesoQuadricFit> fit;
  fit->SetInputData(mesh);
  fit->Update();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    // x . around = cos 30; y = n x x has y . around = -sin 30, for n x around is the axis.
    const MesoVector q = TupleOf(fit->GetOutput(), "MesoQuadric", i);
    const double tolerance = cylinder.Border[i] ? 0.03 : 0.005;
    EXPECT_NEAR(q[0], 0.5 * 0.75, tolerance);
    EXPECT_NEAR(q[1], 0.5 * 0.25, tolerance);
    EXPECT_NEAR(q[2], -std::cos(Pi / 6.) * 0.5, tolerance);
  }
}

TEST(QuadricFit, NeighboursAcrossACreaseAreLeftOut)
{
  // Two squares of 8 x 8, one standing on the other's edge.
  std::vector<MesoVector> positions;
  std::vector<std::vector<vtkIdType>> cells;
  for (int j = 0; j <= 16; ++j)
  {
    for (int i = 0; i <= 8; ++i)
    {
      positions.push_back({ 0.1 * i, 0.1 * std::min(j, 8), 0.1 * std::max(0, j - 8) });
      if (i > 0 && j > 0)
      {
        const vtkIdType a = 9 * j + i;
        cells.push_back({ a - 10, a - 9, a });
        cells.push_back({ a - 10, a, a - 1 });
      }
    }
  }
  const auto mesh = MakeMesh(positions, {}, cells);
  SetArray(mesh, "MesoTangent", X);
  vtkNew<vtkMesoQuadricFit> fit;
  fit->SetInputData(mesh);
  fit->Update();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(TupleOf(fit->GetOutput(), "MesoQuadric", i), (MesoVector{ 0., 0., 0. }));
    const bool crease = i / 9 == 8;
    EXPECT_EQ(TupleOf(fit->GetOutput(), "MesoQuadricCondition", i)[0] > 0., !crease) << i;
  }
  EXPECT_EQ(fit->GetNumberOfPointsWithout(), 9);
  fit->SetFeatureAngle(180.);
  fit->Update();
  EXPECT_LT(TupleOf(fit->GetOutput(), "MesoQuadric", 8 * 9 + 4)[1], -1.); // concave along y
}

TEST(QuadricFit, TiltedPlanesOfFloatsAreZero)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape("plane");
  source->SetParameter("segments", { 12., 12. });
  source->Update();
  vtkNew<vtkPolyData> tilted;
  tilted->DeepCopy(source->GetOutput());
  for (vtkIdType i = 0; i < tilted->GetNumberOfPoints(); ++i)
  {
    const MesoVector p = PositionOf(tilted, i);
    tilted->GetPoints()->SetPoint(i, p[0], 0.3 * p[0] + 0.7 * p[1] + 5., 0.2 * p[0] + 1.1 * p[1]);
  }
  tilted->GetPointData()->SetNormals(nullptr);
  tilted->GetPointData()->RemoveArray("Normals");
  vtkNew<vtkMesoSurfaceFrames> frames;
  frames->SetInputData(tilted);
  vtkNew<vtkMesoQuadricFit> fit;
  fit->SetInputConnection(frames->GetOutputPort());
  fit->Update();
  ASSERT_GT(fit->GetOutput()->GetNumberOfPoints(), 0);
  for (vtkIdType i = 0; i < fit->GetOutput()->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(TupleOf(fit->GetOutput(), "MesoQuadric", i), (MesoVector{ 0., 0., 0. })) << i;
  }
}

TEST(QuadricFit, RefusesMeshesWithoutTangents)
{
  ErrorRecorder recorder;
  vtkNew<vtkMesoQuadricFit> fit;
  recorder.Watch(fit);
  const auto mesh = MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, {}, { { 0, 1, 2 } });
  fit->SetInputData(mesh);
  fit->Update();
  ASSERT_EQ(recorder.Errors.size(), 1u);
  EXPECT_NE(recorder.Errors[0].find("no point array MesoTangent"), std::string::npos);
  EXPECT_EQ(fit->GetOutput()->GetNumberOfPoints(), 0);
  recorder.Clear();
  SetArray(mesh, "MesoTangent", { 1., std::numeric_limits<double>::quiet_NaN(), 0. });
  fit->Update();
  ASSERT_EQ(recorder.Errors.size(), 1u);
  EXPECT_NE(recorder.Errors[0].find("MesoTangent of point 0 is not finite"), std::string::npos);
}
