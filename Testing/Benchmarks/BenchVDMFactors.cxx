// What the factors of tables of view-dependent displacements leave, over the ways to write the table as a
// matrix, what stands in it where a ray meets nothing, and the bits of a weight. By itself, without a window:
//
//   BenchVDMFactors arrangements|misses|bits [PATTERN [DEPTH]]
//
// prints a table of comma-separated values, with
//
//   bytes   of weights and functions
//   rms     of the distances that rays meet, in tiles, over the whole table
//   degree  root mean square of the largest polar angle over convex bases
//   NN      of where 1000 random rays at NN degrees meet the relief, median and 95th percentile, in texels

#include "MesoTableFactors.h"
#include "VDMBench.h"
#include "vtkDataArray.h"
#include "vtkMesoVDM.h"
#include "vtkSMPTools.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <numeric>

namespace
{
using namespace VDMBench;

/// A whole table: of each row the distances, then what the largest angles leave to 90 degrees, both as
/// they are factored.
struct Numbers
{
  MesoVDMLayout Layout;
  std::vector<float> Values; ///< what is factored
  std::vector<float>
    Distance; ///< what stands for the distances rays meet, negative where they meet none
  double AngleScale = 1.; ///< of the largest angles

  double AngleAt(std::size_t row, int curvature) const
  {
    const double left =
      this->Values[row * this->Layout.Columns() + this->Layout.DistanceColumns() + curvature];
    return 90. * (1. - left / this->AngleScale);
  }
};

enum class Missed
{
  Point, ///< the point at the largest angle
  Angle, ///< the largest angle, in radians, among lengths in tiles
  Number ///< -1 tile
};

double RootMeanSquare(const Numbers& numbers, int first, int end)
{
  double sum = 0.;
  const int columns = numbers.Layout.Columns();
  for (std::size_t row = 0; row < numbers.Layout.Rows(); ++row)
  {
    for (int i = first; i < end; ++i)
    {
      const double value = numbers.Values[row * columns + i];
      sum += value * value;
    }
  }
  return std::sqrt(sum / (double(numbers.Layout.Rows()) * (end - first)));
}

Numbers Bake(vtkImageData* map, const MesoVDMLayout& layout, Missed missed)
{
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(map);
  filter->SetLayout(layout);
  filter->SetRanks(0, 0);
  filter->Update();
  vtkPointData* data = filter->GetOutput()->GetPointData();
  vtkDataArray* vdm = data->GetArray("VDM");
  vtkDataArray* mvm = data->GetArray("MVM");
  Numbers numbers;
  numbers.Layout = layout;
  const int columns = layout.Columns();
  numbers.Values.resize(layout.Rows() * columns);
  numbers.Distance.resize(layout.Rows() * layout.DistanceColumns());
  std::vector<double> polars(layout.Polars);
  for (int i = 0; i < layout.Polars; ++i)
  {
    polars[i] = layout.RayPolarAt(i);
  }
  for (std::size_t row = 0; row < layout.Rows(); ++row)
  {
    const auto tuple = static_cast<vtkIdType>(row);
    float* values = &numbers.Values[row * columns];
    float* distance = &numbers.Distance[row * layout.DistanceColumns()];
    for (int i = 0; i < layout.DistanceColumns(); ++i)
    {
      const double largest = mvm->GetComponent(tuple, i / layout.Polars) / 65535. * Pi / 2.;
      values[i] = static_cast<float>(vdm->GetComponent(tuple, i) / 65535.);
      const bool meets = polars[i % layout.Polars] <= largest + 1e-4;
      distance[i] = meets ? values[i] : -1.f;
      if (!meets && missed != Missed::Point)
      {
        values[i] = static_cast<float>((missed == Missed::Angle ? largest : -1.) / layout.Range());
      }
    }
    for (int i = 0; i < layout.Curvatures; ++i)
    {
      values[layout.DistanceColumns() + i] =
        static_cast<float>(1. - mvm->GetComponent(tuple, i) / 65535.);
    }
  }
  const double ofDistances = RootMeanSquare(numbers, 0, layout.DistanceColumns());
  const double ofAngles = RootMeanSquare(numbers, layout.DistanceColumns(), columns);
  numbers.AngleScale = ofAngles > 0. ? ofDistances / ofAngles : 1.;
  for (std::size_t i = 0; i < numbers.Values.size(); ++i)
  {
    if (static_cast<int>(i % columns) >= layout.DistanceColumns())
    {
      numbers.Values[i] *= static_cast<float>(numbers.AngleScale);
    }
  }
  return numbers;
}

/// A way to write a table as a matrix.
struct Arrangement
{
  const char* Rows;
  const char* Columns;
  std::size_t RowCount;
  std::size_t ColumnCount;
  /// Of a place of the table.
  std::function<std::array<std::size_t, 2>(std::size_t row, int column)> PlaceOf;
};

std::vector<Arrangement> Arrangements(const MesoVDMLayout& layout)
{
  const std::size_t area = std::size_t(layout.Width) * layout.Height;
  const std::size_t polars = layout.Polars;
  const std::size_t curvatures = layout.Curvatures;
  const std::size_t distances = layout.DistanceColumns();
  const std::size_t all = layout.Columns();
  return {
    { "x y phi", "theta c", layout.Rows(), all,
      [](std::size_t row, int column) {
        return std::array<std::size_t, 2>{ row, std::size_t(column) };
      } },
    { "x y phi c", "theta", layout.Rows() * curvatures, polars + 1,
      [=](std::size_t row, int column)
      {
        const std::size_t i = column;
        return i < distances
          ? std::array<std::size_t, 2>{ row * curvatures + i / polars, i % polars }
          : std::array<std::size_t, 2>{ row * curvatures + i - distances, polars };
      } },
    { "x y phi theta", "c", layout.Rows() * (polars + 1), curvatures,
      [=](std::size_t row, int column)
      {
        const std::size_t i = column;
        return i < distances
          ? std::array<std::size_t, 2>{ row * (polars + 1) + i % polars, i / polars }
          : std::array<std::size_t, 2>{ row * (polars + 1) + polars, i - distances };
      } },
    { "x y", "phi theta c", area, layout.Azimuths * all,
      [=](std::size_t row, int column) {
        return std::array<std::size_t, 2>{ row % area, row / area * all + std::size_t(column) };
      } },
  };
}

enum class Coding
{
  Byte,
  Half,
  Short,
  Float
};

constexpr const char* CodingNames[] = { "8", "half", "16", "float" };
constexpr std::size_t CodingBytes[] = { 1, 2, 2, 4 };

/// To the nearest number of 11 significant bits and 5 of the exponent.
float AsHalf(float value)
{
  constexpr int Bits = 11;
  constexpr int LeastExponent = -13; // below it numbers lie evenly
  int exponent = 0;
  std::frexp(value, &exponent);
  exponent = std::max(exponent, LeastExponent);
  return std::ldexp(std::nearbyint(std::ldexp(value, Bits - exponent)), exponent - Bits);
}

/// The factors of a table in one arrangement.
class Factors
{
public:
  Factors(const Numbers& numbers, const Arrangement& arrangement, int rank)
    : PlaceOf(arrangement.PlaceOf)
  {
    const std::size_t columns = numbers.Layout.Columns();
    std::vector<float> matrix(arrangement.RowCount * arrangement.ColumnCount);
    for (std::size_t i = 0; i < numbers.Values.size(); ++i)
    {
      const auto place = this->PlaceOf(i / columns, static_cast<int>(i % columns));
      matrix[place[0] * arrangement.ColumnCount + place[1]] = numbers.Values[i];
    }
    this->Table.Compute(matrix.data(), arrangement.RowCount, arrangement.ColumnCount, rank);
    this->Stride = this->Table.GetRank();
    this->Code(Coding::Byte);
  }

