#ifndef MesoHeightMap_h
#define MesoHeightMap_h

/**
 * @file MesoHeightMap.h
 * @brief Turns the stored numbers of a map into heights in [0,1].
 */

#include "mesoIOMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

struct MesoHeights
{
  /// One component, float, in [0,1], 0 lowest; size, spacing and origin are those of the map.
  vtkSmartPointer<vtkImageData> Image;
  std::array<double, 2> Numbers = { 0., 1. }; ///< stored numbers of the heights 0 and 1
  vtkIdType NumberOfClamped = 0;              ///< values outside the range, set to its ends
  std::vector<std::string> Warnings;          ///< what a user should be told, a line each
};

/**
 * Heights of a map. With v = (x - lo) / (hi - lo), clamped to [0,1]: h = v for a height map
 * (brighter is higher), h = 1 - v for a depth map (brighter is deeper). Computed in double.
 *
 * @param map a plane image of unsigned char, unsigned short or float; the first component is taken,
 *   with a warning where the second or third differs from it by more than 8/255 of white, as in a
 *   picture that is not grey
 * @param isDepth a depth map
 * @param range [lo, hi], lo < hi, in stored numbers; by default [0, 255], [0, 65535] and [0, 1] for
 *   unsigned char, unsigned short and float
 * Throws MesoInputError (without a file's name) where the map is empty, of another type, a volume,
 * or holds numbers that are not finite, or the range is not one.
 */
MESOIOMESOSTRUCTURE_EXPORT MesoHeights MesoToHeights(vtkImageData* map, bool isDepth,
  const std::optional<std::array<double, 2>>& range = std::nullopt);

#endif
