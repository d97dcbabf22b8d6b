// Volumes of files: what good files hold, what is said of bad ones, and that damaged ones do no harm.

#include "MessageOf.h"
#include "Mutations.h"
#include "TemporaryFolder.h"

#include "MesoImageFile.h"
#include "MesoScene.h"
#include "MesoVolumeFile.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataWriter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
// Twelve numbers, 0 to 11, as zlib's compress makes them (Python: zlib.compress(bytes(range(12)))).
const std::string Compressed(
  "\x78\x9c\x63\x60\x64\x62\x66\x61\x65\x63\xe7\xe0\xe4\xe2\x06\x00\x01\x2a\x00\x43", 20);

std::string Numbers()
{
  std::string bytes;
  for (int i = 0; i < 12; ++i)
  {
    bytes.push_back(static_cast<char>(i));
  }
  return bytes;
}

const std::string NrrdHead = "NRRD0004\n# a comment\ntype: uint8\ndimension: 3\nsizes: 3 2 2\n";
const std::string MetaHead = "ObjectType = Image\nNDims = 3\nDimSize = 3 2 2\n"
                             "ElementType = MET_UCHAR\nElementSpacing = 1 2 4\n";

/// The file under that name, or what is wrong with it.
std::string Message(const std::string& name, const std::string& bytes)
{
  const TemporaryFolder folder;
  const std::string path = folder.Write(name, bytes);
  const std::string message = MessageOf([&]() { MesoReadVolumeFile(path); });
  return message.compare(0, path.size() + 2, path + ": ") == 0 ? message.substr(path.size() + 2)
                                                               : message;
}

void ExpectNumbers(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  EXPECT_EQ(size[0], 3);
  EXPECT_EQ(size[1], 2);
  EXPECT_EQ(size[2], 2);
  for (int i = 0; i < 12; ++i)
  {
    EXPECT_EQ(image->GetPointData()->GetScalars()->GetTuple1(i), i);
  }
}

vtkSmartPointer<vtkImageData> Read(const std::string& name, const std::string& bytes)
{
  const TemporaryFolder folder;
  return MesoReadVolumeFile(folder.Write(name, bytes));
}

/// A VTK image file of the numbers, compressed and all.
std::string VtiBytes()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 2, 2);
  image->SetSpacing(1., 2., 4.);
  image->AllocateScalars(VTK_SHORT, 1);
  for (int i = 0; i < 12; ++i)
  {
    static_cast<short*>(image->GetScalarPointer())[i] = static_cast<short>(i);
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputData(image);
  writer->WriteToOutputStringOn();
  writer->Write();
  return writer->GetOutputString();
}
}

TEST(VolumeFile, ReadsNrrd)
{
  ExpectNumbers(Read("a.nrrd", NrrdHead + "encoding: raw\n\n" + Numbers()));
  ExpectNumbers(Read("a.nrrd", NrrdHead + "encoding: gzip\n\n" + Compressed));
  ExpectNumbers(Read("a.nrrd", NrrdHead + "encoding: ascii\n\n0 1 2 3 4 5 6 7 8 9 10 11"));
  const auto image = Read("a.nrrd", NrrdHead + "encoding: raw\nspacings: 1 2 4\n\n" + Numbers());
  EXPECT_EQ(image->GetSpacing()[2], 4.);
  const auto turned = Read("a.nrrd",
    NrrdHead + "encoding: raw\nspace directions: (0,3,4) (2,0,0) (0,0,1)\n\n" + Numbers());
  EXPECT_EQ(turned->GetSpacing()[0], 5.);
  ExpectNumbers(Read("a.nrrd", NrrdHead + "encoding: raw\nbyte skip: -1\n\nskipped" + Numbers()));
}

TEST(VolumeFile, ReadsNumbersInTheOrderOfTheirBytes)
{
  const std::string head =
    "NRRD0001\ntype: unsigned short\ndimension: 3\nsizes: 1 1 2\nencoding: raw\n";
  for (const bool isBig : { false, true })
  {
    // This machine's order is little.
    const auto image = Read("a.nrrd",
      head + "endian: " + (isBig ? "big" : "little") + "\n\n" + BytesOf(std::uint16_t(258), isBig) +
        BytesOf(std::uint16_t(7), isBig));
    EXPECT_EQ(image->GetPointData()->GetScalars()->GetTuple1(0), 258.);
    EXPECT_EQ(image->GetPointData()->GetScalars()->GetTuple1(1), 7.);
  }
}

TEST(VolumeFile, ReadsMetaImage)
{
  const auto local = Read("a.mha", MetaHead + "ElementDataFile = LOCAL\n" + Numbers());
  ExpectNumbers(local);
  EXPECT_EQ(local->GetSpacing()[1], 2.);
  ExpectNumbers(
    Read("a.mha", MetaHead + "CompressedData = True\nElementDataFile = LOCAL\n" + Compressed));
  const TemporaryFolder folder;
  folder.Write("a.raw", Numbers());
  ExpectNumbers(MesoReadVolumeFile(folder.Write("a.mhd", MetaHead + "ElementDataFile = a.raw\n")));
}

TEST(VolumeFile, ReadsVti)
{
  const auto image = Read("a.vti", VtiBytes());
  ExpectNumbers(image);
  EXPECT_EQ(image->GetSpacing()[2], 4.);
}

