#include "MesoErrorSpread.h"

#include <algorithm>
#include <cmath>

double MesoPercentile(const std::vector<double>& values, double part)
{
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return values[below] + (place - double(below)) * (values[above] - values[below]);
}

MesoErrorSpread MesoErrorSpread::Of(
  const std::vector<double>& errors, const std::vector<std::size_t>& pixels)
{
  MesoErrorSpread spread;
  spread.Count = errors.size();
  if (errors.empty())
  {
    return spread;
  }
  spread.WorstPixel = pixels[std::max_element(errors.begin(), errors.end()) - errors.begin()];
  std::vector<double> sorted = errors;
  std::sort(sorted.begin(), sorted.end());
  double sum = 0.;
  double squares = 0.;
  for (const double error : sorted)
  {
    sum += error;
    squares += error * error;
  }
  spread.Mean = sum / double(errors.size());
  spread.Rms = std::sqrt(squares / double(errors.size()));
  spread.P50 = MesoPercentile(sorted, 0.5);
  spread.P95 = MesoPercentile(sorted, 0.95);
  spread.P99 = MesoPercentile(sorted, 0.99);
  spread.Maximum = sorted.back();
  return spread;
}
