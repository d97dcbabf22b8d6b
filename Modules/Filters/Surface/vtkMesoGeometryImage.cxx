#include "vtkMesoGeometryImage.h"

#include "MesoFitInput.h"
#include "MesoGeometryImage.h"
#include "MesoPolyDataInput.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkGenericCell.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticCellLocator.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkMesoGeometryImage);

namespace
{
/// Sizes from the finest on.
std::vector<int> SizesFrom(int size)
{
  std::vector<int> sizes;
  for (; size >= vtkMesoGeometryImage::SmallestSize; size /= 2)
  {
    sizes.push_back(size);
  }
  return sizes;
}

int RowsOf(const std::vector<int>& sizes)
{
  int rows = 0;
  for (const int size : sizes)
  {
    rows += size;
  }
  return rows;
}

template <typename Array>
vtkSmartPointer<Array> AddArray(vtkImageData* image, const char* name, int components)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(image->GetNumberOfPoints());
  std::fill_n(array->GetPointer(0), array->GetNumberOfValues(), 0);
  image->GetPointData()->AddArray(array);
  return array;
}

MesoGeometryInput ReadMesh(vtkPolyData* mesh)
{
  MesoCheckCells(mesh->GetPolys(), "polygon", mesh->GetNumberOfPoints());
  MesoCheckCells(mesh->GetStrips(), "strip", mesh->GetNumberOfPoints());
  vtkDataArray* normals = MesoFindNormals(mesh);
  if (!normals)
  {
    throw std::invalid_argument("the mesh has no point normals");
  }
  MesoGeometryInput input;
  input.Coordinates = MesoTuples<2>(MesoFindTextureCoordinates(mesh), "the texture coordinate");
  input.Normals = MesoTuples<3>(normals, "the normal");
  if (mesh->GetPoints())
  {
    input.Mesh.Positions = MesoTuples<3>(mesh->GetPoints()->GetData(), "the position");
  }
  input.Mesh.Triangles = MesoTrianglesOf(MesoTriangulated(mesh)->GetPolys());
  input.Mesh.Vertex = MesoGivenVertices(mesh->GetPointData(), input.Mesh.Positions);
  if (input.Mesh.Vertex.empty())
  {
    input.Mesh.Vertex = MesoMadeVertices(input.Mesh.Positions);
  }
  return input;
}

/// Root mean square and largest distance of the mesh's points from a surface.
std::array<double, 2> DistancesFrom(vtkPolyData* surface, const MesoTriangleMesh& mesh)
{
  if (surface->GetNumberOfPolys() == 0)
  {
    return { 0., 0. };
  }
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(surface);
  locator->BuildLocator();
  vtkNew<vtkGenericCell> cell;
  double sum = 0.;
  double largest = 0.;
  for (const MesoVector& position : mesh.Positions)
  {
    double closest[3];
    vtkIdType id = 0;
    int part = 0;
    double square = 0.;
    locator->FindClosestPoint(position.data(), closest, cell, id, part, square);
    sum += square;
    largest = std::max(largest, square);
  }
  return { std::sqrt(sum / static_cast<double>(mesh.Positions.size())), std::sqrt(largest) };
}

/// The level's samples back out of the image.
MesoGeometryLevel LevelOf(vtkImageData* image, int level)
{
  vtkDataArray* levels = image->GetFieldData()->GetArray("MesoLevels");
  const int size = static_cast<int>(levels->GetComponent(level, 0));
  const auto firstRow = static_cast<vtkIdType>(levels->GetComponent(level, 1));
  const int width = image->GetDimensions()[0];
  vtkPointData* data = image->GetPointData();
  vtkDataArray* positions = data->GetArray("MesoPosition");
  vtkDataArray* normals = data->GetArray("MesoNormal");
  vtkDataArray* coordinates = data->GetArray("TextureCoordinates");
  vtkDataArray* charts = data->GetArray("MesoChart");
  MesoGeometryLevel result;
  result.Size = size;
  for (vtkIdType row = 0; row < size; ++row)
  {
    for (vtkIdType column = 0; column < size; ++column)
    {
      const vtkIdType texel = (firstRow + row) * width + column;
      MesoVector vector;
      positions->GetTuple(texel, vector.data());
      result.Positions.push_back(vector);
      normals->GetTuple(texel, vector.data());
      result.Normals.push_back(vector);
      result.Coordinates.push_back(
        { coordinates->GetComponent(texel, 0), coordinates->GetComponent(texel, 1) });
      result.Charts.push_back(static_cast<std::int32_t>(charts->GetTuple1(texel)));
    }
  }
  return result;
}
}

void vtkMesoGeometryImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size << "\n";
  os << indent << "NumberOfCharts: " << this->NumberOfCharts << "\n";
  os << indent << "NumberOfOverlaps: " << this->NumberOfOverlaps << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}

int vtkMesoGeometryImage::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkMesoGeometryImage::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), 0,
    this->Size - 1, 0, RowsOf(SizesFrom(this->Size)) - 1, 0, 0);
  return 1;
}

int vtkMesoGeometryImage::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  this->NumberOfOverlaps = 0;
  this->NumberOfCharts = 0;
  this->ErrorMessage = MesoFitFailure(
    "geometry image", [&] { this->Make(vtkPolyData::GetData(inputVector[0]), output); });
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
  }
  return 1;
}

