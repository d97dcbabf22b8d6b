#include "MesoErrorPictures.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
constexpr MesoByteColor Magma[] = { { 0, 0, 4 }, { 11, 9, 36 }, { 32, 17, 75 }, { 59, 15, 112 },
  { 87, 21, 126 }, { 114, 31, 129 }, { 140, 41, 129 }, { 168, 50, 125 }, { 196, 60, 117 },
  { 222, 73, 104 }, { 241, 96, 93 }, { 250, 127, 94 }, { 254, 159, 109 }, { 254, 191, 132 },
  { 253, 222, 160 }, { 252, 253, 191 } };

template <typename ColorOf>
vtkSmartPointer<vtkImageData> Picture(int width, int height, const ColorOf& colorOf)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int row = height - 1; row >= 0; --row)
  {
    for (int column = 0; column < width; ++column)
    {
      const MesoByteColor color = colorOf(std::size_t(row) * width + column);
      out = std::copy(color.begin(), color.end(), out);
    }
  }
  return image;
}
}

MesoByteColor MesoColorOfError(double value)
{
  constexpr int Last = static_cast<int>(std::size(Magma)) - 1;
  const double place = std::clamp(value, 0., 1.) * Last;
  const int below = std::min(static_cast<int>(place), Last - 1);
  MesoByteColor color;
  for (int i = 0; i < 3; ++i)
  {
    const double a = Magma[below][i];
    const double b = Magma[below + 1][i];
    color[i] = static_cast<unsigned char>(std::lround(a + (place - below) * (b - a)));
  }
  return color;
}

MesoByteColor MesoColorOfClass(MesoPixelClass kind)
{
  switch (kind)
  {
    case MesoPixelClass::Empty:
      return { 0, 0, 0 };
    case MesoPixelClass::NotANumber:
      return { 255, 0, 255 };
    case MesoPixelClass::Boundary:
      return { 130, 110, 60 };
    case MesoPixelClass::Hole:
      return { 255, 0, 0 };
    case MesoPixelClass::Missing:
      return { 255, 150, 60 };
    case MesoPixelClass::Extra:
      return { 250, 230, 60 };
    case MesoPixelClass::OtherObject:
      return { 150, 90, 220 };
    case MesoPixelClass::Nearer:
      return { 90, 200, 255 };
    case MesoPixelClass::Farther:
      return { 40, 90, 220 };
    case MesoPixelClass::ShadowDiffers:
      return { 60, 180, 90 };
    case MesoPixelClass::Equal:
      break;
  }
  return { 90, 90, 90 };
}

const char* MesoNameOfClass(MesoPixelClass kind)
{
  switch (kind)
  {
    case MesoPixelClass::Empty:
      return "empty";
    case MesoPixelClass::NotANumber:
      return "not a number";
    case MesoPixelClass::Boundary:
      return "boundary";
    case MesoPixelClass::Hole:
      return "hole";
    case MesoPixelClass::Missing:
      return "missing";
    case MesoPixelClass::Extra:
      return "extra";
    case MesoPixelClass::OtherObject:
      return "other object";
    case MesoPixelClass::Nearer:
      return "nearer";
    case MesoPixelClass::Farther:
      return "farther";
    case MesoPixelClass::ShadowDiffers:
      return "shadow wrong";
    case MesoPixelClass::Equal:
      break;
  }
  return "equal";
}

vtkSmartPointer<vtkImageData> MesoPictureOfErrors(
  const std::vector<float>& errors, int width, int height)
{
  return Picture(width, height, [&](std::size_t i) { return MesoColorOfError(errors[i]); });
}

vtkSmartPointer<vtkImageData> MesoPictureOfClasses(
  const std::vector<MesoPixelClass>& classes, int width, int height)
{
  return Picture(width, height, [&](std::size_t i) { return MesoColorOfClass(classes[i]); });
}
