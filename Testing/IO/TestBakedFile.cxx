// Baked tables: what is written comes back, and nothing else is taken for it.

#include "MesoBakedFile.h"
#include "MesoScene.h"
#include "TemporaryFolder.h"

#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <cinttypes>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>

namespace
{
/// A table of 5 x 4 x 3 with two components, a smaller one beside it, parameters of either kind.
MesoBaked SmallTable()
{
  MesoBaked baked;
  baked.Kind = "horizon";
  baked.Parameters["depth"] = std::vector<double>{ 0.1 };
  baked.Parameters["range"] = std::vector<double>{ -2., 1. / 3. };
  baked.Parameters["wrap"] = std::string("mirror");
  baked.Table = vtkSmartPointer<vtkImageData>::New();
  baked.Table->SetDimensions(5, 4, 3);
  baked.Table->SetSpacing(0.2, 0.25, 1.);
  vtkNew<vtkFloatArray> table;
  table->SetName("Angle");
  table->SetNumberOfComponents(2);
  for (int i = 0; i < 5 * 4 * 3; ++i)
  {
    table->InsertNextTuple2(std::sin(i), 1e-30 * i);
  }
  baked.Table->GetPointData()->SetScalars(table);
  vtkNew<vtkFloatArray> weights;
  weights->SetName("Weights");
  weights->InsertNextValue(3.f);
  weights->InsertNextValue(-0.f);
  baked.Table->GetFieldData()->AddArray(weights);
  return baked;
}

std::string ReasonNotToRead(const std::string& fileName, const std::string& kind = {})
{
  try
  {
    MesoReadBaked(fileName, kind);
  }
  catch (const MesoInputError& problem)
  {
    EXPECT_EQ(std::string(problem.what()).compare(0, fileName.size() + 2, fileName + ": "), 0);
    EXPECT_EQ(std::string(problem.what()).find('\n'), std::string::npos);
    return problem.what();
  }
  return {};
}

std::string ReasonNotToWrite(const std::string& fileName, const MesoBaked& baked)
{
  try
  {
    MesoWriteBaked(fileName, baked);
  }
  catch (const MesoInputError& problem)
  {
    return problem.what();
  }
  return {};
}

std::string BytesOf(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}
}

TEST(MesoBakedFile, ComesBackAsItWas)
{
  const TemporaryFolder folder;
  const std::string name = folder.PathOf("x.vti");
  const MesoBaked written = SmallTable();
  MesoWriteBaked(name, written);
  EXPECT_EQ(written.Table->GetFieldData()->GetNumberOfArrays(), 1) << "the caller's own is changed";

  const MesoBaked read = MesoReadBaked(name, "horizon");
  EXPECT_EQ(read.Kind, "horizon");
  EXPECT_EQ(read.Parameters, written.Parameters);
  EXPECT_EQ(read.Table->GetFieldData()->GetNumberOfArrays(), 1);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(read.Table->GetDimensions()[i], written.Table->GetDimensions()[i]);
    EXPECT_EQ(read.Table->GetSpacing()[i], written.Table->GetSpacing()[i]);
  }
  vtkDataArray* table = read.Table->GetPointData()->GetArray("Angle");
  ASSERT_TRUE(table);
  ASSERT_EQ(table->GetNumberOfComponents(), 2);
  ASSERT_EQ(table->GetNumberOfTuples(), 60);
  EXPECT_EQ(std::memcmp(table->GetVoidPointer(0),
              written.Table->GetPointData()->GetScalars()->GetVoidPointer(0), 120 * sizeof(float)),
    0);
  vtkDataArray* weights = read.Table->GetFieldData()->GetArray("Weights");
  ASSERT_TRUE(weights);
  EXPECT_EQ(weights->GetTuple1(0), 3.);
  EXPECT_TRUE(std::signbit(weights->GetTuple1(1)));
}

TEST(MesoBakedFile, SameContentsGiveTheSameBytes)
{
  const TemporaryFolder folder;
  MesoWriteBaked(folder.PathOf("x.vti"), SmallTable());
  MesoWriteBaked(folder.PathOf("y.vti"), SmallTable());
  EXPECT_EQ(BytesOf(folder.PathOf("x.vti")), BytesOf(folder.PathOf("y.vti")));
  EXPECT_EQ(folder.Names().size(), 2u);
}

TEST(MesoBakedFile, VTKReadsIt)
{
  const TemporaryFolder folder;
  MesoWriteBaked(folder.PathOf("x.vti"), SmallTable());
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(folder.PathOf("x.vti").c_str());
  reader->Update();
  vtkFieldData* data = reader->GetOutput()->GetFieldData();
  EXPECT_EQ(vtkStringArray::SafeDownCast(data->GetAbstractArray("meso.kind"))->GetValue(0),
    std::string("horizon"));
  EXPECT_EQ(data->GetArray("meso.format")->GetTuple1(0), MesoBakedFormat);
  EXPECT_EQ(data->GetArray("meso.parameter.range")->GetTuple1(1), 1. / 3.);
}

