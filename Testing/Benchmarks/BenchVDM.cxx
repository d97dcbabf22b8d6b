// What tables of view-dependent displacements leave, over polar angle, curvature, kind of nodes, kind of
// stored numbers, ranks and bits: distances over the base between where random rays really meet the relief
// and where the interpolated table says, in texels. By itself and without a window:
//
//   BenchVDM [PATTERN [DEPTH]]

#include "MesoKernels.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMesoPatternSource.h"
#include "vtkMesoVDM.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace
{
using Kernel = MesoKernels::Double::VDMTable;
const double Pi = std::acos(-1.);
constexpr int Size = 128;

Kernel::VDMLayout KernelLayout(const MesoVDMLayout& layout)
{
  Kernel::VDMLayout result = {};
  result.Stores = static_cast<int>(layout.Stores);
  result.Nodes = static_cast<int>(layout.Nodes);
  result.Polars = layout.Polars;
  result.Curvatures = layout.Curvatures;
  result.FirstCurvature = layout.FirstCurvature;
  result.LastCurvature = layout.LastCurvature;
  result.Depth = layout.Depth;
  result.Range = layout.Range();
  return result;
}

/// A table or its factors, interpolated as a shader does.
class Table
{
public:
  Table(vtkImageData* image, int rank)
    : Image(image)
    , Layout(MesoVDMLayout::Read(image))
    , Rank(rank)
  {
  }

  double Sample(const glm::dvec2& uv, double turns, double polar, double curvature) const
  {
    const double x = uv.x * this->Layout.Width - 0.5;
    const double y = uv.y * this->Layout.Height - 0.5;
    const double a = turns * this->Layout.Azimuths;
    double sum = 0.;
    const auto each = [&](double place, const auto& next)
    {
      const double low = std::floor(place);
      next(static_cast<int>(low), 1. - (place - low));
      if (place > low)
      {
        next(static_cast<int>(low) + 1, place - low);
      }
    };
    const auto wrapped = [](int i, int n) { return (i % n + n) % n; };
    each(x,
      [&](int i, double wi)
      {
        each(y,
          [&](int j, double wj)
          {
            each(a,
              [&](int k, double wk)
              {
                const vtkIdType tuple =
                  (vtkIdType(wrapped(k, this->Layout.Azimuths)) * this->Layout.Height +
                    wrapped(j, this->Layout.Height)) *
                    this->Layout.Width +
                  wrapped(i, this->Layout.Width);
                each(polar,
                  [&](int p, double wp)
                  {
                    each(curvature,
                      [&](int c, double wc) {
                        sum += wi * wj * wk * wp * wc *
                          this->NumberAt(tuple, c * this->Layout.Polars + p);
                      });
                  });
              });
          });
      });
    return std::min(std::max(sum, 0.), 1.);
  }

  const MesoVDMLayout& GetLayout() const { return this->Layout; }

private:
  double NumberAt(vtkIdType tuple, int column) const
  {
    vtkDataArray* numbers = this->Image->GetPointData()->GetScalars();
    if (this->Rank == 0)
    {
      return numbers->GetComponent(tuple, column) / numbers->GetDataTypeMax();
    }
    vtkFieldData* data = this->Image->GetFieldData();
    vtkDataArray* functions = data->GetArray("VDMFunctions");
    double sum = 0.;
    for (int i = 0; i < this->Rank; ++i)
    {
      const double part = numbers->GetComponent(tuple, i) / numbers->GetDataTypeMax();
      sum += (data->GetArray("WeightLow")->GetTuple1(i) +
               part * data->GetArray("WeightWidth")->GetTuple1(i)) *
        functions->GetComponent(column, i);
    }
    return sum;
  }

  vtkImageData* Image;
  MesoVDMLayout Layout;
  int Rank;
};

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

/// Median and 95th percentile of the distance, in texels.
void Measure(const Table& table, const Truth& truth, double polar, double curvature)
{
  const Kernel kernel;
  const Kernel::VDMLayout layout = KernelLayout(table.GetLayout());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<double> errors;
  for (int i = 0; i < 1000; ++i)
  {
    const glm::dvec2 uv(uniform(random), uniform(random));
    const double turns = uniform(random);
    const double offset = truth.Offset(uv, 2. * Pi * turns, polar, curvature);
    if (offset < 0.)
    {
      continue;
    }
    const double stored = table.Sample(
      uv, turns, kernel.vdmPolarPlace(layout, polar), kernel.vdmCurvaturePlace(layout, curvature));
    const double found =
      kernel.vdmPoint(layout, std::sin(polar), std::cos(polar), curvature, stored).Offset;
    errors.push_back(std::abs(found - offset) * Size);
  }
  if (errors.size() < 20)
  {
    std::printf(" %15s", "-");
    return;
  }
  std::sort(errors.begin(), errors.end());
  std::printf(" %7.3f/%7.2f", errors[errors.size() / 2], errors[errors.size() * 95 / 100]);
}

constexpr double Polars[] = { 10., 30., 50., 70., 80., 85. };

void MeasureOver(const Table& table, const Truth& truth, double curvature)
{
  for (const double polar : Polars)
  {
    Measure(table, truth, polar * Pi / 180., curvature);
  }
  std::printf("\n");
}
}

