#ifndef BenchReportParts_h
#define BenchReportParts_h

#include "BenchResults.h"

#include <ostream>
#include <vector>

/// Parts of a bench's report that say what follows from the rows.

/// The least error of each technique within some times a frame.
void WriteErrorsAtTimes(std::ostream& page, const std::vector<BenchResults::Json>& rows);

/// Each setting beside the coarsest dicing that is no worse, and frames until it has caught up.
void WriteEqualError(std::ostream& page, const std::vector<BenchResults::Json>& rows);

/// How fast the errors of model and solver fall with the work.
void WriteOrders(std::ostream& page, const std::vector<BenchResults::Json>& rows);

/// What each effect costs and what it is worth; nothing without ablations.
void WriteAblation(std::ostream& page, const std::vector<BenchResults::Json>& ablations);

/// How time grows; nothing where it was not measured.
void WriteScaling(std::ostream& page, const BenchResults::Json& scaling);

#endif
