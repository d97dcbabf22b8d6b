#ifndef MesoLookupTable_h
#define MesoLookupTable_h

/**
 * @file MesoLookupTable.h
 * @brief Tables of colours for point arrays, and the ranges that suit them.
 */

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <array>
#include <string>

class vtkDataArray;
class vtkLookupTable;

/// The colour of values that are not numbers: magenta, which is in none of the maps.
constexpr std::array<double, 3> MesoNaNColor = { 1., 0., 1. };

/**
 * 256 colours of a map (MesoColorMap.h) over a range: entry i is the map's colour at i / 255 and is
 * drawn for values from lo + i (hi - lo) / 256 to the next. Beyond the range the end colours go on.
 * Throws std::out_of_range where there is no such map.
 */
MESORENDERINGMESOSTRUCTURE_EXPORT vtkSmartPointer<vtkLookupTable> MesoMakeLookupTable(
  const std::string& map, const std::array<double, 2>& range);

/// Smallest and largest finite number of a component (-1: the magnitude), moved apart where they
/// are equal, so that such an array has the middle colour. [0, 1] where there is none.
MESORENDERINGMESOSTRUCTURE_EXPORT std::array<double, 2> MesoRangeOf(
  vtkDataArray* array, int component);

/**
 * [-r, r] for values with a sign of which a few are far larger than the rest, as curvatures are at
 * tips and creases: r is the 90th percentile of the sizes of all finite values but 0, which is what
 * the filters give where there is nothing to say. [-1, 1] where there is none.
 */
MESORENDERINGMESOSTRUCTURE_EXPORT std::array<double, 2> MesoSymmetricRangeOf(
  vtkDataArray* array, int component);

#endif
