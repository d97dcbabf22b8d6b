#include "vtkMesoMapFromMesh.h"

#include "MesoMapFromMesh.h"
#include "MesoPushPull.h"

#include "vtkBoundingBox.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"

#include <limits>

vtkStandardNewMacro(vtkMesoMapFromMesh);

namespace
{
constexpr int LargestSide = 8192;

std::vector<MesoTexturePoint> CoordinatesOf(vtkPolyData* mesh)
{
  return MesoTuples<2>(MesoFindTextureCoordinates(mesh), "the texture coordinate");
}

MesoFitInput ReadMesh(vtkPolyData* mesh, const char* which)
{
  if (mesh->GetNumberOfPoints() == 0)
  {
    throw std::invalid_argument(std::string("the ") + which + " has no points");
  }
  MesoFitInput input = MesoReadFitInput(mesh);
  if (input.Mesh.Triangles.empty())
  {
    throw std::invalid_argument(std::string("the ") + which + " has no triangles");
  }
  return input;
}

/// A map that is filled where nothing was met.
class Map
{
public:
  Map(const std::string& name, int components, std::size_t texels)
    : Name(name)
    , Components(components)
    , Values(texels * components, 0.f)
  {
  }
  void Set(std::size_t texel, const double* tuple)
  {
    std::transform(tuple, tuple + this->Components, &this->Values[texel * this->Components],
      [](double value) { return static_cast<float>(value); });
  }
  void Fill(const std::vector<bool>& known, int width, int height)
  {
    MesoPushPull(this->Values, this->Components, known, width, height);
  }
  /// Filling shortens directions that are mixed.
  void MakeUnit()
  {
    for (std::size_t i = 0; i < this->Values.size(); i += 3)
    {
      const double length = std::hypot(this->Values[i], this->Values[i + 1], this->Values[i + 2]);
      for (int k = 0; k < 3; ++k)
      {
        this->Values[i + k] =
          length > 0. ? static_cast<float>(this->Values[i + k] / length) : (k == 2 ? 1.f : 0.f);
      }
    }
  }
  vtkSmartPointer<vtkFloatArray> ToArray() const
  {
    auto array = vtkSmartPointer<vtkFloatArray>::New();
    array->SetName(this->Name.c_str());
    array->SetNumberOfComponents(this->Components);
    array->SetNumberOfTuples(static_cast<vtkIdType>(this->Values.size() / this->Components));
    std::copy(this->Values.begin(), this->Values.end(), array->GetPointer(0));
    return array;
  }

private:
  std::string Name;
  int Components;
  std::vector<float> Values;
};

vtkDataArray* FindDetailArray(vtkPolyData* detail, const std::string& name)
{
  vtkDataArray* array = detail->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfTuples() != detail->GetNumberOfPoints())
  {
    throw std::invalid_argument("the detail has no point array of numbers named " + name);
  }
  return array;
}
}

vtkMesoMapFromMesh::vtkMesoMapFromMesh()
{
  this->SetNumberOfInputPorts(2);
}

void vtkMesoMapFromMesh::SetDetailData(vtkPolyData* detail)
{
  this->SetInputDataObject(1, detail);
}

void vtkMesoMapFromMesh::SetDetailConnection(vtkAlgorithmOutput* detail)
{
  this->SetInputConnection(1, detail);
}

void vtkMesoMapFromMesh::AddDetailArray(const std::string& name)
{
  if (this->DetailArrays.insert(name).second)
  {
    this->Modified();
  }
}

void vtkMesoMapFromMesh::ClearDetailArrays()
{
  if (!this->DetailArrays.empty())
  {
    this->DetailArrays.clear();
    this->Modified();
  }
}

int vtkMesoMapFromMesh::FillInputPortInformation(int, vtkInformation* information)
{
  information->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkMesoMapFromMesh::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* information = outputVector->GetInformationObject(0);
  const int extent[6] = { 0, this->Size[0] - 1, 0, this->Size[1] - 1, 0, 0 };
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkMesoMapFromMesh::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // vtkImageAlgorithm would ask the meshes for an extent
}

int vtkMesoMapFromMesh::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  this->NumberOfMetTexels = 0;
  this->NumberOfVoidTexels = 0;
  this->NumberOfFoldTexels = 0;
  this->NumberOfOverlappingTexels = 0;
  this->DisplacementRange[0] = this->DisplacementRange[1] = 0.;
  this->LargestDrift = 0.;
  const std::string problem = MesoFitFailure("maps",
    [&]
    {
      this->MakeMaps(
        vtkPolyData::GetData(inputVector[0]), vtkPolyData::GetData(inputVector[1]), output);
    });
  if (!problem.empty() || this->GetAbortExecute())
  {
    output->Initialize();
  }
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
  }
  return 1;
}

