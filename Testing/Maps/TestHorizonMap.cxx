// Horizons of height maps: walls in closed form, tiny maps by brute force, ambient occlusion.

#include "vtkMesoHorizonMap.h"

#include "MadeMap.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace
{
const double twoPi = 2. * vtkMath::Pi();

double AngleAt(vtkMesoHorizonMap* filter, int column, int row, int azimuth)
{
  vtkImageData* output = filter->GetOutput();
  return output->GetPointData()->GetScalars("Horizon")->GetComponent(
    vtkIdType(row) * output->GetDimensions()[0] + column, azimuth);
}

double AmbientAt(vtkMesoHorizonMap* filter, int column, int row)
{
  vtkImageData* output = filter->GetOutput();
  return output->GetPointData()
    ->GetArray("AmbientOcclusion")
    ->GetComponent(vtkIdType(row) * output->GetDimensions()[0] + column, 0);
}

/// Bilinear heights of a map that repeats, texel centres at integers.
double HeightAt(vtkImageData* map, double x, double y)
{
  const int* size = map->GetDimensions();
  const double i = std::floor(x);
  const double j = std::floor(y);
  const auto at = [&](double column, double row)
  {
    const int c = static_cast<int>(column - size[0] * std::floor(column / size[0]));
    const int r = static_cast<int>(row - size[1] * std::floor(row / size[1]));
    return map->GetScalarComponentAsDouble(c, r, 0, 0);
  };
  return (1. - (y - j)) * ((1. - (x - i)) * at(i, j) + (x - i) * at(i + 1., j)) +
    (y - j) * ((1. - (x - i)) * at(i, j + 1.) + (x - i) * at(i + 1., j + 1.));
}

/// The horizon by looking at each of many points along the direction.
double BruteForce(
  vtkImageData* map, int column, int row, double azimuth, double scale, double reach)
{
  const int* size = map->GetDimensions();
  const double own = HeightAt(map, column, row);
  const int steps = static_cast<int>(reach * 40 * std::max(size[0], size[1]));
  double slope = 0.;
  for (int k = 1; k <= steps; ++k)
  {
    const double t = reach * k / steps;
    const double height = HeightAt(
      map, column + t * std::cos(azimuth) * size[0], row + t * std::sin(azimuth) * size[1]);
    slope = std::max(slope, (height - own) / t);
  }
  return std::atan(scale * slope);
}
}

TEST(HorizonMap, OfAWallIsTheClosedForm)
{
  // Low for 24 columns, high for 8, which repeats: from column i the wall on the right begins at the
  // centre of column 24, that on the left at the centre of column -1.
  constexpr int width = 32;
  vtkNew<vtkMesoHorizonMap> filter;
  filter->SetInputData(MakeMap(width, 16, [](int column, int) { return column < 24 ? 0. : 1.; }));
  filter->SetAzimuths(16);
  filter->SetScale(0.2);
  filter->Update();
  for (int column = 0; column < width; ++column)
  {
    for (int k = 0; k < 16; ++k)
    {
      const double cosine = std::cos(twoPi * k / 16.);
      double expected = 0.;
      if (column < 24 && std::abs(cosine) > 1e-6)
      {
        const double tiles = (cosine > 0. ? 24 - column : column + 1) / std::abs(cosine) / width;
        expected = std::atan(0.2 / tiles);
        if (tiles > 2.)
        {
          continue; // out of reach
        }
      }
      // Where lines run along the wall rather than across it, a texel has the mean of two that lie up to
      // a texel nearer to it and further off.
      const bool across = std::abs(cosine) * width >= std::abs(std::sin(twoPi * k / 16.)) * 16.;
      if (!across && (column < 4 || column > 19))
      {
        continue;
      }
      EXPECT_NEAR(AngleAt(filter, column, 5, k), expected, across ? 1e-6 : 3e-3)
        << column << " " << k;
    }
  }
}

