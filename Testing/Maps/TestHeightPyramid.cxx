// Levels of a height map's pyramid: their sizes, and each texel the mean of the area that it covers.

#include "MesoHeightPyramid.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace
{
/// The mean of a map of whole texels over a part of it, [0,1] along u and v, by their areas.
double MeanOver(const std::vector<float>& heights, int width, int height, const double (&u)[2],
  const double (&v)[2])
{
  double sum = 0.;
  for (int row = 0; row < height; ++row)
  {
    const double down =
      std::max(0., std::min(v[1], (row + 1.) / height) - std::max(v[0], double(row) / height));
    for (int column = 0; column < width; ++column)
    {
      const double across = std::max(
        0., std::min(u[1], (column + 1.) / width) - std::max(u[0], double(column) / width));
      sum += across * down * double(heights[std::size_t(row * width + column)]);
    }
  }
  return sum / ((u[1] - u[0]) * (v[1] - v[0]));
}

std::vector<float> RandomHeights(int width, int height)
{
  std::mt19937 generator(11);
  std::uniform_real_distribution<float> any(0.f, 1.f);
  std::vector<float> heights(std::size_t(width) * std::size_t(height));
  std::generate(heights.begin(), heights.end(), [&] { return any(generator); });
  return heights;
}
}

TEST(HeightPyramid, EachTexelIsTheMeanOfWhatItCovers)
{
  for (const auto& [width, height] : { std::pair(16, 16), std::pair(37, 23), std::pair(9, 64) })
  {
    std::vector<float> below = RandomHeights(width, height);
    int columns = width;
    int rows = height;
    for (const MesoHeightLevel& level : MesoMakeHeightPyramid(width, height, below.data()))
    {
      ASSERT_EQ(level.Width, columns / 2);
      ASSERT_EQ(level.Height, rows / 2);
      ASSERT_EQ(level.Heights.size(), std::size_t(level.Width) * std::size_t(level.Height));
      for (int row = 0; row < level.Height; ++row)
      {
        for (int column = 0; column < level.Width; ++column)
        {
          const double u[] = { double(column) / level.Width, (column + 1.) / level.Width };
          const double v[] = { double(row) / level.Height, (row + 1.) / level.Height };
          ASSERT_NEAR(double(level.Heights[std::size_t(row * level.Width + column)]),
            MeanOver(below, columns, rows, u, v), 1e-7)
            << width << " x " << height << ": " << level.Width << " x " << level.Height;
        }
      }
      columns = level.Width;
      rows = level.Height;
      below = level.Heights;
    }
    EXPECT_EQ(std::min(columns, rows), 1);
  }
}

TEST(HeightPyramid, AMapWithASideOfOneTexelHasNone)
{
  const std::vector<float> heights = RandomHeights(1, 9);
  EXPECT_TRUE(MesoMakeHeightPyramid(1, 9, heights.data()).empty());
  EXPECT_TRUE(MesoMakeHeightPyramid(9, 1, heights.data()).empty());
  EXPECT_TRUE(MesoMakeHeightPyramid(1, 1, heights.data()).empty());
}

TEST(HeightPyramid, SlopesAreStepsFromTexelToTexel)
{
  // A ramp along u that is flat along v: 8 texels of 1/10 each.
  std::vector<float> ramp;
  for (int i = 0; i < 8 * 3; ++i)
  {
    ramp.push_back(float(i % 8) * 0.1f);
  }
  EXPECT_NEAR(MesoSlopesOfMap(8, 3, ramp.data()).MeanSize[0], 7. / 8. * 0.8, 1e-6);
  EXPECT_EQ(MesoSlopesOfMap(8, 3, ramp.data()).MeanSize[1], 0.);
  const auto slopes = MesoSlopesOfMap(8, 3, ramp.data()).MeanSquare;
  EXPECT_NEAR(slopes[0], 7. / 8. * 0.8 * 0.8, 1e-6);
  EXPECT_EQ(slopes[1], 0.);
  EXPECT_EQ(MesoSlopesOfMap(1, 1, ramp.data()).MeanSquare, (std::array<double, 2>{ 0., 0. }));
  // Levels have ever less of them.
  const std::vector<float> noise = RandomHeights(64, 32);
  std::array<double, 2> before = MesoSlopesOfMap(64, 32, noise.data()).MeanSquare;
  for (const MesoHeightLevel& level : MesoMakeHeightPyramid(64, 32, noise.data()))
  {
    const auto left = MesoSlopesOfMap(level.Width, level.Height, level.Heights.data()).MeanSquare;
    EXPECT_LT(left[0], 0.7 * before[0]);
    EXPECT_LT(left[1], 0.7 * before[1]);
    before = left;
  }
}
