#include "MesoVDMImage.h"

#include "MesoTableFactors.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/// A column of the weights as whole numbers from 0 on, and what stands for the first and the last.
struct Span
{
  float Low = 0.f;
  float Width = 0.f;
};

std::vector<Span> SpansOf(const std::vector<float>& weights, int rank)
{
  std::vector<Span> spans(rank);
  for (int i = 0; i < rank; ++i)
  {
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    for (std::size_t k = i; k < weights.size(); k += rank)
    {
      low = std::min(low, weights[k]);
      high = std::max(high, weights[k]);
    }
    spans[i] = { low, high - low };
  }
  return spans;
}

template <typename Array>
void AddWeights(
  const std::vector<float>& weights, const std::vector<Span>& spans, vtkImageData* image)
{
  using Code = typename Array::ValueType;
  const std::size_t rank = spans.size();
  vtkNew<Array> codes;
  codes->SetName("Weights");
  codes->SetNumberOfComponents(static_cast<int>(rank));
  codes->SetNumberOfTuples(static_cast<vtkIdType>(weights.size() / rank));
  constexpr float largest = std::numeric_limits<Code>::max();
  Code* code = codes->GetPointer(0);
  for (std::size_t k = 0; k < weights.size(); ++k)
  {
    const Span& span = spans[k % rank];
    const float part = span.Width > 0.f ? (weights[k] - span.Low) / span.Width : 0.f;
    code[k] = static_cast<Code>(std::lround(part * largest));
  }
  image->GetPointData()->SetScalars(codes);
}

std::vector<double> NumbersOf(const char* name, vtkImageData* image)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  std::vector<double> numbers(array->GetNumberOfTuples());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = array->GetTuple1(static_cast<vtkIdType>(i));
  }
  return numbers;
}

/// Of the columns from `first` on, a tuple each.
void AddFunctions(const MesoTableFactors& factors, int first, int count, int rank, double scale,
  const char* name, vtkImageData* image)
{
  vtkNew<vtkFloatArray> functions;
  functions->SetName(name);
  functions->SetNumberOfComponents(rank);
  functions->SetNumberOfTuples(count);
  for (int column = 0; column < count; ++column)
  {
    for (int i = 0; i < rank; ++i)
    {
      functions->SetComponent(column, i,
        scale * factors.GetEigenFunctions()[std::size_t(first + column) * factors.GetRank() + i]);
    }
  }
  image->GetFieldData()->AddArray(functions);
}

void AddNumbers(const std::vector<double>& numbers, const char* name, vtkImageData* image)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double number : numbers)
  {
    array->InsertNextValue(number);
  }
  image->GetFieldData()->AddArray(array);
}

/// Functions in a field of an image, factor by factor.
std::vector<std::vector<float>> FunctionsOf(const char* name, vtkImageData* image)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  std::vector<std::vector<float>> functions(array->GetNumberOfComponents());
  for (std::size_t i = 0; i < functions.size(); ++i)
  {
    for (vtkIdType column = 0; column < array->GetNumberOfTuples(); ++column)
    {
      functions[i].push_back(static_cast<float>(array->GetComponent(column, static_cast<int>(i))));
    }
  }
  return functions;
}

