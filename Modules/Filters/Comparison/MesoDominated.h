#ifndef MesoDominated_h
#define MesoDominated_h

#include "mesoFiltersComparisonModule.h" // for export macro

#include <utility>
#include <vector>

/// For each point (cost, error), whether another one is no worse in both and better in one. The others
/// are the Pareto front. Numbers are finite.
MESOFILTERSCOMPARISON_EXPORT std::vector<bool> MesoDominated(
  const std::vector<std::pair<double, double>>& points);

#endif
