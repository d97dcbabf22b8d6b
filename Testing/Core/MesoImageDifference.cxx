#include "MesoImageDifference.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"

#include <algorithm>    // for std::max
#include <cmath>        // for std::floor
#include <cstdlib>      // for std::abs
#include <filesystem>   // for folders and renaming
#include <sstream>      // for the description
#include <system_error> // for renaming

namespace
{
std::string Shape(vtkImageData* image)
{
  const int* size = image->GetDimensions();
  std::ostringstream text;
  text << size[0] << "x" << size[1] << "x" << size[2] << " of "
       << image->GetNumberOfScalarComponents() << " " << image->GetScalarTypeAsString();
  return text.str();
}

std::string WhyNotComparable(vtkImageData* image, vtkImageData* expected)
{
  if (!image || !expected)
  {
    return image ? "there is no image to compare with" : "there is no image";
  }
  const std::string shape = Shape(image);
  if (shape != Shape(expected))
  {
    return "the image is " + shape + ", expected is " + Shape(expected);
  }
  const int channels = image->GetNumberOfScalarComponents();
  if (image->GetScalarType() != VTK_UNSIGNED_CHAR || channels < 1 || channels > 4 ||
    image->GetNumberOfPoints() == 0)
  {
    return "both are " + shape + ", not 8-bit images of 1 to 4 channels";
  }
  return {};
}

const unsigned char* Values(vtkImageData* image)
{
  return static_cast<const unsigned char*>(image->GetScalarPointer());
}
}

std::string MesoImageDifference::Describe() const
{
  if (!this->Problem.empty())
  {
    return this->Problem;
  }
  std::ostringstream text;
  text << this->SmallPixels << " of " << this->Pixels << " pixels differ, " << this->LargePixels
       << " of them much; largest difference in each channel";
  for (int maximum : this->ChannelMaximum)
  {
    text << " " << maximum;
  }
  text << " of 255; mean " << this->Mean;
  return text.str();
}

MesoImageDifference MesoCompareImages(
  vtkImageData* image, vtkImageData* expected, const MesoImageLimits& limits)
{
  MesoImageDifference result;
  result.Problem = WhyNotComparable(image, expected);
  if (!result.Problem.empty())
  {
    return result;
  }
  const int channels = image->GetNumberOfScalarComponents();
  const unsigned char* a = Values(image);
  const unsigned char* b = Values(expected);
  result.Pixels = image->GetNumberOfPoints();
  double sum = 0.;
  for (vtkIdType pixel = 0; pixel < result.Pixels; ++pixel)
  {
    int largest = 0;
    for (int channel = 0; channel < channels; ++channel, ++a, ++b)
    {
      const int difference = std::abs(int(*a) - int(*b));
      result.ChannelMaximum[channel] = std::max(result.ChannelMaximum[channel], difference);
      largest = std::max(largest, difference);
      sum += difference;
    }
    result.SmallPixels += largest > limits.SmallDifference;
    result.LargePixels += largest > limits.LargeDifference;
  }
  result.Mean = sum / (double(result.Pixels) * channels);
  result.Within = result.SmallPixels <= std::floor(limits.SmallFraction * result.Pixels) &&
    result.LargePixels <= std::floor(limits.LargeFraction * result.Pixels);
  return result;
}

MesoImageDifference MesoCompareImageFiles(
  const std::string& image, const std::string& expected, const MesoImageLimits& limits)
{
  const auto read = MesoReadPNG(image);
  const auto readExpected = MesoReadPNG(expected);
  MesoImageDifference result = MesoCompareImages(read, readExpected, limits);
  if (!read || !readExpected)
  {
    result.Problem = (read ? expected : image) + " is no PNG file that can be read";
  }
  return result;
}

vtkSmartPointer<vtkImageData> MesoDifferencePicture(vtkImageData* image, vtkImageData* expected)
{
  const int channels = image->GetNumberOfScalarComponents();
  const int shown = channels == 2 || channels == 4 ? channels - 1 : channels;
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(image->GetDimensions());
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, shown);
  auto* out = static_cast<unsigned char*>(picture->GetScalarPointer());
  const unsigned char* a = Values(image);
  const unsigned char* b = Values(expected);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i, a += channels, b += channels)
  {
    for (int channel = 0; channel < shown; ++channel)
    {
      *out++ = static_cast<unsigned char>(std::min(255, 16 * std::abs(a[channel] - b[channel])));
    }
  }
  return picture;
}

vtkSmartPointer<vtkImageData> MesoReadPNG(const std::string& path)
{
  vtkNew<vtkPNGReader> reader;
  if (!std::filesystem::is_regular_file(path) || !reader->CanReadFile(path.c_str()))
  {
    return nullptr;
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetErrorCode() == 0 ? reader->GetOutput() : nullptr;
}

bool MesoWritePNG(vtkImageData* image, const std::string& path)
{
  std::error_code error;
  const std::filesystem::path target(path);
  std::filesystem::create_directories(target.parent_path(), error);
  const std::string beside = path + ".part";
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(beside.c_str());
  writer->SetInputData(image);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    return false;
  }
  std::filesystem::rename(beside, target, error);
  return !error;
}
