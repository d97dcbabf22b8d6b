#include "vtkMesoBuiltInSource.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkStreamingDemandDrivenPipeline.h"

vtkMesoBuiltInSource::vtkMesoBuiltInSource(const char* pattern)
  : Pattern(pattern)
{
  this->SetNumberOfInputPorts(0);
}

void vtkMesoBuiltInSource::SetPattern(const char* pattern)
{
  const std::string name = pattern ? pattern : "";
  if (this->Pattern != name)
  {
    this->Pattern = name;
    this->Modified();
  }
}

void vtkMesoBuiltInSource::SetParameter(const std::string& key, double value)
{
  const auto found = this->Parameters.find(key);
  if (found == this->Parameters.end() || found->second != value)
  {
    this->Parameters[key] = value;
    this->Modified();
  }
}

void vtkMesoBuiltInSource::ClearParameters()
{
  if (!this->Parameters.empty())
  {
    this->Parameters.clear();
    this->Modified();
  }
}

int vtkMesoBuiltInSource::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  this->ErrorMessage = this->Problem();
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  if (this->ErrorMessage.empty())
  {
    const auto samples = this->SamplesAlong();
    for (int axis = 0; axis < 3; ++axis)
    {
      extent[2 * axis + 1] = samples[axis] - 1;
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

void vtkMesoBuiltInSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pattern: " << this->Pattern << "\n";
  os << indent << "Seed: " << this->Seed << "\n";
  for (const auto& [key, value] : this->Parameters)
  {
    os << indent << "Parameter " << key << ": " << value << "\n";
  }
  os << indent << "ErrorMessage: " << this->ErrorMessage << "\n";
}
