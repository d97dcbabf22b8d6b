#ifndef BenchReport_h
#define BenchReport_h

#include <string>

class BenchResults;

/// Write `report.html` and, in the folders of the scenes, the plots that it shows. The page stands by
/// itself: it names nothing outside its folder.
void WriteReport(const BenchResults& results, const std::string& folder);

#endif
