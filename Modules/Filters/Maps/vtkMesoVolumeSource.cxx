#include "vtkMesoVolumeSource.h"

#include "MesoDistanceTransform.h"
#include "MesoVolume.h"
#include "MesoVolumePattern.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <utility>

vtkStandardNewMacro(vtkMesoVolumeSource);

vtkMesoVolumeSource::vtkMesoVolumeSource()
  : vtkMesoBuiltInSource("weave")
{
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
  return MesoVolumePatternProblem(this->GetPattern(), this->GetParameters());
}

std::array<int, 3> vtkMesoVolumeSource::SamplesAlong() const
{
  return { this->Size[0], this->Size[1], this->Size[2] };
}

int vtkMesoVolumeSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!this->GetErrorMessage().empty())
  {
    return 1; // said by RequestInformation
  }
  const MesoVolumePattern pattern(this->GetPattern(), this->GetSeed(), this->GetParameters());
  const std::array<int, 3> size = this->SamplesAlong();
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
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << " " << this->Size[2] << "\n";
}
