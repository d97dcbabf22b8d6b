#include "vtkMesoSurfaceFrames.h"

#include "MesoFirstEqual.h"
#include "MesoFrames.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
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
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>
#include <stdexcept>

vtkStandardNewMacro(vtkMesoSurfaceFrames);

namespace
{
constexpr double FloatRounding = 1. / (1 << 24);
constexpr double DoubleRounding = FloatRounding * FloatRounding / 32.; // 2^-53

double RoundingOf(vtkDataArray* array)
{
  return array->GetDataType() == VTK_DOUBLE ? DoubleRounding : FloatRounding;
}

/// The tuples as doubles; throws where one is not finite.
template <std::size_t N>
std::vector<std::array<double, N>> Tuples(vtkDataArray* array, const char* what)
{
  std::vector<std::array<double, N>> tuples(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    array->GetTuple(static_cast<vtkIdType>(i), tuples[i].data());
    for (double component : tuples[i])
    {
      if (!std::isfinite(component))
      {
        std::ostringstream message;
        message << what << " of point " << i << " is not finite (";
        for (std::size_t k = 0; k < N; ++k)
        {
          message << (k > 0 ? ", " : "") << tuples[i][k];
        }
        throw std::invalid_argument(message.str() + ")");
      }
    }
  }
  return tuples;
}

vtkDataArray* Find(vtkDataArray* active, vtkPointData* data, const char* name)
{
  return active ? active : data->GetArray(name);
}

vtkDataArray* FindTextureCoordinates(vtkPolyData* input)
{
  vtkPointData* data = input->GetPointData();
  vtkDataArray* array = Find(data->GetTCoords(), data, "TextureCoordinates");
  if (!array)
  {
    throw std::invalid_argument("the mesh has no texture coordinates");
  }
  if (array->GetNumberOfComponents() != 2)
  {
    throw std::invalid_argument("the texture coordinates have " +
      std::to_string(array->GetNumberOfComponents()) + " components, 2 are needed");
  }
  if (array->GetNumberOfTuples() != input->GetNumberOfPoints())
  {
    throw std::invalid_argument("the mesh has " + std::to_string(input->GetNumberOfPoints()) +
      " points, but " + std::to_string(array->GetNumberOfTuples()) + " texture coordinates");
  }
  return array;
}

/// Null where the input has no normals, or none that fit it.
vtkDataArray* FindNormals(vtkPolyData* input)
{
  vtkPointData* data = input->GetPointData();
  vtkDataArray* array = Find(data->GetNormals(), data, "Normals");
  const bool fits = array && array->GetNumberOfComponents() == 3 &&
    array->GetNumberOfTuples() == input->GetNumberOfPoints();
  return fits ? array : nullptr;
}

void CheckCells(vtkCellArray* cells, const char* what, vtkIdType points)
{
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      if (ids[k] < 0 || ids[k] >= points)
      {
        throw std::invalid_argument(std::string(what) + " " +
          std::to_string(iterator->GetCurrentCellId()) + " names point " + std::to_string(ids[k]) +
          ", and there are " + std::to_string(points));
      }
    }
  }
}

/// The input's polygons and strips as triangles, over the same points.
vtkSmartPointer<vtkPolyData> Triangulated(vtkPolyData* input)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->ShallowCopy(input);
  const bool triangles = input->GetPolys()->IsHomogeneous() == 3;
  if (!triangles || input->GetNumberOfPolys() != input->GetNumberOfCells())
  {
    vtkNew<vtkTriangleFilter> filter;
    filter->SetInputData(result);
    filter->PassVertsOff();
    filter->PassLinesOff();
    filter->Update();
    result = filter->GetOutput();
  }
  return result;
}

std::vector<std::array<std::int64_t, 3>> TrianglesOf(vtkCellArray* cells)
{
  std::vector<std::array<std::int64_t, 3>> triangles;
  triangles.reserve(cells->GetNumberOfCells());
  const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    triangles.push_back({ ids[0], ids[1], ids[2] });
  }
  return triangles;
}

