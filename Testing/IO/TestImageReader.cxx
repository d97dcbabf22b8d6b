// vtkMesoImageReader: precision, channels and rows kept; truncated, huge and odd files refused.

#include "ErrorRecorder.h"
#include "TemporaryFolder.h"
#include "TinyImages.h"

#include "MesoExr.h"
#include "vtkMesoImageReader.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTIFFWriter.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
/// An image of this size in which each component has another value.
vtkSmartPointer<vtkImageData> MakeImage(int width, int height, int type, int components)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      const double value = double(i) * components + k + 1;
      values->SetComponent(i, k, type == VTK_UNSIGNED_SHORT ? 257. * value : value);
    }
  }
  return image;
}

template <typename Writer>
void Write(const std::string& fileName, vtkImageData* image)
{
  vtkNew<Writer> writer;
  writer->SetFileName(fileName.c_str());
  writer->SetInputData(image);
  writer->Write();
}

std::string ReadBytes(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary);
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

class ImageReader : public ::testing::Test
{
protected:
  void SetUp() override { this->Recorder.Watch(this->Reader); }

  vtkImageData* Read(const std::string& fileName)
  {
    this->Recorder.Clear();
    this->Reader->SetFileName(fileName.c_str());
    this->Reader->Modified(); // the name may be as before
    this->Reader->Update();
    return this->Reader->GetOutput();
  }

  vtkImageData* ReadTiny(const char* name, const char* bytes)
  {
    return this->Read(this->Folder.Write(name, TinyImages::BytesOf(bytes)));
  }

  void ExpectRefused(const std::string& fileName, const std::string& part)
  {
    vtkImageData* image = this->Read(fileName);
    EXPECT_EQ(image->GetNumberOfPoints(), 0) << fileName;
    EXPECT_EQ(image->GetPointData()->GetNumberOfArrays(), 0) << fileName;
    const std::string message = this->Reader->GetErrorMessage();
    EXPECT_EQ(message.compare(0, fileName.size() + 2, fileName + ": "), 0) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(this->Recorder.Errors.size(), 1u) << message;
  }

  TemporaryFolder Folder;
  ErrorRecorder Recorder;
  vtkNew<vtkMesoImageReader> Reader;
};
}

TEST_F(ImageReader, KeepsPrecisionAndChannels)
{
  for (int type : { VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT })
  {
    for (int components = 1; components <= 4; ++components)
    {
      const auto written = MakeImage(3, 2, type, components);
      Write<vtkPNGWriter>(this->Folder.PathOf("a.png"), written);
      vtkImageData* image = this->Read(this->Folder.PathOf("a.png"));
      ASSERT_EQ(image->GetScalarType(), type);
      ASSERT_EQ(image->GetNumberOfScalarComponents(), components);
      int extent[6];
      image->GetExtent(extent);
      EXPECT_EQ(extent[1], 2);
      EXPECT_EQ(extent[3], 1);
      EXPECT_EQ(extent[5], 0);
      EXPECT_EQ(int(this->Reader->GetChannelNames().size()), components);
      for (vtkIdType i = 0; i < 6; ++i)
      {
        for (int k = 0; k < components; ++k)
        {
          // VTK's writers put row 0 at the bottom, as this reader does.
          EXPECT_EQ(image->GetPointData()->GetScalars()->GetComponent(i, k),
            written->GetPointData()->GetScalars()->GetComponent(i, k));
        }
      }
      EXPECT_TRUE(this->Recorder.Errors.empty());
    }
  }
}

TEST_F(ImageReader, LooksUpIndexedColorsAndHasTheLastRowFirst)
{
  vtkImageData* image = this->ReadTiny("indexed.png", TinyImages::IndexedPng);
  ASSERT_EQ(image->GetNumberOfScalarComponents(), 3);
  EXPECT_EQ(image->GetScalarComponentAsDouble(0, 1, 0, 0), 10.);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 1, 0, 1), 50.);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 0, 0, 2), 90.);
  image = this->ReadTiny("onebit.png", TinyImages::OneBitPng);
  ASSERT_EQ(image->GetNumberOfScalarComponents(), 1);
  EXPECT_EQ(image->GetScalarComponentAsDouble(0, 0, 0, 0), 255.);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 0, 0, 0), 0.);
}

TEST_F(ImageReader, ReadsHalfTiledAndFloat)
{
  vtkImageData* image = this->ReadTiny("half.exr", TinyImages::HalfTwoPartExr);
  ASSERT_EQ(image->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(image->GetScalarComponentAsDouble(0, 1, 0, 0), 0.25);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 0, 0, 0), -2.);
  ASSERT_EQ(this->Recorder.Warnings.size(), 1u);
  EXPECT_NE(this->Recorder.Warnings[0].find("several images"), std::string::npos);

  image = this->ReadTiny("tiled.exr", TinyImages::TiledExr);
  EXPECT_EQ(image->GetScalarComponentAsDouble(2, 1, 0, 0), 3.);
  EXPECT_EQ(image->GetScalarComponentAsDouble(0, 0, 0, 0), 4.);
  EXPECT_TRUE(this->Recorder.Warnings.empty());

  const auto written = MakeImage(4, 3, VTK_FLOAT, 1);
  Write<vtkTIFFWriter>(this->Folder.PathOf("float.tif"), written);
  image = this->Read(this->Folder.PathOf("float.tif"));
  ASSERT_EQ(image->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(image->GetScalarComponentAsDouble(1, 2, 0, 0), 10.);
}

