#ifndef MesoTestVolume_h
#define MesoTestVolume_h

/**
 * @file MesoTestVolume.h
 * @brief Small volumes in canonical form, from functions of texture space.
 */

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

/// `distance` of (x, y, F z) in tile widths, negative inside, with z F = `depth` at the top.
inline vtkSmartPointer<vtkImageData> MesoTestVolume(const std::array<int, 3>& size, double depth,
  const std::function<double(double, double, double)>& distance)
{
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(size[0], size[1], size[2]);
  volume->AllocateScalars(VTK_FLOAT, 1);
  volume->GetPointData()->GetScalars()->SetName("MesoSignedDistance");
  auto* value = static_cast<float*>(volume->GetScalarPointer());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        *value++ = static_cast<float>(
          distance((i + 0.5) / size[0], (j + 0.5) / size[1], depth * (k + 0.5) / size[2]));
      }
    }
  }
  vtkNew<vtkDoubleArray> depths;
  depths->SetName("MesoVolumeDepth");
  depths->InsertNextValue(depth);
  volume->GetFieldData()->AddArray(depths);
  return volume;
}

/// A round bar along x through the middle of the tile, and one along y above it.
inline vtkSmartPointer<vtkImageData> MesoTestBars()
{
  return MesoTestVolume({ 32, 32, 16 }, 0.5,
    [](double x, double y, double z)
    {
      const double along = std::hypot(y - 0.5, z - 0.15) - 0.1;
      const double across = std::hypot(x - 0.5, z - 0.35) - 0.1;
      return std::min(along, across);
    });
}

/// Matter up to a height (0 to 1) of the shell everywhere.
inline vtkSmartPointer<vtkImageData> MesoTestSlab(double height)
{
  return MesoTestVolume(
    { 4, 4, 16 }, 0.5, [height](double, double, double z) { return z - 0.5 * height; });
}

#endif
