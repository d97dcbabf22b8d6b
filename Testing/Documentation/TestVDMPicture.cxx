// The plots in Documentation/Techniques/VDM.md, of what BenchVDM and BenchVDMFactors have measured.

#include "ChartPicture.h"

#include "vtkAutoInit.h"
#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkFloatArray.h"
#include "vtkPen.h"
#include "vtkPlotPoints.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

VTK_MODULE_INIT(vtkRenderingContextOpenGL2) // charts

namespace
{
/// A file of comma-separated values below a line of names.
class Results
{
public:
  explicit Results(const std::string& name)
  {
    std::ifstream file(std::string(MESO_RESULTS) + "/" + name);
    std::string line;
    std::getline(file, line);
    this->Names = Split(line);
    while (std::getline(file, line))
    {
      this->Rows.push_back(Split(line));
    }
  }

  struct Point
  {
    double X;
    double Y;
  };
  using Curve = std::vector<Point>;

  /// Of the rows that hold a text in a column; those without a y are left out.
  Curve Select(const std::string& column, const std::string& text, const std::string& x,
    const std::string& y) const
  {
    Curve curve;
    for (const std::vector<std::string>& row : this->Rows)
    {
      if (row.at(this->IndexOf(column)) == text && !row.at(this->IndexOf(y)).empty())
      {
        curve.push_back(
          { std::stod(row.at(this->IndexOf(x))), std::stod(row.at(this->IndexOf(y))) });
      }
    }
    return curve;
  }

private:
  static std::vector<std::string> Split(const std::string& line)
  {
    std::vector<std::string> cells;
    std::istringstream stream(line + ",");
    for (std::string cell; std::getline(stream, cell, ',');)
    {
      cells.push_back(cell);
    }
    return cells;
  }

  std::size_t IndexOf(const std::string& name) const
  {
    const auto found = std::find(this->Names.begin(), this->Names.end(), name);
    EXPECT_NE(found, this->Names.end()) << name;
    return found - this->Names.begin();
  }

  std::vector<std::string> Names;
  std::vector<std::vector<std::string>> Rows;
};

struct Line
{
  std::string Title;
  Results::Curve Curve;
  bool Dashed = false;
  int Color = 0;
};

struct Axis
{
  const char* Title;
  double Low;
  double High;
  bool Logarithmic = false;
};

void Draw(const std::vector<Line>& lines, const Axis& across, const Axis& up, const char* name)
{
  const unsigned char colors[][3] = { { 31, 119, 180 }, { 214, 39, 40 }, { 44, 160, 44 },
    { 148, 103, 189 } };
  vtkNew<vtkChartXY> chart;
  chart->SetShowLegend(true);
  // Where errors that fall or rise leave room.
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::LEFT);
  chart->GetLegend()->SetVerticalAlignment(
    up.Logarithmic ? vtkChartLegend::BOTTOM : vtkChartLegend::TOP);
  for (int i = 0; i < 2; ++i)
  {
    const Axis& wanted = i == 0 ? up : across;
    vtkAxis* axis = chart->GetAxis(i == 0 ? vtkAxis::LEFT : vtkAxis::BOTTOM);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetLogScale(wanted.Logarithmic);
    axis->SetUnscaledRange(wanted.Low, wanted.High);
    axis->SetTitle(wanted.Title);
    axis->GetTitleProperties()->SetFontSize(14);
  }
  for (const Line& line : lines)
  {
    vtkNew<vtkTable> table;
    vtkNew<vtkFloatArray> x;
    vtkNew<vtkFloatArray> y;
    x->SetName("x");
    y->SetName(line.Title.c_str());
    for (const Results::Point& point : line.Curve)
    {
      x->InsertNextValue(static_cast<float>(point.X));
      y->InsertNextValue(static_cast<float>(point.Y));
    }
    table->AddColumn(x);
    table->AddColumn(y);
    auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(vtkChart::LINE));
    plot->SetInputData(table, 0, 1);
    const unsigned char* color = colors[line.Color];
    plot->SetColor(color[0], color[1], color[2], 255);
    plot->SetWidth(2.f);
    plot->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    plot->SetMarkerSize(6.f);
    plot->GetPen()->SetLineType(line.Dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE);
  }
  ExpectChart(chart, name);
}

