// vtkMesoSurfaceFrames as a filter: what it takes, carries along and names, and what it refuses.

#include "ErrorRecorder.h"
#include "SurfaceArrays.h"

#include "vtkMesoShapeSource.h"
#include "vtkMesoSurfaceFrames.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace
{
const std::vector<MesoVector> Square = { { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. },
  { 0., 1., 0. } };
const std::vector<std::array<double, 2>> Chart = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } };

class FramesFilter : public ::testing::Test
{
protected:
  void SetUp() override { this->Recorder.Watch(this->Filter); }

  vtkPolyData* Run(vtkPolyData* mesh)
  {
    this->Recorder.Clear();
    this->Filter->SetInputData(mesh);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  void ExpectRefused(vtkPolyData* mesh, const std::string& part)
  {
    vtkPolyData* output = this->Run(mesh);
    ASSERT_EQ(this->Recorder.Errors.size(), 1u) << part;
    EXPECT_NE(this->Recorder.Errors[0].find(part), std::string::npos) << this->Recorder.Errors[0];
    EXPECT_NE(this->Filter->GetErrorMessage().find(part), std::string::npos);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_EQ(output->GetNumberOfCells(), 0);
  }

  ErrorRecorder Recorder;
  vtkNew<vtkMesoSurfaceFrames> Filter;
};

vtkSmartPointer<vtkPolyData> OneSquare()
{
  return MakeMesh(Square, Chart, { { 0, 1, 2, 3 } });
}
}

TEST_F(FramesFilter, RefusesWhatItCannotUseInOneLine)
{
  this->ExpectRefused(MakeMesh(Square, {}, { { 0, 1, 2 } }), "no texture coordinates");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto chart = Chart;
  chart[2] = { 1., nan };
  chart[3] = { nan, 1. };
  this->ExpectRefused(
    MakeMesh(Square, chart, { { 0, 1, 2, 3 } }), "texture coordinate of point 2 is not finite");
  auto positions = Square;
  positions[1][2] = std::numeric_limits<double>::infinity();
  this->ExpectRefused(
    MakeMesh(positions, Chart, { { 0, 1, 2, 3 } }), "position of point 1 is not finite");
  this->ExpectRefused(
    MakeMesh(Square, Chart, { { 0, 1, 2 }, { 0, 1, 4 } }), "polygon 1 names point 4");
  this->ExpectRefused(MakeMesh(Square, Chart, { { 0, 1, -1 } }), "names point -1");

  const auto mesh = OneSquare();
  vtkNew<vtkFloatArray> three;
  three->SetNumberOfComponents(3);
  three->SetNumberOfTuples(4);
  three->Fill(0.);
  mesh->GetPointData()->SetTCoords(three);
  this->ExpectRefused(mesh, "3 components");

  vtkPolyData* output = this->Run(OneSquare());
  EXPECT_TRUE(this->Recorder.Errors.empty());
  EXPECT_TRUE(this->Filter->GetErrorMessage().empty());
  EXPECT_EQ(output->GetNumberOfPolys(), 2);
}

TEST_F(FramesFilter, TakesAnEmptyMesh)
{
  vtkNew<vtkPolyData> empty;
  EXPECT_EQ(this->Run(empty)->GetNumberOfPoints(), 0);
  EXPECT_TRUE(this->Recorder.Errors.empty());
}

TEST_F(FramesFilter, LeavesOutVertexAndLineCellsAndCellsOfTwoPoints)
{
  const auto mesh = MakeMesh(Square, Chart, { { 0, 1 }, { 0, 1, 2, 3 }, {} });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 1 });
  mesh->SetLines(lines);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 2 });
  mesh->SetVerts(vertices);
  vtkNew<vtkIntArray> number;
  number->SetName("number");
  for (int i = 0; i < 5; ++i)
  {
    number->InsertNextValue(i);
  }
  mesh->GetCellData()->AddArray(number);
  vtkPolyData* output = this->Run(mesh);
  EXPECT_TRUE(this->Recorder.Errors.empty());
  ASSERT_EQ(output->GetNumberOfCells(), 2);
  ASSERT_NE(output->GetCellData()->GetArray("number"), nullptr);
  ASSERT_EQ(output->GetCellData()->GetArray("number")->GetNumberOfTuples(), 2);
  EXPECT_EQ(output->GetCellData()->GetArray("number")->GetComponent(1, 0), 3.);
}

TEST_F(FramesFilter, CutsStrips)
{
  const auto mesh = MakeMesh(Square, Chart, {});
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 0, 1, 3, 2 });
  mesh->SetStrips(strips);
  vtkPolyData* output = this->Run(mesh);
  EXPECT_EQ(output->GetNumberOfPolys(), 2);
  EXPECT_EQ(output->GetNumberOfStrips(), 0);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_LT(DistanceOf(TupleOf(output, "MesoTangent", i), { 1., 0., 0. }), 1e-12);
    EXPECT_LT(DistanceOf(TupleOf(output, "Normals", i), { 0., 0., 1. }), 1e-12);
  }
}

