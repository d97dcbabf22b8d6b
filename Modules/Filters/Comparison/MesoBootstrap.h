#ifndef MesoBootstrap_h
#define MesoBootstrap_h

/**
 * @file MesoBootstrap.h
 * @brief How sure a median of few measurements is: intervals by resampling (Efron's bootstrap).
 *
 * The measurements are drawn again from themselves with replacement 1000 times; 95 % of the medians
 * of those draws lie in the interval. The draws are the same in every run.
 */

#include "mesoFiltersComparisonModule.h" // for export macro

#include <optional>
#include <vector>

struct MesoInterval
{
  double Low = 0.;
  double High = 0.;
};

/// Of the median of the values; empty without values.
MESOFILTERSCOMPARISON_EXPORT std::optional<MesoInterval> MesoMedianInterval(
  const std::vector<double>& values);

/// Of the median of `values` over that of `floor`, which were measured in the same rounds, in the same
/// order: a round is drawn as a whole. Empty without values, where the two have unequal numbers, and
/// where a median of the floor is not above 0.
MESOFILTERSCOMPARISON_EXPORT std::optional<MesoInterval> MesoRatioInterval(
  const std::vector<double>& values, const std::vector<double>& floor);

#endif