int main(int argc, char* argv[])
{
  const std::string pattern = argc > 1 ? argv[1] : "brick";
  const double depth = argc > 2 ? std::atof(argv[2]) : 0.1;
  vtkNew<vtkMesoPatternSource> source;
  source->SetPattern(pattern.c_str());
  source->SetSize(Size, Size);
  source->Update();
  vtkImageData* map = source->GetOutput();
  const Truth truth(map, depth);
  std::printf("%s, %g tiles deep: median/95th percentile, texels of 128, at polar angles\n",
    pattern.c_str(), depth);
  for (const double polar : Polars)
  {
    std::printf(" %15g", polar);
  }
  std::printf("\n");
  const auto bake = [&](const MesoVDMLayout& layout, int rank, int bits, MesoVDMCurved curved)
  {
    vtkNew<vtkMesoVDM> filter;
    filter->SetInputData(map);
    filter->SetLayout(layout);
    filter->SetRanks(rank, rank);
    filter->SetBits(bits);
    filter->SetCurved(curved);
    filter->Update();
    vtkSmartPointer<vtkImageData> image = filter->GetOutput();
    return image;
  };
  const char* const nodeNames[] = { "edges", "centres", "graded" };
  const char* const storeNames[] = { "distance", "depth", "offset" };
  MesoVDMLayout layout;
  layout.Depth = depth;
  for (const double curvature : { -1., 0., 1.5 })
  {
    for (int nodes = 0; nodes < 3; ++nodes)
    {
      for (int stores = 0; stores < 3; ++stores)
      {
        MesoVDMLayout one = layout;
        one.Curvatures = 1;
        one.FirstCurvature = one.LastCurvature = curvature;
        one.Nodes = static_cast<MesoVDMNodes>(nodes);
        one.Stores = static_cast<MesoVDMStores>(stores);
        const auto image = bake(one, 0, 16, MesoVDMCurved::Exact);
        std::printf("c %4.1f %8s %8s", curvature, nodeNames[nodes], storeNames[stores]);
        MeasureOver(Table(image, 0), truth, curvature);
      }
    }
  }
  for (const auto curved : { MesoVDMCurved::Exact, MesoVDMCurved::Bent })
  {
    const auto image = bake(layout, 0, 16, curved);
    for (const double curvature : { -2., -1.5, -1., -0.5, 0., 0.5, 1., 1.5, 2., 2.5, 3. })
    {
      std::printf(
        "%s c %4.1f         ", curved == MesoVDMCurved::Exact ? "exact" : "bent ", curvature);
      MeasureOver(Table(image, 0), truth, curvature);
    }
  }
  for (const int bits : { 8, 16 })
  {
    const auto image = bake(layout, 16, bits, MesoVDMCurved::Exact);
    for (const int rank : { 2, 4, 8, 12, 16 })
    {
      std::printf("%2d bits rank %2d rms %.5f", bits, rank,
        image->GetFieldData()->GetArray("Errors")->GetTuple1(rank - 1) * layout.Range());
      MeasureOver(Table(image, rank), truth, 0.5);
    }
  }
  return 0;
}
