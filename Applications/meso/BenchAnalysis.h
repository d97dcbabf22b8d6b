#ifndef BenchAnalysis_h
#define BenchAnalysis_h

#include "BenchResults.h"

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// The figure of a row by a truth ("mesh", "smooth"; "" for the one that it is judged by); none where
/// it was refused or is not known.
std::optional<double> BenchFigure(
  const BenchResults::Json& row, const std::string& name, const std::string& surface = "");

/// Median of the time on the GPU; none where it was refused.
std::optional<double> BenchTime(const BenchResults::Json& row);

/// Texels that costs are asked for.
constexpr double BenchErrors[] = { 1., 0.5, 0.1, 0.02 };

/// The cheapest of these rows whose texcoord_p95 is at most `texels`, null where there is none.
const BenchResults::Json* CheapestWithin(
  const std::vector<const BenchResults::Json*>& rows, double texels);

/// Milliseconds a frame that errors are asked for.
constexpr double BenchTimes[] = { 10., 16.7, 33.3, 100. };

/// The row whose texcoord_p95 is least among those that take at most `milliseconds`, null where there is
/// none.
const BenchResults::Json* MostExact(const std::vector<const BenchResults::Json*>& rows,
  double milliseconds = std::numeric_limits<double>::infinity());

/// The slope of the straight line through points (x, y), by least squares; none where x does not vary.
std::optional<double> BenchSlope(const std::vector<std::pair<double, double>>& points);

/// "relief high".
std::string BenchLabel(const BenchResults::Json& row);

#endif
