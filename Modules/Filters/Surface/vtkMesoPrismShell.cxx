#include "vtkMesoPrismShell.h"

#include "MesoFitInput.h"
#include "MesoPrismShell.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

vtkStandardNewMacro(vtkMesoPrismShell);

namespace
{
constexpr std::size_t MostPrisms = std::size_t(1) << 24; // their numbers are floats in shaders
constexpr int TableRows = 7;

MesoVector MiddleOf(const std::vector<MesoPrism>& prisms)
{
  MesoVector low = prisms[0].Bottom[0];
  MesoVector high = low;
  for (const MesoPrism& prism : prisms)
  {
    for (const MesoVector& corner : prism.Bottom)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], corner[axis]);
        high[axis] = std::max(high[axis], corner[axis]);
      }
    }
  }
  return MesoScaled(MesoSum(low, high), 0.5);
}

/// Heights at which each prism's triangle has points.
std::vector<double> HeightsOf(int slices)
{
  std::vector<double> heights;
  heights.reserve(slices);
  for (int i = 0; i < slices; ++i)
  {
    heights.push_back((i + 0.5) / slices);
  }
  return slices > 0 ? heights : std::vector<double>{ 0., 1. };
}

/// Points of all prisms with their arrays.
void WritePoints(const std::vector<MesoPrism>& prisms, const MesoPrismShellInput& input,
  const std::vector<double>& levels, int type, vtkPolyData* output)
{
  std::vector<MesoVector> normals;
  std::vector<std::array<double, 2>> coordinates;
  std::vector<std::array<double, 1>> numbers;
  std::vector<std::array<double, 1>> heights;
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  points->SetNumberOfPoints(3 * static_cast<vtkIdType>(levels.size() * prisms.size()));
  vtkIdType next = 0;
  for (std::size_t i = 0; i < prisms.size(); ++i)
  {
    for (const double z : levels)
    {
      for (int k = 0; k < 3; ++k)
      {
        const MesoVector place = MesoSum(prisms[i].Bottom[k], MesoScaled(prisms[i].Rise[k], z));
        points->SetPoint(next++, place.data());
        normals.push_back(input.Normals[prisms[i].Points[k]]);
        coordinates.push_back(input.Coordinates[prisms[i].Points[k]]);
        numbers.push_back({ static_cast<double>(i) });
        heights.push_back({ z });
      }
    }
  }
  output->SetPoints(points);
  vtkPointData* data = output->GetPointData();
  data->SetNormals(MesoMakeArray("Normals", type, normals));
  data->SetTCoords(MesoMakeArray("TextureCoordinates", type, coordinates));
  data->AddArray(MesoMakeArray("MesoPrism", type, numbers));
  data->AddArray(MesoMakeArray("MesoShellHeight", type, heights));
}

void AddFace(const MesoPrism& prism, vtkIdType a, vtkIdType b, vtkIdType c, vtkCellArray* faces)
{
  const vtkIdType corners[3] = { a, prism.Turned ? c : b, prism.Turned ? b : c };
  faces->InsertNextCell(3, corners);
}

void WriteSlices(const std::vector<MesoPrism>& prisms, int slices, vtkPolyData* output)
{
  vtkNew<vtkCellArray> faces;
  vtkIdType next = 0;
  for (const MesoPrism& prism : prisms)
  {
    for (int i = 0; i < slices; ++i, next += 3)
    {
      AddFace(prism, next, next + 1, next + 2, faces);
    }
  }
  output->SetPolys(faces);
}

void WriteFaces(const std::vector<MesoPrism>& prisms, bool innerFins, vtkPolyData* output)
{
  vtkNew<vtkCellArray> faces;
  for (std::size_t i = 0; i < prisms.size(); ++i)
  {
    const vtkIdType first = static_cast<vtkIdType>(i) * 6;
    const auto add = [&](int a, int b, int c)
    { AddFace(prisms[i], first + a, first + b, first + c, faces); };
    add(0, 2, 1);
    add(3, 4, 5);
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      if (!innerFins && prisms[i].Beyond[k] >= 0)
      {
        continue;
      }
      if ((prisms[i].Falling >> k) & 1)
      {
        add(k, next, k + 3);
        add(next, next + 3, k + 3);
      }
      else
      {
        add(k, next, next + 3);
        add(k, next + 3, k + 3);
      }
    }
  }
  output->SetPolys(faces);
}

