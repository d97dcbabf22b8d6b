#include "MesoGDMShape.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr vtkIdType ShapeNumbers = 8;

bool Has(vtkFieldData* data, const char* name, vtkIdType tuples, int components)
{
  vtkDataArray* array = data->GetArray(name);
  return array && array->GetNumberOfTuples() == tuples &&
    array->GetNumberOfComponents() == components;
}

/// Whether all numbers of an array are finite; whole numbers are.
bool IsFinite(vtkDataArray* array)
{
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  for (vtkIdType i = 0; isReal && i < array->GetNumberOfTuples(); ++i)
  {
    for (int component = 0; component < array->GetNumberOfComponents(); ++component)
    {
      if (!std::isfinite(array->GetComponent(i, component)))
      {
        return false;
      }
    }
  }
  return true;
}
}

MesoGDMShape MesoGDMShape::Of(vtkImageData* table)
{
  vtkDataArray* numbers = table->GetFieldData()->GetArray("MesoGDMShape");
  const auto whole = [&](vtkIdType i) { return static_cast<int>(numbers->GetTuple1(i)); };
  MesoGDMShape shape;
  shape.Size = { whole(0), whole(1), whole(2) };
  shape.Azimuths = whole(3);
  shape.Polars = whole(4);
  shape.Even = whole(5) != 0;
  shape.Reach = numbers->GetTuple1(6);
  shape.Rank = whole(7);
  shape.Depth = table->GetFieldData()->GetArray("MesoVolumeDepth")->GetTuple1(0);
  return shape;
}

std::string MesoGDMTableProblem(vtkImageData* table)
{
  const std::string none = "is no table of distances through a volume";
  if (!table)
  {
    return none;
  }
  vtkFieldData* data = table->GetFieldData();
  if (!Has(data, "MesoGDMShape", ShapeNumbers, 1) || !Has(data, "MesoVolumeDepth", 1, 1))
  {
    return none;
  }
  for (vtkIdType i = 0; i < ShapeNumbers; ++i)
  {
    const double number = data->GetArray("MesoGDMShape")->GetTuple1(i);
    if (!(number >= 0. && number < 1e6))
    {
      return none + ": its shape makes no sense";
    }
  }
  const MesoGDMShape shape = MesoGDMShape::Of(table);
  const std::array<int, 3> size = { shape.Size[0], shape.Size[1], shape.Azimuths };
  const auto columns = vtkIdType(shape.Polars) * shape.Size[2];
  int found[3];
  table->GetDimensions(found);
  const bool isFactored = shape.Rank > 0;
  const bool fits = std::equal(size.begin(), size.end(), found) && shape.Size[2] > 1 &&
    shape.Polars > 1 && shape.Depth > 0. && std::isfinite(shape.Depth) &&
    Has(table->GetPointData(), isFactored ? "MesoGDMWeights" : "MesoGDMDistances",
      table->GetNumberOfPoints(), isFactored ? shape.Rank : static_cast<int>(columns)) &&
    (!isFactored ||
      (Has(data, "MesoGDMFunctions", columns, shape.Rank) &&
        Has(data, "MesoGDMWeightRange", 2, shape.Rank))) &&
    Has(data, "MesoGDMVolume", vtkIdType(size[0]) * size[1] * shape.Size[2], 1);
  if (!fits)
  {
    return none + ": its arrays are not those that its shape asks for";
  }
  bool isFinite = IsFinite(data->GetArray("MesoGDMVolume")) &&
    IsFinite(table->GetPointData()->GetArray(isFactored ? "MesoGDMWeights" : "MesoGDMDistances"));
  for (const char* name : { "MesoGDMFunctions", "MesoGDMWeightRange" })
  {
    isFinite = isFinite && (!isFactored || IsFinite(data->GetArray(name)));
  }
  return isFinite ? std::string() : none + ": it holds numbers that are not finite";
}
