#ifndef BenchDerived_h
#define BenchDerived_h

#include "BenchResults.h"

#include <optional>
#include <string>
#include <vector>

/**
 * What follows from a scene's rows: statements at equal error, orders of convergence, break-even
 * points. Rows that were refused are passed over.
 */

/// The coarsest dicing (`tessellated`) that is no worse than a row in depth_p95, texcoord_p95 and
/// silhouette_px_mean, each by the row's truth; null where none is.
const BenchResults::Json* BenchAlternative(
  const std::vector<BenchResults::Json>& rows, const BenchResults::Json& row);

/// How a figure falls with the work: e of error ~ steps^-e, fitted over a technique's qualities, steps
/// being those of the linear search or the facets along a texel. By a truth, or "solver". Empty with
/// fewer than three qualities, and where an error is 0.
std::optional<double> BenchOrder(const std::vector<BenchResults::Json>& rows,
  const std::string& technique, const std::string& figure, const std::string& surface);

/// Frames after which `dear`, which takes longer to prepare and less to draw than `slow`, has caught up
/// with it; empty where it has nothing to catch up or never does.
std::optional<double> BenchBreakEven(
  const BenchResults::Json& dear, const BenchResults::Json& slow);

#endif