void vtkMesoMapFromMesh::MakeMaps(vtkPolyData* base, vtkPolyData* detail, vtkImageData* output)
{
  const auto isSide = [](int side) { return side >= 1 && side <= LargestSide; };
  if (!isSide(this->Size[0]) || !isSide(this->Size[1]))
  {
    throw std::invalid_argument("a map of " + std::to_string(this->Size[0]) + " x " +
      std::to_string(this->Size[1]) + " texels cannot be made (1 to " +
      std::to_string(LargestSide) + " a side)");
  }
  const auto baseCoordinates = CoordinatesOf(base);
  const MesoFitInput baseMesh = ReadMesh(base, "base");
  const MesoFitInput detailMesh = ReadMesh(detail, "detail");
  MesoMapFromMesh::Options options;
  options.Width = this->Size[0];
  options.Height = this->Size[1];
  options.ByTexture = this->Correspondence == Texture;
  options.GeometricNormals = this->GeometricNormals;
  options.SlopeLimit = this->SlopeLimit;
  options.Reach =
    this->Reach > 0. ? this->Reach : 0.1 * vtkBoundingBox(detail->GetBounds()).GetDiagonalLength();
  const auto detailCoordinates =
    options.ByTexture ? CoordinatesOf(detail) : std::vector<MesoTexturePoint>();
  const MesoMapFromMesh finder(baseMesh, baseCoordinates, detailMesh, detailCoordinates, options);
  this->NumberOfOverlappingTexels = finder.Cover().Overlapping;

  const std::size_t count = std::size_t(options.Width) * std::size_t(options.Height);
  std::vector<MesoMapFromMesh::Texel> texels(count);
  constexpr int Bands = 20;
  for (int band = 0; band < Bands && !this->GetAbortExecute(); ++band)
  {
    this->UpdateProgress(0.1 + 0.7 * band / Bands);
    vtkSMPTools::For(static_cast<vtkIdType>(count * band / Bands),
      static_cast<vtkIdType>(count * (band + 1) / Bands),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType texel = first; texel < last; ++texel)
        {
          texels[texel] = finder.Look(texel);
        }
      });
  }

  Map displacement("Displacement", 1, count);
  Map normalObject("NormalObject", 3, count);
  Map normal("Normal", 3, count);
  std::vector<Map> others;
  std::vector<vtkDataArray*> otherArrays;
  for (const std::string& name : this->DetailArrays)
  {
    otherArrays.push_back(FindDetailArray(detail, name));
    others.emplace_back(name, otherArrays.back()->GetNumberOfComponents(), count);
  }
  vtkNew<vtkUnsignedCharArray> states;
  states->SetName("State");
  states->SetNumberOfValues(static_cast<vtkIdType>(count));
  std::vector<bool> known(count, false);
  double range[2] = { std::numeric_limits<double>::infinity(),
    -std::numeric_limits<double>::infinity() };
  std::vector<double> tuple;
  for (std::size_t i = 0; i < count; ++i)
  {
    MesoMapFromMesh::Texel& texel = texels[i];
    for (const std::size_t other : { i + 1, i + options.Width })
    {
      const bool isNeighbour = other < count && (other != i + 1 || other % options.Width != 0);
      if (isNeighbour && finder.Jumps(texel, texels[other]))
      {
        texel.Found = MesoMapFromMesh::Fold;
        texels[other].Found = MesoMapFromMesh::Fold;
      }
    }
    states->SetValue(static_cast<vtkIdType>(i), texel.Found);
    this->NumberOfVoidTexels += texel.Found == MesoMapFromMesh::Void ? 1 : 0;
    if (texel.Triangle < 0)
    {
      continue;
    }
    known[i] = true;
    ++this->NumberOfMetTexels;
    this->NumberOfFoldTexels += texel.Found == MesoMapFromMesh::Fold ? 1 : 0;
    range[0] = std::min(range[0], texel.Displacement);
    range[1] = std::max(range[1], texel.Displacement);
    this->LargestDrift = std::max(this->LargestDrift, texel.Drift);
    displacement.Set(i, &texel.Displacement);
    normalObject.Set(i, texel.NormalObject.data());
    normal.Set(i, texel.Normal.data());
    for (std::size_t k = 0; k < others.size(); ++k)
    {
      tuple.assign(otherArrays[k]->GetNumberOfComponents(), 0.);
      for (int corner = 0; corner < 3; ++corner)
      {
        const auto point = detailMesh.Mesh.Triangles[texel.Triangle][corner];
        for (std::size_t component = 0; component < tuple.size(); ++component)
        {
          tuple[component] += texel.Weights[corner] *
            otherArrays[k]->GetComponent(point, static_cast<int>(component));
        }
      }
      others[k].Set(i, tuple.data());
    }
  }
  if (this->NumberOfMetTexels == 0)
  {
    throw std::invalid_argument(
      "nothing of the base meets the detail within a reach of " + std::to_string(options.Reach));
  }
  std::copy_n(range, 2, this->DisplacementRange);
  this->UpdateProgress(0.85);

  output->SetDimensions(options.Width, options.Height, 1);
  vtkPointData* data = output->GetPointData();
  displacement.Fill(known, options.Width, options.Height);
  data->SetScalars(displacement.ToArray());
  for (Map* directions : { &normalObject, &normal })
  {
    directions->Fill(known, options.Width, options.Height);
    directions->MakeUnit();
    data->AddArray(directions->ToArray());
  }
  for (Map& other : others)
  {
    other.Fill(known, options.Width, options.Height);
    data->AddArray(other.ToArray());
  }
  data->AddArray(states);
}

void vtkMesoMapFromMesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "Correspondence: " << (this->Correspondence == Rays ? "Rays" : "Texture") << "\n";
  os << indent << "GeometricNormals: " << (this->GeometricNormals ? "On" : "Off") << "\n";
  os << indent << "SlopeLimit: " << this->SlopeLimit << "\n";
  os << indent << "DetailArrays:";
  for (const std::string& name : this->DetailArrays)
  {
    os << " " << name;
  }
  os << "\n";
  os << indent << "NumberOfMetTexels: " << this->NumberOfMetTexels << "\n";
  os << indent << "NumberOfVoidTexels: " << this->NumberOfVoidTexels << "\n";
  os << indent << "NumberOfFoldTexels: " << this->NumberOfFoldTexels << "\n";
  os << indent << "NumberOfOverlappingTexels: " << this->NumberOfOverlappingTexels << "\n";
  os << indent << "DisplacementRange: " << this->DisplacementRange[0] << " "
     << this->DisplacementRange[1] << "\n";
  os << indent << "LargestDrift: " << this->LargestDrift << "\n";
}
