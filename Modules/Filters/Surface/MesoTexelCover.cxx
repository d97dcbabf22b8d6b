#include "MesoTexelCover.h"

#include <algorithm>
#include <cmath>

namespace
{
/// A centre this close to an edge, in weights, lies on it.
constexpr double OnEdge = 1e-9;

/// The texels along an axis whose centres may lie between two coordinates: first and one past last.
std::array<int, 2> TexelsBetween(double low, double high, int size)
{
  const auto clamped = [&](double texel)
  { return static_cast<int>(std::min(std::max(texel, 0.), static_cast<double>(size))); };
  return { clamped(std::floor(low * size - 0.5)), clamped(std::ceil(high * size + 0.5)) };
}
}

std::array<double, 3> MesoWeightsAt(const MesoTexturePoint& a, const MesoTexturePoint& b,
  const MesoTexturePoint& c, const MesoTexturePoint& point)
{
  const auto area =
    [](const MesoTexturePoint& from, const MesoTexturePoint& to, const MesoTexturePoint& third)
  { return (to[0] - from[0]) * (third[1] - from[1]) - (third[0] - from[0]) * (to[1] - from[1]); };
  const double whole = area(a, b, c);
  const double second = area(a, point, c) / whole;
  const double third = area(a, b, point) / whole;
  return { 1. - second - third, second, third };
}

MesoTexelCover MesoCoverTexels(const std::vector<MesoTexturePoint>& coordinates,
  const std::vector<std::array<std::int64_t, 3>>& triangles, int width, int height)
{
  MesoTexelCover cover;
  cover.Width = width;
  cover.Height = height;
  cover.Triangle.assign(std::size_t(width) * std::size_t(height), -1);
  std::vector<bool> inside(cover.Triangle.size(), false); // not just on an edge
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const MesoTexturePoint& a = coordinates[triangles[t][0]];
    const MesoTexturePoint& b = coordinates[triangles[t][1]];
    const MesoTexturePoint& c = coordinates[triangles[t][2]];
    const auto columns =
      TexelsBetween(std::min({ a[0], b[0], c[0] }), std::max({ a[0], b[0], c[0] }), width);
    const auto rows =
      TexelsBetween(std::min({ a[1], b[1], c[1] }), std::max({ a[1], b[1], c[1] }), height);
    for (int row = rows[0]; row < rows[1]; ++row)
    {
      for (int column = columns[0]; column < columns[1]; ++column)
      {
        const std::size_t texel = std::size_t(row) * std::size_t(width) + std::size_t(column);
        const auto weights = MesoWeightsAt(a, b, c, cover.CentreOf(texel));
        const double least = *std::min_element(weights.begin(), weights.end());
        if (!(least >= -OnEdge)) // outside, or no area
        {
          continue;
        }
        const bool isInside = least > OnEdge;
        if (cover.Triangle[texel] < 0)
        {
          cover.Triangle[texel] = static_cast<std::int32_t>(t);
        }
        else if (isInside && inside[texel])
        {
          ++cover.Overlapping;
        }
        inside[texel] = inside[texel] || isInside;
      }
    }
  }
  return cover;
}
