#include "vtkMesoGDMTable.h"

#include "MesoGDMSweep.h"
#include "MesoTableFactors.h"
#include "MesoWholeImage.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnsignedShortArray.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkMesoGDMTable);

namespace
{
constexpr double PartOfTable = 0.7; // of the work; the rest is its factors

std::string Problem(vtkImageData* volume)
{
  const std::string problem = MesoVolumeProblem(volume);
  if (!problem.empty())
  {
    return problem;
  }
  int size[3];
  volume->GetDimensions(size);
  return std::min({ size[0], size[1], size[2] }) < 2
    ? "a table needs a volume of at least 2 x 2 x 2 samples"
    : "";
}

vtkSmartPointer<vtkFloatArray> FloatArray(const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// Numbers as whole numbers from `least` to `most` of their component.
template <typename Array>
vtkSmartPointer<vtkDataArray> Quantised(const float* numbers, int components, vtkIdType tuples,
  const std::vector<float>& least, const std::vector<float>& most)
{
  using Value = typename Array::ValueType;
  constexpr double steps = std::numeric_limits<Value>::max();
  auto array = vtkSmartPointer<Array>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  Value* target = array->GetPointer(0);
  vtkSMPTools::For(0, tuples,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType i = first * components; i < last * components; ++i)
      {
        const auto component = static_cast<std::size_t>(i % components);
        const double span = double(most[component]) - double(least[component]);
        const double part = span > 0. ? (numbers[i] - double(least[component])) / span : 0.;
        target[i] = static_cast<Value>(std::lround(std::clamp(part, 0., 1.) * steps));
      }
    });
  return array;
}

vtkSmartPointer<vtkDataArray> Kept(int bits, const float* numbers, int components, vtkIdType tuples,
  std::vector<float>& least, std::vector<float>& most)
{
  if (bits == 8)
  {
    return Quantised<vtkUnsignedCharArray>(numbers, components, tuples, least, most);
  }
  if (bits == 16)
  {
    return Quantised<vtkUnsignedShortArray>(numbers, components, tuples, least, most);
  }
  std::fill(least.begin(), least.end(), 0.f);
  std::fill(most.begin(), most.end(), 1.f);
  const auto array = FloatArray("", components, tuples);
  std::copy_n(numbers, tuples * components, array->GetPointer(0));
  return array;
}

/**
 * Of each distance what meets the solid in one of the eight directions beside its own, around z and along it, where
 * that is nearer by more than a voxel: so that what is interpolated between them passes nothing that one of them
 * meets. Elsewhere it stays as it is.
 */
void TakeNearerHits(std::vector<float>& table, const MesoVolumeField& field,
  const MesoGDMDirections& directions, double reach)
{
  const auto slices = static_cast<std::size_t>(field.GetSize()[2]);
  const std::size_t rows = std::size_t(field.GetSize()[0]) * std::size_t(field.GetSize()[1]);
  const int polars = directions.Polars;
  const int azimuths = directions.Azimuths;
  const std::size_t columns = std::size_t(polars) * slices;
  const float voxel = 1.f / static_cast<float>(std::max(field.GetSize()[0], field.GetSize()[1]));
  // What rays that meet nothing have, by (theta, z); what is less is a hit.
  std::vector<float> free(columns);
  for (int polar = 0; polar < polars; ++polar)
  {
    for (std::size_t k = 0; k < slices; ++k)
    {
      const double way = MesoVolumeRay::ToPlane(
        double(k) / double(slices - 1), directions.At(0, polar)[2], field.GetDepth());
      free[std::size_t(polar) * slices + k] =
        static_cast<float>(std::min(reach, way)) - 0.1f * voxel;
    }
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(rows),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<float> nearest(std::size_t(azimuths) * columns);
      for (auto row = static_cast<std::size_t>(begin); row < static_cast<std::size_t>(end); ++row)
      {
        const auto rowOf = [&](int azimuth)
        {
          const int inside = (azimuth + azimuths) % azimuths;
          return table.data() + (std::size_t(inside) * rows + row) * columns;
        };
        for (int azimuth = 0; azimuth < azimuths; ++azimuth)
        {
          const float* beside[3] = { rowOf(azimuth - 1), rowOf(azimuth), rowOf(azimuth + 1) };
          for (int polar = 0; polar < polars; ++polar)
          {
            const int first = std::max(polar - 1, 0);
            const int last = std::min(polar + 1, polars - 1);
            for (std::size_t k = 0; k < slices; ++k)
            {
              const float own = beside[1][std::size_t(polar) * slices + k];
              float found = own - voxel;
              for (const float* numbers : beside)
              {
                for (int near = first; near <= last; ++near)
                {
                  const std::size_t column = std::size_t(near) * slices + k;
                  found = numbers[column] < free[column] ? std::min(found, numbers[column]) : found;
                }
              }
              nearest[std::size_t(azimuth) * columns + std::size_t(polar) * slices + k] =
                found < own - voxel ? found : own;
            }
          }
        }
        for (int azimuth = 0; azimuth < azimuths; ++azimuth)
        {
          std::copy_n(nearest.data() + std::size_t(azimuth) * columns, columns, rowOf(azimuth));
        }
      }
    });
}
}

