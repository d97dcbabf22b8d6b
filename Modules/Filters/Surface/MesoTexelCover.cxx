#include "MesoTexelCover.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace
{
/// A centre this close to an edge, in weights, lies on it.
constexpr double OnEdge = 1e-9;

/// The texels along an axis whose centres may lie between two coordinates: first and one past last.
/// Numbered on over the map's ends.
std::array<std::int64_t, 2> TexelsBetween(double low, double high, int size)
{
  return { static_cast<std::int64_t>(std::floor(low * size - 0.5)),
    static_cast<std::int64_t>(std::ceil(high * size + 0.5)) };
}

std::size_t Wrapped(std::int64_t texel, int size)
{
  const std::int64_t rest = texel % size;
  return static_cast<std::size_t>(rest < 0 ? rest + size : rest);
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
  cover.Weights.resize(cover.Triangle.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const MesoTexturePoint& a = coordinates[triangles[t][0]];
    const MesoTexturePoint& b = coordinates[triangles[t][1]];
    const MesoTexturePoint& c = coordinates[triangles[t][2]];
    double low[2];
    double high[2];
    for (int k = 0; k < 2; ++k)
    {
      low[k] = std::min({ a[k], b[k], c[k] });
      high[k] = std::max({ a[k], b[k], c[k] });
      if (!(high[k] - low[k] <= 1.))
      {
        throw std::invalid_argument("triangle " + std::to_string(t) +
          " is longer than the map in texture coordinates: they are no atlas");
      }
    }
    const auto columns = TexelsBetween(low[0], high[0], width);
    const auto rows = TexelsBetween(low[1], high[1], height);
    for (std::int64_t row = rows[0]; row < rows[1]; ++row)
    {
      for (std::int64_t column = columns[0]; column < columns[1]; ++column)
      {
        const MesoTexturePoint centre = { (static_cast<double>(column) + 0.5) / width,
          (static_cast<double>(row) + 0.5) / height };
        const auto weights = MesoWeightsAt(a, b, c, centre);
        const double least = *std::min_element(weights.begin(), weights.end());
        if (!(least >= -OnEdge)) // outside, or no area
        {
          continue;
        }
        const std::size_t texel =
          Wrapped(row, height) * std::size_t(width) + Wrapped(column, width);
        const bool isInside = least > OnEdge;
        if (cover.Triangle[texel] < 0)
        {
          cover.Triangle[texel] = static_cast<std::int32_t>(t);
          cover.Weights[texel] = { weights[1], weights[2] };
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
