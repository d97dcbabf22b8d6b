#include "BenchReportParts.h"

#include "BenchAnalysis.h"
#include "BenchDerived.h"
#include "BenchHtml.h"
#include "MesoOptions.h"

#include <cmath>
#include <set>

using Json = BenchResults::Json;

namespace
{
void StartTable(std::ostream& page, const std::vector<std::string>& heads)
{
  page << "<div class=\"wrap\"><table><tr>";
  for (const std::string& head : heads)
  {
    page << "<th>" << head << "</th>";
  }
  page << "</tr>\n";
}

void WriteLine(std::ostream& page, const std::vector<std::string>& cells)
{
  page << "<tr>";
  for (const std::string& cell : cells)
  {
    page << "<td>" << cell << "</td>";
  }
  page << "</tr>\n";
}

void EndTable(std::ostream& page)
{
  page << "</table></div>\n";
}

/// To two places: an order is known no better.
std::optional<double> Rounded(std::optional<double> order)
{
  return order ? std::optional<double>(std::round(*order * 100.) / 100. + 0.) : order;
}

bool IsDrawnFromGeometry(const Json& row)
{
  return row["technique"] == MesoName(MesoTechnique::Tessellated);
}
}

void WriteErrorsAtTimes(std::ostream& page, const std::vector<Json>& rows)
{
  page
    << "<h3>Error at a time</h3>\n<p>The least texcoord_p95 of each technique that takes no longer "
       "than so many ms a frame.</p>\n";
  std::vector<std::string> heads = { "technique" };
  for (const double milliseconds : BenchTimes)
  {
    heads.push_back(Number(std::optional<double>(milliseconds)) + " ms");
  }
  StartTable(page, heads);
  std::vector<std::string> techniques;
  for (const Json& row : rows)
  {
    if (row["status"] == "ok" && (techniques.empty() || techniques.back() != row["technique"]))
    {
      techniques.push_back(row["technique"]);
    }
  }
  for (const std::string& technique : techniques)
  {
    std::vector<const Json*> own;
    for (const Json& row : rows)
    {
      if (row["technique"] == technique)
      {
        own.push_back(&row);
      }
    }
    std::vector<std::string> cells = { technique };
    for (const double milliseconds : BenchTimes)
    {
      const Json* best = MostExact(own, milliseconds);
      cells.push_back(
        best ? Number(BenchFigure(*best, "texcoord_p95")) + ", " + BenchLabel(*best) : "&ndash;");
    }
    WriteLine(page, cells);
  }
  EndTable(page);
}

void WriteEqualError(std::ostream& page, const std::vector<Json>& rows)
{
  page
    << "<h3>At equal error</h3>\n<p>Each setting beside the coarsest dicing whose depth_p95, "
       "texcoord_p95 and silhouette_px_mean are no larger; and the frames after which the dicing, "
       "which takes longer to prepare, has caught up where it draws faster.</p>\n";
  StartTable(page,
    { "setting", "ms", "dicing that is no worse", "its ms", "setting / dicing", "bytes",
      "its bytes", "frames to catch up" });
  for (const Json& row : rows)
  {
    if (row["status"] != "ok" || IsDrawnFromGeometry(row))
    {
      continue;
    }
    const Json* other = BenchAlternative(rows, row);
    const auto time = BenchTime(row);
    const auto otherTime = other ? BenchTime(*other) : std::nullopt;
    WriteLine(page,
      { BenchLabel(row), Number(time), other ? BenchLabel(*other) : "none is", Number(otherTime),
        otherTime && *otherTime > 0. ? Number(std::optional<double>(*time / *otherTime))
                                     : "&ndash;",
        Number(row["gpu_bytes"]), other ? Number((*other)["gpu_bytes"]) : "&ndash;",
        other ? Number(BenchBreakEven(*other, row)) : "&ndash;" });
  }
  EndTable(page);
}

void WriteOrders(std::ostream& page, const std::vector<Json>& rows)
{
  page << "<h3>Orders</h3>\n<p>The error of texcoord_p95 falls with the work (steps of the linear "
          "search, facets along a texel) to this power: by the truth, and of the search alone. An "
          "order "
          "near 0 by the truth means that the model is the error.</p>\n";
  StartTable(page, { "technique", "by the", "order" });
  std::set<std::string> seen;
  for (const Json& row : rows)
  {
    const std::string technique = row["technique"];
    if (row["status"] != "ok" || row["quality"].get<std::string>().empty() ||
      !seen.insert(technique).second)
    {
      continue;
    }
    for (const auto& error : row["errors"].items())
    {
      WriteLine(page,
        { technique, error.key(),
          Number(Rounded(BenchOrder(rows, technique, "texcoord_p95", error.key()))) });
    }
  }
  EndTable(page);
}

void WriteAblation(std::ostream& page, const std::vector<Json>& ablations)
{
  if (ablations.empty())
  {
    return;
  }
  page << "<h3>What each effect is worth</h3>\n<p>Each technique with all its effects, and with "
          "one of "
          "them off.</p>\n";
  const std::vector<std::string> figures = { "flip_mean", "texcoord_p95", "depth_p95",
    "normal_mean", "coverage_iou", "shadow_attached", "shadow_cast" };
  std::vector<std::string> heads = { "setting", "without", "ms", "ms saved" };
  heads.insert(heads.end(), figures.begin(), figures.end());
  StartTable(page, heads);
  std::optional<double> all;
  for (const Json& row : ablations)
  {
    const std::string without = row["without"];
    if (row["status"] != "ok")
    {
      page << "<tr><td>" << BenchLabel(row) << "</td><td>" << without
           << "</td><td class=\"wide bad\" colspan=\"" << 2 + figures.size()
           << "\">refused: " << Escaped(row["reason"]) << "</td></tr>\n";
      continue;
    }
    const auto time = BenchTime(row);
    all = without == "none" ? time : all;
    std::vector<std::string> cells = { BenchLabel(row), without,
      Number(time) + Interval(row["gpu_ms"].value("interval", Json())),
      without == "none" || !all ? "&ndash;" : Number(std::optional<double>(*all - *time)) };
    for (const std::string& figure : figures)
    {
      cells.push_back(Number(BenchFigure(row, figure)));
    }
    WriteLine(page, cells);
  }
  EndTable(page);
}

void WriteScaling(std::ostream& page, const Json& scaling)
{
  if (scaling.is_null())
  {
    return;
  }
  page
    << "<h2>How time grows</h2>\n<p>A torus of bricks at medium, with more of one thing at a time; "
       "milliseconds at each number, and the slope of the straight line through them.</p>\n";
  StartTable(page, { "more", "technique", "number: ms", "ns for one" });
  for (const Json& series : scaling["series"])
  {
    std::string points;
    for (const Json& point : series["points"])
    {
      points += (points.empty() ? "" : ", ") + Number(point[0]) + ": " + Number(point[1]);
    }
    WriteLine(page, { series["what"], series["technique"], points, Number(series["ns_per_unit"]) });
  }
  EndTable(page);
}
