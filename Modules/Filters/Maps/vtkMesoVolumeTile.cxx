#include "vtkMesoVolumeTile.h"

#include "MesoWholeImage.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMesoVolumeTile);

namespace
{
/// Samples, x fastest, that can be made anew along one axis after another.
struct Grid
{
  std::array<int, 3> Size;
  std::vector<float> Samples;
};

/// Of a sample along an axis: which of the old ones it is the weighted mean of.
struct Mean
{
  std::vector<std::pair<int, float>> Parts;
};

Grid AlongAxis(const Grid& grid, int axis, const std::vector<Mean>& means)
{
  Grid made = grid;
  made.Size[axis] = static_cast<int>(means.size());
  made.Samples.resize(
    std::size_t(made.Size[0]) * std::size_t(made.Size[1]) * std::size_t(made.Size[2]));
  const auto strideOf = [axis](const Grid& g)
  {
    return axis == 0 ? std::size_t(1)
      : axis == 1    ? std::size_t(g.Size[0])
                     : std::size_t(g.Size[0]) * std::size_t(g.Size[1]);
  };
  const std::size_t stride = strideOf(grid); // the same in both: it is of the axes before
  const std::size_t lines = made.Samples.size() / means.size();
  vtkSMPTools::For(0, static_cast<vtkIdType>(lines),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto line = static_cast<std::size_t>(begin); line < static_cast<std::size_t>(end);
           ++line)
      {
        const std::size_t inner = line % stride;
        const std::size_t outer = line / stride;
        const float* from = grid.Samples.data() + outer * stride * grid.Size[axis] + inner;
        float* to = made.Samples.data() + outer * stride * made.Size[axis] + inner;
        for (std::size_t i = 0; i < means.size(); ++i)
        {
          float sum = 0.f;
          for (const auto& [place, weight] : means[i].Parts)
          {
            sum += weight * from[std::size_t(place) * stride];
          }
          to[i * stride] = sum;
        }
      }
    });
  return made;
}

/// The last `faded` samples faded into the first.
std::vector<Mean> Faded(int count, int faded)
{
  std::vector<Mean> means(static_cast<std::size_t>(count - faded));
  for (int i = 0; i < count - faded; ++i)
  {
    if (i < faded)
    {
      const float weight = (static_cast<float>(i) + 0.5f) / static_cast<float>(faded);
      means[i].Parts = { { i, weight }, { count - faded + i, 1.f - weight } };
    }
    else
    {
      means[i].Parts = { { i, 1.f } };
    }
  }
  return means;
}

std::vector<Mean> Resampled(int count, int wanted, bool repeats)
{
  std::vector<Mean> means(static_cast<std::size_t>(wanted));
  const double ratio = double(count) / wanted;
  const double reach = std::max(1., ratio); // half the tent's width, in old samples
  for (int i = 0; i < wanted; ++i)
  {
    const double middle = (i + 0.5) * ratio - 0.5;
    double sum = 0.;
    std::vector<std::pair<int, double>> parts;
    for (auto place = static_cast<int>(std::ceil(middle - reach));
         place <= static_cast<int>(std::floor(middle + reach)); ++place)
    {
      const double weight = 1. - std::abs(place - middle) / reach;
      if (weight > 0.)
      {
        const int inside =
          repeats ? (place % count + count) % count : std::clamp(place, 0, count - 1);
        parts.emplace_back(inside, weight);
        sum += weight;
      }
    }
    for (const auto& [place, weight] : parts)
    {
      means[i].Parts.emplace_back(place, static_cast<float>(weight / sum));
    }
  }
  return means;
}
}

void vtkMesoVolumeTile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Crop:";
  for (const int side : this->Crop)
  {
    os << " " << side;
  }
  os << "\n" << indent << "Blend: " << this->Blend << "\n";
  os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << " " << this->Size[2] << "\n";
}

int vtkMesoVolumeTile::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int extent[6];
  MesoGetWholeExtent(inputVector[0]->GetInformationObject(0), extent);
  for (int axis = 0; axis < 3; ++axis)
  {
    const int end = this->Crop[2 * axis + 1];
    const int whole = extent[2 * axis + 1] - extent[2 * axis] + 1;
    const int count = end > 0 ? end - this->Crop[2 * axis] : whole;
    const int kept = count - (axis < 2 ? this->FadedOf(count) : 0);
    extent[2 * axis] = 0;
    extent[2 * axis + 1] = (this->Size[axis] > 0 ? this->Size[axis] : kept) - 1;
  }
  vtkInformation* information = outputVector->GetInformationObject(0);
  information->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  vtkDataObject::SetPointDataActiveScalarInfo(information, VTK_FLOAT, 1);
  return 1;
}

int vtkMesoVolumeTile::FadedOf(int count) const
{
  return std::min(static_cast<int>(std::lround(this->Blend * count)), count / 2);
}

int vtkMesoVolumeTile::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* input = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  vtkDataArray* numbers = input->GetPointData()->GetScalars();
  if (!numbers || input->GetNumberOfPoints() == 0)
  {
    vtkErrorMacro("the volume is empty");
    return 1;
  }
  int whole[3];
  input->GetDimensions(whole);
  std::array<int, 3> first{};
  Grid grid;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int end = this->Crop[2 * axis + 1];
    first[axis] = end > 0 ? this->Crop[2 * axis] : 0;
    grid.Size[axis] = (end > 0 ? end : whole[axis]) - first[axis];
    if (first[axis] < 0 || grid.Size[axis] < 1 || first[axis] + grid.Size[axis] > whole[axis])
    {
      vtkErrorMacro("samples " << first[axis] << " to " << end << " of axis " << axis
                               << " are not within the volume's " << whole[axis]);
      return 1;
    }
  }
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      const vtkIdType row =
        (vtkIdType(k + first[2]) * whole[1] + j + first[1]) * whole[0] + first[0];
      for (int i = 0; i < grid.Size[0]; ++i)
      {
        grid.Samples.push_back(static_cast<float>(numbers->GetComponent(row + i, 0)));
      }
    }
  }
  double extent[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const int faded = axis < 2 ? this->FadedOf(grid.Size[axis]) : 0;
    grid = faded > 0 ? AlongAxis(grid, axis, Faded(grid.Size[axis], faded)) : grid;
    extent[axis] = input->GetSpacing()[axis] * grid.Size[axis];
    if (this->Size[axis] > 0 && this->Size[axis] != grid.Size[axis])
    {
      grid = AlongAxis(grid, axis, Resampled(grid.Size[axis], this->Size[axis], axis < 2));
    }
  }
  output->SetDimensions(grid.Size.data());
  output->SetSpacing(extent[0] / grid.Size[0], extent[1] / grid.Size[1], extent[2] / grid.Size[2]);
  vtkNew<vtkFloatArray> samples;
  samples->SetName("Number");
  samples->SetNumberOfValues(output->GetNumberOfPoints());
  std::copy(grid.Samples.begin(), grid.Samples.end(), samples->GetPointer(0));
  output->GetPointData()->SetScalars(samples);
  return 1;
}
