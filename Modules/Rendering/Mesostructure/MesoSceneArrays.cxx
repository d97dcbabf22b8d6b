#include "MesoSceneArrays.h"

#include "MesoAlgorithmRun.h"
#include "MesoMessage.h"
#include "MesoSceneKeys.h"
#include "vtkMesoMeshPart.h"
#include "vtkMesoPrincipalCurvatures.h"
#include "vtkMesoQuadricFit.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>

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
}

bool MesoArrayNeedsFrames(const std::string& name)
{
  return Has(QuadricArrays, name) || Has(FrameArrays, name);
}

vtkSmartPointer<vtkPolyData> MesoWithArray(vtkPolyData* mesh, const std::string& name,
  const std::optional<int>& component, const std::string& place, std::vector<std::string>& warnings)
{
  vtkSmartPointer<vtkPolyData> result = mesh;
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
  if (component.value_or(0) >= components)
  {
    throw MesoInputError(place + ": " + name + " has " + std::to_string(components) +
      (components == 1 ? " component" : " components") + ", numbered from 0; there is no [" +
      std::to_string(*component) + "]");
  }
  return result;
}

vtkSmartPointer<vtkPolyData> MesoPartOfMesh(vtkPolyData* mesh, const MesoScenePart& part,
  const std::string& place, std::vector<std::string>& warnings)
{
  const std::string coordinates = "xyzuv";
  const bool isCoordinate =
    part.By.size() == 1 && !part.Component && coordinates.find(part.By) != std::string::npos;
  const vtkSmartPointer<vtkPolyData> whole = isCoordinate
    ? vtkSmartPointer<vtkPolyData>(mesh)
    : MesoWithArray(mesh, part.By, part.Component, place + ".by", warnings);
  vtkNew<vtkMesoMeshPart> filter;
  filter->SetInputData(whole);
  filter->SetBy(part.By);
  filter->SetComponent(part.Component.value_or(-1));
  filter->SetRange(part.Range.data());
  MesoRunAlgorithm(filter, place, warnings);
  if (filter->GetOutput()->GetNumberOfPolys() == 0)
  {
    std::ostringstream text;
    text << place << ": no triangle of the mesh has its " << part.By << " in [" << part.Range[0]
         << ", " << part.Range[1] << ")";
    throw MesoInputError(text.str());
  }
  return filter->GetOutput();
}
