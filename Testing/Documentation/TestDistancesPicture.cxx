// The picture of three distances to a curved base in Documentation/CurvedRelief.md: Oliveira2005, Figure 10,
// against the true depth.

#include "ChartPicture.h"
#include "QuadricDistances.h"

#include "vtkAutoInit.h"
#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkFloatArray.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <gtest/gtest.h>

VTK_MODULE_INIT(vtkRenderingContextOpenGL2) // charts

namespace
{
vtkSmartPointer<vtkTable> Table()
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (const char* name : { "degrees from the normal", "across the view ray (equation 6)",
         "along the fragment's normal (equation 7)", "along the base's own normals" })
  {
    vtkNew<vtkFloatArray> column;
    column->SetName(name);
    table->AddColumn(column);
  }
  for (int degrees = 0; degrees < 90; ++degrees)
  {
    const QuadricDistances at = DistancesAt(std::max(0.1, double(degrees)));
    const double values[4] = { at.Degrees, at.Across, at.Along, at.Normal };
    for (int i = 0; i < 4; ++i)
    {
      vtkFloatArray::SafeDownCast(table->GetColumn(i))
        ->InsertNextValue(static_cast<float>(values[i]));
    }
  }
  return table;
}
}

TEST(DistancesPicture, ThreeDistancesOverTheTrueOne)
{
  const auto table = Table();
  // What the picture shows: near the normal equation 6 is the worst, and the base's own normals the best.
  double worstAlong = 0.;
  double worstNormal = 0.;
  for (int row = 0; row < table->GetNumberOfRows(); ++row)
  {
    worstAlong = std::max(worstAlong, std::abs(table->GetValue(row, 2).ToDouble() - 1.));
    worstNormal = std::max(worstNormal, std::abs(table->GetValue(row, 3).ToDouble() - 1.));
  }
  EXPECT_GT(table->GetValue(0, 1).ToDouble(), 6.);
  EXPECT_LT(std::abs(table->GetValue(89, 1).ToDouble() - 1.), 0.01);
  EXPECT_LT(worstAlong, 0.01);
  EXPECT_LT(worstNormal, 0.001);

  vtkNew<vtkChartXY> chart;
  chart->SetShowLegend(true);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
  const unsigned char colors[3][3] = { { 214, 39, 40 }, { 31, 119, 180 }, { 44, 160, 44 } };
  const float widths[3] = { 3.f, 5.f, 2.f };
  for (int i = 0; i < 3; ++i)
  {
    vtkPlot* plot = chart->AddPlot(vtkChart::LINE);
    plot->SetInputData(table, 0, i + 1);
    plot->SetColor(colors[i][0], colors[i][1], colors[i][2], 255);
    plot->SetWidth(widths[i]);
  }
  const char* const titles[2] = { "distance / true depth", "degrees between view and normal" };
  for (int i = 0; i < 2; ++i)
  {
    vtkAxis* axis = chart->GetAxis(i == 0 ? vtkAxis::LEFT : vtkAxis::BOTTOM);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(0., i == 0 ? 7. : 90.);
    axis->SetTitle(titles[i]);
    axis->GetTitleProperties()->SetFontSize(14);
  }
  ExpectChart(chart, "CurvedDistances");
}