  int GetRank() const { return static_cast<int>(this->Stride); }

  /// Weights as so many bits hold them, each factor's from its least to its largest.
  void Code(Coding coding)
  {
    this->Weights = this->Table.GetWeights();
    const double largest = coding == Coding::Byte ? 255. : 65535.;
    for (std::size_t i = 0; i < this->Stride && coding != Coding::Float; ++i)
    {
      float low = std::numeric_limits<float>::max();
      float high = std::numeric_limits<float>::lowest();
      for (std::size_t k = i; k < this->Weights.size(); k += this->Stride)
      {
        low = std::min(low, this->Weights[k]);
        high = std::max(high, this->Weights[k]);
      }
      const double width = high > low ? double(high) - low : 1.;
      for (std::size_t k = i; k < this->Weights.size(); k += this->Stride)
      {
        float& weight = this->Weights[k];
        weight = coding == Coding::Half
          ? AsHalf(weight)
          : static_cast<float>(
              low + std::nearbyint((weight - low) / width * largest) / largest * width);
      }
    }
  }

  double At(std::size_t row, int column, int rank) const
  {
    const auto place = this->PlaceOf(row, column);
    const float* weights = &this->Weights[place[0] * this->Stride];
    const float* functions = &this->Table.GetEigenFunctions()[place[1] * this->Stride];
    return std::inner_product(weights, weights + rank, functions, 0.);
  }

private:
  std::function<std::array<std::size_t, 2>(std::size_t, int)> PlaceOf;
  MesoTableFactors Table;
  std::vector<float> Weights;
  std::size_t Stride = 0;
};

/// Prints rms, degree and the spreads of a rank's factors: every third row is looked at.
void PrintErrors(const Numbers& numbers, const Factors& factors, const std::array<int, 2>& ranks,
  const Truth& truth, double curvature)
{
  constexpr std::size_t Apart = 3;
  const MesoVDMLayout& layout = numbers.Layout;
  const int distances = layout.DistanceColumns();
  struct Sums
  {
    double Square = 0.;
    double Met = 0.;
    double Angle = 0.;
    double Count = 0.;
  };
  const auto angle = [&](std::size_t row, int k)
  {
    const double left = factors.At(row, distances + k, ranks[1]) / numbers.AngleScale;
    return 90. * (1. - std::min(std::max(left, 0.), 1.));
  };
  std::vector<Sums> parts(layout.Azimuths);
  const std::size_t area = layout.Rows() / layout.Azimuths;
  vtkSMPTools::For(0, layout.Azimuths, 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType part = begin; part < end; ++part)
      {
        Sums& sums = parts[part];
        for (std::size_t row = part * area; row < (part + 1) * area; row += Apart)
        {
          for (int i = 0; i < distances; ++i)
          {
            const double exact = numbers.Distance[row * distances + i];
            if (exact >= 0.)
            {
              const double off = factors.At(row, i, ranks[0]) - exact;
              sums.Square += off * off;
              sums.Met += 1.;
            }
          }
          for (int k = 0; k < layout.Curvatures; ++k)
          {
            if (layout.CurvatureAt(k) > 1e-9)
            {
              const double off = angle(row, k) - numbers.AngleAt(row, k);
              sums.Angle += off * off;
              sums.Count += 1.;
            }
          }
        }
      }
    });
  Sums all;
  for (const Sums& part : parts)
  {
    all.Square += part.Square;
    all.Met += part.Met;
    all.Angle += part.Angle;
    all.Count += part.Count;
  }
  std::printf(",%.5f,%.2f", std::sqrt(all.Square / all.Met) * layout.Range(),
    std::sqrt(all.Angle / all.Count));
  const Table table(
    layout, [&](std::size_t row, int column) { return factors.At(row, column, ranks[0]); });
  for (const double polar : { 30., 50., 70. })
  {
    const Spread spread = Measure(table, truth, polar * Pi / 180., curvature);
    std::printf(",%.3f,%.2f", spread.Median, spread.Most);
  }
  std::printf("\n");
  std::fflush(stdout);
}

