#include "vtkMesoSurfaceFrames.h"

#include "MesoFrames.h"
#include "MesoPolyDataInput.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
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
#include <stdexcept>

vtkStandardNewMacro(vtkMesoSurfaceFrames);

namespace
{
vtkDataArray* Find(vtkDataArray* active, vtkPointData* data, const char* name)
{
  return active ? active : data->GetArray(name);
}

/// The points and their data, with copies at the end for the sources after the first `points`.
void CopyPoints(vtkPolyData* from, const std::vector<std::int64_t>& source, vtkPolyData* to)
{
  const vtkIdType points = from->GetNumberOfPoints();
  const auto size = static_cast<vtkIdType>(source.size());
  if (size == points)
  {
    to->SetPoints(from->GetPoints());
    to->GetPointData()->ShallowCopy(from->GetPointData());
    return;
  }
  vtkNew<vtkIdList> ids;
  ids->SetNumberOfIds(size);
  std::copy(source.begin(), source.end(), ids->GetPointer(0));
  vtkNew<vtkPoints> copies;
  copies->SetDataType(from->GetPoints()->GetDataType());
  copies->SetNumberOfPoints(size);
  from->GetPoints()->GetData()->GetTuples(ids, copies->GetData());
  to->SetPoints(copies);
  vtkPointData* data = to->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(from->GetPointData(), size);
  vtkNew<vtkIdList> places;
  places->SetNumberOfIds(size);
  for (vtkIdType i = 0; i < size; ++i)
  {
    places->SetId(i, i);
  }
  data->CopyData(from->GetPointData(), ids, places);
}

vtkSmartPointer<vtkCellArray> CellsOf(const std::vector<std::array<std::int64_t, 3>>& triangles)
{
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(3 * static_cast<vtkIdType>(triangles.size()));
  vtkIdType* next = corners->GetPointer(0);
  for (const auto& triangle : triangles)
  {
    next = std::copy(triangle.begin(), triangle.end(), next);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(3, corners);
  return cells;
}

void Remove(vtkDataArray* array, vtkPointData* data)
{
  for (int i = data->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    if (data->GetAbstractArray(i) == array)
    {
      data->RemoveArray(i);
    }
  }
}

/// `array` under this name. The input's own object is never renamed: others may hold it.
vtkSmartPointer<vtkDataArray> Named(vtkDataArray* array, const char* name, vtkPointData* data)
{
  if (array->GetName() && std::string(array->GetName()) == name)
  {
    return array;
  }
  const auto result = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  result->ShallowCopy(array);
  result->SetName(name);
  Remove(array, data);
  return result;
}

/// Whether all normals are the input's own, which then stay as they are.
bool KeepsNormals(const std::vector<MesoVector>& normals)
{
  return !normals.empty() &&
    std::all_of(normals.begin(), normals.end(),
      [](const MesoVector& normal) { return MesoLength(normal) > 0.; });
}

void AddArrays(const MesoFrames& frames, const MesoFramesInput& input, vtkPolyData* output)
{
  const int type = output->GetPoints()->GetDataType() == VTK_DOUBLE ? VTK_DOUBLE : VTK_FLOAT;
  vtkPointData* data = output->GetPointData();
  data->SetTCoords(
    Named(Find(data->GetTCoords(), data, "TextureCoordinates"), "TextureCoordinates", data));
  vtkDataArray* normals = Find(data->GetNormals(), data, "Normals");
  if (KeepsNormals(input.Normals))
  {
    data->SetNormals(Named(normals, "Normals", data));
  }
  else
  {
    if (data->GetNormals())
    {
      Remove(data->GetNormals(), data);
    }
    data->SetNormals(MesoMakeArray("Normals", type, frames.Normals));
  }
  std::vector<std::array<double, 1>> valid;
  std::vector<std::array<double, 1>> vertices;
  for (std::size_t i = 0; i < frames.Source.size(); ++i)
  {
    valid.push_back({ frames.Valid[i] ? 1. : 0. });
    vertices.push_back({ static_cast<double>(input.Mesh.Vertex[frames.Source[i]]) });
  }
  data->AddArray(MesoMakeArray("MesoVertex", VTK_DOUBLE, vertices));
  data->AddArray(MesoMakeArray("MesoTangent", type, frames.Tangents));
  data->AddArray(MesoMakeArray("MesoBitangent", type, frames.Bitangents));
  data->AddArray(MesoMakeArray("MesoTileScale", type, frames.Scales));
  data->AddArray(MesoMakeArray("MesoFrameValid", type, valid));
}
}

int vtkMesoSurfaceFrames::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->ErrorMessage.clear();
  this->NumberOfInvalidFrames = 0;
  try
  {
    this->Execute(vtkPolyData::GetData(inputVector[0]), output);
  }
  catch (const std::invalid_argument& error)
  {
    this->ErrorMessage = error.what();
  }
  catch (const std::bad_alloc&)
  {
    this->ErrorMessage = "there is not enough memory for the frames of this mesh";
  }
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    // Returning 0 would make the executive add an error of several lines that says nothing more.
  }
  return 1;
}

void vtkMesoSurfaceFrames::Execute(vtkPolyData* input, vtkPolyData* output)
{
  const vtkIdType points = input->GetNumberOfPoints();
  if (points == 0)
  {
    return;
  }
  MesoFramesInput frame;
  vtkDataArray* coordinates = MesoFindTextureCoordinates(input);
  frame.TextureCoordinates = MesoTuples<2>(coordinates, "the texture coordinate");
  frame.TextureRounding = MesoRoundingOf(coordinates);
  vtkDataArray* positions = input->GetPoints()->GetData();
  frame.Mesh.Positions = MesoTuples<3>(positions, "the position");
  frame.Mesh.PositionRounding = MesoRoundingOf(positions);
  if (vtkDataArray* normals = MesoFindNormals(input))
  {
    frame.Normals = MesoTuples<3>(normals, "the normal");
  }
  MesoCheckCells(input->GetPolys(), "polygon", points);
  MesoCheckCells(input->GetStrips(), "strip", points);
  this->UpdateProgress(0.2);

  const vtkSmartPointer<vtkPolyData> triangles = MesoTriangulated(input);
  frame.Mesh.Triangles = MesoTrianglesOf(triangles->GetPolys());
  frame.Mesh.Vertex = MesoGivenVertices(input->GetPointData(), frame.Mesh.Positions);
  if (frame.Mesh.Vertex.empty())
  {
    frame.Mesh.Vertex = MesoMadeVertices(frame.Mesh.Positions);
  }
  frame.SplitNormals = this->SplitNormals;
  frame.FeatureAngle = this->FeatureAngle;
  this->UpdateProgress(0.4);

  const MesoFrames frames = MesoMakeFrames(frame);
  this->UpdateProgress(0.9);
  this->NumberOfInvalidFrames = std::count(frames.Valid.begin(), frames.Valid.end(), false);
  CopyPoints(triangles, frames.Source, output);
  output->SetPolys(CellsOf(frames.Triangles));
  output->GetCellData()->ShallowCopy(triangles->GetCellData());
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  AddArrays(frames, frame, output);
}

void vtkMesoSurfaceFrames::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SplitNormals: " << (this->SplitNormals ? "On" : "Off") << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << " degrees\n";
  os << indent << "NumberOfInvalidFrames: " << this->NumberOfInvalidFrames << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
