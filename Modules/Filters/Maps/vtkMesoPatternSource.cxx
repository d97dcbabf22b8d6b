#include "vtkMesoPatternSource.h"

#include "MesoPattern.h"

#include "vtkDataObject.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

vtkStandardNewMacro(vtkMesoPatternSource);

namespace
{
// Rows made between two reports of progress: enough work to make the report cheap.
constexpr int RowsAtOnce = 64;

std::string SizeProblem(const int size[2])
{
  if (std::min(size[0], size[1]) >= 1 && std::max(size[0], size[1]) <= MesoPatternMaximumSize)
  {
    return {};
  }
  return "size " + std::to_string(size[0]) + " x " + std::to_string(size[1]) +
    ", allowed are 1 to " + std::to_string(MesoPatternMaximumSize) + " a side";
}
}

vtkMesoPatternSource::vtkMesoPatternSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkMesoPatternSource::SetPattern(const char* pattern)
{
  const std::string name = pattern ? pattern : "";
  if (this->Pattern != name)
  {
    this->Pattern = name;
    this->Modified();
  }
}

void vtkMesoPatternSource::SetParameter(const std::string& key, double value)
{
  const auto found = this->Parameters.find(key);
  if (found == this->Parameters.end() || found->second != value)
  {
    this->Parameters[key] = value;
    this->Modified();
  }
}

void vtkMesoPatternSource::ClearParameters()
{
  if (!this->Parameters.empty())
  {
    this->Parameters.clear();
    this->Modified();
  }
}

int vtkMesoPatternSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  this->ErrorMessage = MesoPatternProblem(this->Pattern, this->Parameters);
  if (this->ErrorMessage.empty())
  {
    this->ErrorMessage = SizeProblem(this->Size);
  }
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (this->ErrorMessage.empty())
  {
    extent[1] = this->Size[0] - 1;
    extent[3] = this->Size[1] - 1;
    extent[5] = 0;
  }
  else
  {
    vtkErrorMacro(<< this->ErrorMessage);
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  const double origin[3] = { 0., 0., 0. };
  const double spacing[3] = { 1., 1., 1. };
  information->Set(vtkDataObject::ORIGIN(), origin, 3);
  information->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkMesoPatternSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!this->ErrorMessage.empty())
  {
    return 1; // said by RequestInformation
  }
  const MesoPattern pattern(this->Pattern, this->Seed, this->Parameters);
  output->SetDimensions(this->Size[0], this->Size[1], 1);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Height");
  heights->SetNumberOfValues(vtkIdType(this->Size[0]) * this->Size[1]);
  for (int first = 0; first < this->Size[1]; first += RowsAtOnce)
  {
    const int last = std::min(first + RowsAtOnce, this->Size[1]);
    pattern.Rows({ this->Size[0], this->Size[1] }, first, last,
      heights->GetPointer(vtkIdType(first) * this->Size[0]));
    this->UpdateProgress(static_cast<double>(last) / this->Size[1]);
  }
  output->GetPointData()->SetScalars(heights);
  return 1;
}

void vtkMesoPatternSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pattern: " << this->Pattern << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  for (const auto& [key, value] : this->Parameters)
  {
    os << indent << "Parameter " << key << ": " << value << "\n";
  }
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
