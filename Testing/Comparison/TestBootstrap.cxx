// Intervals of medians: where they must lie, and that they are the same in every run.

#include "MesoBootstrap.h"

#include <gtest/gtest.h>
#include <random>

TEST(Bootstrap, EqualValuesAreSure)
{
  const auto interval = MesoMedianInterval({ 3., 3., 3., 3. });
  ASSERT_TRUE(interval);
  EXPECT_EQ(interval->Low, 3.);
  EXPECT_EQ(interval->High, 3.);
  EXPECT_FALSE(MesoMedianInterval({}));
}

TEST(Bootstrap, HoldsTheMedianOfWhatTheValuesWereDrawnFrom)
{
  // Of 95 % intervals of 21 values from a known distribution, most hold its median.
  std::mt19937 generator(3);
  std::normal_distribution<double> normal(10., 2.);
  int held = 0;
  double width = 0.;
  constexpr int Runs = 200;
  for (int run = 0; run < Runs; ++run)
  {
    std::vector<double> values(21);
    for (double& value : values)
    {
      value = normal(generator);
    }
    const auto interval = MesoMedianInterval(values);
    ASSERT_TRUE(interval);
    EXPECT_LT(interval->Low, interval->High);
    held += interval->Low <= 10. && interval->High >= 10. ? 1 : 0;
    width += (interval->High - interval->Low) / Runs;
  }
  EXPECT_GT(held, Runs * 88 / 100);
  EXPECT_LT(held, Runs);
  // A median of n normal values has a deviation of 1.25 / sqrt(n); 95 % are 3.9 of those.
  EXPECT_NEAR(width, 3.92 * 1.2533 * 2. / std::sqrt(21.), 0.4);
}

TEST(Bootstrap, SlowRoundsCancelInRatios)
{
  // Rounds differ by up to a factor of 3, value and floor together.
  std::vector<double> values;
  std::vector<double> floor;
  for (const double load : { 1., 3., 2., 1.5, 2.5, 1.2, 2.8 })
  {
    values.push_back(8. * load);
    floor.push_back(2. * load);
  }
  const auto ratio = MesoRatioInterval(values, floor);
  ASSERT_TRUE(ratio);
  EXPECT_DOUBLE_EQ(ratio->Low, 4.);
  EXPECT_DOUBLE_EQ(ratio->High, 4.);
  EXPECT_FALSE(MesoRatioInterval(values, { 1. }));
  EXPECT_FALSE(MesoRatioInterval({ 1., 2. }, { 0., 0. }));
}

TEST(Bootstrap, IsTheSameInEveryRun)
{
  const std::vector<double> values = { 5., 1., 4., 2., 8., 3. };
  EXPECT_EQ(MesoMedianInterval(values)->Low, MesoMedianInterval(values)->Low);
  EXPECT_EQ(MesoMedianInterval(values)->High, MesoMedianInterval(values)->High);
}
