#include "vtkMesoDisplacedMesh.h"

#include "MesoDicer.h"
#include "MesoFitInput.h"

#include "vtkArrayListTemplate.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTypeInt32Array.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMesoDisplacedMesh);

namespace
{
std::vector<float> HeightsOf(vtkImageData* image)
{
  int size[3] = { 0, 0, 0 };
  image->GetDimensions(size);
  vtkDataArray* array = image->GetPointData()->GetScalars();
  if (!array || image->GetNumberOfPoints() == 0)
  {
    throw std::invalid_argument("the height map is empty");
  }
  if (size[2] != 1)
  {
    throw std::invalid_argument(
      "the height map has " + std::to_string(size[2]) + " slices, 1 is needed");
  }
  const auto* floats = vtkFloatArray::SafeDownCast(array);
  if (!floats || array->GetNumberOfComponents() != 1)
  {
    throw std::invalid_argument("the height map has " +
      std::to_string(array->GetNumberOfComponents()) + " components of " +
      array->GetDataTypeAsString() + ", 1 of float is needed");
  }
  std::vector<float> heights(std::size_t(size[0]) * std::size_t(size[1]));
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    heights[i] = floats->GetValue(static_cast<vtkIdType>(i));
    if (!(heights[i] >= 0.f && heights[i] <= 1.f)) // NaN as well
    {
      std::ostringstream message;
      message << "the height of texel (" << i % size[0] << ", " << i / size[0] << ") is "
              << heights[i] << ", not in [0, 1]";
      throw std::invalid_argument(message.str());
    }
  }
  return heights;
}

/// An array of the input as one of the output's, which `list` then fills. Nothing where the output has
/// one of that name anyway.
void AddCarried(const std::string& name, vtkIdType points, vtkPolyData* input, vtkPolyData* output,
  ArrayList& list)
{
  if (name == "Normals" || name == "TextureCoordinates" || name == "MesoRelief")
  {
    return;
  }
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfTuples() != input->GetNumberOfPoints() ||
    array->GetDataType() == VTK_BIT)
  {
    throw std::invalid_argument(
      "the mesh has no point array of numbers named " + name + ", which is to be carried");
  }
  vtkStdString own = name;
  output->GetPointData()->AddArray(list.AddArrayPair(points, array, own, 0., true));
}

template <typename Array>
vtkSmartPointer<Array> NewArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  if (!array->Allocate(components * tuples))
  {
    throw std::bad_alloc();
  }
  array->SetNumberOfTuples(tuples);
  return array;
}
}

vtkMesoDisplacedMesh::vtkMesoDisplacedMesh()
{
  this->SetNumberOfInputPorts(2);
}

void vtkMesoDisplacedMesh::SetHeightMapData(vtkImageData* heights)
{
  this->SetInputDataObject(1, heights);
}

void vtkMesoDisplacedMesh::SetHeightMapConnection(vtkAlgorithmOutput* heights)
{
  this->SetInputConnection(1, heights);
}

int vtkMesoDisplacedMesh::FillInputPortInformation(int port, vtkInformation* information)
{
  information->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkImageData");
  return 1;
}

int vtkMesoDisplacedMesh::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* heights = inputVector[1]->GetInformationObject(0);
  heights->Set(Pipeline::UPDATE_EXTENT(), heights->Get(Pipeline::WHOLE_EXTENT()), 6);
  return this->Superclass::RequestUpdateExtent(request, inputVector, outputVector);
}

int vtkMesoDisplacedMesh::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->NumberOfTornEdges = 0;
  this->LargestTear = 0.;
  this->ErrorMessage = MesoFitFailure("displaced triangles",
    [&]
    {
      this->Execute(
        vtkPolyData::GetData(inputVector[0]), vtkImageData::GetData(inputVector[1]), output);
    });
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    // Returning 0 would make the executive add an error of several lines that says nothing more.
  }
  return 1;
}

