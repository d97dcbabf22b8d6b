#include "BenchAnalysis.h"

using Json = BenchResults::Json;

std::optional<double> BenchFigure(
  const Json& row, const std::string& name, const std::string& surface)
{
  if (row["status"] != "ok")
  {
    return std::nullopt;
  }
  const std::string judge = surface.empty() ? row["judged_by"].get<std::string>() : surface;
  const Json& value = row["errors"][judge][name];
  return value.is_number() ? std::optional<double>(value.get<double>()) : std::nullopt;
}

std::optional<double> BenchTime(const Json& row)
{
  return row["status"] == "ok" ? std::optional<double>(row["gpu_ms"]["median"].get<double>())
                               : std::nullopt;
}

const Json* CheapestWithin(const std::vector<const Json*>& rows, double texels)
{
  const Json* cheapest = nullptr;
  for (const Json* row : rows)
  {
    const auto error = BenchFigure(*row, "texcoord_p95");
    if (error && *error <= texels && (!cheapest || BenchTime(*row) < BenchTime(*cheapest)))
    {
      cheapest = row;
    }
  }
  return cheapest;
}

const Json* MostExact(const std::vector<const Json*>& rows, double milliseconds)
{
  const Json* best = nullptr;
  for (const Json* row : rows)
  {
    const auto error = BenchFigure(*row, "texcoord_p95");
    if (error && *BenchTime(*row) <= milliseconds &&
      (!best || *error < *BenchFigure(*best, "texcoord_p95")))
    {
      best = row;
    }
  }
  return best;
}

std::optional<double> BenchSlope(const std::vector<std::pair<double, double>>& points)
{
  const auto n = static_cast<double>(points.size());
  double sumX = 0.;
  double sumY = 0.;
  double sumXX = 0.;
  double sumXY = 0.;
  for (const auto& [x, y] : points)
  {
    sumX += x;
    sumY += y;
    sumXX += x * x;
    sumXY += x * y;
  }
  const double spread = n * sumXX - sumX * sumX;
  return spread > 0. ? std::optional<double>((n * sumXY - sumX * sumY) / spread) : std::nullopt;
}

std::string BenchLabel(const Json& row)
{
  const std::string quality = row["quality"];
  const std::string search = row.value("search", "");
  return row["technique"].get<std::string>() + (quality.empty() ? "" : " ") + quality +
    (search.empty() ? "" : " ") + search;
}
