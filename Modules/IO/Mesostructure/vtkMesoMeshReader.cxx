#include "vtkMesoMeshReader.h"

#include "MesoMeshFormats.h"
#include "MesoMeshSurface.h"
#include "MesoScene.h" // for MesoInputError

#include "vtkAOSDataArrayTemplate.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <new>

vtkStandardNewMacro(vtkMesoMeshReader);

namespace
{
constexpr double LargestFloatError = 1e-6; // of the diagonal of the bounding box

template <std::size_t N>
bool FloatIsEnough(const std::vector<std::array<double, N>>& tuples)
{
  double error = 0.;
  double diagonal = 0.;
  for (std::size_t k = 0; k < N; ++k)
  {
    double least = tuples[0][k];
    double most = tuples[0][k];
    for (const auto& tuple : tuples)
    {
      least = std::min(least, tuple[k]);
      most = std::max(most, tuple[k]);
      error = std::max(error, std::abs(tuple[k] - static_cast<float>(tuple[k])));
    }
    diagonal = std::hypot(diagonal, most - least);
  }
  return error <= LargestFloatError * diagonal;
}

template <typename Array, std::size_t N>
vtkSmartPointer<vtkDataArray> MakeArray(const std::vector<std::array<double, N>>& tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(static_cast<int>(N));
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  auto* target = array->GetPointer(0);
  for (const auto& tuple : tuples)
  {
    for (double component : tuple)
    {
      *target++ = static_cast<typename Array::ValueType>(component);
    }
  }
  return array;
}

template <std::size_t N>
vtkSmartPointer<vtkDataArray> MakeFloatOrDouble(const std::vector<std::array<double, N>>& tuples)
{
  return FloatIsEnough(tuples) ? MakeArray<vtkFloatArray>(tuples)
                               : MakeArray<vtkDoubleArray>(tuples);
}

vtkSmartPointer<vtkCellArray> MakeCells(const std::vector<std::array<std::int32_t, 3>>& triangles)
{
  vtkNew<vtkIdTypeArray> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(triangles.size()) * 3);
  vtkIdType* target = connectivity->GetPointer(0);
  for (const auto& triangle : triangles)
  {
    target = std::copy(triangle.begin(), triangle.end(), target);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(3, connectivity);
  return cells;
}

/// The file's further point arrays at the points that its positions became.
void AddFileArrays(const MesoMeshFile& file, const MesoMeshSurface& surface, vtkPointData* target)
{
  if (!file.PointData)
  {
    return;
  }
  const auto count = static_cast<vtkIdType>(surface.FilePosition.size());
  for (int i = 0; i < file.PointData->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* given = file.PointData->GetArray(i);
    const auto array = vtkSmartPointer<vtkDataArray>::Take(given->NewInstance());
    array->SetName(given->GetName());
    array->SetNumberOfComponents(given->GetNumberOfComponents());
    array->SetNumberOfTuples(count);
    for (vtkIdType point = 0; point < count; ++point)
    {
      array->SetTuple(point, surface.FilePosition[point], given);
    }
    target->AddArray(array);
  }
}
}

vtkMesoMeshReader::vtkMesoMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMesoMeshReader::~vtkMesoMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkMesoMeshReader::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ErrorMessage.clear();
  this->Notes.clear();
  this->NumberOfOpenEdges = 0;
  this->NumberOfSheets = 0;
  const std::string fileName = this->FileName ? this->FileName : "";
  try
  {
    this->Read(output);
  }
  catch (const MesoInputError& error)
  {
    this->ErrorMessage = error.what();
  }
  catch (const std::bad_alloc&)
  {
    this->ErrorMessage = fileName + ": there is not enough memory for this mesh";
  }
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    // Returning 0 would make the executive add an error of several lines that says nothing more.
    return 1;
  }
  for (const std::string& note : this->Notes)
  {
    vtkWarningMacro(<< fileName << ": " << note);
  }
  return 1;
}

void vtkMesoMeshReader::Read(vtkPolyData* output)
{
  if (!this->FileName || !*this->FileName)
  {
    throw MesoInputError("vtkMesoMeshReader: no file name is set");
  }
  const MesoMeshFile file = MesoReadMeshFile(this->FileName);
  this->UpdateProgress(0.4);
  const MesoMeshSurface surface = MesoMakeSurface(file, this->FileName);
  this->UpdateProgress(0.9);

  this->Notes = surface.Notes;
  this->NumberOfOpenEdges = static_cast<vtkIdType>(surface.NumberOfOpenEdges);
  this->NumberOfSheets = static_cast<vtkIdType>(surface.NumberOfSheets);
  vtkNew<vtkPoints> points;
  points->SetData(MakeFloatOrDouble(surface.Positions));
  output->SetPoints(points);
  output->SetPolys(MakeCells(surface.Triangles));
  vtkPointData* data = output->GetPointData();
  AddFileArrays(file, surface, data);
  if (!surface.TextureCoordinates.empty())
  {
    const auto coordinates = MakeFloatOrDouble(surface.TextureCoordinates);
    coordinates->SetName("TextureCoordinates");
    data->SetTCoords(coordinates);
  }
  if (!surface.Normals.empty())
  {
    const auto normals = MakeArray<vtkFloatArray>(surface.Normals);
    normals->SetName("Normals");
    data->SetNormals(normals);
  }
  // Double as all arrays for the shaders are float or double: a float holds no id above 2^24.
  vtkNew<vtkDoubleArray> vertex;
  vertex->SetName("MesoVertex");
  vertex->SetNumberOfValues(static_cast<vtkIdType>(surface.Vertex.size()));
  std::copy(surface.Vertex.begin(), surface.Vertex.end(), vertex->GetPointer(0));
  data->AddArray(vertex);
}

void vtkMesoMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
  os << indent << "NumberOfOpenEdges: " << this->NumberOfOpenEdges << "\n";
  os << indent << "NumberOfSheets: " << this->NumberOfSheets << "\n";
  for (const std::string& note : this->Notes)
  {
    os << indent << "Note: " << note << "\n";
  }
}
