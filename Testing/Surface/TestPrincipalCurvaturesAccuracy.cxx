// vtkMesoPrincipalCurvatures against closed forms: errors, their order, directions, and scales.

#include "CurvatureRun.h"

namespace
{
// Of a side of the grid's squares; their diagonals are then at random, too.
constexpr double Jitter = 0.24;
}

TEST(CurvatureAccuracy, TorusOfEightThousandVertices)
{
  for (const double jitter : { 0., Jitter })
  {
    const CurvedMesh mesh = SampleNamed("torus", 8000, jitter);
    const CurvatureError error = ErrorOf(mesh, RunCurvatures(mesh.Mesh));
    EXPECT_LT(error.Maximum, 0.001) << jitter;
    EXPECT_LT(error.Minimum, 0.001) << jitter;
    EXPECT_LT(error.Direction, 0.01) << jitter;
  }
}

TEST(CurvatureAccuracy, SaddleOfEightThousandVertices)
{
  for (const double jitter : { 0., Jitter })
  {
    const CurvedMesh mesh = SampleNamed("saddle", 8000, jitter);
    const CurvatureError error = ErrorOf(mesh, RunCurvatures(mesh.Mesh));
    EXPECT_LT(error.Maximum, 0.0005) << jitter;
    EXPECT_LT(error.Minimum, 0.0005) << jitter;
    EXPECT_LT(error.Direction, 0.005) << jitter;
  }
}

TEST(CurvatureAccuracy, FallsWithTheThirdPowerOfTheEdgesOrFaster)
{
  for (const char* name : { "sphere", "cylinder", "torus", "saddle", "monkey saddle" })
  {
    for (const double jitter : { 0., Jitter })
    {
      std::array<double, 3> error;
      for (std::size_t i = 0; i < 3; ++i)
      {
        const CurvedMesh mesh = SampleNamed(name, 500 << (2 * i), jitter);
        error[i] = ErrorOf(mesh, RunCurvatures(mesh.Mesh), false).Maximum;
      }
      // Theory says 3; the coarse meshes are not in the limit yet, and each step is one draw.
      EXPECT_GT(std::log2(error[0] / error[1]), 2.2) << name << " " << jitter;
      EXPECT_GT(std::log2(error[1] / error[2]), 2.5) << name << " " << jitter;
    }
  }
}

TEST(CurvatureAccuracy, PlaneHasNone)
{
  for (const double jitter : { 0., Jitter })
  {
    const CurvedMesh mesh = SampleNamed("plane", 900, jitter);
    const CurvatureRun run = RunCurvatures(mesh.Mesh);
    for (std::size_t i = 0; i < run.Curvatures.size(); ++i)
    {
      EXPECT_NEAR(run.Curvatures[i][0], 0., 1e-9);
      EXPECT_NEAR(run.Curvatures[i][1], 0., 1e-9);
      EXPECT_GT(run.Confidences[i], 0.2);
    }
  }
}

TEST(CurvatureAccuracy, DoesNotDependOnScaleNorOnPlace)
{
  const CurvedMesh mesh = SampleNamed("torus", 2000, Jitter);
  const CurvatureRun run = RunCurvatures(mesh.Mesh);
  const double far = 1e6;
  // Positions 1e6 off have lost 1e-10, which second differences over edges of .06 multiply by 300
  // and the fit's conditioning by some tens.
  for (const auto& [scale, offset, tolerance] : { std::array<double, 3>{ 1e-6, 0., 1e-9 },
         std::array<double, 3>{ 1e6, 0., 1e-9 }, std::array<double, 3>{ 1., far, 1e-5 } })
  {
    vtkNew<vtkPolyData> moved;
    moved->DeepCopy(mesh.Mesh);
    for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
    {
      MesoVector p = MesoScaled(PositionOf(mesh.Mesh, i), scale);
      p = MesoSum(p, { offset, -offset, offset });
      moved->GetPoints()->SetPoint(i, p.data());
    }
    const CurvatureRun other = RunCurvatures(moved);
    for (std::size_t i = 0; i < run.Curvatures.size(); ++i)
    {
      EXPECT_NEAR(other.Curvatures[i][0] * scale, run.Curvatures[i][0], tolerance) << scale;
      EXPECT_NEAR(other.Curvatures[i][1] * scale, run.Curvatures[i][1], tolerance) << scale;
      EXPECT_NEAR(other.Confidences[i], run.Confidences[i], 1e-4) << scale;
    }
  }
}

TEST(CurvatureAccuracy, FloatsAreEnoughForAModelOfOrdinarySize)
{
  const CurvedMesh mesh = SampleNamed("torus", 8000, Jitter);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  points->DeepCopy(mesh.Mesh->GetPoints());
  ASSERT_EQ(points->GetDataType(), VTK_FLOAT);
  vtkNew<vtkPolyData> single;
  single->SetPoints(points);
  single->SetPolys(mesh.Mesh->GetPolys());
  const CurvatureRun run = RunCurvatures(single);
  EXPECT_EQ(run.Output->GetPointData()->GetArray("MesoCurvature")->GetDataType(), VTK_FLOAT);
  EXPECT_LT(ErrorOf(mesh, run).Maximum, 0.001);
}

TEST(CurvatureAccuracy, BordersAreOneSidedAndLessSure)
{
  const CurvedMesh mesh = SampleNamed("saddle", 2000, 0.);
  const CurvatureRun run = RunCurvatures(mesh.Mesh);
  for (std::size_t i = 0; i < run.Curvatures.size(); ++i)
  {
    // The worst are the corners, for which four rings are needed.
    EXPECT_NEAR(run.Curvatures[i][0], mesh.Curvatures[i][0], mesh.Border[i] ? 0.05 : 0.002);
    EXPECT_GT(run.Confidences[i], 0.1);
    EXPECT_TRUE(!mesh.Border[i] || run.Confidences[i] < 0.8) << run.Confidences[i];
  }
  EXPECT_GT(run.Confidences[20 * 46 + 20], 0.95);
}
