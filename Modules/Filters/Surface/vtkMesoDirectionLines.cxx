#include "vtkMesoDirectionLines.h"

#include "MesoVector.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>

vtkStandardNewMacro(vtkMesoDirectionLines);

namespace
{
constexpr double FlatTurn = 1e-4; ///< radians over the whole mesh, below which it is flat

bool IsFinite(const MesoVector& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

vtkDataArray* FindArray(vtkPolyData* input, const char* name, int components)
{
  vtkDataArray* array = input->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}
}

int vtkMesoDirectionLines::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* input = vtkPolyData::GetData(inputVector[0]);
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  if (input->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  vtkDataArray* curvatures = FindArray(input, "MesoCurvature", 2);
  vtkDataArray* directions = FindArray(input, "MesoPrincipalDirections", 6);
  vtkDataArray* confidences = FindArray(input, "MesoCurvatureConfidence", 1);
  if (!curvatures || !directions || !confidences)
  {
    const char* missing = !curvatures ? "MesoCurvature (2 components)"
      : !directions                   ? "MesoPrincipalDirections (6 components)"
                                      : "MesoCurvatureConfidence (1 component)";
    vtkErrorMacro(
      "the input has no point array " << missing << ": vtkMesoPrincipalCurvatures makes it");
    return 1;
  }
  vtkDataArray* normals = input->GetPointData()->GetNormals();
  const double diagonal = input->GetLength();
  const double length = this->Length > 0. ? this->Length : diagonal / 60.;

  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkDoubleArray> along;
  along->SetName("MesoCurvature");
  const auto addLine = [&](const MesoVector& middle, const MesoVector& direction, double curvature)
  {
    const MesoVector half = MesoScaled(direction, 0.5 * length);
    const vtkIdType first = points->InsertNextPoint(MesoDifference(middle, half).data());
    const vtkIdType second = points->InsertNextPoint(MesoSum(middle, half).data());
    lines->InsertNextCell({ first, second });
    along->InsertNextValue(curvature);
    along->InsertNextValue(curvature);
  };

  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    std::array<double, 2> c;
    std::array<double, 6> d;
    MesoVector middle;
    MesoVector normal = { 0., 0., 0. };
    curvatures->GetTuple(i, c.data());
    directions->GetTuple(i, d.data());
    input->GetPoint(i, middle.data());
    if (normals)
    {
      normals->GetTuple(i, normal.data());
    }
    middle = MesoSum(middle, MesoScaled(normal, this->Lift * length));
    const MesoVector first = { d[0], d[1], d[2] };
    const MesoVector second = { d[3], d[4], d[5] };
    // Written so that a curvature or confidence that is no number has no line either.
    const double apart = c[0] - c[1];
    const double larger = std::max(std::abs(c[0]), std::abs(c[1]));
    const bool known = confidences->GetComponent(i, 0) > this->MinimumConfidence &&
      apart > this->UmbilicTolerance * larger && apart * diagonal > FlatTurn;
    if (!known || !IsFinite(middle) || !IsFinite(first) || !IsFinite(second))
    {
      continue;
    }
    if (this->Maximum)
    {
      addLine(middle, first, c[0]);
    }
    if (this->Minimum)
    {
      addLine(middle, second, c[1]);
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  output->GetPointData()->SetScalars(along);
  return 1;
}

void vtkMesoDirectionLines::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Maximum: " << (this->Maximum ? "on" : "off") << "\n";
  os << indent << "Minimum: " << (this->Minimum ? "on" : "off") << "\n";
  os << indent << "Length: " << this->Length << " object units\n";
  os << indent << "Lift: " << this->Lift << " lengths\n";
  os << indent << "MinimumConfidence: " << this->MinimumConfidence << "\n";
  os << indent << "UmbilicTolerance: " << this->UmbilicTolerance << "\n";
}
