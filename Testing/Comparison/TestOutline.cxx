// Outlines: shifted shapes whose distance is known, and all distances against a search through all.

#include "MesoOutline.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace
{
std::vector<bool> Cover(int width, int height, const std::function<bool(int, int)>& covered)
{
  std::vector<bool> coverage;
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      coverage.push_back(covered(column, row));
    }
  }
  return coverage;
}

std::function<bool(int, int)> Disc(double x, double y, double radius)
{
  return [=](int column, int row) { return std::hypot(column + 0.5 - x, row + 0.5 - y) < radius; };
}

using Point = std::pair<double, double>;

/// Middles of the sides between covered and uncovered pixels, found directly.
std::vector<Point> SidesOf(const std::vector<bool>& coverage, int width, int height)
{
  std::vector<Point> sides;
  for (int row = 0; row < height; ++row)
  {
    for (int column = 0; column < width; ++column)
    {
      const std::size_t at = std::size_t(row) * width + column;
      if (column + 1 < width && coverage[at] != coverage[at + 1])
      {
        sides.emplace_back(column + 1., row + 0.5);
      }
      if (row + 1 < height && coverage[at] != coverage[at + width])
      {
        sides.emplace_back(column + 0.5, row + 1.);
      }
    }
  }
  return sides;
}

double Nearest(const std::vector<Point>& sides, double x, double y)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point& side : sides)
  {
    nearest = std::min(nearest, std::hypot(side.first - x, side.second - y));
  }
  return nearest;
}
}

TEST(Outline, OfAShiftedEdgeIsAtTheShift)
{
  const auto edgeAt = [](int place)
  { return Cover(20, 10, [place](int column, int) { return column < place; }); };
  for (const int shift : { 0, 1, 3, 7 })
  {
    const auto distance =
      MesoOutline::Between(MesoOutline(edgeAt(8), 20, 10), MesoOutline(edgeAt(8 + shift), 20, 10));
    EXPECT_DOUBLE_EQ(distance.Mean, shift);
    EXPECT_DOUBLE_EQ(distance.Maximum, shift);
  }
}

TEST(Outline, OfAShiftedDiscIsAtMostAtTheShift)
{
  for (const int shift : { 1, 2, 5 })
  {
    const MesoOutline here(Cover(64, 64, Disc(30., 32., 20.)), 64, 64);
    const MesoOutline there(Cover(64, 64, Disc(30. + shift, 32., 20.)), 64, 64);
    const auto distance = MesoOutline::Between(here, there);
    // At the sides the whole shift, above and below nearly none: on a circle the mean of |cos|. The
    // staircase of a disc has 4 / pi times a circle's length, most of it on the slanted parts.
    EXPECT_DOUBLE_EQ(distance.Maximum, shift);
    EXPECT_NEAR(distance.Mean, 2. / 3.14159265 * shift, 0.15 * shift);
  }
}

TEST(Outline, OfAGrownSquareIsAtTheGrowth)
{
  const auto square = [](int half)
  {
    return Cover(40, 40,
      [half](int column, int row)
      { return std::max(std::abs(2 * column - 39), std::abs(2 * row - 39)) < 2 * half; });
  };
  const auto distance =
    MesoOutline::Between(MesoOutline(square(8), 40, 40), MesoOutline(square(10), 40, 40));
  // The outer corners' sides reach past the inner square: their middles lie 0.5 and 1.5 past its
  // last middle of a side.
  EXPECT_NEAR(distance.Maximum, std::hypot(2., 2.), 0.4);
  EXPECT_NEAR(distance.Mean, 2., 0.1);
}

TEST(Outline, HasTheDistancesThatASearchFinds)
{
  std::mt19937 random(5);
  for (int run = 0; run < 20; ++run)
  {
    const int width = 1 + static_cast<int>(random() % 17);
    const int height = 1 + static_cast<int>(random() % 13);
    const unsigned rarity = 2 + random() % 9;
    const auto coverage = Cover(width, height, [&](int, int) { return random() % rarity == 0; });
    const auto other = Cover(width, height, [&](int, int) { return random() % rarity == 0; });
    const MesoOutline outline(coverage, width, height);
    const auto sides = SidesOf(coverage, width, height);
    const auto otherSides = SidesOf(other, width, height);
    ASSERT_EQ(outline.Empty(), sides.empty());
    for (int row = 0; row < height; ++row)
    {
      for (int column = 0; column < width; ++column)
      {
        const double expected = Nearest(sides, column + 0.5, row + 0.5);
        if (std::isinf(expected))
        {
          ASSERT_TRUE(std::isinf(outline.DistanceOfPixel(column, row)));
          continue;
        }
        ASSERT_NEAR(outline.DistanceOfPixel(column, row), expected, 1e-12)
          << "run " << run << " at " << column << ", " << row;
      }
    }
    if (sides.empty() || otherSides.empty())
    {
      continue;
    }
    double sum = 0.;
    double most = 0.;
    for (const Point& side : sides)
    {
      sum += Nearest(otherSides, side.first, side.second);
      most = std::max(most, Nearest(otherSides, side.first, side.second));
    }
    for (const Point& side : otherSides)
    {
      sum += Nearest(sides, side.first, side.second);
      most = std::max(most, Nearest(sides, side.first, side.second));
    }
    const auto distance = MesoOutline::Between(outline, MesoOutline(other, width, height));
    EXPECT_NEAR(distance.Mean, sum / double(sides.size() + otherSides.size()), 1e-12);
    EXPECT_NEAR(distance.Maximum, most, 1e-12);
  }
}

TEST(Outline, ThatIsMissingHasNoDistance)
{
  const MesoOutline none(std::vector<bool>(12, true), 4, 3);
  const MesoOutline disc(Cover(4, 3, Disc(2., 1.5, 1.)), 4, 3);
  EXPECT_TRUE(none.Empty()) << "the picture's edge is no outline";
  EXPECT_EQ(MesoOutline::Between(none, none).Mean, 0.);
  EXPECT_TRUE(std::isnan(MesoOutline::Between(none, disc).Mean));
  EXPECT_TRUE(std::isnan(MesoOutline::Between(disc, none).Maximum));
}

TEST(Outline, PartsTouchAtCorners)
{
  // Two pixels that touch at a corner, and one alone.
  const std::vector<bool> set = { true, false, false, true, //
    false, true, false, false };
  std::vector<bool> reaches(8, false);
  std::vector<bool> marks;
  EXPECT_EQ(MesoCountUnreached(set, reaches, 4, 2, &marks), 3u);
  EXPECT_EQ(marks, set);
  reaches[0] = true;
  EXPECT_EQ(MesoCountUnreached(set, reaches, 4, 2, &marks), 1u);
  EXPECT_TRUE(marks[3]);
  EXPECT_FALSE(marks[5]);
  reaches[0] = false;
  reaches[1] = true; // no pixel of the set
  EXPECT_EQ(MesoCountUnreached(set, reaches, 4, 2), 3u);
}