constexpr const char* ErrorNames = "rms,degree,30 median,30 p95,50 median,50 p95,70 median,70 p95";

/// Ranks at which errors are looked at, up to a largest.
std::vector<int> RanksUpTo(int largest)
{
  std::vector<int> ranks;
  for (const int rank : { 1, 2, 4, 8, 12, 16, 32, 64 })
  {
    if (rank < largest)
    {
      ranks.push_back(rank);
    }
  }
  ranks.push_back(largest);
  return ranks;
}

void CompareArrangements(vtkImageData* map, const Truth& truth, const MesoVDMLayout& layout)
{
  constexpr int MostRank = 16;
  constexpr int MostOfManyColumns = 64;
  const Numbers numbers = Bake(map, layout, Missed::Point);
  std::printf("rows,columns,rank,bytes,%s\n", ErrorNames);
  for (const Arrangement& arrangement : Arrangements(layout))
  {
    const int most = arrangement.ColumnCount > std::size_t(layout.Columns())
      ? MostOfManyColumns
      : std::min(MostRank, static_cast<int>(arrangement.ColumnCount));
    const Factors factors(numbers, arrangement, most);
    for (const int rank : RanksUpTo(most))
    {
      const std::size_t bytes =
        rank * (arrangement.RowCount + arrangement.ColumnCount * sizeof(float));
      std::printf("%s,%s,%d,%zu", arrangement.Rows, arrangement.Columns, rank, bytes);
      PrintErrors(numbers, factors, { rank, rank }, truth, 0.5);
    }
  }
}

