#include "MesoBootstrap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>

namespace
{
constexpr int Draws = 1000;
constexpr double Outside = 0.025; // on either side

double Median(std::vector<double>& values)
{
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/// The figure of each draw; `figure` is given the numbers of the rounds that were drawn.
template <typename Figure>
std::optional<MesoInterval> IntervalOf(std::size_t rounds, Figure&& figure)
{
  if (rounds == 0)
  {
    return {};
  }
  // The generator's numbers are fixed by the standard; how a distribution uses them is not.
  std::mt19937 generator(1979);
  std::vector<double> figures;
  std::vector<std::size_t> drawn(rounds);
  for (int draw = 0; draw < Draws; ++draw)
  {
    for (std::size_t& round : drawn)
    {
      round = generator() % rounds;
    }
    const double value = figure(drawn);
    if (!std::isfinite(value))
    {
      return {};
    }
    figures.push_back(value);
  }
  std::sort(figures.begin(), figures.end());
  const auto at = [&](double part)
  { return figures[static_cast<std::size_t>(std::lround(part * (Draws - 1)))]; };
  return MesoInterval{ at(Outside), at(1. - Outside) };
}

double MedianOf(const std::vector<double>& values, const std::vector<std::size_t>& rounds)
{
  std::vector<double> drawn;
  drawn.reserve(rounds.size());
  for (const std::size_t round : rounds)
  {
    drawn.push_back(values[round]);
  }
  return Median(drawn);
}
}

std::optional<MesoInterval> MesoMedianInterval(const std::vector<double>& values)
{
  return IntervalOf(values.size(),
    [&](const std::vector<std::size_t>& rounds) { return MedianOf(values, rounds); });
}

std::optional<MesoInterval> MesoRatioInterval(
  const std::vector<double>& values, const std::vector<double>& floor)
{
  if (values.size() != floor.size())
  {
    return {};
  }
  return IntervalOf(values.size(),
    [&](const std::vector<std::size_t>& rounds)
    {
      const double below = MedianOf(floor, rounds);
      return below > 0. ? MedianOf(values, rounds) / below : std::nan("");
    });
}
