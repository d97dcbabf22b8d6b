#include "vtkMesoConeMap.h"

#include "MesoHeightCones.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

vtkStandardNewMacro(vtkMesoConeMap);

namespace
{
vtkNew<vtkUnsignedCharArray> ToArray(const char* name, const std::vector<unsigned char>& codes)
{
  constexpr int Ways = 4;
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(Ways);
  array->SetNumberOfTuples(vtkIdType(codes.size()) / Ways);
  std::copy(codes.begin(), codes.end(), array->GetPointer(0));
  return array;
}
}

void vtkMesoConeMap::Compute(const Map& map, vtkImageData* output)
{
  const MesoHeightCones cones =
    MesoMakeHeightCones(map.Width, map.Height, this->GetWrap(), map.Heights.data(),
      [this](int count, const std::function<void(int, int)>& work, double done, double all)
      { return this->ForRows(count, work, done, all); });
  output->GetPointData()->SetScalars(ToArray("ConeSteepness", cones.Steepness));
  output->GetPointData()->AddArray(ToArray("ConeApex", cones.Apex));
}
