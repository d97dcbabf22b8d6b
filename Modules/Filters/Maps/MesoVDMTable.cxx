#include "MesoVDMTable.h"

#include "MesoKernels.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
using Kernel = MesoKernels::Double::VDMTable;

static_assert(Kernel::VDMStoresDistance == static_cast<int>(MesoVDMStores::Distance) &&
    Kernel::VDMStoresDepth == static_cast<int>(MesoVDMStores::Depth) &&
    Kernel::VDMStoresOffset == static_cast<int>(MesoVDMStores::Offset) &&
    Kernel::VDMNodesEdges == static_cast<int>(MesoVDMNodes::Edges) &&
    Kernel::VDMNodesCentres == static_cast<int>(MesoVDMNodes::Centres) &&
    Kernel::VDMNodesGraded == static_cast<int>(MesoVDMNodes::Graded),
  "the enumerations count as the kernel does");

/// The polar angles of the kernel.
Kernel::VDMLayout KernelLayout(const MesoVDMLayout& layout)
{
  Kernel::VDMLayout result = {};
  result.Nodes = static_cast<int>(layout.Nodes);
  result.Polars = layout.Polars;
  result.Curvatures = layout.Curvatures;
  result.FirstCurvature = layout.FirstCurvature;
  result.LastCurvature = layout.LastCurvature;
  return result;
}

constexpr const char* SizesName = "VDMSizes";
constexpr const char* NumbersName = "VDMNumbers";
constexpr int SizeCount = 7;
constexpr int NumberCount = 4;

void AddArray(vtkFieldData* data, const char* name, const std::vector<double>& numbers)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (double number : numbers)
  {
    array->InsertNextValue(number);
  }
  data->AddArray(array);
}

std::vector<double> ArrayOf(vtkImageData* image, const char* name, int count)
{
  vtkDataArray* array = image->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfValues() != count)
  {
    throw std::runtime_error(
      std::string("the field data has no ") + name + " of " + std::to_string(count) + " numbers");
  }
  std::vector<double> numbers(count);
  for (int i = 0; i < count; ++i)
  {
    numbers[i] = array->GetVariantValue(i).ToDouble();
  }
  return numbers;
}
}

double MesoVDMLayout::PolarAt(int i) const
{
  return Kernel().vdmPolarAt(KernelLayout(*this), i);
}

double MesoVDMLayout::PolarPlace(double polar) const
{
  return Kernel().vdmPolarPlace(KernelLayout(*this), polar);
}

double MesoVDMLayout::RayPolarAt(int i) const
{
  constexpr double leastSlope = 1e-2;
  return std::min(this->PolarAt(i), Kernel::VDMRightAngle - leastSlope);
}

double MesoVDMLayout::CurvatureAt(int i) const
{
  // As it is written: 0 is 0, not nearly.
  const int last = std::max(this->Curvatures - 1, 1);
  return (this->FirstCurvature * (last - i) + this->LastCurvature * i) / last;
}

double MesoVDMLayout::Range() const
{
  if (this->Stores == MesoVDMStores::Depth)
  {
    return this->LastCurvature > 0. ? 2. * this->Depth : this->Depth;
  }
  // The bottom stops every ray that does not come out before.
  double range = 0.;
  for (int k = 0; k < this->Curvatures; ++k)
  {
    const double c = this->CurvatureAt(k);
    if (c > 0.) // the ray that touches the bottom comes out furthest away
    {
      const double sine = 1. - c * this->Depth;
      const double offset = 2. * std::acos(sine) / c;
      range = std::max(range, this->Stores == MesoVDMStores::Offset ? offset : offset / sine);
    }
    for (int i = 0; i < this->Polars; ++i)
    {
      const double polar = this->RayPolarAt(i);
      const double sine = std::sin(polar);
      const double cosine = std::cos(polar);
      const double rest = (2. - c * this->Depth) * this->Depth;
      const bool comesOut = cosine * cosine < c * rest;
      const double offset = comesOut
        ? (2. * Kernel::VDMRightAngle - 2. * polar) / c
        : Kernel().vdmPointAtDepth(sine, cosine, c, this->Depth, false).Offset;
      const double extended = sine > 1e-6 ? offset / sine : this->Depth / (1. - c * this->Depth);
      range = std::max(range, this->Stores == MesoVDMStores::Offset ? offset : extended);
    }
  }
  return range;
}

