#ifndef VDMBench_h
#define VDMBench_h

// What the programs that measure tables of view-dependent displacements share: where random rays really meet
// the relief, and where the interpolated table says.

#include "MesoKernels.h"
#include "MesoVDMTable.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoPatternSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace VDMBench
{
using Kernel = MesoKernels::Double::VDMTable;
const double Pi = std::acos(-1.);
constexpr int Size = 128;

inline vtkSmartPointer<vtkImageData> MapOf(const std::string& pattern)
{
  vtkNew<vtkMesoPatternSource> source;
  source->SetPattern(pattern.c_str());
  source->SetSize(Size, Size);
  source->Update();
  return source->GetOutput();
}

/// The relief by steps of a tenth of a texel and halving.
class Truth
{
public:
  Truth(vtkImageData* map, double depth)
    : Map(map)
    , Depth(depth)
  {
  }

  /// Offset of the point that a ray meets; negative where it meets none.
  double Offset(const glm::dvec2& uv, double azimuth, double polar, double c) const
  {
    const auto below = [&](double t, double& offset)
    {
      const double along = t * std::sin(polar);
      const double inwards = t * std::cos(polar);
      double depth = inwards;
      offset = along;
      if (c != 0.)
      {
        const double square = 2. * c * inwards - c * c * t * t;
        depth = square / c / (1. + std::sqrt(1. - square));
        offset = std::atan2(c * along, 1. - c * inwards) / c;
      }
      if (t > 0. && depth < 0.)
      {
        return 2;
      }
      return depth >=
          this->ReliefAt(uv.x + offset * std::cos(azimuth), uv.y + offset * std::sin(azimuth))
        ? 1
        : 0;
    };
    double offset = 0.;
    double before = 0.;
    for (double t = 0.; t < 40.; t += 0.1 / Size)
    {
      const int state = below(t, offset);
      if (state == 2)
      {
        return -1.;
      }
      if (state == 1)
      {
        double high = t;
        for (int i = 0; i < 30; ++i)
        {
          const double middle = 0.5 * (before + high);
          (below(middle, offset) == 1 ? high : before) = middle;
        }
        below(high, offset);
        return offset;
      }
      before = t;
    }
    return -1.;
  }

private:
  double ReliefAt(double u, double v) const
  {
    const double x = u * Size - 0.5;
    const double y = v * Size - 0.5;
    const double i = std::floor(x);
    const double j = std::floor(y);
    const float* heights =
      static_cast<vtkFloatArray*>(this->Map->GetPointData()->GetScalars())->GetPointer(0);
    const auto at = [&](double column, double row)
    {
      const int c = static_cast<int>(column) & (Size - 1);
      const int r = static_cast<int>(row) & (Size - 1);
      return double(heights[r * Size + c]);
    };
    const double height = (1. - (y - j)) * ((1. - (x - i)) * at(i, j) + (x - i) * at(i + 1., j)) +
      (y - j) * ((1. - (x - i)) * at(i, j + 1.) + (x - i) * at(i + 1., j + 1.));
    return this->Depth * (1. - height);
  }

  vtkImageData* Map;
  double Depth;
};

/// The number, of what is stored, at a row and a column of a table.
using NumberAt = std::function<double(std::size_t row, int column)>;

/// A table as a shader interpolates it, linear over all its axes.
class Table
{
public:
  Table(const MesoVDMLayout& layout, NumberAt numberAt)
    : Layout(layout)
    , Number(std::move(numberAt))
  {
    this->Axes.Stores = static_cast<int>(layout.Stores);
    this->Axes.Nodes = static_cast<int>(layout.Nodes);
    this->Axes.Polars = layout.Polars;
    this->Axes.Curvatures = layout.Curvatures;
    this->Axes.FirstCurvature = layout.FirstCurvature;
    this->Axes.LastCurvature = layout.LastCurvature;
    this->Axes.Depth = layout.Depth;
    this->Axes.Range = layout.Range();
  }

  /// Offset over the base of the point that a ray meets.
  double Offset(const glm::dvec2& uv, double turns, double polar, double curvature) const
  {
    const Kernel kernel;
    const double stored = this->Sample(uv, turns, kernel.vdmPolarPlace(this->Axes, polar),
      kernel.vdmCurvaturePlace(this->Axes, curvature));
    return kernel.vdmPoint(this->Axes, std::sin(polar), std::cos(polar), curvature, stored).Offset;
  }

private:
  double Sample(const glm::dvec2& uv, double turns, double polar, double curvature) const
  {
    const double places[5] = { uv.x * this->Layout.Width - 0.5, uv.y * this->Layout.Height - 0.5,
      turns * this->Layout.Azimuths, polar, curvature };
    const int sizes[5] = { this->Layout.Width, this->Layout.Height, this->Layout.Azimuths,
      this->Layout.Polars, this->Layout.Curvatures };
    double sum = 0.;
    for (int corner = 0; corner < 32; ++corner)
    {
      double weight = 1.;
      int at[5];
      for (int axis = 0; axis < 5; ++axis)
      {
        const double low = std::floor(places[axis]);
        const bool upper = (corner >> axis & 1) != 0;
        weight *= upper ? places[axis] - low : 1. - (places[axis] - low);
        at[axis] = (static_cast<int>(low) + (upper ? 1 : 0) + sizes[axis]) % sizes[axis];
      }
      if (weight > 0.)
      {
        const std::size_t row =
          (std::size_t(at[2]) * this->Layout.Height + at[1]) * this->Layout.Width + at[0];
        sum += weight * this->Number(row, at[4] * this->Layout.Polars + at[3]);
      }
    }
    return std::min(std::max(sum, 0.), 1.);
  }

  MesoVDMLayout Layout;
  Kernel::VDMLayout Axes = {};
  NumberAt Number;
};

/// Of distances over the base between truth and table, in texels.
struct Spread
{
  double Median = -1.; ///< negative where next to no ray meets anything
  double Most = -1.;   ///< the 95th percentile
};

/// Of a thousand random rays at a polar angle over a curvature.
inline Spread Measure(const Table& table, const Truth& truth, double polar, double curvature)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<double> errors;
  for (int i = 0; i < 1000; ++i)
  {
    const double u = uniform(random);
    const glm::dvec2 uv(u, uniform(random));
    const double turns = uniform(random);
    const double offset = truth.Offset(uv, 2. * Pi * turns, polar, curvature);
    if (offset >= 0.)
    {
      errors.push_back(std::abs(table.Offset(uv, turns, polar, curvature) - offset) * Size);
    }
  }
  if (errors.size() < 20)
  {
    return {};
  }
  std::sort(errors.begin(), errors.end());
  return { errors[errors.size() / 2], errors[errors.size() * 95 / 100] };
}
}

#endif
