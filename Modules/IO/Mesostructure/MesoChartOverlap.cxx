#include "MesoChartOverlap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace
{
constexpr int Side = 512;
constexpr std::size_t MostSteps = 50000000;
// Places are off the middle of their cell by irrational parts, so that they hardly ever lie on an
// edge of charts made of grids, which both its triangles would count.
constexpr std::array<double, 2> Offset = { 0.41421356, 0.61803399 };

/// Columns (or rows) whose places lie between two numbers, first and one past the last.
std::array<int, 2> Between(double low, double high, double offset)
{
  const double first = std::ceil(low - offset);
  const double last = std::floor(high - offset);
  return { static_cast<int>(std::clamp(first, 0., double(Side))),
    static_cast<int>(std::clamp(last + 1., 0., double(Side))) };
}
}

double MesoTwiceArea(const MesoTextureTriangle& t)
{
  return (t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]);
}

std::optional<double> MesoChartOverlap(const std::vector<MesoTextureTriangle>& triangles)
{
  std::array<double, 2> least = { 0., 0. };
  std::array<double, 2> most = { 0., 0. };
  bool isFirst = true;
  for (const MesoTextureTriangle& triangle : triangles)
  {
    for (const auto& corner : triangle)
    {
      for (int k = 0; k < 2; ++k)
      {
        least[k] = isFirst ? corner[k] : std::min(least[k], corner[k]);
        most[k] = isFirst ? corner[k] : std::max(most[k], corner[k]);
      }
      isFirst = false;
    }
  }
  if (!(most[0] > least[0]) || !(most[1] > least[1]))
  {
    return 0.;
  }
  std::vector<std::uint8_t> cover(std::size_t(Side) * Side);
  std::size_t steps = 0;
  for (const MesoTextureTriangle& given : triangles)
  {
    MesoTextureTriangle triangle = given;
    for (auto& corner : triangle)
    {
      for (int k = 0; k < 2; ++k)
      {
        corner[k] = (corner[k] - least[k]) / (most[k] - least[k]) * Side;
      }
    }
    const auto [x0, x1, x2] = std::array{ triangle[0][0], triangle[1][0], triangle[2][0] };
    const auto [y0, y1, y2] = std::array{ triangle[0][1], triangle[1][1], triangle[2][1] };
    const auto columns = Between(std::min({ x0, x1, x2 }), std::max({ x0, x1, x2 }), Offset[0]);
    const auto rows = Between(std::min({ y0, y1, y2 }), std::max({ y0, y1, y2 }), Offset[1]);
    const double twice = MesoTwiceArea(triangle);
    for (int row = rows[0]; row < rows[1]; ++row)
    {
      for (int column = columns[0]; column < columns[1]; ++column)
      {
        if (++steps > MostSteps)
        {
          return std::nullopt;
        }
        const std::array<double, 2> place = { column + Offset[0], row + Offset[1] };
        const double a = MesoTwiceArea({ place, triangle[1], triangle[2] });
        const double b = MesoTwiceArea({ triangle[0], place, triangle[2] });
        const double c = twice - a - b;
        if (twice != 0. && a / twice >= 0. && b / twice >= 0. && c / twice >= 0.)
        {
          std::uint8_t& count = cover[std::size_t(row) * Side + column];
          count = std::min<std::uint8_t>(2, count + 1);
        }
      }
    }
  }
  const auto once = std::count_if(cover.begin(), cover.end(), [](int n) { return n >= 1; });
  const auto twice = std::count(cover.begin(), cover.end(), 2);
  return once == 0 ? 0. : double(twice) / double(once);
}
