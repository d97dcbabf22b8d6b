#ifndef MesoErrorSpread_h
#define MesoErrorSpread_h

#include "mesoFiltersComparisonModule.h" // for export macro

#include <cstddef>
#include <limits>
#include <vector>

/// How the errors of many pixels are spread. Not a number where there are none.
struct MESOFILTERSCOMPARISON_EXPORT MesoErrorSpread
{
  std::size_t Count = 0;
  double Mean = std::numeric_limits<double>::quiet_NaN();
  double Rms = std::numeric_limits<double>::quiet_NaN(); ///< root of the mean square
  double P50 = std::numeric_limits<double>::quiet_NaN(); ///< half of the errors are no larger
  double P95 = std::numeric_limits<double>::quiet_NaN();
  double P99 = std::numeric_limits<double>::quiet_NaN();
  double Maximum = std::numeric_limits<double>::quiet_NaN();
  std::size_t WorstPixel = 0; ///< the first with the largest error

  /// Errors (finite, >= 0) and the pixels that they were found at, as many.
  static MesoErrorSpread Of(
    const std::vector<double>& errors, const std::vector<std::size_t>& pixels);
};

/// The value that the fraction `part` in [0,1] of the values lies below, interpolated linearly
/// between neighbours in order: 0.5 is the median. `values` is sorted and not empty.
MESOFILTERSCOMPARISON_EXPORT double MesoPercentile(const std::vector<double>& values, double part);

#endif
