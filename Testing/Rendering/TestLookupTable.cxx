// Tables of colours hold the published colours, and ranges that suit an array ignore what is no number.

#include "MesoColorMap.h"
#include "MesoLookupTable.h"

#include "vtkDoubleArray.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <stdexcept>

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

std::array<double, 3> ColorOf(vtkLookupTable* table, double value)
{
  std::array<double, 3> color;
  table->GetColor(value, color.data());
  return color;
}

void ExpectColor(vtkLookupTable* table, double value, const std::array<double, 3>& expected)
{
  const auto color = ColorOf(table, value);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(color[k], expected[k], 0.6 / 255.) << "at " << value << ", channel " << k;
  }
}

/// Rec. 709 luma, near enough to lightness to tell whether it rises.
double Lightness(const std::array<double, 3>& color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

vtkSmartPointer<vtkDoubleArray> ArrayOf(const std::vector<std::array<double, 2>>& tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(2);
  for (const auto& tuple : tuples)
  {
    array->InsertNextTuple(tuple.data());
  }
  return array;
}

using Range = std::array<double, 2>;
}

TEST(LookupTable, ViridisIsThePublishedOne)
{
  const auto table = MesoMakeLookupTable("viridis", { -2., 3. });
  ASSERT_EQ(table->GetNumberOfTableValues(), 256);
  ExpectColor(table, -2., { 0.267004, 0.004874, 0.329415 });
  ExpectColor(table, 3., { 0.993248, 0.906157, 0.143936 });
  // Entries 128 and 77 of the published 256, of which every fifth is a control point.
  ExpectColor(table, -2. + 5. * 128.5 / 256., { 0.127568, 0.566949, 0.550556 });
  ExpectColor(table, -2. + 5. * 77.5 / 256., { 0.204903, 0.375746, 0.553533 });
  // Of neighbours, rounding to 8 bits hides which is lighter.
  for (int i = 4; i < 256; ++i)
  {
    EXPECT_GT(Lightness(ColorOf(table, -2. + 5. * (i + 0.5) / 256.)),
      Lightness(ColorOf(table, -2. + 5. * (i - 3.5) / 256.)))
      << i;
  }
}

TEST(LookupTable, CoolwarmIsNeutralInTheMiddle)
{
  const auto table = MesoMakeLookupTable("coolwarm", { -1., 1. });
  ExpectColor(table, -1., { 59. / 255., 76. / 255., 192. / 255. });
  ExpectColor(table, 1., { 180. / 255., 4. / 255., 38. / 255. });
  // The paper's middle is (221, 221, 221); 256 entries have none just in the middle.
  for (const double value : { -0.001, 0.001 })
  {
    for (const double channel : ColorOf(table, value))
    {
      EXPECT_NEAR(channel, 221. / 255., 2. / 255.);
    }
  }
  EXPECT_GT(ColorOf(table, -0.5)[2], ColorOf(table, -0.5)[0] + 0.2);
  EXPECT_GT(ColorOf(table, 0.5)[0], ColorOf(table, 0.5)[2] + 0.2);
}

TEST(LookupTable, EndsGoOnAndNaNIsMagenta)
{
  for (const std::string& name : MesoColorMapNames())
  {
    const auto table = MesoMakeLookupTable(name, { 1., 2. });
    EXPECT_EQ(ColorOf(table, -1e30), ColorOf(table, 1.)) << name;
    EXPECT_EQ(ColorOf(table, 1e30), ColorOf(table, 2.)) << name;
    EXPECT_EQ(ColorOf(table, NaN), (std::array<double, 3>{ 1., 0., 1. })) << name;
    for (int i = 0; i < 256; ++i)
    {
      const auto color = ColorOf(table, 1. + (i + 0.5) / 256.);
      EXPECT_GT(std::hypot(color[0] - 1., color[1], color[2] - 1.), 0.4) << name << " " << i;
    }
  }
  EXPECT_THROW(MesoMakeLookupTable("jet", { 0., 1. }), std::out_of_range);
}

TEST(LookupTable, RangesIgnoreWhatIsNoNumber)
{
  const auto array = ArrayOf({ { 3., 4. }, { -5., 12. }, { NaN, 1. }, { 0., Infinity } });
  EXPECT_EQ(MesoRangeOf(array, 0), (Range{ -5., 3. }));
  EXPECT_EQ(MesoRangeOf(array, 1), (Range{ 1., 12. }));
  EXPECT_EQ(MesoRangeOf(array, -1), (Range{ 5., 13. }));
  EXPECT_EQ(MesoRangeOf(ArrayOf({}), 0), (Range{ 0., 1. }));
  EXPECT_EQ(MesoRangeOf(ArrayOf({ { NaN, 0. } }), 0), (Range{ 0., 1. }));
}

TEST(LookupTable, ConstantArraysHaveTheMiddleColor)
{
  for (const double value : { 0., 1., -3e-9, 7e17 })
  {
    const Range range = MesoRangeOf(ArrayOf({ { value, 0. }, { value, 1. } }), 0);
    EXPECT_LT(range[0], value);
    EXPECT_GT(range[1], value);
    EXPECT_NEAR((value - range[0]) / (range[1] - range[0]), 0.5, 1e-9) << value;
  }
}

TEST(LookupTable, SymmetricRangesLeaveOutliersAndZerosOut)
{
  std::vector<std::array<double, 2>> tuples(500, { 0., 0. });
  for (int i = 1; i <= 101; ++i)
  {
    tuples.push_back({ i % 2 == 0 ? 0.01 * i : -0.01 * i, 0. });
  }
  tuples[500 + 100][0] = -1e6; // the 101st
  EXPECT_EQ(MesoSymmetricRangeOf(ArrayOf(tuples), 0), (Range{ -0.91, 0.91 }));
  EXPECT_EQ(MesoSymmetricRangeOf(ArrayOf(tuples), 1), (Range{ -1., 1. })); // nothing but 0
  EXPECT_EQ(MesoSymmetricRangeOf(ArrayOf({}), 0), (Range{ -1., 1. }));
  EXPECT_EQ(MesoSymmetricRangeOf(ArrayOf({ { -2., 0. }, { NaN, 0. } }), 0), (Range{ -2., 2. }));
}

TEST(LookupTable, TerrainGetsLighterWithHeight)
{
  const auto table = MesoMakeLookupTable("terrain", { 0., 1. });
  double before = -1.;
  for (int i = 0; i <= 100; ++i)
  {
    double color[3];
    table->GetColor(0.01 * i, color);
    const double light = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    EXPECT_GE(light, before) << i;
    before = light;
  }
  EXPECT_GT(before, 0.95);
}
