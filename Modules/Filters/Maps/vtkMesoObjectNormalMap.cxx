#include "vtkMesoObjectNormalMap.h"

#include "MesoKernels.h"
#include "MesoWholeImage.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMesoObjectNormalMap);

namespace
{
constexpr int LargestSize = 16384;
constexpr double Margin = 1.; // texels beside a triangle that continue it

/// What a mesh has at each point.
struct Vertices
{
  vtkDataArray* Normals = nullptr;
  vtkDataArray* Coordinates = nullptr;
  vtkDataArray* Tangents = nullptr;
  vtkDataArray* Bitangents = nullptr;
  vtkDataArray* Scales = nullptr;

  explicit Vertices(vtkPointData* data)
    : Normals(data->GetNormals())
    , Coordinates(data->GetTCoords())
    , Tangents(data->GetArray("MesoTangent"))
    , Bitangents(data->GetArray("MesoBitangent"))
    , Scales(data->GetArray("MesoTileScale"))
  {
  }

  bool Complete() const
  {
    return this->Normals && this->Coordinates && this->Coordinates->GetNumberOfComponents() == 2 &&
      this->Tangents && this->Bitangents && this->Scales;
  }
};

glm::dvec3 VectorAt(vtkDataArray* array, vtkIdType id)
{
  glm::dvec3 vector(0.);
  array->GetTuple(id, &vector.x);
  return vector;
}

/// A triangle over the map, in texels.
struct Chart
{
  std::array<glm::dvec2, 3> Corners; ///< in texels, centres at integers
  std::array<glm::dvec2, 3> Coordinates;
  std::array<glm::dvec3, 3> Normals;
  std::array<glm::dvec3, 3> PerU; ///< dp/du and dp/dv of the texture coordinate
  std::array<glm::dvec3, 3> PerV;
  double Area = 0.; ///< twice, with its sign

  Chart(const Vertices& vertices, const vtkIdType* ids, const glm::dvec2& size)
  {
    for (int k = 0; k < 3; ++k)
    {
      vertices.Coordinates->GetTuple(ids[k], &this->Coordinates[k].x);
      this->Corners[k] = this->Coordinates[k] * size - 0.5;
      this->Normals[k] = VectorAt(vertices.Normals, ids[k]);
      this->PerU[k] =
        vertices.Scales->GetComponent(ids[k], 0) * VectorAt(vertices.Tangents, ids[k]);
      this->PerV[k] =
        vertices.Scales->GetComponent(ids[k], 1) * VectorAt(vertices.Bitangents, ids[k]);
    }
    const glm::dvec2 a = this->Corners[1] - this->Corners[0];
    const glm::dvec2 b = this->Corners[2] - this->Corners[0];
    this->Area = a.x * b.y - a.y * b.x;
  }

  /// Weights of the corners at a texel; outside: how many texels it lies outside of the triangle.
  glm::dvec3 WeightsAt(const glm::dvec2& texel, double& outside) const
  {
    glm::dvec3 weights;
    outside = 0.;
    for (int k = 0; k < 3; ++k)
    {
      const glm::dvec2& from = this->Corners[(k + 1) % 3];
      const glm::dvec2 edge = this->Corners[(k + 2) % 3] - from;
      const glm::dvec2 to = texel - from;
      const double cross = edge.x * to.y - edge.y * to.x;
      weights[k] = cross / this->Area;
      if (weights[k] < 0.)
      {
        outside = std::max(outside, std::abs(cross) / std::max(glm::length(edge), 1e-12));
      }
    }
    return weights;
  }

  template <typename Value>
  static Value Between(const std::array<Value, 3>& values, const glm::dvec3& weights)
  {
    return weights.x * values[0] + weights.y * values[1] + weights.z * values[2];
  }
};

int Wrapped(int i, int size)
{
  return (i % size + size) % size;
}
}

vtkMesoObjectNormalMap::vtkMesoObjectNormalMap()
{
  this->SetNumberOfInputPorts(2);
}

void vtkMesoObjectNormalMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Tiles: " << this->Tiles[0] << " " << this->Tiles[1] << "\n";
  os << indent << "Wrap: " << MesoName(this->Wrap) << "\n";
  os << indent << "NumberOfOverlaps: " << this->NumberOfOverlaps << "\n";
}

int vtkMesoObjectNormalMap::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkImageData" : "vtkPolyData");
  return 1;
}

int vtkMesoObjectNormalMap::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int extent[6] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, 0 };
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkMesoObjectNormalMap::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*)
{
  MesoAskForWholeImage(inputVector[0]->GetInformationObject(0));
  return 1;
}