void vtkMesoDisplacedMesh::AddCarriedArray(const std::string& name)
{
  if (this->CarriedArrays.insert(name).second)
  {
    this->Modified();
  }
}

void vtkMesoDisplacedMesh::ClearCarriedArrays()
{
  if (!this->CarriedArrays.empty())
  {
    this->CarriedArrays.clear();
    this->Modified();
  }
}

void vtkMesoDisplacedMesh::CheckParameters() const
{
  const auto check = [](bool right, const char* name, double value, const char* range)
  {
    if (!right || !std::isfinite(value))
    {
      std::ostringstream message;
      message << name << " must be " << range << ", is " << value;
      throw std::invalid_argument(message.str());
    }
  };
  check(this->Scale >= 0., "Scale", this->Scale, "0 or more");
  check(this->Reference >= 0. && this->Reference <= 1., "Reference", this->Reference, "in [0, 1]");
  check(this->Tiles[0] > 0., "Tiles along u", this->Tiles[0], "more than 0");
  check(this->Tiles[1] > 0., "Tiles along v", this->Tiles[1], "more than 0");
  check(this->FacetsPerTexel > 0., "FacetsPerTexel", this->FacetsPerTexel, "more than 0");
}

void vtkMesoDisplacedMesh::Execute(vtkPolyData* input, vtkImageData* heights, vtkPolyData* output)
{
  this->CheckParameters();
  if (input->GetNumberOfPoints() == 0)
  {
    return;
  }
  const int* size = heights->GetDimensions();
  const MesoKernels::Double::HeightField field(size[0], size[1], this->Wrap, HeightsOf(heights));
  vtkDataArray* coordinates = MesoFindTextureCoordinates(input);
  const auto uv = MesoTuples<2>(coordinates, "the texture coordinate");
  const MesoFitInput base = MesoReadFitInput(input);
  this->UpdateProgress(0.05);

  std::vector<std::array<double, 2>> texels(uv.size());
  for (std::size_t i = 0; i < uv.size(); ++i)
  {
    texels[i] = { uv[i][0] * this->Tiles[0] * size[0], uv[i][1] * this->Tiles[1] * size[1] };
  }
  const MesoDicePlan plan(base.Mesh, texels, this->FacetsPerTexel, this->MaximumNumberOfTriangles);
  this->UpdateProgress(0.1);

  vtkDataArray* normals = MesoFindNormals(input);
  const MesoDisplacement::Base surface = { base.Mesh, base.Normals, uv,
    normals && !base.NormalsAreMade ? MesoRoundingOf(normals) : 0., MesoRoundingOf(coordinates) };
  const MesoDisplacement displacement(
    surface, field, { this->Tiles[0], this->Tiles[1] }, this->Scale, this->Reference);
  const bool done = base.ArrayType() == VTK_DOUBLE
    ? this->Fill<vtkDoubleArray>(plan, displacement, base.Mesh, input, output)
    : this->Fill<vtkFloatArray>(plan, displacement, base.Mesh, input, output);
  if (!done)
  {
    output->Initialize();
    return;
  }
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
}

template <typename Work>
bool vtkMesoDisplacedMesh::ForEach(vtkIdType size, double from, double to, const Work& work)
{
  constexpr vtkIdType steps = 20;
  for (vtkIdType step = 0; step < steps; ++step)
  {
    this->UpdateProgress(from + (to - from) * static_cast<double>(step) / steps);
    if (this->GetAbortExecute())
    {
      return false;
    }
    vtkSMPTools::For(step * size / steps, (step + 1) * size / steps, work);
  }
  return true;
}

