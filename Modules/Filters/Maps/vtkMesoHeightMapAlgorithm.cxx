#include "vtkMesoHeightMapAlgorithm.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <string>

namespace
{
/// The reason why an image is no height map, or an empty text.
std::string Problem(vtkImageData* image)
{
  int size[3];
  image->GetDimensions(size);
  auto* heights = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  if (size[0] < 1 || size[1] < 1 || size[2] != 1 || !heights ||
    heights->GetNumberOfComponents() != 1)
  {
    return "The input is no height map: a plane image with one component of float";
  }
  for (vtkIdType i = 0; i < heights->GetNumberOfTuples(); ++i)
  {
    const float height = heights->GetValue(i);
    if (!(height >= 0.f && height <= 1.f))
    {
      return "The height of texel (" + std::to_string(i % size[0]) + ", " +
        std::to_string(i / size[0]) + ") is " + std::to_string(height) + ", not in [0,1]";
    }
  }
  return {};
}
}

void vtkMesoHeightMapAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Wrap: " << MesoName(this->Wrap) << "\n";
}

int vtkMesoHeightMapAlgorithm::RequestData(
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
  int size[3];
  input->GetDimensions(size);
  auto* heights = static_cast<vtkFloatArray*>(input->GetPointData()->GetScalars());
  const float* first = heights->GetPointer(0);
  Map map = { size[0], size[1], { first, first + heights->GetNumberOfValues() } };
  output->CopyStructure(input);
  this->Compute(map, output);
  if (this->GetAbortExecute())
  {
    output->Initialize();
  }
  return 1;
}

bool vtkMesoHeightMapAlgorithm::ForRows(
  int count, const std::function<void(int, int)>& work, double done, double all)
{
  constexpr int Bands = 50; // progress is told this often
  const int band = std::max(1, (count + Bands - 1) / Bands);
  for (int first = 0; first < count && !this->GetAbortExecute(); first += band)
  {
    const int end = std::min(count, first + band);
    vtkSMPTools::For(first, end,
      [&](vtkIdType begin, vtkIdType stop)
      { work(static_cast<int>(begin), static_cast<int>(stop)); });
    this->UpdateProgress(done + all * end / count);
  }
  return this->GetAbortExecute() == 0;
}