void CompareMisses(vtkImageData* map, const Truth& truth, const MesoVDMLayout& layout)
{
  std::printf("stored,missed,ranks,%s\n", ErrorNames);
  for (const auto stores : { MesoVDMStores::Depth, MesoVDMStores::Distance })
  {
    MesoVDMLayout one = layout;
    one.Stores = stores;
    for (const auto missed : { Missed::Point, Missed::Angle, Missed::Number })
    {
      const char* const names[] = { "point", "angle", "-1" };
      const Numbers numbers = Bake(map, one, missed);
      const Factors factors(numbers, Arrangements(one).front(), 12);
      for (const std::array<int, 2>& ranks : { std::array<int, 2>{ 8, 4 }, { 12, 12 } })
      {
        std::printf("%s,%s,%d + %d", stores == MesoVDMStores::Depth ? "h" : "d",
          names[static_cast<int>(missed)], ranks[0], ranks[1]);
        PrintErrors(numbers, factors, ranks, truth, 2.);
      }
    }
  }
}

void CompareBits(vtkImageData* map, const Truth& truth, const MesoVDMLayout& layout)
{
  const Numbers numbers = Bake(map, layout, Missed::Point);
  const Arrangement arrangement = Arrangements(layout).front();
  Factors factors(numbers, arrangement, 16);
  std::printf("bits,rank,bytes,%s\n", ErrorNames);
  for (const auto coding : { Coding::Byte, Coding::Half, Coding::Short, Coding::Float })
  {
    factors.Code(coding);
    for (const int rank : { 4, 8, 12, 16 })
    {
      std::printf("%s,%d,%zu", CodingNames[static_cast<int>(coding)], rank,
        rank *
          (arrangement.RowCount * CodingBytes[static_cast<int>(coding)] +
            arrangement.ColumnCount * sizeof(float)));
      PrintErrors(numbers, factors, { rank, rank }, truth, 0.5);
    }
  }
}
}

int main(int argc, char* argv[])
{
  const std::string what = argc > 1 ? argv[1] : "";
  MesoVDMLayout layout;
  layout.Depth = argc > 3 ? std::atof(argv[3]) : 0.1;
  const vtkSmartPointer<vtkImageData> map = MapOf(argc > 2 ? argv[2] : "brick");
  const Truth truth(map, layout.Depth);
  if (what == "arrangements")
  {
    CompareArrangements(map, truth, layout);
  }
  else if (what == "misses")
  {
    CompareMisses(map, truth, layout);
  }
  else if (what == "bits")
  {
    CompareBits(map, truth, layout);
  }
  else
  {
    std::fprintf(stderr, "usage: BenchVDMFactors arrangements|misses|bits [PATTERN [DEPTH]]\n");
    return 2;
  }
  return 0;
}
