#ifndef MesoTestPicture_h
#define MesoTestPicture_h

/**
 * @file MesoTestPicture.h
 * @brief A picture to try the comparison on: a shaded ball before a checkerboard.
 */

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <algorithm> // for std::clamp
#include <cmath>     // for shading

/// 300x300 RGB, drawn by arithmetic: flat areas, smooth shades, edges and a silhouette.
inline vtkSmartPointer<vtkImageData> MesoTestPicture()
{
  constexpr int size = 300;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* value = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < size; ++y)
  {
    for (int x = 0; x < size; ++x)
    {
      const double u = (x - 150) / 100.;
      const double v = (y - 150) / 100.;
      const double w = 1. - u * u - v * v;
      const bool dark = (x / 30 + y / 30) % 2 == 0;
      const double shade = w > 0. ? 40. + 180. * std::sqrt(w) : (dark ? 60. : 150.);
      for (double tint : { 1., 0.8, 0.6 })
      {
        *value++ = static_cast<unsigned char>(std::clamp(shade * tint, 0., 255.));
      }
    }
  }
  return image;
}

/// A copy with each channel of each pixel replaced by change(image, x, y, channel).
template <typename Change>
vtkSmartPointer<vtkImageData> MesoChangedPicture(vtkImageData* image, Change change)
{
  auto result = vtkSmartPointer<vtkImageData>::New();
  result->DeepCopy(image);
  const int* size = image->GetDimensions();
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      for (int channel = 0; channel < image->GetNumberOfScalarComponents(); ++channel)
      {
        const double value = change(image, x, y, channel);
        result->SetScalarComponentFromDouble(x, y, 0, channel, std::clamp(value, 0., 255.));
      }
    }
  }
  return result;
}

#endif
