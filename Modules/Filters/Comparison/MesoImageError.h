#ifndef MesoImageError_h
#define MesoImageError_h

/**
 * @file MesoImageError.h
 * @brief All figures of error of a rendering against the true one, with their names.
 */

#include "MesoGeometryError.h"
#include "MesoPictureError.h"

#include <optional>
#include <string>

/// A rendering: its picture, what its pixels know, or both of one size.
struct MesoRendering
{
  std::string Name; ///< for messages
  std::optional<MesoPicture> Picture;
  std::optional<MesoAOVs> AOVs;
};

struct MesoImageError
{
  int Width = 0;
  int Height = 0;
  std::optional<MesoPictureError> Picture;
  std::optional<MesoGeometryError> Geometry;
};

/**
 * Compare what both renderings have: MesoComparePictures() (over the pixels that either covers, where
 * AOVs are there as well), MesoCompareGeometry(). Throws MesoInputError, by one line with the names,
 * where sizes, channels or objects differ, or where there is nothing to compare.
 */
MESOFILTERSCOMPARISON_EXPORT MesoImageError MesoCompareRenderings(
  const MesoRendering& truth, const MesoRendering& test);

/// A figure of error as tables show it.
struct MesoFigure
{
  std::string Name;
  std::string Unit;
  double Value = 0.; ///< not a number where it is not known
};

/// All figures in their fixed order, those of pictures last. What was not compared is not a number.
MESOFILTERSCOMPARISON_EXPORT std::vector<MesoFigure> MesoFiguresOfError(
  const MesoImageError& error);

#endif
