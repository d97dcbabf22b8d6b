#ifndef MesoTexelCover_h
#define MesoTexelCover_h

/**
 * @file MesoTexelCover.h
 * @brief Which triangle of an atlas lies under each texel's centre.
 */

#include "mesoFiltersSurfaceModule.h" // for export macro

#include <array>
#include <cstdint>
#include <vector>

using MesoTexturePoint = std::array<double, 2>;

/// Texels row by row, row 0 at v = 0; centres at (i + 0.5) / size.
struct MesoTexelCover
{
  int Width = 0;
  int Height = 0;
  std::vector<std::int32_t> Triangle; ///< a texel each, -1 where no triangle lies
  /// Weights of its second and third corner at the texel's centre.
  std::vector<std::array<double, 2>> Weights;
  /// Texels whose centre lies inside of several triangles, not just on their common edge. The first
  /// of them has it.
  std::int64_t Overlapping = 0;

  /// Weights of the three corners at the centre of a texel that is covered.
  std::array<double, 3> WeightsOf(std::size_t texel) const
  {
    const auto [second, third] = this->Weights[texel];
    return { 1. - second - third, second, third };
  }
};

/// Weights of a triangle's corners at a point of its plane; they sum to 1. Not finite where the
/// triangle has no area.
MESOFILTERSSURFACE_EXPORT std::array<double, 3> MesoWeightsAt(const MesoTexturePoint& a,
  const MesoTexturePoint& b, const MesoTexturePoint& c, const MesoTexturePoint& point);

/**
 * Covers the texels of a map, which repeats outside of [0,1] x [0,1]. Triangles may be mirrored.
 *
 * @param coordinates a point each, finite
 * @throw std::invalid_argument where a triangle is longer than the map, which makes no atlas
 * @param triangles point numbers
 */
MESOFILTERSSURFACE_EXPORT MesoTexelCover MesoCoverTexels(
  const std::vector<MesoTexturePoint>& coordinates,
  const std::vector<std::array<std::int64_t, 3>>& triangles, int width, int height);

#endif
