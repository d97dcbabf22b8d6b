// Which triangle lies under a texel, and what fills the texels that have none.

#include "MesoPushPull.h"
#include "MesoTexelCover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using Triangle = std::array<std::int64_t, 3>;
}

TEST(TexelCover, ASquareOfTwoTrianglesCoversEachTexelOnce)
{
  // The diagonal runs through texel centres.
  const std::vector<MesoTexturePoint> corners = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } };
  const std::vector<Triangle> triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const MesoTexelCover cover = MesoCoverTexels(corners, triangles, 8, 8);
  EXPECT_EQ(std::count(cover.Triangle.begin(), cover.Triangle.end(), -1), 0);
  EXPECT_EQ(cover.Overlapping, 0);
  EXPECT_EQ(cover.Triangle[7], 0);
  EXPECT_EQ(cover.Triangle[7 * 8], 1);
}

TEST(TexelCover, MirroredTrianglesCoverAndThoseWithoutAreaDoNot)
{
  const std::vector<MesoTexturePoint> corners = { { 0., 0. }, { 1., 0. }, { 0., 1. }, { 0.5, 0. } };
  const auto covered = [&](const Triangle& triangle)
  {
    const MesoTexelCover cover = MesoCoverTexels(corners, { triangle }, 16, 16);
    return std::count(cover.Triangle.begin(), cover.Triangle.end(), 0);
  };
  EXPECT_EQ(covered({ 0, 1, 2 }), 16 * 17 / 2);
  EXPECT_EQ(covered({ 0, 2, 1 }), 16 * 17 / 2);
  EXPECT_EQ(covered({ 0, 1, 3 }), 0);
  EXPECT_EQ(covered({ 0, 0, 0 }), 0);
}

TEST(TexelCover, CountsOverlapsAndKeepsTheFirst)
{
  const std::vector<MesoTexturePoint> corners = { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. } };
  const MesoTexelCover cover = MesoCoverTexels(corners, { { 0, 1, 3 }, { 0, 1, 2 } }, 10, 10);
  EXPECT_EQ(cover.Triangle[0], 0);
  EXPECT_EQ(cover.Triangle[9 + 9 * 10], 1);
  EXPECT_EQ(cover.Overlapping, 20); // a quarter of the square, its edges aside: 4 + 6 + ...
}

TEST(TexelCover, WeightsGiveThePointBack)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1., 1.);
  for (int trial = 0; trial < 1000; ++trial)
  {
    MesoTexturePoint corners[3];
    for (MesoTexturePoint& corner : corners)
    {
      corner = { number(random), number(random) };
    }
    const MesoTexturePoint point = { number(random), number(random) };
    const auto weights = MesoWeightsAt(corners[0], corners[1], corners[2], point);
    const double size = std::abs(weights[0]) + std::abs(weights[1]) + std::abs(weights[2]);
    for (int k = 0; k < 2; ++k)
    {
      EXPECT_NEAR(
        weights[0] * corners[0][k] + weights[1] * corners[1][k] + weights[2] * corners[2][k],
        point[k], 1e-13 * size);
    }
  }
}

TEST(PushPull, KeepsWhatIsKnownAndFillsWithIt)
{
  std::vector<float> values(7 * 5 * 2, -100.f);
  std::vector<bool> known(7 * 5, false);
  known[3] = true;
  values[6] = 0.25f;
  values[7] = 3.f;
  MesoPushPull(values, 2, known, 7, 5);
  for (std::size_t i = 0; i < known.size(); ++i)
  {
    EXPECT_FLOAT_EQ(values[2 * i], 0.25f);
    EXPECT_FLOAT_EQ(values[2 * i + 1], 3.f);
  }
}

TEST(PushPull, IsSmoothAndWithinTheKnownValues)
{
  // The left column is 0, the right one 1.
  const int size = 32;
  std::vector<float> values(size * size, 9.f);
  std::vector<bool> known(size * size, false);
  for (int row = 0; row < size; ++row)
  {
    known[row * size] = known[row * size + size - 1] = true;
    values[row * size] = 0.f;
    values[row * size + size - 1] = 1.f;
  }
  MesoPushPull(values, 1, known, size, size);
  for (int row = 0; row < size; ++row)
  {
    EXPECT_EQ(values[row * size], 0.f);
    EXPECT_EQ(values[row * size + size - 1], 1.f);
    for (int column = 1; column < size; ++column)
    {
      const float step = values[row * size + column] - values[row * size + column - 1];
      EXPECT_GE(step, -1e-6f);
      EXPECT_LT(step, 0.15f);
    }
  }
}

TEST(PushPull, LeavesAMapOfWhichNothingIsKnown)
{
  std::vector<float> values = { 1.f, 2.f, 3.f };
  MesoPushPull(values, 1, { false, false, false }, 3, 1);
  EXPECT_EQ(values, (std::vector<float>{ 1.f, 2.f, 3.f }));
}
