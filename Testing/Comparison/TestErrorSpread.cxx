// Means and percentiles of known errors.

#include "MesoErrorSpread.h"

#include <cmath>
#include <gtest/gtest.h>

TEST(ErrorSpread, OfZeroToAHundred)
{
  std::vector<double> errors;
  std::vector<std::size_t> pixels;
  for (int i = 0; i <= 100; ++i)
  {
    errors.push_back((37 * i) % 101); // each of 0 to 100 once, in another order
    pixels.push_back(1000 + i);
  }
  const MesoErrorSpread spread = MesoErrorSpread::Of(errors, pixels);
  EXPECT_EQ(spread.Count, 101u);
  EXPECT_DOUBLE_EQ(spread.Mean, 50.);
  EXPECT_DOUBLE_EQ(spread.Rms, std::sqrt(100. * 201. / 6.)); // of squares: n (n + 1) (2 n + 1) / 6
  EXPECT_DOUBLE_EQ(spread.P50, 50.);
  EXPECT_DOUBLE_EQ(spread.P95, 95.);
  EXPECT_DOUBLE_EQ(spread.P99, 99.);
  EXPECT_EQ(spread.Maximum, 100.);
  EXPECT_EQ(errors[spread.WorstPixel - 1000], 100.);
}

TEST(ErrorSpread, LiesBetweenNeighbours)
{
  EXPECT_DOUBLE_EQ(MesoPercentile({ 0., 10. }, 0.95), 9.5);
  EXPECT_DOUBLE_EQ(MesoPercentile({ 1., 2., 4. }, 0.75), 3.);
  EXPECT_DOUBLE_EQ(MesoPercentile({ 7. }, 0.99), 7.);
}

TEST(ErrorSpread, OfNothingIsNotKnown)
{
  const MesoErrorSpread spread = MesoErrorSpread::Of({}, {});
  EXPECT_EQ(spread.Count, 0u);
  EXPECT_TRUE(std::isnan(spread.Mean));
  EXPECT_TRUE(std::isnan(spread.Maximum));
}