void vtkMesoGDMTable::SetBits(int bits)
{
  const int allowed = bits <= 8 ? 8 : bits <= 16 ? 16 : 32;
  if (this->Bits != allowed)
  {
    this->Bits = allowed;
    this->Modified();
  }
}

void vtkMesoGDMTable::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Azimuths: " << this->Azimuths << "\n";
  os << indent << "Polars: " << this->Polars << "\n";
  os << indent << "Even: " << this->Even << "\n";
  os << indent << "Reach: " << this->Reach << "\n";
  os << indent << "Rank: " << this->Rank << "\n";
  os << indent << "Bits: " << this->Bits << "\n";
  os << indent << "Exact: " << this->Exact << "\n";
  os << indent << "Cautious: " << this->Cautious << "\n";
  os << indent << "FollowedPart: " << this->FollowedPart << "\n";
}

int vtkMesoGDMTable::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  int extent[6];
  MesoGetWholeExtent(inputVector[0]->GetInformationObject(0), extent);
  extent[4] = 0;
  extent[5] = this->Azimuths - 1;
  outputVector->GetInformationObject(0)->Set(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  return 1;
}

int vtkMesoGDMTable::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkImageData* volume = vtkImageData::GetData(inputVector[0]);
  vtkImageData* output = vtkImageData::GetData(outputVector);
  output->Initialize();
  this->FactorErrors.clear();
  const std::string problem = Problem(volume);
  if (!problem.empty())
  {
    vtkErrorMacro(<< problem);
    return 1;
  }
  int size[3];
  volume->GetDimensions(size);
  output->SetDimensions(size[0], size[1], this->Azimuths);
  const std::size_t columns = std::size_t(this->Polars) * std::size_t(size[2]);
  std::vector<float> table;
  bool isWhole = this->MakeTable(volume, table);
  if (isWhole && this->Rank > 0)
  {
    isWhole = this->AddFactors(table, columns, output);
  }
  else if (isWhole)
  {
    std::vector<float> least(columns, 0.f);
    std::vector<float> most(columns, static_cast<float>(this->Reach));
    const auto distances = Kept(this->Bits, table.data(), static_cast<int>(columns),
      output->GetNumberOfPoints(), least, most);
    distances->SetName("MesoGDMDistances");
    output->GetPointData()->SetScalars(distances);
  }
  if (!isWhole)
  {
    output->Initialize();
    return 1;
  }
  vtkNew<vtkDoubleArray> shape;
  shape->SetName("MesoGDMShape");
  for (const double number :
    { double(size[0]), double(size[1]), double(size[2]), double(this->Azimuths),
      double(this->Polars), this->Even ? 1. : 0., this->Reach, double(this->Rank) })
  {
    shape->InsertNextValue(number);
  }
  output->GetFieldData()->AddArray(shape);
  const MesoVolumeField field(volume);
  const auto samples = FloatArray("MesoGDMVolume", 1, volume->GetNumberOfPoints());
  std::copy(field.GetValues().begin(), field.GetValues().end(), samples->GetPointer(0));
  output->GetFieldData()->AddArray(samples);
  vtkNew<vtkDoubleArray> depth;
  depth->SetName("MesoVolumeDepth");
  depth->InsertNextValue(field.GetDepth());
  output->GetFieldData()->AddArray(depth);
  return 1;
}

