#include "vtkMesoBaseImage.h"

#include "MesoBaseImage.h"
#include "MesoPolyDataInput.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkMesoBaseImage);

namespace
{
constexpr int LeastSize = 16;
constexpr int GreatestSize = 8192;
constexpr double TexelsPerTriangle = 8.;

MesoBaseImageInput ReadMesh(vtkPolyData* mesh)
{
  MesoCheckCells(mesh->GetPolys(), "polygon", mesh->GetNumberOfPoints());
  MesoCheckCells(mesh->GetStrips(), "strip", mesh->GetNumberOfPoints());
  vtkDataArray* normals = MesoFindNormals(mesh);
  if (!normals)
  {
    throw std::invalid_argument("the mesh has no point normals");
  }
  MesoBaseImageInput input;
  input.Coordinates = MesoTuples<2>(MesoFindTextureCoordinates(mesh), "the texture coordinate");
  input.Normals = MesoTuples<3>(normals, "the normal");
  if (mesh->GetPoints())
  {
    input.Positions = MesoTuples<3>(mesh->GetPoints()->GetData(), "the position");
  }
  input.Triangles = MesoTrianglesOf(MesoTriangulated(mesh)->GetPolys());
  return input;
}

vtkSmartPointer<vtkFloatArray> FourComponents(
  const char* name, const std::vector<MesoVector>& vectors)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(4);
  array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
  float* value = array->GetPointer(0);
  for (const MesoVector& vector : vectors)
  {
    for (int k = 0; k < 4; ++k)
    {
      *value++ = k < 3 ? static_cast<float>(vector[k]) : 0.f;
    }
  }
  return array;
}

template <std::size_t N>
void AddField(vtkImageData* image, const char* name, const std::array<double, N>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(N));
  array->InsertNextTuple(values.data());
  image->GetFieldData()->AddArray(array);
}
}

void vtkMesoBaseImage::SetSize(int width, int height)
{
  const int size[2] = { std::clamp(width, LeastSize, GreatestSize),
    std::clamp(height, LeastSize, GreatestSize) };
  if (!std::equal(size, size + 2, this->Size))
  {
    std::copy_n(size, 2, this->Size);
    this->Modified();
  }
}

void vtkMesoBaseImage::SetSizeFor(vtkPolyData* mesh, int most)
{
  try
  {
    const std::array<int, 2> size = MesoBaseImageSize(ReadMesh(mesh), TexelsPerTriangle, most);
    this->SetSize(size[0], size[1]);
  }
  catch (const std::invalid_argument&)
  {
    return; // the update will say it
  }
}

int vtkMesoBaseImage::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkMesoBaseImage::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  outputVector->GetInformationObject(0)->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), 0,
    this->Size[0] - 1, 0, this->Size[1] - 1, 0, 0);
  return 1;
}

int vtkMesoBaseImage::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  this->NumberOfInsideTexels = 0;
  this->NumberOfAmbiguousTexels = 0;
  this->ErrorMessage.clear();
  try
  {
    this->Compute(vtkPolyData::GetData(inputVector[0]), output);
  }
  catch (const std::invalid_argument& error)
  {
    this->ErrorMessage = error.what();
  }
  catch (const std::bad_alloc&)
  {
    this->ErrorMessage = "there is not enough memory for an image of this mesh";
  }
  if (!this->ErrorMessage.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< this->ErrorMessage);
  }
  return 1;
}

void vtkMesoBaseImage::Compute(vtkPolyData* input, vtkImageData* output)
{
  const MesoBaseImage image = MesoMakeBaseImage(ReadMesh(input), { this->Size[0], this->Size[1] });
  this->UpdateProgress(0.8);
  this->NumberOfInsideTexels = image.NumberOfInside;
  this->NumberOfAmbiguousTexels = image.NumberOfAmbiguous;
  output->SetDimensions(image.Size[0], image.Size[1], 1);
  auto positions = FourComponents("MesoBasePosition", image.Positions);
  for (std::size_t i = 0; i < image.Kinds.size(); ++i)
  {
    const float kind = 0.5f * static_cast<float>(image.Kinds[i]);
    positions->SetComponent(static_cast<vtkIdType>(i), 3, kind);
  }
  output->GetPointData()->SetScalars(positions);
  output->GetPointData()->AddArray(FourComponents("MesoBaseNormal", image.Normals));
  AddField<3>(output, "MesoBaseCentre", image.Centre);
  AddField<2>(output, "MesoBaseScale", image.Scale);
  AddField<2>(output, "MesoBaseOffset", image.Offset);
  AddField<2>(output, "MesoBaseWraps", { image.Wraps[0] ? 1. : 0., image.Wraps[1] ? 1. : 0. });
}

void vtkMesoBaseImage::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Size: " << this->Size[0] << " x " << this->Size[1] << "\n";
  os << indent << "NumberOfInsideTexels: " << this->NumberOfInsideTexels << "\n";
  os << indent << "NumberOfAmbiguousTexels: " << this->NumberOfAmbiguousTexels << "\n";
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