/// What coded factors leave of the numbers that they stand for, in which the largest angles are scaled: root
/// mean square and maximum of the distances, root mean square of the angles over convex bases.
std::vector<double> FactorErrorsOf(
  const MesoVDMLayout& layout, const MesoVDMNumbers& numbers, double scale, vtkImageData* image)
{
  struct Sums
  {
    double Distance = 0.;
    double Largest = 0.;
    double Angle = 0.;
  };
  vtkDataArray* codes = image->GetPointData()->GetScalars();
  const std::vector<std::vector<float>> functions = FunctionsOf("VDMFunctions", image);
  const std::vector<std::vector<float>> angleFunctions = FunctionsOf("MVMFunctions", image);
  const std::vector<double> lows = NumbersOf("WeightLow", image);
  const std::vector<double> widths = NumbersOf("WeightWidth", image);
  const double most = codes->GetDataTypeMax();
  const std::size_t distances = layout.DistanceColumns();
  const std::size_t curvatures = layout.Curvatures;
  std::size_t flats = 0; // curvatures over which every ray comes down
  while (flats < curvatures && layout.CurvatureAt(static_cast<int>(flats)) <= 0.)
  {
    ++flats;
  }
  const std::size_t area = layout.Rows() / layout.Azimuths;
  // An azimuth each, so that sums do not depend on threads.
  std::vector<Sums> parts(layout.Azimuths);
  vtkSMPTools::For(0, layout.Azimuths, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> off(layout.Columns());
      for (std::size_t row = begin * area; row < end * area; ++row)
      {
        Sums& sums = parts[row / area];
        const float* here = &numbers[row * off.size()];
        std::transform(here, here + distances, off.begin(), [](float number) { return -number; });
        std::transform(here + distances, here + off.size(), off.begin() + distances,
          [&](float number) { return static_cast<float>(-number / scale); });
        for (std::size_t i = 0; i < lows.size(); ++i)
        {
          const double code = codes->GetComponent(static_cast<vtkIdType>(row), static_cast<int>(i));
          const auto weight = static_cast<float>(lows[i] + widths[i] * code / most);
          for (std::size_t k = 0; i < functions.size() && k < distances; ++k)
          {
            off[k] += weight * functions[i][k];
          }
          for (std::size_t k = flats; i < angleFunctions.size() && k < curvatures; ++k)
          {
            off[distances + k] += weight * angleFunctions[i][k];
          }
        }
        for (std::size_t k = 0; k < distances; ++k)
        {
          sums.Distance += double(off[k]) * off[k];
          sums.Largest = std::max(sums.Largest, std::abs(double(off[k])));
        }
        for (std::size_t k = flats; k < curvatures; ++k)
        {
          sums.Angle += double(off[distances + k]) * off[distances + k];
        }
      }
    });
  Sums all;
  for (const Sums& part : parts)
  {
    all.Distance += part.Distance;
    all.Largest = std::max(all.Largest, part.Largest);
    all.Angle += part.Angle;
  }
  const double ofDistances = double(layout.Rows()) * double(distances);
  const double ofAngles =
    double(layout.Rows()) * double(std::max<std::size_t>(curvatures - flats, 1));
  return { std::sqrt(all.Distance / ofDistances), all.Largest, std::sqrt(all.Angle / ofAngles) };
}

double RootMeanSquare(const MesoVDMNumbers& numbers, int columns, int first, int end)
{
  double sum = 0.;
  for (std::size_t row = 0; row < numbers.size(); row += columns)
  {
    for (int i = first; i < end; ++i)
    {
      sum += double(numbers[row + i]) * numbers[row + i];
    }
  }
  return std::sqrt(sum * columns / (double(numbers.size()) * (end - first)));
}
}

double MesoVDMAngularError(const MesoVDMLayout& layout, const MesoVDMNumbers& numbers)
{
  const std::size_t columns = layout.Columns();
  const std::size_t area = std::size_t(layout.Width) * layout.Height;
  const std::size_t turn = area * layout.Azimuths;
  const auto squareOf = [](double before, double here, double after)
  {
    const double eighth = 0.125 * (before - 2. * here + after);
    return eighth * eighth;
  };
  double ofAzimuths = 0.;
  double ofPolars = 0.;
  for (std::size_t row = 0; row < layout.Rows(); ++row)
  {
    const float* here = &numbers[row * columns];
    const float* before = &numbers[(row + turn - area) % turn * columns];
    const float* after = &numbers[(row + area) % turn * columns];
    for (int i = 0; i < layout.DistanceColumns(); ++i)
    {
      ofAzimuths += squareOf(before[i], here[i], after[i]);
      const int polar = i % layout.Polars;
      ofPolars +=
        polar > 0 && polar + 1 < layout.Polars ? squareOf(here[i - 1], here[i], here[i + 1]) : 0.;
    }
  }
  const double count = double(layout.Rows()) * layout.Curvatures;
  return std::sqrt(ofAzimuths / (count * layout.Polars) +
    (layout.Polars > 2 ? ofPolars / (count * (layout.Polars - 2)) : 0.));
}

