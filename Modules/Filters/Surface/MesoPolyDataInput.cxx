#include "MesoPolyDataInput.h"

#include "MesoFirstEqual.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkTriangleFilter.h"

namespace
{
constexpr double FloatRounding = 1. / (1 << 24);
constexpr double DoubleRounding = FloatRounding * FloatRounding / 32.; // 2^-53
}

double MesoRoundingOf(vtkDataArray* array)
{
  return array->GetDataType() == VTK_DOUBLE ? DoubleRounding : FloatRounding;
}

/// Null where the input has no normals, or none that fit it.
vtkDataArray* MesoFindNormals(vtkPolyData* input)
{
  vtkPointData* data = input->GetPointData();
  vtkDataArray* array = data->GetNormals();
  array = array ? array : data->GetArray("Normals");
  const bool fits = array && array->GetNumberOfComponents() == 3 &&
    array->GetNumberOfTuples() == input->GetNumberOfPoints();
  return fits ? array : nullptr;
}

vtkDataArray* MesoFindTextureCoordinates(vtkPolyData* input)
{
  vtkPointData* data = input->GetPointData();
  vtkDataArray* array = data->GetTCoords();
  array = array ? array : data->GetArray("TextureCoordinates");
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

void MesoCheckCells(vtkCellArray* cells, const char* what, vtkIdType points)
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
vtkSmartPointer<vtkPolyData> MesoTriangulated(vtkPolyData* input)
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

std::vector<std::array<std::int64_t, 3>> MesoTrianglesOf(vtkCellArray* cells)
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
std::vector<std::int64_t> MesoGivenVertices(
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
std::vector<std::int64_t> MesoMadeVertices(const std::vector<MesoVector>& positions)
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
