#ifndef BenchPlot_h
#define BenchPlot_h

#include <array>
#include <string>
#include <vector>

/// A setting: what it costs, how wrong it is.
struct BenchPoint
{
  double Time = 0.;       ///< ms, > 0
  double Error = 0.;      ///< > 0, as both axes are logarithmic
  bool Dominated = false; ///< drawn hollow
};

/// A technique: its settings, in their order.
struct BenchCurve
{
  std::string Name;
  std::array<unsigned char, 3> Color = { 0, 0, 0 };
  std::vector<BenchPoint> Points;
};

/// Draw time across and error up, on logarithmic axes, as a PNG of 720 x 520. At least one curve has a
/// point.
void WritePlot(const std::string& title, const std::string& errorTitle,
  const std::vector<BenchCurve>& curves, const std::string& fileName);

#endif