/// The input's MesoVertex, or nothing where it does not number positions.
std::vector<std::int64_t> GivenVertices(
  vtkPointData* data, const std::vector<MesoVector>& positions)
{
  vtkDataArray* array = data->GetArray("MesoVertex");
  const auto size = static_cast<vtkIdType>(positions.size());
  if (!array || array->GetNumberOfComponents() != 1 || array->GetNumberOfTuples() != size)
  {
    return {};
  }
  std::vector<std::int64_t> vertices(size);
  std::vector<std::int64_t> first(size, -1);
  for (vtkIdType i = 0; i < size; ++i)
  {
    const double number = array->GetComponent(i, 0);
    if (!(number >= 0. && number < static_cast<double>(size) && number == std::floor(number)))
    {
      return {};
    }
    vertices[i] = static_cast<std::int64_t>(number);
    std::int64_t& other = first[vertices[i]];
    other = other < 0 ? i : other;
    if (positions[other] != positions[i])
    {
      return {};
    }
  }
  return vertices;
}

/// Numbers positions from 0 without a gap, in the order of their first point.
std::vector<std::int64_t> MadeVertices(const std::vector<MesoVector>& positions)
{
  std::vector<std::int64_t> vertices = MesoFirstEqual(positions);
  std::int64_t next = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    const bool isFirst = vertices[i] == static_cast<std::int64_t>(i);
    vertices[i] = isFirst ? next++ : vertices[vertices[i]];
  }
  return vertices;
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
  corners->SetNumberOfValues(static_cast<vtkIdType>(3 * triangles.size()));
  vtkIdType* next = corners->GetPointer(0);
  for (const auto& triangle : triangles)
  {
    next = std::copy(triangle.begin(), triangle.end(), next);
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(3, corners);
  return cells;
}

template <std::size_t N>
vtkSmartPointer<vtkDataArray> MakeArray(
  const char* name, int type, const std::vector<std::array<double, N>>& tuples)
{
  const auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(N));
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    array->SetTuple(static_cast<vtkIdType>(i), tuples[i].data());
  }
  return array;
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
    data->SetNormals(MakeArray("Normals", type, frames.Normals));
  }
  std::vector<std::array<double, 1>> valid;
  std::vector<std::array<double, 1>> vertices;
  for (std::size_t i = 0; i < frames.Source.size(); ++i)
  {
    valid.push_back({ frames.Valid[i] ? 1. : 0. });
    vertices.push_back({ static_cast<double>(input.Mesh.Vertex[frames.Source[i]]) });
  }
  data->AddArray(MakeArray("MesoVertex", VTK_DOUBLE, vertices));
  data->AddArray(MakeArray("MesoTangent", type, frames.Tangents));
  data->AddArray(MakeArray("MesoBitangent", type, frames.Bitangents));
  data->AddArray(MakeArray("MesoTileScale", type, frames.Scales));
  data->AddArray(MakeArray("MesoFrameValid", type, valid));
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
  vtkDataArray* coordinates = FindTextureCoordinates(input);
  frame.TextureCoordinates = Tuples<2>(coordinates, "the texture coordinate");
  frame.TextureRounding = RoundingOf(coordinates);
  vtkDataArray* positions = input->GetPoints()->GetData();
  frame.Mesh.Positions = Tuples<3>(positions, "the position");
  frame.Mesh.PositionRounding = RoundingOf(positions);
  if (vtkDataArray* normals = FindNormals(input))
  {
    frame.Normals = Tuples<3>(normals, "the normal");
  }
  CheckCells(input->GetPolys(), "polygon", points);
  CheckCells(input->GetStrips(), "strip", points);
  this->UpdateProgress(0.2);

  const vtkSmartPointer<vtkPolyData> triangles = Triangulated(input);
  frame.Mesh.Triangles = TrianglesOf(triangles->GetPolys());
  frame.Mesh.Vertex = GivenVertices(input->GetPointData(), frame.Mesh.Positions);
  if (frame.Mesh.Vertex.empty())
  {
    frame.Mesh.Vertex = MadeVertices(frame.Mesh.Positions);
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
