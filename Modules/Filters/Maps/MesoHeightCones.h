#ifndef MesoHeightCones_h
#define MesoHeightCones_h

#include "MesoOptions.h"           // for MesoWrap
#include "mesoFiltersMapsModule.h" // for export macro

#include <cstddef>
#include <functional>
#include <vector>

/**
 * Cones of free space over a height map, four a texel: for ways rightwards and upwards, leftwards and
 * upwards, rightwards and downwards, leftwards and downwards (Shaders/Kernels/HeightCone.glsl).
 *
 * The cone of texel o for a way of travel has its apex at depth a, and is at depth
 * a - m (|du| + |dv|) at (du, dv) texels from o, in the quarter plane that begins at o and lies in that
 * way. No point of the bilinear surface there is higher, the map being continued by its wrap mode. a is
 * the depth of the highest of the four texels of the patch that lies ahead of o; m is the least that
 * does, up to 25 %.
 */
struct MesoHeightCones
{
  /// Four a texel, row by row from v = 0: depth of the apex, 255 a, rounded to less deep.
  std::vector<unsigned char> Apex;
  /// Four a texel: steepness, 255 sqrt(2 m), rounded to steeper. m is at most 1/2.
  std::vector<unsigned char> Steepness;
};

/// Calls work(first, end) for parts of the items 0 to `count`, which may be done at the same time; the
/// last arguments say which part of the whole work lies before these items and in them. Returns false
/// where all is to end at once.
using MesoConeRunner = std::function<bool(
  int count, const std::function<void(int, int)>& work, double done, double all)>;

/**
 * Cones of a map of width x height heights in [0,1], row 0 at v = 0. In O(N log P) time for N texels and a
 * period of P texels: the highest texel of growing triangles ahead of each texel, each made of three
 * smaller ones. What the triangle has grown by is taken to be as near as its nearest texel.
 *
 * What is returned is not all made where the runner has ended it.
 */
MESOFILTERSMAPS_EXPORT MesoHeightCones MesoMakeHeightCones(
  int width, int height, MesoWrap wrap, const float* heights, const MesoConeRunner& run);

#endif