TEST(HorizonMap, OfTinyMapsIsThatOfBruteForce)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(0., 1.);
  struct Case
  {
    const char* Name;
    vtkSmartPointer<vtkImageData> Map;
    double AlongLines; ///< most degrees off, where lines go through texel centres
    double Between;    ///< mean degrees off, where they do not
  };
  const Case cases[] = {
    { "smooth",
      MakeMap(32, 32,
        [&](int i, int j)
        {
          return 0.5 + 0.3 * std::cos(twoPi * (i + 0.5) / 32) +
            0.2 * std::sin(2. * twoPi * (j + 0.5) / 32);
        }),
      0.01, 0.3 },
    // As rough as can be: patches twist by up to 2, of which a 32nd may rise above the samples, and a texel
    // aside is another world.
    { "random", MakeMap(16, 16, [&](int, int) { return uniform(random); }), 6., 10. },
    { "spike", MakeMap(16, 16, [&](int i, int j) { return i == 5 && j == 9 ? 1. : 0.; }), 0.6,
      1.5 },
  };
  for (const Case& example : cases)
  {
    const int size = example.Map->GetDimensions()[0];
    vtkNew<vtkMesoHorizonMap> filter;
    filter->SetInputData(example.Map);
    filter->SetAzimuths(16);
    filter->SetScale(0.2);
    filter->SetReach(2.);
    filter->Update();
    double onLines = 0.;
    double between = 0.;
    int count = 0;
    for (int k = 0; k < 16; ++k)
    {
      for (int row = 0; row < size; row += 3)
      {
        for (int column = 0; column < size; ++column)
        {
          const double off = vtkMath::DegreesFromRadians(std::abs(AngleAt(filter, column, row, k) -
            BruteForce(example.Map, column, row, twoPi * k / 16, 0.2, 2.)));
          if (k % 2 == 0)
          {
            onLines = std::max(onLines, off);
          }
          else
          {
            between += off;
            ++count;
          }
        }
      }
    }
    std::cout << example.Name << ": on lines " << onLines << ", between " << between / count
              << " degrees\n";
    EXPECT_LT(onLines, example.AlongLines) << example.Name;
    EXPECT_LT(between / count, example.Between) << example.Name;
  }
}

TEST(HorizonMap, IsTheSameWhicheverWayTheMapIsTurned)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0., 1.);
  std::vector<double> values(12 * 20);
  std::generate(values.begin(), values.end(), [&]() { return uniform(random); });
  vtkNew<vtkMesoHorizonMap> straight;
  straight->SetInputData(MakeMap(12, 20, [&](int i, int j) { return values[12 * j + i]; }));
  straight->SetAzimuths(12);
  straight->Update();
  // Transposed: azimuth k, at 30 k degrees, is that at 90 - 30 k.
  vtkNew<vtkMesoHorizonMap> turned;
  turned->SetInputData(MakeMap(20, 12, [&](int i, int j) { return values[12 * i + j]; }));
  turned->SetAzimuths(12);
  turned->Update();
  for (int k = 0; k < 12; ++k)
  {
    for (int j = 0; j < 20; ++j)
    {
      for (int i = 0; i < 12; ++i)
      {
        EXPECT_NEAR(AngleAt(straight, i, j, k), AngleAt(turned, j, i, (15 - k) % 12), 1e-5);
      }
    }
  }
}

TEST(HorizonMap, WrapsAsItIsTold)
{
  // A single wall at the right border: what is left of it sees it; beyond the left border it is there
  // once more where the map repeats.
  const auto map = MakeMap(16, 4, [](int column, int) { return column == 15 ? 1. : 0.; });
  for (const MesoWrap wrap : { MesoWrap::Repeat, MesoWrap::Clamp, MesoWrap::Mirror })
  {
    vtkNew<vtkMesoHorizonMap> filter;
    filter->SetInputData(map);
    filter->SetAzimuths(4);
    filter->SetScale(0.1);
    filter->SetWrap(wrap);
    filter->Update();
    EXPECT_NEAR(AngleAt(filter, 5, 1, 0), std::atan(0.1 * 16. / 10.), 1e-6);
    const double behind = wrap == MesoWrap::Repeat ? 6. : 21.; // mirrored: at -16, from 5
    EXPECT_NEAR(
      AngleAt(filter, 5, 1, 2), wrap == MesoWrap::Clamp ? 0. : std::atan(0.1 * 16. / behind), 1e-6);
  }
}

TEST(HorizonMap, OcclusionOfTheSkyIsThatOfWallsAndOfThePlane)
{
  vtkNew<vtkMesoHorizonMap> filter;
  filter->SetInputData(MakeMap(8, 8, [](int, int) { return 0.3; }));
  filter->Update();
  EXPECT_EQ(AmbientAt(filter, 3, 4), 1.f);
  // A trench without end: each wall takes (1 - cos e) / 2 of the sky's light, e being its elevation
  // straight across. The sum over azimuths is within 1e-3 of the integral for 128 of them.
  constexpr int width = 64;
  filter->SetInputData(
    MakeMap(width, 2, [](int column, int) { return column > 0 && column < 22 ? 0. : 1.; }));
  filter->SetAzimuths(128);
  filter->SetScale(0.3);
  filter->SetReach(16.);
  filter->Update();
  for (const int column : { 1, 6, 11, 20 })
  {
    const double left = std::atan(0.3 * width / double(column));
    const double right = std::atan(0.3 * width / double(22 - column));
    EXPECT_NEAR(AmbientAt(filter, column, 0),
      1. - (1. - std::cos(left)) / 2. - (1. - std::cos(right)) / 2., 2e-3)
      << column;
  }
}
