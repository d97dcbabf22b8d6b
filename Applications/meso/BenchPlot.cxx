#include "BenchPlot.h"

#include "CommandLine.h"
#include "MesoAtomicFile.h"
#include "RenderResults.h"
#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPlotLine.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Width = 720;
constexpr int Height = 520;

vtkSmartPointer<vtkTable> TableOf(const std::vector<BenchPoint>& points)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkNew<vtkDoubleArray> times;
  vtkNew<vtkDoubleArray> errors;
  times->SetName("time");
  errors->SetName("error");
  for (const BenchPoint& point : points)
  {
    times->InsertNextValue(point.Time);
    errors->InsertNextValue(point.Error);
  }
  table->AddColumn(times);
  table->AddColumn(errors);
  return table;
}

vtkPlotPoints* AddPlot(vtkChartXY* chart, int kind, const std::vector<BenchPoint>& points,
  const std::array<unsigned char, 3>& color, float size)
{
  auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(kind));
  plot->SetInputData(TableOf(points), 0, 1);
  plot->SetColor(color[0], color[1], color[2], 255);
  plot->SetWidth(kind == vtkChart::LINE ? 2.f : 1.f);
  plot->SetMarkerStyle(vtkPlotPoints::CIRCLE);
  plot->SetMarkerSize(size);
  plot->SetLegendVisibility(false);
  return plot;
}

/// A range around the values that ends at ticks: at 1, 2 and 5 of each decade, over many decades at
/// 1 alone. No value touches the ends.
void SetTicks(vtkAxis* axis, const std::string& title, double least, double most)
{
  const double first = std::floor(std::log10(least)) - 1.;
  const double last = std::ceil(std::log10(most)) + 1.;
  const std::vector<double> parts =
    last - first > 6. ? std::vector<double>{ 1. } : std::vector<double>{ 1., 2., 5. };
  std::vector<double> ticks;
  for (double decade = first; decade <= last; decade += 1.)
  {
    for (const double part : parts)
    {
      ticks.push_back(part * std::pow(10., decade));
    }
  }
  const auto low = std::lower_bound(ticks.begin(), ticks.end(), 0.9 * least) - 1;
  const auto high = std::upper_bound(ticks.begin(), ticks.end(), 1.1 * most);
  vtkNew<vtkDoubleArray> places;
  vtkNew<vtkStringArray> labels;
  for (auto tick = low; tick <= high; ++tick)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%g", *tick);
    places->InsertNextValue(std::log10(*tick));
    labels->InsertNextValue(text);
  }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetUnscaledRange(*low, *high);
  axis->SetLogScale(true);
  axis->SetCustomTickPositions(places, labels);
  axis->SetTitle(title);
  axis->GetTitleProperties()->SetFontSize(16);
  axis->GetLabelProperties()->SetFontSize(14);
}
}

void WritePlot(const std::string& title, const std::string& errorTitle,
  const std::vector<BenchCurve>& curves, const std::string& fileName)
{
  vtkNew<vtkChartXY> chart;
  chart->SetTitle(title);
  chart->GetTitleProperties()->SetFontSize(18);
  chart->SetShowLegend(true);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  double range[2][2] = { { HUGE_VAL, 0. }, { HUGE_VAL, 0. } };
  for (const BenchCurve& curve : curves)
  {
    std::vector<BenchPoint> hollow;
    for (const BenchPoint& point : curve.Points)
    {
      const double values[2] = { point.Time, point.Error };
      for (int axis = 0; axis < 2; ++axis)
      {
        range[axis][0] = std::min(range[axis][0], values[axis]);
        range[axis][1] = std::max(range[axis][1], values[axis]);
      }
      if (point.Dominated)
      {
        hollow.push_back(point);
      }
    }
    vtkPlotPoints* line = AddPlot(chart,
      curve.Points.size() > 1 ? vtkChart::LINE : vtkChart::POINTS, curve.Points, curve.Color, 11.f);
    line->SetLabel(curve.Name);
    line->SetLegendVisibility(true);
    if (!hollow.empty())
    {
      AddPlot(chart, vtkChart::POINTS, hollow, { 255, 255, 255 }, 7.f);
    }
  }
  SetTicks(chart->GetAxis(vtkAxis::BOTTOM), "time on the GPU or in software, ms", range[0][0],
    range[0][1]);
  SetTicks(chart->GetAxis(vtkAxis::LEFT), errorTitle, range[1][0], range[1][1]);

  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(4);
  window->SetSize(Width, Height);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1., 1., 1.);
  window->AddRenderer(renderer);
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart);
  renderer->AddActor(actor);
  actor->GetScene()->SetRenderer(renderer);
  const std::string bytes = PictureBytes(RenderPicture(window, renderer, 1, [](double) {}));
  MesoAtomicFile::Write(fileName, bytes.data(), bytes.size());
}
