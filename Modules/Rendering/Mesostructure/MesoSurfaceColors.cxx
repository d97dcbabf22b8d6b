#include "MesoSurfaceColors.h"

#include "MesoAlgorithmRun.h"
#include "MesoLookupTable.h"
#include "MesoMessage.h"
#include "MesoSceneKeys.h"
#include "vtkLookupTable.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkMesoPrincipalCurvatures.h"
#include "vtkMesoQuadricFit.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
const std::vector<std::string> CurvatureArrays = { "MesoCurvature", "MesoPrincipalDirections",
  "MesoCurvatureConfidence" };
const std::vector<std::string> QuadricArrays = { "MesoQuadric", "MesoQuadricCondition" };
const std::vector<std::string> FrameArrays = { "MesoTangent", "MesoBitangent", "MesoTileScale",
  "MesoFrameValid" };

bool Has(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The names of the arrays that the mesh has and of those that are made when they are named.
std::vector<std::string> ArraysOf(vtkPolyData* mesh)
{
  std::vector<std::string> names = CurvatureArrays;
  names.insert(names.end(), QuadricArrays.begin(), QuadricArrays.end());
  vtkPointData* data = mesh->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const char* name = data->GetArray(i) ? data->GetArray(i)->GetName() : nullptr;
    if (name && !Has(names, name))
    {
      names.emplace_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

[[noreturn]] void FailMissing(vtkPolyData* mesh, const std::string& name, const std::string& place)
{
  const std::vector<std::string> names = ArraysOf(mesh);
  const std::string nearest = MesoNearestWord(name, names);
  std::string list;
  for (const std::string& there : names)
  {
    list += (list.empty() ? "" : ", ") + there;
  }
  throw MesoInputError(place + ": the mesh has no point array \"" + MesoPrintable(name) + "\" (" +
    (nearest.empty() ? "" : "did you mean " + nearest + "? ") + "there are: " + list + ")");
}

/// Whether the array's numbers have a sign and a few of them are far off, as fits to meshes have.
bool IsFitted(const std::string& name)
{
  return name == "MesoCurvature" || name == "MesoQuadric";
}
}

bool MesoColorNeedsFrames(const MesoSceneColorBy& colorBy)
{
  return Has(QuadricArrays, colorBy.Array) || Has(FrameArrays, colorBy.Array);
}

vtkSmartPointer<vtkPolyData> MesoWithColorArray(vtkPolyData* mesh, const MesoSceneColorBy& colorBy,
  const std::string& place, std::vector<std::string>& warnings)
{
  vtkSmartPointer<vtkPolyData> result = mesh;
  const std::string& name = colorBy.Array;
  const auto add = [&](vtkPolyDataAlgorithm* filter)
  {
    filter->SetInputData(mesh);
    MesoRunAlgorithm(filter, place, warnings);
    result = filter->GetOutput();
  };
  if (!mesh->GetPointData()->GetArray(name.c_str()))
  {
    if (Has(CurvatureArrays, name))
    {
      add(vtkNew<vtkMesoPrincipalCurvatures>());
    }
    else if (Has(QuadricArrays, name))
    {
      add(vtkNew<vtkMesoQuadricFit>());
    }
  }
  vtkDataArray* array = result->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    FailMissing(mesh, name, place);
  }
  const int components = array->GetNumberOfComponents();
  if (colorBy.Component.value_or(0) >= components)
  {
    throw MesoInputError(place + ": " + name + " has " + std::to_string(components) +
      (components == 1 ? " component" : " components") + ", numbered from 0; there is no [" +
      std::to_string(*colorBy.Component) + "]");
  }
  return result;
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
