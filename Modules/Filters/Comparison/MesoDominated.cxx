#include "MesoDominated.h"

#include <algorithm>

std::vector<bool> MesoDominated(const std::vector<std::pair<double, double>>& points)
{
  std::vector<bool> dominated;
  for (const auto& point : points)
  {
    dominated.push_back(std::any_of(points.begin(), points.end(),
      [&point](const auto& other)
      { return other.first <= point.first && other.second <= point.second && other != point; }));
  }
  return dominated;
}
