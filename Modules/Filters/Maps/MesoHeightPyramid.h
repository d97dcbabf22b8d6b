#ifndef MesoHeightPyramid_h
#define MesoHeightPyramid_h

#include "mesoFiltersMapsModule.h" // for export macro

#include <array>
#include <vector>

/// A level of a height map's pyramid, row by row from v = 0.
struct MesoHeightLevel
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Heights;
};

/**
 * The levels above a map of width x height heights, row 0 at v = 0: each has half as many texels along u and
 * v as the one before, rounded down, and each texel is the mean of what it covers of that one. The last is
 * that of which a side is one texel; a map with such a side has none.
 */
MESOFILTERSMAPS_EXPORT std::vector<MesoHeightLevel> MesoMakeHeightPyramid(
  int width, int height, const float* heights);

/// A map's slopes along u and v, height per map coordinate.
struct MesoMapSlopes
{
  std::array<double, 2> MeanSquare = { 0., 0. };
  /// Of their absolute values: how much goes up and down.
  std::array<double, 2> MeanSize = { 0., 0. };
};

/// Of the steps from texel to texel, without those over the map's border.
MESOFILTERSMAPS_EXPORT MesoMapSlopes MesoSlopesOfMap(int width, int height, const float* heights);

#endif
