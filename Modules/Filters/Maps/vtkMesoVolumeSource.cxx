#include "vtkMesoVolumeSource.h"

#include "MesoDistanceTransform.h"
#include "MesoVolume.h"
#include "MesoVolumePattern.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkMesoVolumeSource);

vtkMesoVolumeSource::vtkMesoVolumeSource()
{
  this->SetNumberOfInputPorts(0);
}

void vtkMesoVolumeSource::SetPattern(const char* pattern)
{
  const std::string name = pattern ? pattern : "";
  if (this->Pattern != name)
  {
    this->Pattern = name;
    this->Modified();
  }
}

void vtkMesoVolumeSource::SetParameter(const std::string& key, double value)
{
  const auto found = this->Parameters.find(key);
  if (found == this->Parameters.end() || found->second != value)
  {
    this->Parameters[key] = value;
    this->Modified();
  }
}

void vtkMesoVolumeSource::ClearParameters()
{
  if (!this->Parameters.empty())
  {
    this->Parameters.clear();
    this->Modified();
  }
}

std::string vtkMesoVolumeSource::Problem() const
{
  const auto [least, most] = std::minmax({ this->Size[0], this->Size[1], this->Size[2] });
  if (least < 2 || most > MesoVolumeMaximumSize)
  {
    return "size " + std::to_string(this->Size[0]) + " x " + std::to_string(this->Size[1]) + " x " +
      std::to_string(this->Size[2]) + ", allowed are 2 to " +
      std::to_string(MesoVolumeMaximumSize) + " a side";
  }
  return MesoVolumePatternProblem(this->Pattern, this->Parameters);
}

int vtkMesoVolumeSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  this->ErrorMessage = this->Problem();
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (this->ErrorMessage.empty())
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[2 * axis + 1] = this->Size[axis] - 1;
    }
  }
  else
  {
    vtkErrorMacro(<< this->ErrorMessage);
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkMesoVolumeSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!this->ErrorMessage.empty())
  {
    return 1; // said by RequestInformation
  }
  const MesoVolumePattern pattern(this->Pattern, this->Seed, this->Parameters);
  const std::array<int, 3> size = { this->Size[0], this->Size[1], this->Size[2] };
  std::vector<float> values(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]));
  pattern.Slices(size, 0, size[2], values.data());
  const auto volume =
    MesoCanonicalVolume(MesoVolumeField(size, pattern.GetDepth(), std::move(values)), this);
  if (volume)
  {
    output->ShallowCopy(volume);
  }
  return 1;
}

void vtkMesoVolumeSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pattern: " << this->Pattern << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << " " << this->Size[2] << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  for (const auto& [key, value] : this->Parameters)
  {
    os << indent << "Parameter " << key << ": " << value << "\n";
  }
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
