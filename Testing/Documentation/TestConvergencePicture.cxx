// The plot of section 3.2's claim in Documentation/Techniques/ShellSDF.md: that the distortion of straight ways through
// prisms goes to 0 as the base is made finer. Each base is judged by its own truth.

#include "ChartPicture.h"
#include "DrawnAOVs.h"
#include "MesoGeometryError.h"
#include "MesoReference.h"
#include "MesoScene.h"

#include "vtkAutoInit.h"
#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkFloatArray.h"
#include "vtkPlot.h"
#include "vtkPlotPoints.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <gtest/gtest.h>

VTK_MODULE_INIT(vtkRenderingContextOpenGL2) // charts

namespace
{
constexpr int Width = 160;
constexpr int Height = 120;

MesoScene Scene(const std::string& technique, int rings)
{
  return MesoParseScene(R"({"meso": 1, "camera": {"position": [0, 3, 5], "view_angle": 24},
      "lights": [], "nodes": [{"mesh": {"shape": "torus", "rings": )" +
      std::to_string(rings) + R"(, "sides": )" + std::to_string(rings / 2) +
      R"(}, "mesostructure": {"scale": 0.08, "tiles": [12, 5], "quality": "high",
      "volume": {"pattern": "weave", "size": [32, 32, 16]}, "technique": ")" +
      technique + "\"}}]}",
    "test.json");
}

MesoGeometryError ErrorOf(const std::string& technique, int rings)
{
  const MesoScene scene = Scene(technique, rings);
  return MesoCompareGeometry(MesoAOVsOfImage(MesoReference(scene).Render(Width, Height).AOVs),
    DrawnAOVs(scene, Width, Height));
}

vtkSmartPointer<vtkTable> TableOf(const std::vector<const char*>& names)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const char* name : names)
  {
    vtkNew<vtkFloatArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  return table;
}
}

TEST(ConvergencePicture, DistortionGoesToNothingAsTheBaseIsMadeFiner)
{
  const auto table =
    TableOf({ "facets around the torus", "shell-sdf", "gdm", "half at twice the facets" });
  std::vector<double> sdf;
  std::vector<double> gdm;
  for (const int rings : { 12, 24, 48, 96 })
  {
    sdf.push_back(ErrorOf("shell-sdf", rings).Texcoord.P50);
    gdm.push_back(ErrorOf("gdm", rings).Texcoord.P50);
    std::cout << rings << ": shell-sdf " << sdf.back() << ", gdm " << gdm.back() << "\n";
    const double values[4] = { double(rings), sdf.back(), gdm.back(), sdf.front() * 12. / rings };
    for (int i = 0; i < 4; ++i)
    {
      vtkFloatArray::SafeDownCast(table->GetColumn(i))
        ->InsertNextValue(static_cast<float>(values[i]));
    }
  }
  for (std::size_t i = 1; i < sdf.size(); ++i)
  {
    EXPECT_LT(sdf[i], 0.85 * sdf[i - 1]) << i;
  }
  EXPECT_LT(sdf.back(), 0.2 * sdf.front());

  vtkNew<vtkChartXY> chart;
  chart->SetShowLegend(true);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  const unsigned char colors[3][3] = { { 31, 119, 180 }, { 214, 39, 40 }, { 150, 150, 150 } };
  for (int i = 0; i < 3; ++i)
  {
    vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
    plot->SetInputData(table, 0, i + 1);
    plot->SetColor(colors[i][0], colors[i][1], colors[i][2], 255);
    plot->SetWidth(i == 2 ? 1.f : 3.f);
    vtkPlotPoints::SafeDownCast(plot)->SetMarkerStyle(
      i == 2 ? vtkPlotPoints::NONE : vtkPlotPoints::CIRCLE);
  }
  const char* const titles[2] = { "median error of the map coordinate, texels",
    "facets around the torus" };
  for (int i = 0; i < 2; ++i)
  {
    vtkAxis* axis = chart->GetAxis(i == 0 ? vtkAxis::LEFT : vtkAxis::BOTTOM);
    axis->SetTitle(titles[i]);
    axis->GetTitleProperties()->SetFontSize(14);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->LogScaleOn();
    axis->SetUnscaledRange(i == 0 ? 0.002 : 10., i == 0 ? 0.2 : 120.);
  }
  ExpectChart(chart, "ShellConvergence");
}