template <typename Array>
bool vtkMesoDisplacedMesh::Fill(const MesoDicePlan& plan, const MesoDisplacement& surface,
  const MesoTriangleMesh& mesh, vtkPolyData* input, vtkPolyData* output)
{
  const vtkIdType points = plan.NumberOfPoints();
  const auto positions = NewArray<Array>("Points", 3, points);
  const auto normals = NewArray<Array>("Normals", 3, points);
  const auto coordinates = NewArray<Array>("TextureCoordinates", 2, points);
  const auto reliefs = NewArray<Array>("MesoRelief", 1, points);
  const auto triangles = NewArray<vtkTypeInt32Array>("", 1, 3 * plan.NumberOfTriangles());
  ArrayList carried;
  for (const std::string& name : this->CarriedArrays)
  {
    AddCarried(name, points, input, output, carried);
  }
  MesoDicedArrays<typename Array::ValueType> arrays = { positions->GetPointer(0),
    normals->GetPointer(0), coordinates->GetPointer(0), reliefs->GetPointer(0), {} };
  if (output->GetPointData()->GetNumberOfArrays() > 0)
  {
    arrays.Carry = [&carried](
                     int count, const std::int64_t* ids, const double* weights, std::int64_t point)
    {
      vtkIdType from[3];
      std::copy(ids, ids + count, from);
      carried.Interpolate(count, from, weights, point);
    };
  }
  const MesoDicer<typename Array::ValueType> dicer(
    plan, surface, mesh, arrays, this->DetailNormals);
  std::int32_t* const corners = triangles->GetPointer(0);

  const bool done = this->ForEach(dicer.NumberOfVertices(), 0.1, 0.15,
                      [&](vtkIdType first, vtkIdType last)
                      {
                        for (vtkIdType v = first; v < last; ++v)
                        {
                          dicer.FillVertex(v);
                        }
                      }) &&
    this->ForEach(dicer.NumberOfEdges(), 0.15, 0.25,
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType edge = first; edge < last; ++edge)
        {
          dicer.FillEdge(edge);
        }
      }) &&
    this->ForEach(plan.NumberOfItems(), 0.25, 0.95,
      [&](vtkIdType first, vtkIdType last)
      {
        const auto& grids = plan.GetGrids();
        std::int64_t grid = plan.GridOfItem(first);
        for (vtkIdType item = first; item < last; ++item)
        {
          grid += item == grids[grid].FirstItem + grids[grid].Rows ? 1 : 0;
          const std::int64_t row = item - grids[grid].FirstItem;
          dicer.FillRow(grids[grid], row);
          plan.WriteTriangles(grids[grid], row, corners);
        }
      });
  if (!done)
  {
    return false;
  }
  for (std::int64_t edge = 0; edge < dicer.NumberOfEdges(); ++edge)
  {
    const double tear = dicer.TearOf(edge);
    this->NumberOfTornEdges += tear > 0. ? 1 : 0;
    this->LargestTear = std::max(this->LargestTear, tear);
  }

  vtkNew<vtkPoints> places;
  places->SetData(positions);
  output->SetPoints(places);
  vtkNew<vtkCellArray> cells;
  cells->SetData(3, triangles);
  output->SetPolys(cells);
  output->GetPointData()->SetNormals(normals);
  output->GetPointData()->SetTCoords(coordinates);
  output->GetPointData()->AddArray(reliefs);
  return true;
}

void vtkMesoDisplacedMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "Reference: " << this->Reference << "\n";
  os << indent << "Tiles: " << this->Tiles[0] << " " << this->Tiles[1] << "\n";
  os << indent << "Wrap: " << MesoName(this->Wrap) << "\n";
  os << indent << "FacetsPerTexel: " << this->FacetsPerTexel << "\n";
  os << indent << "MaximumNumberOfTriangles: " << this->MaximumNumberOfTriangles << "\n";
  os << indent << "DetailNormals: " << (this->DetailNormals ? "On" : "Off") << "\n";
  os << indent << "CarriedArrays:";
  for (const std::string& name : this->CarriedArrays)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "NumberOfTornEdges: " << this->NumberOfTornEdges << "\n";
  os << indent << "LargestTear: " << this->LargestTear << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
