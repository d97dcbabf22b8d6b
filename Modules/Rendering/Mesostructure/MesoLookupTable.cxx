#include "MesoLookupTable.h"

#include "MesoColorMap.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
std::vector<double> FiniteValues(vtkDataArray* array, int component)
{
  std::vector<double> values;
  values.reserve(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    double value = 0.;
    if (component < 0)
    {
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        value = std::hypot(value, array->GetComponent(i, k));
      }
    }
    else
    {
      value = array->GetComponent(i, component);
    }
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
  return values;
}
}

vtkSmartPointer<vtkLookupTable> MesoMakeLookupTable(
  const std::string& map, const std::array<double, 2>& range)
{
  const MesoColorMap& colors = MesoColorMapNamed(map);
  vtkNew<vtkColorTransferFunction> function;
  if (colors.Diverging)
  {
    function->SetColorSpaceToDiverging();
  }
  const double last = static_cast<double>(colors.Colors.size() - 1);
  for (std::size_t i = 0; i < colors.Colors.size(); ++i)
  {
    const auto& color = colors.Colors[i];
    function->AddRGBPoint(static_cast<double>(i) / last, color[0], color[1], color[2]);
  }
  constexpr int size = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(size);
  for (int i = 0; i < size; ++i)
  {
    double color[3];
    function->GetColor(i / (size - 1.), color);
    table->SetTableValue(i, color[0], color[1], color[2]);
  }
  table->SetRange(range[0], range[1]);
  table->SetNanColor(MesoNaNColor[0], MesoNaNColor[1], MesoNaNColor[2], 1.);
  return table;
}

std::array<double, 2> MesoRangeOf(vtkDataArray* array, int component)
{
  const std::vector<double> values = FiniteValues(array, component);
  if (values.empty())
  {
    return { 0., 1. };
  }
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (*least < *most)
  {
    return { *least, *most };
  }
  const double apart = std::max(0.5, 0.5 * std::abs(*least));
  return { *least - apart, *least + apart };
}

std::array<double, 2> MesoSymmetricRangeOf(vtkDataArray* array, int component)
{
  std::vector<double> sizes;
  for (const double value : FiniteValues(array, component))
  {
    if (value != 0.)
    {
      sizes.push_back(std::abs(value));
    }
  }
  if (sizes.empty())
  {
    return { -1., 1. };
  }
  const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(0.9 * (sizes.size() - 1.));
  std::nth_element(sizes.begin(), place, sizes.end());
  return { -*place, *place };
}
