// The cells of a height map: their corners against an independent wrap of texels, and the ranges of
// blocks against all cells below.

#include "ReferenceWorld.h"

namespace
{
std::vector<float> RandomHeights(int count)
{
  RandomNumbers random(3);
  std::vector<float> heights(count);
  std::generate(
    heights.begin(), heights.end(), [&] { return static_cast<float>(random.In(0., 1.)); });
  return heights;
}

/// By walking: one texel at a time from 0.
int WalkedTexel(int texel, int size, MesoWrap wrap)
{
  int at = 0;
  int step = 1;
  for (int i = 0; i < std::abs(texel); ++i)
  {
    const int direction = texel > 0 ? 1 : -1;
    const int next = at + direction * step;
    if (next >= 0 && next < size)
    {
      at = next;
    }
    else if (wrap == MesoWrap::Repeat)
    {
      at = direction > 0 ? 0 : size - 1;
    }
    else if (wrap == MesoWrap::Mirror)
    {
      step = -step; // the edge's texel comes twice
    }
  }
  return at;
}

const MesoWrap AllWraps[] = { MesoWrap::Repeat, MesoWrap::Clamp, MesoWrap::Mirror };
}

TEST(HeightPyramid, WrapsTexels)
{
  for (MesoWrap wrap : AllWraps)
  {
    for (int size : { 1, 2, 5 })
    {
      const MesoHeightPyramid::Axis axis(size, wrap);
      for (int texel = -23; texel <= 23; ++texel)
      {
        EXPECT_EQ(axis.Wrapped(texel), WalkedTexel(texel, size, wrap))
          << MesoName(wrap) << " of " << size << " at " << texel;
      }
    }
  }
}

TEST(HeightPyramid, CellsFillTheLineOnce)
{
  for (MesoWrap wrap : AllWraps)
  {
    const MesoHeightPyramid::Axis axis(5, wrap);
    for (double x = -30.25; x < 30.; x += 0.5)
    {
      const std::int64_t tile = axis.TileOf(x);
      const int cell = axis.CellOf(tile, x);
      EXPECT_LE(axis.Low(tile, cell), x) << MesoName(wrap);
      EXPECT_GT(axis.High(tile, cell), x) << MesoName(wrap);
    }
  }
}

TEST(HeightPyramid, CornersAreTheMapsOwn)
{
  constexpr int Width = 7;
  constexpr int Height = 3;
  for (MesoWrap wrap : AllWraps)
  {
    const MesoHeightPyramid map(Width, Height, wrap, RandomHeights(Width * Height));
    for (double x = -16.75; x < 20.; x += 0.5)
    {
      for (double y = -8.75; y < 9.; y += 0.5)
      {
        const std::int64_t tileX = map.X().TileOf(x);
        const std::int64_t tileY = map.Y().TileOf(y);
        const int i = map.X().CellOf(tileX, x);
        const int j = map.Y().CellOf(tileY, y);
        const auto h = map.Corners(i, j);
        const double a = x - std::floor(x);
        const double b = y - std::floor(y);
        const double bilinear =
          (1. - b) * ((1. - a) * h[0] + a * h[1]) + b * ((1. - a) * h[2] + a * h[3]);
        EXPECT_NEAR(bilinear, map.HeightAt((x + 0.5) / Width, (y + 0.5) / Height), 1e-12)
          << MesoName(wrap) << " at " << x << ", " << y;
      }
    }
  }
}

TEST(HeightPyramid, RangesAreThoseOfTheCells)
{
  for (MesoWrap wrap : AllWraps)
  {
    const MesoHeightPyramid map(13, 6, wrap, RandomHeights(13 * 6));
    for (int level = 0; level <= map.TopLevel(); ++level)
    {
      for (int j = 0; j <= (map.Y().Cells() - 1) >> level; ++j)
      {
        for (int i = 0; i <= (map.X().Cells() - 1) >> level; ++i)
        {
          double low = 1.;
          double high = 0.;
          for (int row = j << level; row < std::min((j + 1) << level, map.Y().Cells()); ++row)
          {
            for (int cell = i << level; cell < std::min((i + 1) << level, map.X().Cells()); ++cell)
            {
              const auto corners = map.Corners(cell, row);
              low = std::min(low, *std::min_element(corners.begin(), corners.end()));
              high = std::max(high, *std::max_element(corners.begin(), corners.end()));
            }
          }
          const auto range = map.RangeOf(level, i, j);
          EXPECT_EQ(static_cast<double>(range.Low), low) << level << ": " << i << ", " << j;
          EXPECT_EQ(static_cast<double>(range.High), high) << level << ": " << i << ", " << j;
        }
      }
    }
    EXPECT_EQ((map.X().Cells() - 1) >> map.TopLevel(), 0);
    EXPECT_EQ((map.Y().Cells() - 1) >> map.TopLevel(), 0);
  }
}
