#ifndef MesoBaseImage_h
#define MesoBaseImage_h

/**
 * @file MesoBaseImage.h
 * @brief A mesh as an image over its texture coordinates: positions and normals, texel by texel.
 */

#include "MesoVector.h"

#include "mesoFiltersSurfaceModule.h" // for export macro

#include <array>
#include <cstdint>
#include <vector>

struct MesoBaseImageInput
{
  std::vector<MesoVector> Positions;
  std::vector<MesoVector> Normals;
  std::vector<std::array<double, 2>> Coordinates;
  std::vector<std::array<std::int64_t, 3>> Triangles;
};

/// What a texel is: values of MesoBaseImage::Kinds.
enum class MesoBaseTexel : std::uint8_t
{
  Unknown, ///< no triangle near, or several that lie apart
  Beside,  ///< beside the charts: the nearest triangle goes on, flat
  Inside
};

/// Texel (i, j) is number j * Size[0] + i. Its centre has the texture coordinates u with
/// u * Scale + Offset = (i, j).
struct MesoBaseImage
{
  std::array<int, 2> Size = { 0, 0 };
  std::array<double, 2> Scale = { 0., 0. };
  std::array<double, 2> Offset = { 0., 0. };
  /// The image's last column (row) is followed by its first: the mesh closes there.
  std::array<bool, 2> Wraps = { false, false };
  MesoVector Centre = { 0., 0., 0. }; ///< positions are counted from here
  std::vector<MesoVector> Positions;  ///< object units, 0 where unknown
  std::vector<MesoVector> Normals;    ///< unit, 0 where unknown
  std::vector<MesoBaseTexel> Kinds;
  std::int64_t NumberOfInside = 0;
  std::int64_t NumberOfAmbiguous = 0; ///< covered by triangles that lie apart
};

/// Texels beside the charts, along an axis on which the mesh does not close.
constexpr int MesoBaseImageMargin = 4;

/// A size at which the median triangle is so many texels wide and high; no less than 16 and no more
/// than `most` texels along an axis.
MESOFILTERSSURFACE_EXPORT std::array<int, 2> MesoBaseImageSize(
  const MesoBaseImageInput& input, double texelsPerTriangle, int most);

/// Throws std::invalid_argument where the texture coordinates of no triangle span an area. All numbers
/// of the input are finite; the size is at least 16 along each axis.
MESOFILTERSSURFACE_EXPORT MesoBaseImage MesoMakeBaseImage(
  const MesoBaseImageInput& input, const std::array<int, 2>& size);

#endif