void vtkMesoGeometryImage::Make(vtkPolyData* input, vtkImageData* output)
{
  const MesoGeometryInput mesh = ReadMesh(input);
  const MesoGeometryImage image(mesh);
  this->NumberOfCharts = image.NumberOfCharts();
  const std::vector<int> sizes = SizesFrom(this->Size);
  output->SetDimensions(this->Size, RowsOf(sizes), 1);
  const auto positions = AddArray<vtkFloatArray>(output, "MesoPosition", 3);
  const auto normals = AddArray<vtkFloatArray>(output, "MesoNormal", 3);
  const auto coordinates = AddArray<vtkFloatArray>(output, "TextureCoordinates", 2);
  const auto charts = AddArray<vtkIntArray>(output, "MesoChart", 1);
  output->GetPointData()->SetScalars(positions);
  vtkNew<vtkDoubleArray> levels;
  levels->SetName("MesoLevels");
  levels->SetNumberOfComponents(4);
  output->GetFieldData()->AddArray(levels);
  vtkIdType firstRow = 0;
  for (const int size : sizes)
  {
    if (this->GetAbortExecute())
    {
      output->Initialize();
      return;
    }
    const MesoGeometryLevel level = image.Sample(size);
    this->NumberOfOverlaps = size == this->Size ? level.Overlapping : this->NumberOfOverlaps;
    for (vtkIdType i = 0; i < vtkIdType(size) * size; ++i)
    {
      const vtkIdType texel = (firstRow + i / size) * this->Size + i % size;
      positions->SetTuple(texel, level.Positions[i].data());
      normals->SetTuple(texel, level.Normals[i].data());
      coordinates->SetTuple(texel, level.Coordinates[i].data());
      charts->SetValue(texel, level.Charts[i]);
    }
    const double place[] = { double(size), double(firstRow), 0., 0. };
    const vtkIdType number = levels->InsertNextTuple(place);
    const auto distances =
      DistancesFrom(vtkMesoGeometryImage::SurfaceOf(output, static_cast<int>(number)), mesh.Mesh);
    levels->SetComponent(number, 2, distances[0]);
    levels->SetComponent(number, 3, distances[1]);
    firstRow += size;
    this->UpdateProgress(
      std::min(1., 0.75 + 0.25 * double(number) / static_cast<double>(sizes.size())));
  }
}

int vtkMesoGeometryImage::NumberOfLevelsOf(vtkImageData* image, std::string& problem)
{
  vtkDataArray* levels = image->GetFieldData()->GetArray("MesoLevels");
  if (!levels || levels->GetNumberOfComponents() != 4 || levels->GetNumberOfTuples() == 0)
  {
    problem = "a geometry image has MesoLevels among its field data, which is missing";
    return 0;
  }
  const std::pair<const char*, int> arrays[] = { { "MesoPosition", 3 }, { "MesoNormal", 3 },
    { "TextureCoordinates", 2 }, { "MesoChart", 1 } };
  for (const auto& [name, components] : arrays)
  {
    vtkDataArray* array = image->GetPointData()->GetArray(name);
    if (!array || array->GetNumberOfComponents() != components)
    {
      problem = std::string("a geometry image has the point array ") + name + " of " +
        std::to_string(components) + " components, which is missing";
      return 0;
    }
  }
  for (vtkIdType i = 0; i < levels->GetNumberOfTuples(); ++i)
  {
    const double size = levels->GetComponent(i, 0);
    const double row = levels->GetComponent(i, 1);
    if (!(size >= 1. && row >= 0. && size <= image->GetDimensions()[0] &&
          row + size <= image->GetDimensions()[1]))
    {
      problem = "level " + std::to_string(i) + " of the geometry image lies outside of it";
      return 0;
    }
  }
  return static_cast<int>(levels->GetNumberOfTuples());
}

vtkSmartPointer<vtkPolyData> vtkMesoGeometryImage::SurfaceOf(vtkImageData* image, int number)
{
  const MesoGeometryLevel level = LevelOf(image, number);
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("TextureCoordinates");
  coordinates->SetNumberOfComponents(2);
  std::vector<vtkIdType> numbers(level.Positions.size(), -1);
  vtkNew<vtkCellArray> cells;
  const std::vector<std::int32_t> triangles = MesoGeometryImage::Triangles(level);
  for (std::size_t i = 0; i < triangles.size(); i += 3)
  {
    vtkIdType corners[3];
    for (int k = 0; k < 3; ++k)
    {
      const std::int32_t texel = triangles[i + k];
      if (numbers[texel] < 0)
      {
        numbers[texel] = points->InsertNextPoint(level.Positions[texel].data());
        normals->InsertNextTuple(level.Normals[texel].data());
        coordinates->InsertNextTuple(level.Coordinates[texel].data());
      }
      corners[k] = numbers[texel];
    }
    cells->InsertNextCell(3, corners);
  }
  surface->SetPoints(points);
  surface->SetPolys(cells);
  surface->GetPointData()->SetNormals(normals);
  surface->GetPointData()->SetTCoords(coordinates);
  return surface;
}
