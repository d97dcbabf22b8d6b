#include "MesoHeightVolume.h"

#include "MesoAlgorithmRun.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMesoSignedDistance.h"
#include "vtkMesoVolumeTile.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>

namespace
{
constexpr int MostVoxels = 64; // a side, as of volumes' files
constexpr int Slices = 32;
constexpr double Depth = 0.25;           // as the built-in volumes have
constexpr double Margin = 0.55 / Slices; // just within the first and the last sample
}

vtkSmartPointer<vtkImageData> MesoVolumeOfHeights(
  vtkImageData* heights, const std::string& place, std::vector<std::string>& warnings)
{
  int texels[3];
  heights->GetDimensions(texels);
  vtkNew<vtkMesoVolumeTile> tile;
  tile->SetInputData(heights);
  tile->SetSize(std::clamp(texels[0], 2, MostVoxels), std::clamp(texels[1], 2, MostVoxels), 1);
  MesoRunAlgorithm(tile, place, warnings);
  vtkDataArray* resampled = tile->GetOutput()->GetPointData()->GetScalars();
  int size[3];
  tile->GetOutput()->GetDimensions(size);

  vtkNew<vtkImageData> below; // how far below the surface: its zeros in z are the heights
  below->SetDimensions(size[0], size[1], Slices);
  below->AllocateScalars(VTK_FLOAT, 1);
  auto* number = static_cast<float*>(below->GetScalarPointer());
  for (int k = 0; k < Slices; ++k)
  {
    for (vtkIdType column = 0; column < resampled->GetNumberOfTuples(); ++column)
    {
      *number++ = static_cast<float>(
        Margin + (1. - 2. * Margin) * resampled->GetComponent(column, 0) - (k + 0.5) / Slices);
    }
  }
  vtkNew<vtkMesoSignedDistance> distance;
  distance->SetInputData(below);
  distance->SetThreshold(0.);
  distance->SetDepth(Depth);
  MesoRunAlgorithm(distance, place, warnings);
  return distance->GetOutput();
}