void WriteTable(
  const std::vector<MesoPrism>& prisms, const MesoPrismShellInput& input, vtkPolyData* output)
{
  const MesoVector middle = MiddleOf(prisms);
  vtkNew<vtkFloatArray> table;
  table->SetName("MesoPrismTable");
  table->SetNumberOfComponents(4);
  table->SetNumberOfTuples(TableRows * static_cast<vtkIdType>(prisms.size()));
  vtkNew<vtkIdTypeArray> triangles;
  triangles->SetName("MesoPrismTriangle");
  vtkIdType next = 0;
  for (const MesoPrism& prism : prisms)
  {
    for (int k = 0; k < 3; ++k)
    {
      const MesoVector place = MesoDifference(prism.Bottom[k], middle);
      table->SetTuple4(next++, place[0], place[1], place[2], input.Coordinates[prism.Points[k]][0]);
    }
    for (int k = 0; k < 3; ++k)
    {
      const MesoVector& rise = prism.Rise[k];
      table->SetTuple4(next++, rise[0], rise[1], rise[2], input.Coordinates[prism.Points[k]][1]);
    }
    const auto& beyond = prism.Beyond;
    table->SetTuple4(next++, prism.Flags(), static_cast<double>(beyond[0]),
      static_cast<double>(beyond[1]), static_cast<double>(beyond[2]));
    triangles->InsertNextValue(static_cast<vtkIdType>(prism.Triangle));
  }
  vtkNew<vtkDoubleArray> centre;
  centre->SetName("MesoPrismCentre");
  centre->SetNumberOfComponents(3);
  centre->InsertNextTuple(middle.data());
  for (vtkDataArray* array : { static_cast<vtkDataArray*>(table),
         static_cast<vtkDataArray*>(centre), static_cast<vtkDataArray*>(triangles) })
  {
    output->GetFieldData()->AddArray(array);
  }
}
}

int vtkMesoPrismShell::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  this->InvertedTriangles.clear();
  this->NumberOfDegenerateTriangles = 0;
  this->NumberOfOpenFins = 0;
  this->NumberOfSeamFins = 0;
  this->LeastRise = 1.;
  this->ErrorMessage =
    MesoFitFailure("prisms", [&] { this->Execute(vtkPolyData::GetData(inputVector[0]), output); });
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
    // Returning 0 would make the executive add an error of several lines that says nothing more.
  }
  return 1;
}

void vtkMesoPrismShell::Execute(vtkPolyData* input, vtkPolyData* output)
{
  if (!(this->Thickness > 0.) || !std::isfinite(this->Thickness))
  {
    throw std::invalid_argument("Thickness must be more than 0 and finite");
  }
  if (!(this->Tiles[0] > 0. && this->Tiles[1] > 0.))
  {
    throw std::invalid_argument("Tiles must be more than 0");
  }
  if (input->GetNumberOfPoints() == 0 ||
    input->GetNumberOfPolys() + input->GetNumberOfStrips() == 0)
  {
    return;
  }
  MesoPrismShellInput source;
  MesoFitInput read = MesoReadFitInput(input);
  if (read.Mesh.Triangles.size() > MostPrisms)
  {
    throw std::invalid_argument("the mesh has more than 2^24 triangles");
  }
  source.Coordinates = MesoTuples<2>(MesoFindTextureCoordinates(input), "the texture coordinate");
  source.Mesh = std::move(read.Mesh);
  source.Normals = std::move(read.Normals);
  source.Tiles = { this->Tiles[0], this->Tiles[1] };
  source.Thickness = this->Thickness;
  source.Reference = this->Reference;
  source.Clamp = this->ClampThickness;
  this->UpdateProgress(0.2);
  const MesoPrismShell shell = MesoMakePrismShell(source);
  this->UpdateProgress(0.6);
  this->InvertedTriangles.assign(shell.Inverted.begin(), shell.Inverted.end());
  this->NumberOfDegenerateTriangles = shell.DegenerateTriangles;
  this->NumberOfOpenFins = shell.OpenFins;
  this->NumberOfSeamFins = shell.SeamFins;
  this->LeastRise = shell.LeastRise;
  if (shell.Prisms.empty() || this->GetAbortExecute())
  {
    return;
  }
  WritePoints(
    shell.Prisms, source, HeightsOf(this->Slices), input->GetPoints()->GetDataType(), output);
  if (this->Slices > 0)
  {
    WriteSlices(shell.Prisms, this->Slices, output);
  }
  else
  {
    WriteFaces(shell.Prisms, this->InnerFins, output);
  }
  WriteTable(shell.Prisms, source, output);
}

void vtkMesoPrismShell::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thickness: " << this->Thickness << "\n";
  os << indent << "Reference: " << this->Reference << "\n";
  os << indent << "Tiles: " << this->Tiles[0] << " " << this->Tiles[1] << "\n";
  os << indent << "Slices: " << this->Slices << "\n";
  os << indent << "InnerFins: " << this->InnerFins << "\n";
  os << indent << "ClampThickness: " << this->ClampThickness << "\n";
  os << indent << "InvertedTriangles: " << this->InvertedTriangles.size() << "\n";
  os << indent << "NumberOfDegenerateTriangles: " << this->NumberOfDegenerateTriangles << "\n";
  os << indent << "NumberOfOpenFins: " << this->NumberOfOpenFins << "\n";
  os << indent << "NumberOfSeamFins: " << this->NumberOfSeamFins << "\n";
  os << indent << "LeastRise: " << this->LeastRise << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
