#ifndef MadeMap_h
#define MadeMap_h

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <functional>

/// A height map out of heightAt(column, row).
inline vtkSmartPointer<vtkImageData> MakeMap(
  int width, int height, const std::function<double(int, int)>& heightAt)
{
  vtkNew<vtkFloatArray> heights;
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      heights->InsertNextValue(static_cast<float>(heightAt(column, row)));
    }
  }
  auto map = vtkSmartPointer<vtkImageData>::New();
  map->SetDimensions(width, height, 1);
  map->GetPointData()->SetScalars(heights);
  return map;
}

#endif