void MesoStoreVDM(const MesoVDMLayout& layout, const MesoVDMNumbers& numbers, vtkImageData* image)
{
  const int columns = layout.Columns();
  const int distances = layout.DistanceColumns();
  vtkNew<vtkUnsignedShortArray> vdm;
  vdm->SetName("VDM");
  vdm->SetNumberOfComponents(distances);
  vdm->SetNumberOfTuples(static_cast<vtkIdType>(layout.Rows()));
  vtkNew<vtkUnsignedShortArray> mvm;
  mvm->SetName("MVM");
  mvm->SetNumberOfComponents(layout.Curvatures);
  mvm->SetNumberOfTuples(static_cast<vtkIdType>(layout.Rows()));
  unsigned short* distance = vdm->GetPointer(0);
  unsigned short* angle = mvm->GetPointer(0);
  constexpr float largest = std::numeric_limits<unsigned short>::max();
  for (std::size_t row = 0; row < numbers.size(); row += columns)
  {
    for (int i = 0; i < columns; ++i)
    {
      const auto code = static_cast<unsigned short>(std::lround(numbers[row + i] * largest));
      *(i < distances ? distance : angle)++ = code;
    }
  }
  image->GetPointData()->SetScalars(vdm);
  image->GetPointData()->AddArray(mvm);
}

bool MesoStoreVDMFactors(const MesoVDMLayout& layout, MesoVDMNumbers& numbers,
  const std::array<int, 2>& ranks, int bits, const std::function<bool(double)>& progress,
  vtkImageData* image)
{
  const int columns = layout.Columns();
  const int distances = layout.DistanceColumns();
  // What is left to 90 degrees: 0 for most rays, so that its size is that of outlines.
  for (std::size_t row = 0; row < numbers.size(); row += columns)
  {
    for (int i = distances; i < columns; ++i)
    {
      numbers[row + i] = 1.f - numbers[row + i];
    }
  }
  const double ofDistances = RootMeanSquare(numbers, columns, 0, distances);
  const double ofAngles = RootMeanSquare(numbers, columns, distances, columns);
  const double scale = ofDistances > 0. && ofAngles > 0. ? ofDistances / ofAngles : 1.;
  for (std::size_t row = 0; row < numbers.size(); row += columns)
  {
    for (int i = distances; i < columns; ++i)
    {
      numbers[row + i] = static_cast<float>(scale * numbers[row + i]);
    }
  }
  MesoTableFactors factors;
  if (!factors.Compute(
        numbers.data(), layout.Rows(), columns, std::max(ranks[0], ranks[1]), progress))
  {
    return false;
  }
  const int rank = factors.GetRank();
  const std::vector<Span> spans = SpansOf(factors.GetWeights(), rank);
  if (bits > MesoVDMLeastBits)
  {
    AddWeights<vtkUnsignedShortArray>(factors.GetWeights(), spans, image);
  }
  else
  {
    AddWeights<vtkUnsignedCharArray>(factors.GetWeights(), spans, image);
  }
  AddFunctions(factors, 0, distances, std::min(ranks[0], rank), 1., "VDMFunctions", image);
  AddFunctions(factors, distances, layout.Curvatures, std::min(ranks[1], rank), 1. / scale,
    "MVMFunctions", image);
  std::vector<double> lows;
  std::vector<double> widths;
  std::vector<double> errors;
  for (int i = 0; i < rank; ++i)
  {
    lows.push_back(spans[i].Low);
    widths.push_back(spans[i].Width);
    errors.push_back(factors.GetError(i + 1));
  }
  AddNumbers(lows, "WeightLow", image);
  AddNumbers(widths, "WeightWidth", image);
  AddNumbers(errors, "Errors", image);
  AddNumbers(FactorErrorsOf(layout, numbers, scale, image), "FactorErrors", image);
  return true;
}
