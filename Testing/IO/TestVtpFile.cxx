// VTP through VTK: polygons, strips, arrays kept, and what VTK's reader does not check.

#include "MesoVtpFile.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkMesoMeshReader.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

#include <gtest/gtest.h>

namespace
{
/// A square as one polygon, a triangle as a strip, with texture coordinates and a further array.
std::string Square(bool isText)
{
  vtkNew<vtkPolyData> mesh;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double positions[5][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
    { 1e6 + 0.125, 0, 0 } };
  vtkNew<vtkFloatArray> texture;
  texture->SetName("TextureCoordinates");
  texture->SetNumberOfComponents(2);
  vtkNew<vtkDoubleArray> heat;
  heat->SetName("heat");
  for (const auto& position : positions)
  {
    points->InsertNextPoint(position);
    texture->InsertNextTuple2(position[0], position[1]);
    heat->InsertNextValue(10. * position[1] + position[0]);
  }
  mesh->SetPoints(points);
  mesh->GetPointData()->SetTCoords(texture);
  mesh->GetPointData()->AddArray(heat);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({ 1, 4, 2 });
  mesh->SetPolys(polygons);
  mesh->SetStrips(strips);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->WriteToOutputStringOn();
  if (isText)
  {
    writer->SetDataModeToAscii();
  }
  writer->Write();
  return writer->GetOutputString();
}

std::string Refusal(const std::string& bytes)
{
  return MessageOf([&] { MesoParseVtp(bytes, "m.vtp"); });
}

std::string Replaced(std::string text, const std::string& what, const std::string& instead)
{
  const std::size_t place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return text.replace(place, what.size(), instead);
}
}

TEST(VtpFile, ReadsPolygonsStripsAndArrays)
{
  for (bool isText : { true, false })
  {
    const auto file = MesoParseVtp(Square(isText), "m.vtp");
    ASSERT_EQ(file.NumberOfFaces(), 2u);
    EXPECT_EQ(file.FirstCorner, (std::vector<std::size_t>{ 0, 4, 7 }));
    EXPECT_EQ(file.Corners[6].Position, 2);
    EXPECT_EQ(file.Positions[4][0], 1e6 + 0.125);
    EXPECT_EQ(file.TextureCoordinates[2], (std::array<double, 2>{ 1., 1. }));
    EXPECT_EQ(file.Corners[6].TextureCoordinate, 2);
    ASSERT_NE(file.PointData, nullptr);
    EXPECT_EQ(file.PointData->GetNumberOfArrays(), 1);
    EXPECT_TRUE(file.Notes.empty());
  }
}

TEST(VtpFile, TheReaderKeepsFurtherPointArrays)
{
  const TemporaryFolder folder;
  vtkNew<vtkMesoMeshReader> reader;
  reader->SetFileName(folder.Write("m.vtp", Square(false)).c_str());
  reader->Update();
  vtkPointData* data = reader->GetOutput()->GetPointData();
  ASSERT_NE(data->GetArray("heat"), nullptr);
  ASSERT_EQ(data->GetArray("heat")->GetNumberOfTuples(), reader->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(data->GetArray("heat")->GetComponent(3, 0), 10.);
}

TEST(VtpFile, RefusesWhatVtkDoesNotCheck)
{
  const std::string text = Square(true);
  EXPECT_EQ(Refusal("junk"), "m.vtp: is no VTK XML file: it has no element VTKFile");
  EXPECT_NE(Refusal(Replaced(text, "NumberOfPoints=\"5\"", "NumberOfPoints=\"5000000000000\""))
              .find("NumberOfPoints 5000000000000 is more than the file can hold"),
    std::string::npos);
  EXPECT_EQ(Refusal(Replaced(text, "0 1 2 3\n", "0 1 2 9\n")),
    "m.vtp: polygon 0: there is no point 9 (there are 5, from 0)");
  EXPECT_EQ(Refusal(Replaced(text, "1 4 2\n", "1 -4 2\n")),
    "m.vtp: strip 0: there is no point -4 (there are 5, from 0)");
  EXPECT_EQ(Refusal(Replaced(text, "1000000.125 0 0", "nan 0 0")).compare(0, 7, "m.vtp: "), 0);
}

TEST(VtpFile, RefusesTruncationsInOneLine)
{
  const std::string whole = Square(true);
  for (std::size_t size = 0; size < whole.size() - 20; size += 37)
  {
    const std::string message = Refusal(whole.substr(0, size));
    EXPECT_EQ(message.compare(0, 7, "m.vtp: "), 0) << size << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}