/// By their columns, in the order of the bench.
const char* const Arrangements[] = { "theta c", "theta", "c", "phi theta c" };

std::vector<Line> LinesOver(const std::string& x, double unit)
{
  const Results results("vdm-arrangements.csv");
  std::vector<Line> lines;
  for (int i = 0; i < 4; ++i)
  {
    lines.push_back({ std::string("columns ") + Arrangements[i],
      results.Select("columns", Arrangements[i], x, "rms"), false, i });
    EXPECT_GE(lines.back().Curve.size(), 5u);
    for (Results::Point& point : lines.back().Curve)
    {
      point.X /= unit;
    }
  }
  return lines;
}

/// The least error of a curve up to an x; infinite where it has none.
double LeastUpTo(const Results::Curve& curve, double x)
{
  double least = HUGE_VAL;
  for (const Results::Point& point : curve)
  {
    least = point.X <= x ? std::min(least, point.Y) : least;
  }
  return least;
}
}

TEST(VDMPicture, ErrorOverBytes)
{
  const std::vector<Line> lines = LinesOver("bytes", 1e6);
  // What the picture shows: of columns over angle, curvature or both, both leave least from 1 to 5 MB.
  for (const double megabytes : { 1.1, 2.2, 4.8 })
  {
    EXPECT_LT(LeastUpTo(lines[0].Curve, megabytes), LeastUpTo(lines[1].Curve, megabytes));
    EXPECT_LT(LeastUpTo(lines[0].Curve, megabytes), LeastUpTo(lines[2].Curve, megabytes));
  }
  Draw(lines, { "megabytes", 0.03, 100., true }, { "RMS of distances, tiles", 1e-4, 0.03, true },
    "VDMErrorOverBytes");
}

TEST(VDMPicture, ErrorOverRank)
{
  const std::vector<Line> lines = LinesOver("rank", 1.);
  for (const Line& line : lines)
  {
    for (std::size_t i = 1; i < line.Curve.size(); ++i)
    {
      EXPECT_LT(line.Curve[i].Y, line.Curve[i - 1].Y) << line.Title;
    }
  }
  Draw(lines, { "rank", 1., 64., true }, { "RMS of distances, tiles", 1e-4, 0.03, true },
    "VDMErrorOverRank");
}

TEST(VDMPicture, TheShortcutOverCurvature)
{
  const Results results("vdm-curvatures.csv");
  std::vector<Line> lines;
  for (const char* polar : { "70", "50" })
  {
    for (const char* curved : { "bent", "exact" })
    {
      lines.push_back({ std::string(curved) + ", " + polar + " degrees",
        results.Select("curved", curved, "curvature", std::string(polar) + " median"),
        std::string(curved) == "bent", polar[0] == '7' ? 1 : 0 });
      EXPECT_EQ(lines.back().Curve.size(), 21u);
    }
  }
  // The same where the base is flat, and off on both sides.
  constexpr std::size_t Flat = 8;
  for (const std::size_t i : { 0, 2 })
  {
    EXPECT_EQ(lines[i].Curve[Flat].X, 0.);
    EXPECT_EQ(lines[i].Curve[Flat].Y, lines[i + 1].Curve[Flat].Y);
    EXPECT_GT(lines[i].Curve[Flat - 4].Y, 1.2 * lines[i + 1].Curve[Flat - 4].Y);
    EXPECT_GT(lines[i].Curve[Flat + 4].Y, 1.4 * lines[i + 1].Curve[Flat + 4].Y);
  }
  Draw(
    lines, { "curvature, 1 / tile", -2., 3. }, { "median error, texels", 0., 2.5 }, "VDMShortcut");
}
