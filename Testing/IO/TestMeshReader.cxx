// vtkMesoMeshReader: arrays and their types, errors of one line, and empty output after them.

#include "ErrorRecorder.h"
#include "TemporaryFolder.h"

#include "vtkMesoMeshReader.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace
{
const std::string Quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                         "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1 4/4/1\n";

class MeshReader : public ::testing::Test
{
protected:
  vtkPolyData* Read(const std::string& name, const std::string& text)
  {
    this->Reader->SetFileName(this->Folder.Write(name, text).c_str());
    this->Reader->Modified(); // the name may be as before
    this->Reader->Update();
    return this->Reader->GetOutput();
  }

  void SetUp() override { this->Recorder.Watch(this->Reader); }

  TemporaryFolder Folder;
  ErrorRecorder Recorder;
  vtkNew<vtkMesoMeshReader> Reader;
};
}

TEST_F(MeshReader, GivesNamedAndActiveArrays)
{
  vtkPolyData* mesh = this->Read("quad.obj", Quad);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 4);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 2);
  vtkPointData* data = mesh->GetPointData();
  ASSERT_NE(data->GetTCoords(), nullptr);
  EXPECT_STREQ(data->GetTCoords()->GetName(), "TextureCoordinates");
  EXPECT_EQ(data->GetTCoords()->GetNumberOfComponents(), 2);
  EXPECT_EQ(data->GetTCoords()->GetComponent(2, 1), 1.);
  ASSERT_NE(data->GetNormals(), nullptr);
  EXPECT_EQ(data->GetNormals()->GetComponent(3, 2), 1.);
  ASSERT_NE(data->GetArray("MesoVertex"), nullptr);
  EXPECT_EQ(data->GetArray("MesoVertex")->GetComponent(3, 0), 3.);
  EXPECT_EQ(mesh->GetPoints()->GetDataType(), VTK_FLOAT);
  EXPECT_EQ(this->Reader->GetNumberOfOpenEdges(), 4);
  EXPECT_EQ(this->Reader->GetNumberOfSheets(), 1);
  EXPECT_TRUE(this->Recorder.Errors.empty());
  EXPECT_TRUE(this->Recorder.Warnings.empty());
}

TEST_F(MeshReader, PositionsAreDoubleWhereFloatLosesTooMuch)
{
  const std::string faces = "vt 0 0\nf 1/1 2/1 3/1\n";
  EXPECT_EQ(this->Read("a.obj", "v 1000000.125 0 0\nv 1000001.3 0 0\nv 1000000 1 0\n" + faces)
              ->GetPoints()
              ->GetDataType(),
    VTK_DOUBLE);
  EXPECT_EQ(this->Reader->GetOutput()->GetPoint(1)[0], 1000001.3);
  EXPECT_EQ(
    this->Read("b.obj", "v 0.1 0 0\nv 0.2 0 0\nv 0.1 0.3 0\n" + faces)->GetPoints()->GetDataType(),
    VTK_FLOAT);
  EXPECT_EQ(this->Read("c.obj", "v 0.1e-6 0 0\nv 0.2e-6 0 0\nv 0.1e-6 0.3e-6 0\n" + faces)
              ->GetPoints()
              ->GetDataType(),
    VTK_FLOAT);
}

TEST_F(MeshReader, RefusalIsOneLineAndAnEmptyOutput)
{
  this->Read("quad.obj", Quad);
  const std::pair<const char*, const char*> cases[] = {
    { "", "bad.obj: is empty" },
    { "junk\x01\x02", "bad.obj: line 1: " },
    { "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n", "bad.obj: line 4: there is no vertex 7" },
    { "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "bad.obj: line 1: \"nan\" is not finite" },
  };
  for (const auto& [text, part] : cases)
  {
    this->Recorder.Clear();
    vtkPolyData* mesh = this->Read("bad.obj", text);
    EXPECT_EQ(mesh->GetNumberOfPoints(), 0);
    EXPECT_EQ(mesh->GetNumberOfCells(), 0);
    EXPECT_EQ(mesh->GetPointData()->GetNumberOfArrays(), 0);
    ASSERT_EQ(this->Recorder.Errors.size(), 1u) << part;
    EXPECT_NE(this->Recorder.Errors[0].find(part), std::string::npos) << this->Recorder.Errors[0];
    EXPECT_NE(this->Reader->GetErrorMessage().find(part), std::string::npos);
    EXPECT_EQ(this->Reader->GetErrorMessage().find('\n'), std::string::npos);
  }
}

TEST_F(MeshReader, RefusesFilesByName)
{
  this->Reader->SetFileName("/tmp");
  this->Reader->Update();
  EXPECT_EQ(this->Reader->GetErrorMessage(), "/tmp: is a folder, not a file");
  this->Read("a.png", Quad);
  EXPECT_NE(this->Reader->GetErrorMessage().find("is not a mesh by its name"), std::string::npos);
  this->Reader->SetFileName("/no/such.obj");
  this->Reader->Update();
  EXPECT_EQ(this->Reader->GetErrorMessage(), "/no/such.obj: there is no such file");
  this->Reader->SetFileName(nullptr);
  this->Reader->Update();
  EXPECT_NE(this->Reader->GetErrorMessage().find("no file name"), std::string::npos);
  EXPECT_EQ(this->Recorder.Errors.size(), 4u);
  EXPECT_EQ(this->Read("UPPER.OBJ", Quad)->GetNumberOfPolys(), 2);
  EXPECT_TRUE(this->Reader->GetErrorMessage().empty());
}

TEST_F(MeshReader, WarnsOfWhatIsOdd)
{
  this->Read("odd.obj", "mtllib missing.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n");
  ASSERT_EQ(this->Reader->GetNotes().size(), 2u);
  ASSERT_EQ(this->Recorder.Warnings.size(), 2u);
  EXPECT_NE(this->Recorder.Warnings[0].find("1 of 4 vertices are in no face (first vertex 4)"),
    std::string::npos);
  EXPECT_NE(this->Recorder.Warnings[1].find("has no texture coordinates"), std::string::npos);
  EXPECT_EQ(this->Reader->GetOutput()->GetPointData()->GetTCoords(), nullptr);
  EXPECT_EQ(this->Reader->GetOutput()->GetPointData()->GetNormals(), nullptr);
}
