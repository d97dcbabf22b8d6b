// vtkMesoPrincipalCurvatures as a filter: what it carries along, merges, refuses, and repeats.

#include "CurvatureRun.h"
#include "ErrorRecorder.h"

#include "vtkMesoShapeSource.h"

#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkSMPTools.h"

#include <cstring>
#include <limits>

TEST(CurvatureFilter, SeamsAndPolesOfTheShapesAreNoBorders)
{
  vtkNew<vtkMesoShapeSource> source;
  for (const char* shape : { "sphere", "torus" })
  {
    source->SetShape(shape);
    source->SetParameter("rings", { 48. });
    source->SetParameter("sides", { 48. });
    source->Update();
    const CurvatureRun run = RunCurvatures(source->GetOutput());
    ASSERT_EQ(run.Output->GetNumberOfPoints(), source->GetOutput()->GetNumberOfPoints());
    std::vector<std::array<double, 2>> known(run.Curvatures.size(), { 0., 0. });
    for (std::size_t i = 0; i < run.Curvatures.size(); ++i)
    {
      const double exact = shape[0] == 's' ? 1. : 2.5;
      EXPECT_NEAR(run.Curvatures[i][0], exact, 0.01 * exact) << shape;
      EXPECT_GT(run.Confidences[i], 0.8) << shape;
      const auto vertex =
        static_cast<std::size_t>(TupleOf(run.Output, "MesoVertex", static_cast<vtkIdType>(i))[0]);
      EXPECT_TRUE(known[vertex][0] == 0. || known[vertex] == run.Curvatures[i]) << shape;
      known[vertex] = run.Curvatures[i];
    }
  }
}

TEST(CurvatureFilter, NormalsOfTheInputTurnTheSign)
{
  const CurvedMesh mesh = SampleNamed("torus", 2000, 0.);
  const CurvatureRun out = RunCurvatures(mesh.Mesh);
  vtkNew<vtkPolyData> inward;
  inward->ShallowCopy(out.Output);
  vtkNew<vtkDoubleArray> normals;
  normals->DeepCopy(out.Output->GetPointData()->GetNormals());
  for (vtkIdType i = 0; i < 3 * normals->GetNumberOfTuples(); ++i)
  {
    normals->SetValue(i, -normals->GetValue(i));
  }
  inward->GetPointData()->SetNormals(normals);
  const CurvatureRun in = RunCurvatures(inward);
  for (std::size_t i = 0; i < out.Curvatures.size(); ++i)
  {
    EXPECT_EQ(in.Curvatures[i][0], -out.Curvatures[i][1]);
    EXPECT_EQ(in.Curvatures[i][1], -out.Curvatures[i][0]);
    EXPECT_GT(std::abs(MesoDot(in.Directions[i][0], out.Directions[i][1])), 1. - 1e-9);
  }
}

TEST(CurvatureFilter, UmbilicsHaveTheSamePairInEveryRun)
{
  const CurvedMesh mesh = SampleNamed("plane", 400, 0.);
  const CurvatureRun first = RunCurvatures(mesh.Mesh);
  const CurvatureRun second = RunCurvatures(mesh.Mesh);
  for (std::size_t i = 0; i < first.Directions.size(); ++i)
  {
    EXPECT_EQ(first.Directions[i][0], second.Directions[i][0]);
    EXPECT_NEAR(
      std::abs(first.Directions[i][0][0]), 1., 1e-12); // the axis farthest from the normal
  }
}

TEST(CurvatureFilter, DoesNotDependOnTheNumberOfThreads)
{
  const CurvedMesh mesh = SampleNamed("monkey saddle", 4000, 0.24);
  vtkSMPTools::Initialize(1);
  const CurvatureRun one = RunCurvatures(mesh.Mesh);
  vtkSMPTools::Initialize(4);
  const CurvatureRun four = RunCurvatures(mesh.Mesh);
  for (const char* name : { "MesoCurvature", "MesoPrincipalDirections", "MesoCurvatureConfidence" })
  {
    vtkDataArray* a = one.Output->GetPointData()->GetArray(name);
    vtkDataArray* b = four.Output->GetPointData()->GetArray(name);
    ASSERT_EQ(a->GetDataSize(), b->GetDataSize());
    EXPECT_EQ(
      std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), a->GetDataSize() * sizeof(double)),
      0);
  }
}

TEST(CurvatureFilter, CarriesDataAlong)
{
  const CurvedMesh mesh = SampleNamed("saddle", 400, 0.);
  vtkNew<vtkFloatArray> value;
  value->SetName("value");
  value->SetNumberOfTuples(mesh.Mesh->GetNumberOfPoints());
  value->Fill(3.);
  mesh.Mesh->GetPointData()->SetScalars(value);
  vtkNew<vtkFloatArray> cell;
  cell->SetName("cell");
  cell->SetNumberOfTuples(mesh.Mesh->GetNumberOfCells());
  cell->Fill(4.);
  mesh.Mesh->GetCellData()->AddArray(cell);
  const CurvatureRun run = RunCurvatures(mesh.Mesh);
  EXPECT_EQ(run.Output->GetPointData()->GetScalars(), value.Get());
  EXPECT_EQ(run.Output->GetCellData()->GetArray("cell"), cell.Get());
  EXPECT_EQ(run.Output->GetNumberOfCells(), mesh.Mesh->GetNumberOfCells());
  EXPECT_STREQ(run.Output->GetPointData()->GetNormals()->GetName(), "Normals");
  EXPECT_EQ(mesh.Mesh->GetPointData()->GetNumberOfArrays(), 1); // the input is as it was
}

TEST(CurvatureFilter, RefusesWhatItCannotUseInOneLine)
{
  ErrorRecorder recorder;
  vtkNew<vtkMesoPrincipalCurvatures> filter;
  recorder.Watch(filter);
  const auto expectRefused = [&](vtkPolyData* mesh, const char* part)
  {
    recorder.Clear();
    filter->SetInputData(mesh);
    filter->Update();
    ASSERT_EQ(recorder.Errors.size(), 1u) << part;
    EXPECT_NE(recorder.Errors[0].find(part), std::string::npos) << recorder.Errors[0];
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expectRefused(MakeMesh({ { 0, 0, 0 }, { 1, nan, 0 }, { 0, 1, 0 } }, {}, { { 0, 1, 2 } }),
    "position of point 1 is not finite");
  expectRefused(MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, {}, { { 0, 1, 3 } }),
    "polygon 0 names point 3");
  recorder.Clear();
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(recorder.Errors.empty());
}

TEST(CurvatureFilter, TellsItsProgressAndCanBeAborted)
{
  const CurvedMesh mesh = SampleNamed("torus", 2000, 0.);
  vtkNew<vtkMesoPrincipalCurvatures> filter;
  filter->SetInputData(mesh.Mesh);
  double last = -1.;
  int steps = 0;
  struct Watch
  {
    double& Last;
    int& Steps;
    bool Abort;
  } watch = { last, steps, false };
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void* client, void* amount)
    {
      auto* state = static_cast<Watch*>(client);
      EXPECT_GE(*static_cast<double*>(amount), state->Last);
      state->Last = *static_cast<double*>(amount);
      ++state->Steps;
      if (state->Abort && state->Last > 0.5)
      {
        static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
      }
    });
  filter->AddObserver(vtkCommand::ProgressEvent, command);
  filter->Update();
  EXPECT_GT(steps, 10);
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), mesh.Mesh->GetNumberOfPoints());
  last = -1.;
  watch.Abort = true;
  filter->Modified();
  filter->Update();
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(filter->GetErrorMessage().empty());
}
