#include "BenchReport.h"

#include "BenchAnalysis.h"
#include "BenchHtml.h"
#include "BenchPlot.h"
#include "BenchReportParts.h"
#include "MesoAtomicFile.h"
#include "MesoDominated.h"
#include "MesoErrorPictures.h"
#include "MesoOptions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <sstream>

namespace
{
using Json = BenchResults::Json;
using Rows = std::vector<Json>;

const char* const Head = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Accuracy and cost</title><style>
body { font: 15px/1.45 sans-serif; color: #222; max-width: 1100px; margin: 2em auto; padding: 0 1em; }
h1, h2, h3 { line-height: 1.2; } h2 { margin-top: 2.5em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; font-size: 13px; margin: 1em 0; }
th, td { border: 1px solid #ddd; padding: 3px 7px; text-align: right; white-space: nowrap; }
th { background: #f2f2f2; } td:first-child, th:first-child { text-align: left; }
td.wide { text-align: left; white-space: normal; } td.bad { background: #fbe3e0; } tr.other td { color: #999; }
img { max-width: 100%; } figure { margin: 1em 0; } figcaption { font-size: 13px; color: #555; }
.plots img { width: 49%; }
.key { display: inline-block; width: 1em; height: 1em; vertical-align: -0.15em; } .wrap { overflow-x: auto; }
</style></head><body>
)";

/// Colours that are told apart, also by those who see fewer of them.
std::array<unsigned char, 3> ColorOfTechnique(const std::string& name)
{
  constexpr std::array<unsigned char, 3> Colors[] = { { 60, 60, 60 }, { 0, 114, 178 },
    { 213, 94, 0 }, { 0, 158, 115 }, { 204, 121, 167 }, { 230, 159, 0 }, { 86, 180, 233 },
    { 120, 80, 20 }, { 148, 103, 189 }, { 188, 189, 34 }, { 227, 119, 194 } };
  const std::vector<std::string> names = MesoTechniqueNames();
  const std::size_t place = std::find(names.begin(), names.end(), name) - names.begin();
  return Colors[place % std::size(Colors)];
}

/// Draws one figure, by one truth, against time; false where no row has it.
bool Plot(const Rows& rows, const std::string& scene, const std::string& figure,
  const std::string& surface, const std::string& title, const std::string& fileName)
{
  // What is 0, or noise below 0, is drawn at the least that a logarithmic axis is given here.
  constexpr double LeastError = 1e-6;
  constexpr double LeastTime = 1e-3;
  std::vector<std::pair<double, double>> points;
  std::map<std::string, BenchCurve> curves;
  std::vector<std::pair<std::string, std::size_t>> places;
  for (const Json& row : rows)
  {
    const auto error = BenchFigure(row, figure, surface);
    if (error)
    {
      points.emplace_back(std::max(*BenchTime(row), LeastTime), std::max(*error, LeastError));
      const std::string technique = row["technique"];
      const std::string search = row.value("search", "");
      const std::string name = technique + (search.empty() ? "" : " " + search);
      BenchCurve& curve = curves[name];
      curve.Name = name;
      curve.Color = ColorOfTechnique(technique);
      places.emplace_back(name, curve.Points.size());
      curve.Points.push_back({ points.back().first, points.back().second, false });
    }
  }
  if (points.empty())
  {
    return false;
  }
  const std::vector<bool> dominated = MesoDominated(points);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    curves[places[i].first].Points[places[i].second].Dominated = dominated[i];
  }
  std::vector<BenchCurve> list;
  list.reserve(curves.size());
  for (const auto& curve : curves)
  {
    list.push_back(curve.second);
  }
  WritePlot(scene, title, list, fileName);
  return true;
}

const char* const TableFigures[] = { "texcoord_p50", "texcoord_p95", "texcoord_p99", "texcoord_max",
  "depth_p95", "normal_mean", "coverage_iou", "silhouette_px_mean", "shadow_attached",
  "shadow_cast", "void_pixels", "extra_pixels", "boundary_pixels", "hole_pixels", "nan_pixels",
  "flip_mean", "ssim", "rmse" };

/// A line of the table: a row by one of the truths, and what it costs where it is judged by that.
void WriteFigures(std::ostream& page, const Json& row, const std::string& surface)
{
  const bool judged = row["judged_by"] == surface;
  page << (judged ? "<tr><td>" : "<tr class=\"other\"><td>") << BenchLabel(row) << "</td><td>"
       << surface << "</td>";
  for (const std::string figure : TableFigures)
  {
    const auto value = BenchFigure(row, figure, surface);
    const bool bad = (figure == "hole_pixels" || figure == "nan_pixels") && value && *value > 0.;
    page << (bad ? "<td class=\"bad\">" : "<td>") << Number(value) << "</td>";
  }
  if (!judged)
  {
    page << "<td colspan=\"9\"></td></tr>\n";
    return;
  }
  for (const char* part : { "median", "min", "max" })
  {
    page << "<td>" << Number(row["gpu_ms"][part]) << "</td>";
  }
  for (const char* name : { "ratio_to_floor", "fetches_mean", "fetches_max" })
  {
    page << "<td>" << Number(row[name]) << "</td>";
  }
  page << "<td>" << row["gpu_bytes"] << "</td><td>" << Number(row["prepare_s"]) << "</td><td>"
       << row["triangles"] << "</td></tr>\n";
}

void WriteTable(std::ostream& page, const Rows& rows)
{
  page << "<div class=\"wrap\"><table><tr><th></th><th>by the</th>";
  for (const char* figure : TableFigures)
  {
    page << "<th>" << figure << "</th>";
  }
  page << "<th>gpu_ms</th><th>min</th><th>max</th><th>times plain</th><th>fetches</th>"
          "<th>fetches_max</th><th>gpu_bytes</th><th>prepare_s</th><th>triangles</th></tr>\n";
  for (const Json& row : rows)
  {
    if (row["status"] != "ok")
    {
      page << "<tr><td>" << BenchLabel(row) << "</td><td class=\"wide bad\" colspan=\""
           << 10 + std::size(TableFigures) << "\">refused: " << Escaped(row["reason"])
           << "</td></tr>\n";
      continue;
    }
    for (const auto& error : row["errors"].items())
    {
      WriteFigures(page, row, error.key());
    }
  }
  page << "</table></div>\n";
}

/// The settings that reach each error at the least cost, for a group of rows.
void WriteCosts(std::ostream& page, const std::string& name, const std::vector<const Json*>& rows)
{
  page << "<tr><td>" << name << "</td>";
  for (const double texels : BenchErrors)
  {
    const Json* row = CheapestWithin(rows, texels);
    page << "<td>"
         << (row ? BenchLabel(*row) + ", " + Number(BenchTime(*row)) +
                  Interval((*row)["gpu_ms"].value("interval", Json())) + " ms" + TimesPlain(*row)
                 : "not reached")
         << "</td>";
  }
  const Json* best = MostExact(rows);
  page << "<td>" << (best ? Number(BenchFigure(*best, "texcoord_p95")) : "&ndash;")
       << "</td></tr>\n";
}

void StartCosts(std::ostream& page, const std::string& title)
{
  page << "<div class=\"wrap\"><table><tr><th>" << title << "</th>";
  for (const double texels : BenchErrors)
  {
    page << "<th>" << texels << " texel</th>";
  }
  page << "<th>least texcoord_p95</th></tr>\n";
}

std::vector<const Json*> PointersTo(const Rows& rows, const std::string& technique = "")
{
  std::vector<const Json*> pointers;
  for (const Json& row : rows)
  {
    if (technique.empty() || row["technique"] == technique)
    {
      pointers.push_back(&row);
    }
  }
  return pointers;
}

/// What each technique comes to in each scene at its most exact setting.
void WriteMostExact(std::ostream& page, const BenchResults& results)
{
  page
    << "<h2>The most exact setting of each technique</h2>\n<p>texcoord_p95 in texels, and its time "
       "as a multiple of plain.</p>\n<div class=\"wrap\"><table><tr><th>scene</th>";
  for (const std::string& technique : MesoTechniqueNames())
  {
    page << "<th>" << technique << "</th>";
  }
  page << "</tr>\n";
  for (const Json& scene : results.All()["scenes"])
  {
    page << "<tr><td>" << Escaped(scene["scene"]) << "</td>";
    const Rows rows = results.RowsOf(scene["scene"]);
    for (const std::string& technique : MesoTechniqueNames())
    {
      const std::vector<const Json*> own = PointersTo(rows, technique);
      const Json* best = MostExact(own);
      page << (own.empty() || best ? "<td>" : "<td class=\"bad\">")
           << (best             ? Number(BenchFigure(*best, "texcoord_p95")) + TimesPlain(*best)
                  : own.empty() ? "not measured"
                                : "refused")
           << "</td>";
    }
    page << "</tr>\n";
  }
  page << "</table></div>\n";
}

void WritePictures(std::ostream& page, const Rows& rows)
{
  for (const Json& row : rows)
  {
    if (row["status"] != "ok")
    {
      continue;
    }
    page << "<figure><img src=\"" << Escaped(row["picture"]) << "\" alt=\"\"><figcaption>"
         << BenchLabel(row) << ": truth, technique, FLIP, classes (mean FLIP "
         << Number(BenchFigure(row, "flip_mean")) << ", texcoord_p95 "
         << Number(BenchFigure(row, "texcoord_p95")) << " texel)</figcaption></figure>\n";
  }
  page << "<h3>The worst pixels</h3>\n";
  for (const Json& row : rows)
  {
    if (row["status"] == "ok" && row.contains("worst_picture"))
    {
      const Json& pixel = row["errors"][row["judged_by"].get<std::string>()]["worst_texcoord"];
      page << "<figure><img src=\"" << Escaped(row["worst_picture"]) << "\" alt=\"\"><figcaption>"
           << BenchLabel(row) << ": truth, technique, classes around "
           << "column " << pixel[0] << ", row " << pixel[1] << ", which is off by "
           << Number(BenchFigure(row, "texcoord_max")) << " texels</figcaption></figure>\n";
    }
  }
}

void WriteScene(
  std::ostream& page, const BenchResults& results, const Json& scene, const std::string& folder)
{
  const std::string name = scene["scene"];
  page << "<h2 id=\"" << Escaped(name) << "\">" << Escaped(name) << "</h2>\n";
  if (scene["status"] != "ok")
  {
    page << "<p>There is no truth: " << Escaped(scene["reason"]) << "</p>\n";
    return;
  }
  const Rows rows = results.RowsOf(name);
  page << "<p>" << scene["size"][0] << " x " << scene["size"][1] << " pixels.";
  if (!scene["surfaces"].is_null())
  {
    page << " The mesh's truth against that of the smooth shape: texcoord_p95 "
         << Number(scene["surfaces"]["texcoord_p95"]) << " texel, depth_p95 "
         << Number(scene["surfaces"]["depth_p95"]) << " D, silhouette_px_mean "
         << Number(scene["surfaces"]["silhouette_px_mean"]) << " pixel.";
  }
  page << "</p>\n<div class=\"plots\">";
  const std::pair<const char*, const char*> plots[] = { { "texcoord_p95", "texcoord_p95, texel" },
    { "flip_mean", "mean FLIP" } };
  for (const std::string surface : scene["truths"])
  {
    for (const auto& plot : plots)
    {
      const std::string file = name + "/" + plot.first + "-" + surface + ".png";
      if (Plot(rows, name + ", by the " + surface + " surface", plot.first, surface, plot.second,
            folder + "/" + file))
      {
        page << "<img src=\"" << Escaped(file) << "\" alt=\"" << plot.second << " against time\"> ";
      }
    }
  }
  page << "</div>\n<p>Dominated settings are hollow: another one is no dearer and no worse.</p>\n";
  StartCosts(page, "cost to reach");
  std::vector<std::string> techniques;
  for (const Json& row : rows)
  {
    if (techniques.empty() || techniques.back() != row["technique"])
    {
      techniques.push_back(row["technique"]);
    }
  }
  for (const std::string& technique : techniques)
  {
    WriteCosts(page, technique, PointersTo(rows, technique));
  }
  page << "</table></div>\n";
  WriteErrorsAtTimes(page, rows);
  WriteEqualError(page, rows);
  WriteOrders(page, rows);
  WriteAblation(page, results.AblationsOf(name));
  WriteTable(page, rows);
  WritePictures(page, rows);
}

/// What the colours of classes mean.
void WriteLegend(std::ostream& page)
{
  page << "<p>Classes:";
  for (int i = 0; i <= static_cast<int>(MesoPixelClass::Equal); ++i)
  {
    const auto kind = static_cast<MesoPixelClass>(i);
    const MesoByteColor color = MesoColorOfClass(kind);
    page << " <span class=\"key\" style=\"background: rgb(" << int(color[0]) << ' ' << int(color[1])
         << ' ' << int(color[2]) << ")\"></span>&nbsp;" << MesoNameOfClass(kind);
  }
  page << ". FLIP errors: from black (0) over violet and orange to a pale yellow (1).</p>\n";
}
}

void WriteReport(const BenchResults& results, const std::string& folder)
{
  const Json& all = results.All();
  std::ostringstream page;
  page
    << Head << "<h1>Accuracy and cost</h1>\n<p>Drawn by " << Escaped(all["device"]) << ", meso "
    << Escaped(all["version"]) << ", on "
    << Escaped(all["machine"].value("processor", "an unknown processor")) << ", "
    << all["machine"]["cores"] << " cores, "
    << Escaped(all["machine"].value("system", "an unknown system"))
    << ".</p>\n<p>Times of one machine compare with one another; beside each stands its ratio "
       "to the "
       "base mesh drawn plain in the same run, measured in turns. The row <em>plain</em> is "
       "measured beside that floor like any other: how far its ratio is from 1 is the noise. "
       "Techniques that model the smooth shape are judged by it, the others by the mesh. By the "
       "<em>solver</em> is by the technique's own model solved exactly: what remains is the error "
       "of its search. Raw numbers: <a "
       "href=\"results.csv\">results.csv</a>, <a href=\"results.json\">results.json</a>.</p>\n"
       "<h2>The cheapest setting that reaches an error (texcoord_p95)</h2>\n";
  StartCosts(page, "scene");
  for (const Json& scene : all["scenes"])
  {
    const std::string name = Escaped(scene["scene"]);
    const Rows rows = results.RowsOf(scene["scene"]);
    WriteCosts(page, "<a href=\"#" + name + "\">" + name + "</a>", PointersTo(rows));
  }
  page << "</table></div>\n";
  WriteMostExact(page, results);
  WriteScaling(page, all["scaling"]);
  WriteLegend(page);
  for (const Json& scene : all["scenes"])
  {
    WriteScene(page, results, scene, folder);
  }
  page << "</body></html>\n";
  const std::string bytes = page.str();
  MesoAtomicFile::Write(folder + "/report.html", bytes.data(), bytes.size());
}
