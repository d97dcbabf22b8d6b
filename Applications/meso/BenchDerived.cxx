#include "BenchDerived.h"

#include "BenchAnalysis.h"
#include "MesoOptions.h"

#include <cmath>

using Json = BenchResults::Json;

namespace
{
/// What a technique does more of in a higher quality.
double WorkOf(const Json& row)
{
  const MesoQuality quality = *MesoQualityFromName(row["quality"]);
  return row["technique"] == MesoName(MesoTechnique::Tessellated)
    ? MesoFacetsPerTexel(quality)
    : static_cast<double>(MesoStepsOfQuality(quality).Linear);
}
}

const Json* BenchAlternative(const std::vector<Json>& rows, const Json& row)
{
  const Json* coarsest = nullptr;
  for (const Json& other : rows)
  {
    if (other["status"] != "ok" || other["technique"] != MesoName(MesoTechnique::Tessellated) ||
      (coarsest && other["triangles"] >= (*coarsest)["triangles"]))
    {
      continue;
    }
    const std::string surface = row["judged_by"];
    bool noWorse = true;
    for (const char* figure : { "depth_p95", "texcoord_p95", "silhouette_px_mean" })
    {
      const auto wanted = BenchFigure(row, figure, surface);
      const auto found = BenchFigure(other, figure, surface);
      // A figure that the scene does not give (no outline in the picture) decides nothing.
      noWorse = noWorse && (!wanted || (found && *found <= *wanted));
    }
    coarsest = noWorse ? &other : coarsest;
  }
  return coarsest;
}

std::optional<double> BenchOrder(const std::vector<Json>& rows, const std::string& technique,
  const std::string& figure, const std::string& surface)
{
  std::vector<std::pair<double, double>> points;
  for (const Json& row : rows)
  {
    if (row["technique"] != technique || row["status"] != "ok" ||
      !row["errors"].contains(surface) || row["quality"].get<std::string>().empty() ||
      row["quality"] == MesoName(MesoQuality::Certified) ||
      !row.value("search", std::string()).empty())
    {
      continue;
    }
    const auto error = BenchFigure(row, figure, surface);
    if (!error || !(*error > 0.))
    {
      return {};
    }
    points.emplace_back(std::log(WorkOf(row)), std::log(*error));
  }
  const auto slope = points.size() >= 3 ? BenchSlope(points) : std::nullopt;
  return slope ? std::optional<double>(-*slope) : slope;
}

std::optional<double> BenchBreakEven(const Json& dear, const Json& slow)
{
  const auto dearTime = BenchTime(dear);
  const auto slowTime = BenchTime(slow);
  if (!dearTime || !slowTime)
  {
    return {};
  }
  const double prepared = 1000. * (double(dear["prepare_s"]) - double(slow["prepare_s"]));
  const double saved = *slowTime - *dearTime;
  return prepared > 0. && saved > 0. ? std::optional<double>(prepared / saved) : std::nullopt;
}
