#include "vtkMesoVDM.h"

#include "MesoVDMImage.h"
#include "MesoVDMRays.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkMesoVDM);

namespace
{
/// The part of the whole progress that baking is, before the factors are found.
constexpr double BakingPart = 0.5;

/// One axis of a map that repeats, from `from` to `to` samples at the centres of even parts: each the mean
/// over its part of the linear interpolation, or a value of it where samples grow in number.
std::vector<float> ResampledRow(const std::vector<float>& values, int to)
{
  const int from = static_cast<int>(values.size());
  std::vector<float> result(to);
  const double step = double(from) / to;
  const int taps = std::max(1, static_cast<int>(std::ceil(step)));
  for (int i = 0; i < to; ++i)
  {
    double sum = 0.;
    for (int tap = 0; tap < taps; ++tap)
    {
      const double place = (i + (tap + 0.5) / taps) * step - 0.5;
      const double low = std::floor(place);
      const double weight = place - low;
      const auto at = [&](int k) { return values[(k % from + from) % from]; };
      sum += (1. - weight) * at(static_cast<int>(low)) + weight * at(static_cast<int>(low) + 1);
    }
    result[i] = static_cast<float>(sum / taps);
  }
  return result;
}

/// Depths of a table's texels, in tiles.
std::vector<float> DepthsOf(
  const std::vector<float>& heights, int width, int height, const MesoVDMLayout& layout)
{
  std::vector<float> columns(std::size_t(layout.Width) * height);
  for (int row = 0; row < height; ++row)
  {
    const auto first = heights.begin() + std::ptrdiff_t(row) * width;
    const std::vector<float> resampled = ResampledRow({ first, first + width }, layout.Width);
    std::copy(
      resampled.begin(), resampled.end(), columns.begin() + std::ptrdiff_t(row) * layout.Width);
  }
  std::vector<float> depths(std::size_t(layout.Width) * layout.Height);
  for (int column = 0; column < layout.Width; ++column)
  {
    std::vector<float> values(height);
    for (int row = 0; row < height; ++row)
    {
      values[row] = columns[std::size_t(row) * layout.Width + column];
    }
    const std::vector<float> resampled = ResampledRow(values, layout.Height);
    for (int row = 0; row < layout.Height; ++row)
    {
      depths[std::size_t(row) * layout.Width + column] =
        static_cast<float>(layout.Depth * (1. - double(resampled[row])));
    }
  }
  return depths;
}
}

void vtkMesoVDM::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const MesoVDMLayout& layout = this->Layout;
  os << indent << "Layout: " << layout.Width << " x " << layout.Height << " x " << layout.Azimuths
     << " x " << layout.Polars << " x " << layout.Curvatures << "\n";
  os << indent << "Depth: " << layout.Depth << "\n";
  os << indent << "Curved: " << static_cast<int>(this->Curved) << "\n";
  os << indent << "Ranks: " << this->Ranks[0] << " " << this->Ranks[1] << "\n";
  os << indent << "Bits: " << this->Bits << "\n";
}

void vtkMesoVDM::SetLayout(const MesoVDMLayout& layout)
{
  this->Layout = layout;
  this->Modified();
}

int vtkMesoVDM::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const int extent[] = { 0, this->Layout.Width - 1, 0, this->Layout.Height - 1, 0,
    this->Layout.Azimuths - 1 };
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

MesoVDMNumbers vtkMesoVDM::Bake(const std::vector<float>& depths)
{
  const double start = vtkTimerLog::GetUniversalTime();
  const MesoVDMLayout& layout = this->Layout;
  const double part = this->Ranks[0] > 0 ? BakingPart : 1.;
  const std::size_t count = layout.Rows() / layout.Azimuths * layout.Columns();
  MesoVDMNumbers numbers(layout.Rows() * layout.Columns());
  for (int azimuth = 0; azimuth < layout.Azimuths && !this->GetAbortExecute(); ++azimuth)
  {
    float* here = &numbers[azimuth * count];
    if (!this->KeptParts.Take || !this->KeptParts.Take(azimuth, here, count))
    {
      this->BakeAzimuth(depths, azimuth, here);
      if (this->KeptParts.Keep)
      {
        this->KeptParts.Keep(azimuth, here, count);
      }
    }
    this->UpdateProgress(part * (azimuth + 1) / layout.Azimuths);
  }
  this->RaySeconds = vtkTimerLog::GetUniversalTime() - start;
  return numbers;
}

void vtkMesoVDM::BakeAzimuth(const std::vector<float>& depths, int azimuth, float* numbers) const
{
  const MesoVDMLayout& layout = this->Layout;
  const MesoVDMRays rays(layout, this->Curved, 2. * vtkMath::Pi() * azimuth / layout.Azimuths);
  vtkSMPTools::For(0, layout.Height, 4,
    [&](vtkIdType first, vtkIdType end)
    {
      MesoHeightLine::Profile profile(rays.GetLine(), depths.data());
      for (auto row = static_cast<int>(first); row < end; ++row)
      {
        for (int column = 0; column < layout.Width; ++column)
        {
          const std::size_t index = std::size_t(row) * layout.Width + column;
          rays.Trace(profile, column, row, &numbers[index * layout.Columns()]);
        }
      }
    });
}

void vtkMesoVDM::Compute(const Map& map, vtkImageData* output)
{
  const std::string problem = this->Layout.Problem();
  if (!problem.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< problem);
    return;
  }
  if (this->GetWrap() != MesoWrap::Repeat)
  {
    output->Initialize();
    vtkErrorMacro(
      "The table is of a tile that repeats; the wrap " << MesoName(this->GetWrap()) << " has none");
    return;
  }
  const std::vector<float> depths = DepthsOf(map.Heights, map.Width, map.Height, this->Layout);
  this->FactorSeconds = 0.;
  MesoVDMNumbers numbers = this->Bake(depths);
  if (this->GetAbortExecute())
  {
    return;
  }
  output->SetDimensions(this->Layout.Width, this->Layout.Height, this->Layout.Azimuths);
  output->SetSpacing(1. / this->Layout.Width, 1. / this->Layout.Height, 1. / this->Layout.Azimuths);
  output->SetOrigin(0.5 / this->Layout.Width, 0.5 / this->Layout.Height, 0.);
  this->Layout.Write(output);
  vtkNew<vtkFloatArray> heights;
  heights->SetName("Heights");
  for (const float depth : depths)
  {
    heights->InsertNextValue(static_cast<float>(1. - depth / this->Layout.Depth));
  }
  output->GetFieldData()->AddArray(heights);
  vtkNew<vtkDoubleArray> error;
  error->SetName("AngularError");
  error->InsertNextValue(MesoVDMAngularError(this->Layout, numbers));
  output->GetFieldData()->AddArray(error);
  if (this->Ranks[0] <= 0)
  {
    MesoStoreVDM(this->Layout, numbers, output);
    return;
  }
  this->StoreFactors(numbers, output);
}

void vtkMesoVDM::StoreFactors(MesoVDMNumbers& numbers, vtkImageData* output)
{
  const double start = vtkTimerLog::GetUniversalTime();
  MesoStoreVDMFactors(
    this->Layout, numbers, { this->Ranks[0], std::max(this->Ranks[1], 1) }, this->Bits,
    [this](double part)
    {
      this->UpdateProgress(BakingPart + (1. - BakingPart) * part);
      return this->GetAbortExecute() == 0;
    },
    output);
  this->FactorSeconds = vtkTimerLog::GetUniversalTime() - start;
}