int vtkMesoObjectNormalMap::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkPolyData* mesh = vtkPolyData::GetData(inputVector[1]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  this->NumberOfOverlaps = 0;
  auto* heights = vtkFloatArray::SafeDownCast(input->GetPointData()->GetScalars());
  const Vertices vertices(mesh->GetPointData());
  std::string problem;
  if (!heights || heights->GetNumberOfComponents() != 1 || input->GetDimensions()[2] != 1)
  {
    problem = "The first input is no height map: a plane image with one component of float";
  }
  else if (!vertices.Complete())
  {
    problem = "The mesh needs normals, two texture coordinates and the arrays of "
              "vtkMesoSurfaceFrames";
  }
  else if (std::min(this->Size[0], this->Size[1]) < 1 ||
    std::max(this->Size[0], this->Size[1]) > LargestSize || !(this->Tiles[0] > 0.) ||
    !(this->Tiles[1] > 0.))
  {
    problem = "The size must be 1 to " + std::to_string(LargestSize) + " and the tiles above 0";
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }
  const float* first = heights->GetPointer(0);
  const MesoKernels::Double::HeightField field(input->GetDimensions()[0], input->GetDimensions()[1],
    this->Wrap, { first, first + heights->GetNumberOfValues() });
  const MesoKernels::Double::Frame frame;
  const glm::dvec2 tiles(this->Tiles[0], this->Tiles[1]);
  output->SetDimensions(this->Size[0], this->Size[1], 1);
  const vtkIdType texels = output->GetNumberOfPoints();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normal");
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(texels);
  normals->FillValue(0.f);
  enum : unsigned char
  {
    Empty,
    Beside,
    Inside
  };
  std::vector<unsigned char> filled(texels, Empty);

  const glm::dvec2 size(this->Size[0], this->Size[1]);
  const vtkIdType cells = mesh->GetPolys()->GetNumberOfCells();
  vtkIdType done = 0;
  auto cell = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal() && !this->GetAbortExecute();
       cell->GoToNextCell())
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(corners, ids);
    for (vtkIdType k = 2; k < corners; ++k) // polygons as fans
    {
      const vtkIdType fan[3] = { ids[0], ids[k - 1], ids[k] };
      const Chart chart(vertices, fan, size);
      const glm::dvec2 low =
        glm::min(glm::min(chart.Corners[0], chart.Corners[1]), chart.Corners[2]);
      const glm::dvec2 high =
        glm::max(glm::max(chart.Corners[0], chart.Corners[1]), chart.Corners[2]);
      // Also false where a coordinate is not finite.
      if (!(std::abs(chart.Area) > 0.) || !(high.x - low.x <= 2. * size.x) ||
        !(high.y - low.y <= 2. * size.y) || !(std::abs(low.x) + std::abs(low.y) < 1e8))
      {
        continue;
      }
      for (int row = int(std::ceil(low.y - Margin)); row <= int(std::floor(high.y + Margin)); ++row)
      {
        for (int column = int(std::ceil(low.x - Margin));
             column <= int(std::floor(high.x + Margin)); ++column)
        {
          double outside = 0.;
          const glm::dvec3 weights = chart.WeightsAt(glm::dvec2(column, row), outside);
          const vtkIdType texel =
            vtkIdType(Wrapped(row, this->Size[1])) * this->Size[0] + Wrapped(column, this->Size[0]);
          const unsigned char now = outside > 0. ? Beside : Inside;
          if (outside > Margin || (now == Beside && filled[texel] != Empty))
          {
            continue;
          }
          // Two triangles share the texels on their edge.
          const bool within = std::min({ weights.x, weights.y, weights.z }) > 1e-6;
          this->NumberOfOverlaps += now == Inside && filled[texel] == Inside && within ? 1 : 0;
          filled[texel] = now;
          const glm::dvec3 normal = glm::normalize(Chart::Between(chart.Normals, weights));
          const glm::dvec2 gradient =
            field.heightGradient(Chart::Between(chart.Coordinates, weights) * tiles);
          const glm::dvec3 tilted =
            frame.tiltedNormal(Chart::Between(chart.PerU, weights) / tiles.x,
              Chart::Between(chart.PerV, weights) / tiles.y, -this->Scale * normal, normal,
              glm::dvec3(gradient, 1.));
          for (int i = 0; i < 3; ++i)
          {
            const bool sound = std::isfinite(tilted.x + tilted.y + tilted.z);
            normals->SetTypedComponent(texel, i, sound ? static_cast<float>(tilted[i]) : 0.f);
          }
        }
      }
    }
    if (++done % 1024 == 0)
    {
      this->UpdateProgress(static_cast<double>(done) / static_cast<double>(cells));
    }
  }
  if (this->GetAbortExecute())
  {
    output->Initialize();
    return 1;
  }
  output->GetPointData()->SetScalars(normals);
  return 1;
}
