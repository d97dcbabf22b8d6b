#include "BenchPictures.h"

#include "CommandLine.h"
#include "MesoAtomicFile.h"
#include "MesoErrorPictures.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
using ColorOf = std::function<MesoByteColor(int column, int row)>;

constexpr int Gap = 4;

ColorOf ColorsOf(const MesoPicture& picture)
{
  return [&picture](int column, int row)
  {
    const float* rgb = &picture.Rgb[3 * (std::size_t(row) * picture.Width + column)];
    MesoByteColor color;
    std::transform(rgb, rgb + 3, color.begin(),
      [](float value) { return static_cast<unsigned char>(std::lround(255.f * value)); });
    return color;
  };
}

ColorOf ColorsOfClasses(const MesoImageError& error)
{
  return [&error](int column, int row)
  { return MesoColorOfClass(error.Geometry->Classes[std::size_t(row) * error.Width + column]); };
}

/// Pictures of one size side by side with white between, each pixel `zoom` wide; row 0 is the top.
void WriteSideBySide(const std::vector<ColorOf>& pictures, int width, int height, int zoom,
  const std::string& fileName)
{
  const int count = static_cast<int>(pictures.size());
  vtkNew<vtkImageData> image;
  image->SetDimensions(count * (zoom * width + Gap) - Gap, zoom * height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const vtkIdType values = image->GetNumberOfPoints() * 3;
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), values, 255);
  for (int i = 0; i < count; ++i)
  {
    for (int y = 0; y < zoom * height; ++y)
    {
      auto* out = static_cast<unsigned char*>(
        image->GetScalarPointer(i * (zoom * width + Gap), zoom * height - 1 - y, 0));
      for (int x = 0; x < zoom * width; ++x)
      {
        const MesoByteColor color = pictures[i](x / zoom, y / zoom);
        out = std::copy(color.begin(), color.end(), out);
      }
    }
  }
  const std::string bytes = PictureBytes(image);
  MesoAtomicFile::Write(fileName, bytes.data(), bytes.size());
}
}

void WriteStrip(const MesoPicture& truth, const MesoPicture& test, const MesoImageError& error,
  const std::string& fileName)
{
  const ColorOf flip = [&error](int column, int row)
  { return MesoColorOfError(error.Picture->FlipMap[std::size_t(row) * error.Width + column]); };
  WriteSideBySide({ ColorsOf(truth), ColorsOf(test), flip, ColorsOfClasses(error) }, error.Width,
    error.Height, 1, fileName);
}

void WriteWorst(const MesoPicture& truth, const MesoPicture& test, const MesoImageError& error,
  const std::string& fileName)
{
  constexpr int Side = 21;
  constexpr int Zoom = 8;
  const int width = std::min(Side, error.Width);
  const int height = std::min(Side, error.Height);
  const int pixel = static_cast<int>(error.Geometry->Texcoord.WorstPixel);
  const int left = std::clamp(pixel % error.Width - Side / 2, 0, error.Width - width);
  const int top = std::clamp(pixel / error.Width - Side / 2, 0, error.Height - height);
  const auto around = [=](const ColorOf& colors) -> ColorOf
  { return [=](int column, int row) { return colors(left + column, top + row); }; };
  WriteSideBySide(
    { around(ColorsOf(truth)), around(ColorsOf(test)), around(ColorsOfClasses(error)) }, width,
    height, Zoom, fileName);
}