TEST_F(ImageReader, ContentsDecideNotTheName)
{
  Write<vtkPNGWriter>(this->Folder.PathOf("a.jpg"), MakeImage(1, 1, VTK_UNSIGNED_SHORT, 1));
  EXPECT_EQ(this->Read(this->Folder.PathOf("a.jpg"))->GetScalarComponentAsDouble(0, 0, 0, 0), 257.);
  Write<vtkPNGWriter>(this->Folder.PathOf("line"), MakeImage(7, 1, VTK_UNSIGNED_CHAR, 1));
  EXPECT_EQ(this->Read(this->Folder.PathOf("line"))->GetNumberOfPoints(), 7);
}

TEST_F(ImageReader, TruncatedFilesAreErrors)
{
  const auto image = MakeImage(60, 50, VTK_UNSIGNED_CHAR, 3);
  Write<vtkPNGWriter>(this->Folder.PathOf("a.png"), image);
  for (const char* name : { "a.jpg", "progressive.jpg" })
  {
    vtkNew<vtkJPEGWriter> writer;
    writer->SetProgressive(name[0] == 'p');
    writer->SetFileName(this->Folder.PathOf(name).c_str());
    writer->SetInputData(image);
    writer->Write();
  }
  Write<vtkTIFFWriter>(this->Folder.PathOf("a.tif"), image);
  const std::vector<float> floats(60 * 50, 1.5f);
  MesoWriteExr(this->Folder.PathOf("a.exr"), 60, 50, { "Y" }, floats.data());
  for (const char* name : { "a.png", "a.jpg", "progressive.jpg", "a.tif", "a.exr" })
  {
    const std::string bytes = ReadBytes(this->Folder.PathOf(name));
    EXPECT_GT(this->Read(this->Folder.PathOf(name))->GetNumberOfPoints(), 0) << name;
    for (double part : { 0., 0.01, 0.3, 0.7, 0.95 })
    {
      const auto length = static_cast<std::size_t>(part * double(bytes.size()));
      this->ExpectRefused(
        this->Folder.Write("cut-" + std::string(name), bytes.substr(0, length)), ": ");
    }
  }
}

TEST_F(ImageReader, RefusesWhatIsNoImageOrTooLarge)
{
  this->ExpectRefused(this->Folder.PathOf("none.png"), "there is no such file");
  this->ExpectRefused(this->Folder.Write("text.png", "hello"), "is not an image that can be read");
  this->ExpectRefused(this->Folder.Write("text.xyz", "hello"), "is not an image that can be read");
  this->ExpectRefused(
    this->Folder.Write("zero.png", TinyImages::BytesOf(TinyImages::ZeroPng)), "has no pixels");
  this->ExpectRefused(this->Folder.Write("huge.png", TinyImages::BytesOf(TinyImages::HugePng)),
    "is 32768 x 32768 pixels, over the limit of 16384 in either direction");
  this->ExpectRefused(this->Folder.Write("id.exr", TinyImages::BytesOf(TinyImages::IntegerExr)),
    "holds values of type uint");
  this->Reader->SetFileName(nullptr);
  this->Reader->Update();
  EXPECT_NE(this->Reader->GetErrorMessage().find("no file name"), std::string::npos);
}

TEST_F(ImageReader, DamagedPngFilesAreToldByChunk)
{
  const std::string whole = TinyImages::BytesOf(TinyImages::IndexedPng);
  const std::string cut = whole.substr(0, whole.size() - 14);
  this->ExpectRefused(this->Folder.Write("a.png", cut), "the file ends in the chunk that begins");
  this->ExpectRefused(this->Folder.Write("b.png", whole.substr(0, whole.size() - 12)),
    "byte " + std::to_string(whole.size() - 12) + ": the file ends before its last chunk");
  std::string bit = whole;
  bit[whole.find("IDAT") + 6] ^= 4;
  this->ExpectRefused(this->Folder.Write("c.png", bit),
    "byte " + std::to_string(whole.find("IDAT") - 4) + ": the chunk \"IDAT\" has a wrong checksum");
  EXPECT_EQ(this->ReadTiny("more.png", TinyImages::IndexedPng)->GetNumberOfPoints(), 4);
}

TEST_F(ImageReader, RefusesValuesThatAreNotFinite)
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const float values[] = { 0, 1, 2, 3, 4, nan, 6, 7, infinity, 9, -infinity, 11 };
  const std::string fileName = this->Folder.PathOf("nan.exr");
  MesoWriteExr(fileName, 2, 3, { "R", "G" }, values);
  this->ExpectRefused(
    fileName, "3 values are not finite (first: channel G at column 0, row 1 from the top)");
}

TEST_F(ImageReader, AGoodFileAfterABadOneIsRead)
{
  this->ExpectRefused(this->Folder.PathOf("none.png"), "there is no such file");
  EXPECT_EQ(this->ReadTiny("tiled.exr", TinyImages::TiledExr)->GetNumberOfPoints(), 6);
  EXPECT_TRUE(this->Reader->GetErrorMessage().empty());
  EXPECT_TRUE(this->Recorder.Errors.empty());
}
