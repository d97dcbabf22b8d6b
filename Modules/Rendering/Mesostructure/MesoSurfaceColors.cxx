#include "MesoSurfaceColors.h"

#include "MesoLookupTable.h"
#include "vtkLookupTable.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace
{
/// Whether the array's numbers have a sign and a few of them are far off, as fits to meshes have.
bool IsFitted(const std::string& name)
{
  return name == "MesoCurvature" || name == "MesoQuadric";
}
}

void MesoSetSurfaceColors(
  const MesoSceneColorBy& colorBy, vtkPolyData* base, vtkMesoPolyDataMapper* mapper)
{
  if (colorBy.IsHeight())
  {
    mapper->SetHeightColors(
      MesoMakeLookupTable(colorBy.LookupTable.empty() ? "viridis" : colorBy.LookupTable,
        colorBy.Range.value_or(std::array<double, 2>{ 0., 1. })));
    return;
  }
  vtkDataArray* array = base->GetPointData()->GetArray(colorBy.Array.c_str());
  const bool isMagnitude = !colorBy.Component && array->GetNumberOfComponents() > 1;
  const int component = isMagnitude ? -1 : colorBy.Component.value_or(0);
  std::string map = "viridis";
  std::array<double, 2> range = MesoRangeOf(array, component);
  if (IsFitted(colorBy.Array))
  {
    range = MesoSymmetricRangeOf(array, component);
    range[0] = isMagnitude ? 0. : range[0];
    map = isMagnitude ? map : "coolwarm";
  }
  const auto table = MesoMakeLookupTable(
    colorBy.LookupTable.empty() ? map : colorBy.LookupTable, colorBy.Range.value_or(range));
  if (isMagnitude)
  {
    table->SetVectorModeToMagnitude();
  }
  else
  {
    table->SetVectorModeToComponent();
    table->SetVectorComponent(component);
  }
  mapper->SetLookupTable(table);
  mapper->UseLookupTableScalarRangeOn();
  mapper->SetColorModeToMapScalars();
  mapper->SetScalarModeToUsePointFieldData();
  mapper->SelectColorArray(colorBy.Array.c_str());
  // Numbers are interpolated and then coloured; the other way gives colours that no number has.
  mapper->InterpolateScalarsBeforeMappingOn();
  mapper->ScalarVisibilityOn();
}