TEST_F(FramesFilter, CarriesDataAndNamesWhatIsActive)
{
  const auto mesh = MakeMesh(
    Square, { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 0. } }, { { 0, 1, 2 }, { 0, 2, 3 } });
  mesh->GetPointData()->GetTCoords()->SetComponent(3, 0, 1.); // mirrors the second triangle
  vtkNew<vtkIntArray> ids;
  ids->SetName("ids");
  for (int i = 0; i < 4; ++i)
  {
    ids->InsertNextValue(10 + i);
  }
  mesh->GetPointData()->AddArray(ids);
  vtkNew<vtkDoubleArray> weights;
  weights->SetName("weights");
  weights->InsertNextValue(0.5);
  weights->InsertNextValue(0.25);
  mesh->GetCellData()->SetScalars(weights);
  vtkPolyData* output = this->Run(mesh);
  ASSERT_EQ(output->GetNumberOfPoints(), 6);
  EXPECT_EQ(TupleOf(output, "ids", 3)[0], 13.);
  EXPECT_EQ(TupleOf(output, "ids", 4)[0], 10.);
  EXPECT_EQ(TupleOf(output, "ids", 5)[0], 12.);
  ASSERT_NE(output->GetCellData()->GetScalars(), nullptr);
  EXPECT_EQ(output->GetCellData()->GetScalars()->GetComponent(1, 0), 0.25);
  ASSERT_NE(output->GetPointData()->GetTCoords(), nullptr);
  EXPECT_STREQ(output->GetPointData()->GetTCoords()->GetName(), "TextureCoordinates");
  EXPECT_EQ(output->GetPointData()->GetArray("uv"), nullptr);
  ASSERT_NE(output->GetPointData()->GetNormals(), nullptr);
  EXPECT_STREQ(output->GetPointData()->GetNormals()->GetName(), "Normals");
  EXPECT_STREQ(mesh->GetPointData()->GetTCoords()->GetName(), "uv"); // the input is as it was
  EXPECT_EQ(mesh->GetNumberOfPoints(), 4);
  EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 2);
}

TEST_F(FramesFilter, KeepsNormalsAndMakesThoseOfLengthZero)
{
  const auto mesh = OneSquare();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("given");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 4; ++i)
  {
    normals->InsertNextTuple3(0., 0.6, 0.8);
  }
  mesh->GetPointData()->SetNormals(normals);
  vtkPolyData* output = this->Run(mesh);
  EXPECT_LT(DistanceOf(TupleOf(output, "Normals", 2), { 0., 0.6, 0.8 }), 1e-6);
  // dp/dv = (0, 1, 0) projected into the plane at right angles to the normal.
  EXPECT_LT(DistanceOf(TupleOf(output, "MesoBitangent", 2), { 0., 0.8, -0.6 }), 1e-6);
  EXPECT_NEAR(TupleOf(output, "MesoTileScale", 2)[1], 0.8, 1e-6);
  EXPECT_EQ(output->GetPointData()->GetArray("given"), nullptr);

  normals->SetTuple3(2, 0., 0., 0.);
  normals->Modified();
  mesh->Modified();
  output = this->Run(mesh);
  EXPECT_LT(DistanceOf(TupleOf(output, "Normals", 2), { 0., 0., 1. }), 1e-6);
  EXPECT_LT(DistanceOf(TupleOf(output, "Normals", 1), { 0., 0.6, 0.8 }), 1e-6);
  EXPECT_EQ(TupleOf(output, "MesoFrameValid", 2)[0], 1.);
}

TEST_F(FramesFilter, BelievesMesoVertexOnlyWhereItNumbersPositions)
{
  // The square's two triangles, apart: points 0 and 3, and 2 and 4, are at the same positions.
  const auto mesh = MakeMesh({ Square[0], Square[1], Square[2], Square[0], Square[2], Square[3] },
    { Chart[0], Chart[1], Chart[2], Chart[0], Chart[2], Chart[3] }, { { 0, 1, 2 }, { 3, 4, 5 } });
  vtkNew<vtkDoubleArray> vertex;
  vertex->SetName("MesoVertex");
  for (int i = 0; i < 6; ++i)
  {
    vertex->InsertNextValue(i);
  }
  mesh->GetPointData()->AddArray(vertex);
  EXPECT_EQ(TupleOf(this->Run(mesh), "MesoVertex", 3)[0], 3.); // sheets may be apart
  for (double wrong : { 1., 0.5, -1., 6., std::numeric_limits<double>::quiet_NaN() })
  {
    vertex->SetValue(3, wrong);
    mesh->Modified();
    vtkPolyData* output = this->Run(mesh);
    EXPECT_EQ(TupleOf(output, "MesoVertex", 3)[0], 0.) << wrong;
    EXPECT_EQ(TupleOf(output, "MesoVertex", 4)[0], 2.) << wrong;
    EXPECT_EQ(TupleOf(output, "MesoVertex", 5)[0], 3.) << wrong;
  }
}

TEST_F(FramesFilter, KeepsPrecisionAndIsDeterministic)
{
  vtkNew<vtkMesoShapeSource> source;
  source->SetShape("torus");
  for (int precision : { vtkAlgorithm::SINGLE_PRECISION, vtkAlgorithm::DOUBLE_PRECISION })
  {
    source->SetOutputPointsPrecision(precision);
    source->Update();
    const int type = precision == vtkAlgorithm::SINGLE_PRECISION ? VTK_FLOAT : VTK_DOUBLE;
    vtkNew<vtkPolyData> first;
    first->DeepCopy(this->Run(source->GetOutput()));
    this->Filter->Modified();
    vtkPolyData* second = this->Run(source->GetOutput());
    EXPECT_EQ(second->GetPoints()->GetDataType(), type);
    for (const char* name : { "MesoTangent", "MesoBitangent", "MesoTileScale", "MesoFrameValid" })
    {
      vtkDataArray* a = first->GetPointData()->GetArray(name);
      vtkDataArray* b = second->GetPointData()->GetArray(name);
      ASSERT_NE(b, nullptr);
      EXPECT_EQ(b->GetDataType(), type);
      const std::size_t bytes = a->GetDataSize() * a->GetDataTypeSize();
      EXPECT_EQ(std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0), bytes), 0) << name;
    }
  }
}