TEST(MesoBakedFile, RefusesWhatIsNotOne)
{
  const TemporaryFolder folder;
  EXPECT_NE(ReasonNotToRead(folder.PathOf("none.vti")).find("no such file"), std::string::npos);
  for (const char* text : { "", "junk", "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\"/>" })
  {
    const std::string name = folder.Write("junk.vti", text);
    EXPECT_NE(ReasonNotToRead(name).find("is no baked file"), std::string::npos) << text;
  }
  vtkNew<vtkXMLImageDataWriter> writer; // an image, but none of ours
  writer->SetInputData(SmallTable().Table);
  writer->SetFileName(folder.PathOf("plain.vti").c_str());
  writer->Write();
  EXPECT_NE(
    ReasonNotToRead(folder.PathOf("plain.vti")).find("is no baked file"), std::string::npos);

  MesoWriteBaked(folder.PathOf("x.vti"), SmallTable());
  EXPECT_NE(
    ReasonNotToRead(folder.PathOf("x.vti"), "cone").find("holds a baked horizon, not a cone"),
    std::string::npos);
}

TEST(MesoBakedFile, RefusesAnotherFormatAndAChangedValue)
{
  const TemporaryFolder folder;
  const auto changed = [&](const char* array, double value)
  {
    MesoWriteBaked(folder.PathOf("x.vti"), SmallTable());
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName(folder.PathOf("x.vti").c_str());
    reader->Update();
    vtkImageData* image = reader->GetOutput();
    vtkDataArray* numbers = image->GetFieldData()->GetArray(array);
    (numbers ? numbers : image->GetPointData()->GetArray(array))->SetComponent(0, 0, value);
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetInputData(image);
    writer->SetFileName(folder.PathOf("y.vti").c_str());
    writer->Write();
    // Sealed as if all were well: 64-bit FNV-1a.
    std::string bytes = BytesOf(folder.PathOf("y.vti"));
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char byte : bytes)
    {
      hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    }
    char seal[64];
    std::snprintf(seal, sizeof(seal), "<!-- meso %016" PRIx64 " -->\n", hash);
    return ReasonNotToRead(folder.Write("z.vti", bytes + seal));
  };
  EXPECT_EQ(changed("meso.format", 1.), "") << "the same contents";
  EXPECT_NE(changed("meso.format", 2.).find("is of format 2"), std::string::npos);
  EXPECT_NE(changed("Angle", 0.5).find("checksum"), std::string::npos);
  EXPECT_NE(changed("Weights", 3.5).find("checksum"), std::string::npos);
  EXPECT_NE(changed("meso.parameter.depth", 0.2).find("checksum"), std::string::npos);
}

TEST(MesoBakedFile, RefusesATruncatedFile)
{
  const TemporaryFolder folder;
  MesoWriteBaked(folder.PathOf("x.vti"), SmallTable());
  const std::string bytes = BytesOf(folder.PathOf("x.vti"));
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 150)
  {
    EXPECT_NE(ReasonNotToRead(folder.Write("y.vti", bytes.substr(0, size))), "") << size;
  }
  EXPECT_NE(ReasonNotToRead(folder.Write("y.vti", bytes.substr(0, bytes.size() - 1))), "");
  EXPECT_NE(ReasonNotToRead(folder.Write("y.vti", bytes + "\n")), "");
}

TEST(MesoBakedFile, RefusesEveryChangedByte)
{
  const TemporaryFolder folder;
  MesoWriteBaked(folder.PathOf("x.vti"), SmallTable());
  const std::string bytes = BytesOf(folder.PathOf("x.vti"));
  for (std::size_t i = 0; i < bytes.size(); i += 7)
  {
    std::string changed = bytes;
    changed[i] = static_cast<char>(changed[i] ^ (1 << i % 8));
    EXPECT_NE(ReasonNotToRead(folder.Write("y.vti", changed)), "") << i;
  }
}

TEST(MesoBakedFile, WritesNothingThatMakesNoSense)
{
  const TemporaryFolder folder;
  const std::string name = folder.PathOf("x.vti");
  MesoBaked baked = SmallTable();
  baked.Kind.clear();
  EXPECT_NE(ReasonNotToWrite(name, baked).find("there is no kind"), std::string::npos);
  baked = SmallTable();
  baked.Table = nullptr;
  EXPECT_NE(ReasonNotToWrite(name, baked).find("there is no table"), std::string::npos);
  baked = SmallTable();
  baked.Table->GetFieldData()->GetArray(0)->SetName("meso.weights");
  EXPECT_NE(ReasonNotToWrite(name, baked).find("begins with"), std::string::npos);
  EXPECT_NE(ReasonNotToWrite(folder.PathOf("no/x.vti"), SmallTable()), "");
  EXPECT_TRUE(folder.Names().empty());
}
