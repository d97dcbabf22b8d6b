#include "vtkMesoMeshPart.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <unordered_map>
#include <vector>

vtkStandardNewMacro(vtkMesoMeshPart);

namespace
{
/// A value of each point; empty where there is none of the name.
std::vector<double> ValuesOf(vtkPolyData* mesh, const std::string& by, int component)
{
  const std::string axes = "xyz";
  const std::string coordinates = "uv";
  vtkDataArray* array = nullptr;
  if (by.size() == 1 && axes.find(by) != std::string::npos)
  {
    array = mesh->GetPoints()->GetData();
    component = static_cast<int>(axes.find(by));
  }
  else if (by.size() == 1 && coordinates.find(by) != std::string::npos)
  {
    array = mesh->GetPointData()->GetTCoords();
    component = static_cast<int>(coordinates.find(by));
  }
  else
  {
    array = mesh->GetPointData()->GetArray(by.c_str());
  }
  if (!array || component >= array->GetNumberOfComponents())
  {
    return {};
  }
  const int components = array->GetNumberOfComponents();
  if (component < 0 && components == 1)
  {
    component = 0;
  }
  std::vector<double> values(mesh->GetNumberOfPoints());
  std::vector<double> tuple(components);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    array->GetTuple(i, tuple.data());
    double squares = 0.;
    for (const double value : tuple)
    {
      squares += value * value;
    }
    values[i] = component < 0 ? std::sqrt(squares) : tuple[component];
  }
  return values;
}

/// Numbers the vertices 0, 1, 2, ... in the order of the points.
void MakeDense(vtkDataArray* vertices)
{
  std::unordered_map<vtkIdType, vtkIdType> numbers;
  for (vtkIdType i = 0; i < vertices->GetNumberOfTuples(); ++i)
  {
    const auto old = static_cast<vtkIdType>(vertices->GetTuple1(i));
    const auto number = numbers.emplace(old, static_cast<vtkIdType>(numbers.size())).first->second;
    vertices->SetTuple1(i, static_cast<double>(number));
  }
}
}

int vtkMesoMeshPart::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  const std::vector<double> values = ValuesOf(input, this->By, this->Component);
  if (values.empty())
  {
    vtkErrorMacro(<< "the points have no " << this->By
                  << (this->Component < 0 ? std::string()
                                          : "[" + std::to_string(this->Component) + "]")
                  << " to choose a part by");
    return 1;
  }

  constexpr vtkIdType unused = -1;
  std::vector<vtkIdType> newPoint(values.size(), unused);
  std::vector<vtkIdType> cells;
  auto walk = vtkSmartPointer<vtkCellArrayIterator>::Take(input->GetPolys()->NewIterator());
  const vtkIdType before = input->GetNumberOfVerts() + input->GetNumberOfLines();
  for (walk->GoToFirstCell(); !walk->IsDoneWithTraversal(); walk->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    walk->GetCurrentCell(count, corners);
    double sum = 0.;
    for (vtkIdType i = 0; i < count; ++i)
    {
      sum += values[corners[i]];
    }
    const double mean = sum / static_cast<double>(count);
    if (mean >= this->Range[0] && mean < this->Range[1])
    {
      cells.push_back(walk->GetCurrentCellId());
      for (vtkIdType i = 0; i < count; ++i)
      {
        newPoint[corners[i]] = 0;
      }
    }
  }

  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  output->GetPointData()->CopyAllOn();
  output->GetPointData()->CopyAllocate(input->GetPointData());
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    if (newPoint[i] != unused)
    {
      newPoint[i] = points->InsertNextPoint(input->GetPoint(i));
      output->GetPointData()->CopyData(input->GetPointData(), i, newPoint[i]);
    }
  }
  vtkNew<vtkCellArray> polygons;
  output->GetCellData()->CopyAllOn();
  output->GetCellData()->CopyAllocate(input->GetCellData());
  for (const vtkIdType cell : cells)
  {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    input->GetPolys()->GetCellAtId(cell, count, corners);
    const vtkIdType added = polygons->InsertNextCell(static_cast<int>(count));
    for (vtkIdType i = 0; i < count; ++i)
    {
      polygons->InsertCellPoint(newPoint[corners[i]]);
    }
    output->GetCellData()->CopyData(input->GetCellData(), before + cell, added);
  }
  output->SetPoints(points);
  output->SetPolys(polygons);
  if (vtkDataArray* vertices = output->GetPointData()->GetArray("MesoVertex"))
  {
    MakeDense(vertices);
  }
  return 1;
}

void vtkMesoMeshPart::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "By: " << this->By << "\n";
  os << indent << "Component: " << this->Component << "\n";
  os << indent << "Range: " << this->Range[0] << ", " << this->Range[1] << "\n";
}
