#include "vtkMesoPatternSource.h"

#include "MesoPattern.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"

#include <algorithm>

vtkStandardNewMacro(vtkMesoPatternSource);

namespace
{
// Rows made between two reports of progress: enough work to make the report cheap.
constexpr int RowsAtOnce = 64;
}

vtkMesoPatternSource::vtkMesoPatternSource()
  : vtkMesoBuiltInSource("brick")
{
}

std::string vtkMesoPatternSource::Problem() const
{
  const std::string problem = MesoPatternProblem(this->GetPattern(), this->GetParameters());
  if (!problem.empty())
  {
    return problem;
  }
  const auto [least, most] = std::minmax(this->Size[0], this->Size[1]);
  if (least < 1 || most > MesoPatternMaximumSize)
  {
    return "size " + std::to_string(this->Size[0]) + " x " + std::to_string(this->Size[1]) +
      ", allowed are 1 to " + std::to_string(MesoPatternMaximumSize) + " a side";
  }
  return {};
}

std::array<int, 3> vtkMesoPatternSource::SamplesAlong() const
{
  return { this->Size[0], this->Size[1], 1 };
}

int vtkMesoPatternSource::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  if (!this->GetErrorMessage().empty())
  {
    return 1; // said by RequestInformation
  }
  const MesoPattern pattern(this->GetPattern(), this->GetSeed(), this->GetParameters());
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
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
}
