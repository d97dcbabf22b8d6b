#include "MesoScalarBar.h"

#include "vtkLookupTable.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
/// The table of heights as one of the map's stored numbers, which fall with the height in a depth map.
vtkSmartPointer<vtkLookupTable> OverMapNumbers(
  vtkLookupTable* heights, const std::array<double, 2>& numbers)
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->DeepCopy(heights);
  const double* range = heights->GetRange();
  const auto numberOf = [&](double height)
  { return numbers[0] + height * (numbers[1] - numbers[0]); };
  if (numbers[0] <= numbers[1])
  {
    table->SetRange(numberOf(range[0]), numberOf(range[1]));
    return table;
  }
  table->SetRange(numberOf(range[1]), numberOf(range[0]));
  const vtkIdType size = heights->GetNumberOfTableValues();
  for (vtkIdType i = 0; i < size; ++i)
  {
    table->SetTableValue(i, heights->GetTableValue(size - 1 - i));
  }
  return table;
}

std::string TitleOf(const MesoSceneScalarBar& bar, const MesoSceneColorBy& colorBy)
{
  std::string title = bar.Title;
  if (title.empty())
  {
    title = colorBy.Array;
    title += colorBy.Component ? "[" + std::to_string(*colorBy.Component) + "]" : "";
  }
  return bar.Units.empty() ? title : title + " [" + bar.Units + "]";
}
}

MesoContourLines MesoContoursOfScene(
  const MesoSceneContours& contours, const std::array<double, 2>& mapNumbers)
{
  std::array<double, 2> numbers = { 0., 1. };
  if (contours.ValuesOf == MesoSceneHeightUnit::Map)
  {
    numbers = mapNumbers;
  }
  const double span = numbers[1] - numbers[0];
  MesoContourLines lines;
  lines.Color = contours.Color;
  lines.Width = contours.Width;
  lines.Spacing = contours.Spacing / std::abs(span);
  lines.Offset = contours.Spacing > 0. ? -numbers[0] / span : 0.;
  for (const double value : contours.Values)
  {
    lines.Heights.push_back((value - numbers[0]) / span);
  }
  return lines;
}

vtkSmartPointer<vtkScalarBarActor> MesoMakeScalarBar(const MesoSceneScalarBar& bar,
  const MesoSceneColorBy& colorBy, vtkMesoPolyDataMapper* mapper, int place, vtkRenderer* renderer)
{
  vtkSmartPointer<vtkScalarsToColors> table = mapper->GetLookupTable();
  if (colorBy.IsHeight())
  {
    table = bar.ValuesOf == MesoSceneHeightUnit::Map
      ? OverMapNumbers(mapper->GetHeightColors(), mapper->GetMapNumbers())
      : vtkSmartPointer<vtkLookupTable>(mapper->GetHeightColors());
  }
  constexpr double width = 0.19; // of the picture
  constexpr double height = 0.8;
  constexpr int smallest = 9; // letters, pixels high
  const int size = std::max(smallest, renderer->GetRenderWindow()->GetSize()[1] / 28);
  auto actor = vtkSmartPointer<vtkScalarBarActor>::New();
  actor->SetLookupTable(table);
  actor->SetTitle(TitleOf(bar, colorBy).c_str());
  actor->SetNumberOfLabels(5);
  actor->SetLabelFormat("%-.3g");
  actor->SetMaximumNumberOfColors(256);
  actor->SetBarRatio(0.2);
  actor->SetVerticalTitleSeparation(size / 2);
  actor->UnconstrainedFontSizeOn();
  actor->SetWidth(width);
  actor->SetHeight(height);
  actor->SetPosition(1. - (place + 1) * width, 0.5 * (1. - height));
  const double* background = renderer->GetBackground();
  const double luma = 0.2126 * background[0] + 0.7152 * background[1] + 0.0722 * background[2];
  for (vtkTextProperty* text : { actor->GetTitleTextProperty(), actor->GetLabelTextProperty() })
  {
    const double ink = luma > 0.4 ? 0. : 1.;
    text->SetColor(ink, ink, ink);
    text->SetFontSize(size);
    text->ShadowOff();
    text->ItalicOff();
    text->BoldOff();
  }
  return actor;
}