std::string MesoVDMLayout::Problem() const
{
  const auto within = [](int number, int low, int high) { return number >= low && number <= high; };
  if (!within(this->Width, 1, 1024) || !within(this->Height, 1, 1024))
  {
    return "a table has 1 to 1024 texels along each side";
  }
  if (!within(this->Azimuths, 4, 360) || !within(this->Polars, 2, 90) ||
    !within(this->Curvatures, 1, 64))
  {
    return "a table has 4 to 360 azimuths, 2 to 90 polar angles and 1 to 64 curvatures";
  }
  if (!(this->FirstCurvature <= this->LastCurvature) || !std::isfinite(this->FirstCurvature) ||
    !std::isfinite(this->LastCurvature) ||
    (this->Curvatures > 1 && this->FirstCurvature == this->LastCurvature))
  {
    return "the first curvature must be less than the last";
  }
  if (!(this->Depth >= 1e-6 && this->Depth <= 16.))
  {
    return "the depth must be from 0.000001 to 16 tiles";
  }
  if (this->Depth * this->LastCurvature >= 1.)
  {
    return "the relief of depth " + std::to_string(this->Depth) +
      " reaches beyond the centre of the curvature " + std::to_string(this->LastCurvature) +
      ": their product must be below 1";
  }
  return {};
}

void MesoVDMLayout::Write(vtkImageData* image) const
{
  AddArray(image->GetFieldData(), SizesName,
    { double(this->Width), double(this->Height), double(this->Azimuths), double(this->Polars),
      double(this->Curvatures), double(this->Nodes), double(this->Stores) });
  AddArray(image->GetFieldData(), NumbersName,
    { this->FirstCurvature, this->LastCurvature, this->Depth, this->Range() });
}

MesoVDMLayout MesoVDMLayout::Read(vtkImageData* image)
{
  const std::vector<double> sizes = ArrayOf(image, SizesName, SizeCount);
  const std::vector<double> numbers = ArrayOf(image, NumbersName, NumberCount);
  const auto whole = [&](int i)
  {
    if (!(sizes[i] >= 0. && sizes[i] <= 65536. && sizes[i] == std::floor(sizes[i])))
    {
      throw std::runtime_error(std::string(SizesName) + " holds no whole numbers");
    }
    return static_cast<int>(sizes[i]);
  };
  MesoVDMLayout layout;
  layout.Width = whole(0);
  layout.Height = whole(1);
  layout.Azimuths = whole(2);
  layout.Polars = whole(3);
  layout.Curvatures = whole(4);
  if (whole(5) > static_cast<int>(MesoVDMNodes::Graded) ||
    whole(6) > static_cast<int>(MesoVDMStores::Offset))
  {
    throw std::runtime_error(std::string(SizesName) + " names no kind of nodes or numbers");
  }
  layout.Nodes = static_cast<MesoVDMNodes>(whole(5));
  layout.Stores = static_cast<MesoVDMStores>(whole(6));
  layout.FirstCurvature = numbers[0];
  layout.LastCurvature = numbers[1];
  layout.Depth = numbers[2];
  const std::string problem = layout.Problem();
  if (!problem.empty())
  {
    throw std::runtime_error(problem);
  }
  int size[3];
  image->GetDimensions(size);
  if (size[0] != layout.Width || size[1] != layout.Height || size[2] != layout.Azimuths)
  {
    throw std::runtime_error("the image is not of the table's size");
  }
  return layout;
}