/// Rows (phi, y, x), columns (theta, z).
bool vtkMesoGDMTable::MakeTable(vtkImageData* volume, std::vector<float>& table)
{
  const MesoVolumeField field(volume);
  const MesoGDMSweep sweep(field, this->Reach);
  MesoGDMDirections directions;
  directions.Azimuths = this->Azimuths;
  directions.Polars = this->Polars;
  directions.Even = this->Even;
  const auto& size = field.GetSize();
  const std::size_t columns = std::size_t(this->Polars) * std::size_t(size[2]);
  const std::size_t rows = std::size_t(size[0]) * std::size_t(size[1]);
  table.resize(rows * columns * std::size_t(this->Azimuths));
  std::atomic<std::size_t> followed{ 0 };
  const int count = this->Azimuths * this->Polars;
  // A few directions at a time, between which progress is told.
  constexpr int AtOnce = 16;
  for (int done = 0; done < count; done += AtOnce)
  {
    if (this->GetAbortExecute())
    {
      return false;
    }
    vtkSMPTools::For(done, std::min(done + AtOnce, count), 1,
      [&](vtkIdType first, vtkIdType last)
      {
        for (auto number = static_cast<int>(first); number < last; ++number)
        {
          const int azimuth = number / this->Polars;
          const int polar = number % this->Polars;
          const auto direction = directions.At(azimuth, polar);
          float* target =
            table.data() + std::size_t(azimuth) * rows * columns + std::size_t(polar) * size[2];
          if (this->Exact)
          {
            sweep.Cast(direction, target, columns);
          }
          else
          {
            followed += sweep.Sweep(direction, target, columns);
          }
        }
      });
    this->UpdateProgress(PartOfTable * std::min(done + AtOnce, count) / count);
  }
  this->FollowedPart = this->Exact ? 1. : double(followed) / double(table.size());
  if (this->Cautious)
  {
    TakeNearerHits(table, field, directions, this->Reach);
  }
  return true;
}

bool vtkMesoGDMTable::AddFactors(
  const std::vector<float>& table, std::size_t columns, vtkImageData* output)
{
  const vtkIdType rows = output->GetNumberOfPoints();
  MesoTableFactors factors;
  if (!factors.Compute(table.data(), static_cast<std::size_t>(rows), columns, this->Rank,
        [this](double done)
        {
          this->UpdateProgress(PartOfTable + (1. - PartOfTable) * done);
          return this->GetAbortExecute() == 0;
        }))
  {
    return false;
  }
  const int kept = factors.GetRank();
  for (int rank = 1; rank <= kept; ++rank)
  {
    this->FactorErrors.push_back(factors.GetError(rank));
  }
  // A rank above the columns' number is filled with products of nothing.
  std::vector<float> weights(static_cast<std::size_t>(rows) * this->Rank, 0.f);
  std::vector<float> least(this->Rank, 0.f);
  std::vector<float> most(this->Rank, 0.f);
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
  {
    for (int r = 0; r < kept; ++r)
    {
      const float weight = factors.GetWeights()[row * kept + r];
      weights[row * this->Rank + r] = weight;
      least[r] = row == 0 ? weight : std::min(least[r], weight);
      most[r] = row == 0 ? weight : std::max(most[r], weight);
    }
  }
  const auto array = Kept(this->Bits, weights.data(), this->Rank, rows, least, most);
  array->SetName("MesoGDMWeights");
  output->GetPointData()->SetScalars(array);

  const auto functions = FloatArray("MesoGDMFunctions", this->Rank, vtkIdType(columns));
  functions->FillValue(0.f);
  for (std::size_t column = 0; column < columns; ++column)
  {
    std::copy_n(factors.GetEigenFunctions().data() + column * kept, kept,
      functions->GetPointer(vtkIdType(column) * this->Rank));
  }
  output->GetFieldData()->AddArray(functions);
  const auto range = FloatArray("MesoGDMWeightRange", this->Rank, 2);
  std::copy(least.begin(), least.end(), range->GetPointer(0));
  std::copy(most.begin(), most.end(), range->GetPointer(this->Rank));
  output->GetFieldData()->AddArray(range);
  return true;
}