TEST(VolumeFile, SaysWhatIsWrong)
{
  const std::string raw = "encoding: raw\n\n";
  EXPECT_NE(Message("a.nrrd", "junk").find("no NRRD file"), std::string::npos);
  EXPECT_NE(Message("a.nrrd", "").find("no NRRD file"), std::string::npos);
  EXPECT_NE(Message("a.nrrd", NrrdHead + raw + "123").find("fewer numbers"), std::string::npos);
  EXPECT_NE(Message("a.nrrd", NrrdHead + "encoding: bzip2\n\n").find("bzip2"), std::string::npos);
  EXPECT_NE(
    Message("a.nrrd", "NRRD0004\ntype: uint8\ndimension: 2\nsizes: 3 2\n" + raw).find("three"),
    std::string::npos);
  EXPECT_NE(
    Message("a.nrrd", "NRRD0004\ntype: block\ndimension: 3\nsizes: 3 2 2\n" + raw).find("type"),
    std::string::npos);
  EXPECT_NE(Message("a.nrrd", "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 3 2 99999999\n" + raw)
              .find("4096"),
    std::string::npos);
  EXPECT_NE(Message("a.nrrd",
              "NRRD0004\ntype: double\nendian: big\ndimension: 3\nsizes: 4096 4096 4096\n" + raw)
              .find("2 GiB"),
    std::string::npos);
  std::string damaged = Compressed;
  damaged[9] = 'x';
  EXPECT_NE(Message("a.nrrd", NrrdHead + "encoding: gzip\n\n" + damaged).find("damaged"),
    std::string::npos);
  EXPECT_NE(
    Message("a.nrrd", NrrdHead + "encoding: text\n\n1 2 3 x 1 1 1 1 1 1 1 1 1").find("3 numbers"),
    std::string::npos);
  EXPECT_NE(
    Message("a.nrrd", NrrdHead + "encoding: text\n\n1 2 3 999 1 1 1 1 1 1 1 1").find("beyond"),
    std::string::npos);
  EXPECT_NE(Message("a.mha", "junk\n").find("without '='"), std::string::npos);
  EXPECT_NE(
    Message("a.mha", MetaHead + "ElementDataFile = LIST\n").find("several"), std::string::npos);
  EXPECT_NE(Message("a.mhd", MetaHead + "ElementDataFile = none.raw\n").find("no such file"),
    std::string::npos);
  EXPECT_NE(Message("a.vti", "junk").find("no extent"), std::string::npos);
  EXPECT_NE(
    Message("a.vti", "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"0 9 0 9 0 999999\">")
      .find("4096"),
    std::string::npos);
  EXPECT_NE(Message("a.vol", "junk").find(".nrrd"), std::string::npos);
  EXPECT_NE(MessageOf([]() { MesoReadVolumeFile("/none/a.nrrd"); }).find("no such file"),
    std::string::npos);
  EXPECT_NE(
    MessageOf([]() { MesoReadVolumeFile("/none/a.tif"); }).find("no such file"), std::string::npos);
}

TEST(VolumeFile, RefusesATiffOfOneImage)
{
  const TemporaryFolder folder;
  const std::string path = folder.PathOf("a.tif");
  const std::vector<float> numbers(12, 0.5f);
  MesoWriteImage(path, 4, 3, 1, MesoImageHeader::Type::UnsignedChar, numbers.data());
  EXPECT_NE(MessageOf([&]() { MesoReadVolumeFile(path); }).find("1 image"), std::string::npos);
}

TEST(VolumeFile, DamagedFilesDoNoHarm)
{
  const std::pair<std::string, std::string> files[] = {
    { "a.nrrd", NrrdHead + "encoding: raw\nspacings: 1 2 4\n\n" + Numbers() },
    { "a.nrrd", NrrdHead + "encoding: gzip\n\n" + Compressed },
    { "a.nrrd", NrrdHead + "encoding: text\n\n0 1 2 3 4 5 6 7 8 9 10 11" },
    { "a.mha", MetaHead + "CompressedData = True\nElementDataFile = LOCAL\n" + Compressed },
    { "a.vti", VtiBytes() }
  };
  const std::vector<std::string> words = { "nan", "-1", "99999999999", "1e300", "\n\n", ": ", " = ",
    "sizes: ", "DimSize = ", "Extent=\"0 9 0 9 0 9\"", "gzip", "LOCAL", std::string(1, '\0') };
  int read = 0;
  for (const auto& [name, bytes] : files)
  {
    Mutator mutator(7);
    for (int i = 0; i < 150; ++i)
    {
      const std::string message = Message(name, mutator.Damage(bytes, words));
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      read += message == "read without an error";
    }
  }
  EXPECT_GT(read, 20);
  EXPECT_LT(read, 600);
}

TEST(VolumeReport, CountsNumbersAndTheStepOverTheBorder)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 4, 2);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int n = 0; n < 64; ++n)
  {
    values[n] = static_cast<float>(n % 8); // a ramp in x, the same in y and z
  }
  MesoVolumeReport report = MesoReportVolume(image);
  EXPECT_EQ(report.Size[0], 8);
  EXPECT_EQ(report.Least, 0.);
  EXPECT_EQ(report.Most, 7.);
  EXPECT_EQ(report.Mean, 3.5);
  EXPECT_EQ(report.Tiling[0].Inside, 1.);
  EXPECT_EQ(report.Tiling[0].AcrossBorder, 7.);
  EXPECT_STREQ(report.Tiling[0].Verdict(), "no");
  EXPECT_STREQ(report.Tiling[1].Verdict(), "yes");
  values[5] = NAN;
  report = MesoReportVolume(image);
  EXPECT_EQ(report.NotFinite, 1u);
}

TEST(VolumeReport, PartsTwoGroupsOfNumbersInTheMiddleBetweenThem)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(10, 10, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int n = 0; n < 100; ++n)
  {
    values[n] = static_cast<unsigned char>(n < 90 ? n % 10 : 200 + n % 10);
  }
  EXPECT_NEAR(MesoReportVolume(image).Parting, 0.5 * (9. + 200.), 3.);
}
