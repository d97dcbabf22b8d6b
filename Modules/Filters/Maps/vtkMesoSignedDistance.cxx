#include "vtkMesoSignedDistance.h"

#include "MesoDistanceTransform.h"
#include "MesoVolumePattern.h" // for MesoVolumeMaximumSize
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <utility>

vtkStandardNewMacro(vtkMesoSignedDistance);

namespace
{
std::string Problem(vtkImageData* input)
{
  vtkDataArray* numbers = input->GetPointData()->GetScalars();
  if (!numbers || input->GetNumberOfPoints() == 0)
  {
    return "the volume is empty";
  }
  int size[3];
  input->GetDimensions(size);
  if (*std::max_element(size, size + 3) > MesoVolumeMaximumSize)
  {
    return "a volume of " + std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " +
      std::to_string(size[2]) + " voxels; allowed are " + std::to_string(MesoVolumeMaximumSize) +
      " a side: resample it";
  }
  return {};
}
}

void vtkMesoSignedDistance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Threshold: " << this->Threshold << "\n";
  os << indent << "SolidBelow: " << this->SolidBelow << "\n";
  os << indent << "Depth: " << this->Depth << "\n";
}

int vtkMesoSignedDistance::RequestInformation(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataObject::SetPointDataActiveScalarInfo(outputVector->GetInformationObject(0), VTK_FLOAT, 1);
  return this->Superclass::RequestInformation(request, inputVector, outputVector);
}

int vtkMesoSignedDistance::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  const std::string problem = Problem(input);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }
  std::array<int, 3> size{};
  input->GetDimensions(size.data());
  double depth = this->Depth;
  if (depth == 0.)
  {
    const double* spacing = input->GetSpacing();
    depth = std::abs(spacing[2] * size[2] / (spacing[0] * size[0]));
  }
  if (!(depth > 0.) || !std::isfinite(depth))
  {
    vtkErrorMacro("the image's spacing gives the volume no depth; set Depth");
    return 1;
  }
  vtkDataArray* numbers = input->GetPointData()->GetScalars();
  std::vector<float> values(static_cast<std::size_t>(numbers->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double above = numbers->GetComponent(static_cast<vtkIdType>(i), 0) - this->Threshold;
    if (!std::isfinite(above))
    {
      vtkErrorMacro("the volume holds numbers that are not finite");
      return 1;
    }
    const bool isSolid = this->SolidBelow ? above < 0. : above >= 0.;
    // A number that is just the threshold counts as solid, and so must its sign.
    values[i] = static_cast<float>(isSolid ? -std::max(std::abs(above), 1e-30) : std::abs(above));
  }
  const auto volume = MesoCanonicalVolume(MesoVolumeField(size, depth, std::move(values)), this);
  if (volume)
  {
    output->ShallowCopy(volume);
  }
  return 1;
}
