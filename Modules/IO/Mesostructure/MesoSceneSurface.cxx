#include "MesoSceneSurface.h"

#include "MesoColorMap.h"
#include "MesoContourLines.h"
#include "MesoSceneParameters.h"
#include "MesoShape.h"

#include <tuple>
#include <utility>

namespace
{

/// "NAME" or "NAME[component]": the name, and the component where there is one.
std::pair<std::string, std::optional<int>> ReadArrayName(const MesoSceneValue& value)
{
  const std::string text = value.ToText();
  if (text.back() != ']')
  {
    return { text, std::nullopt };
  }
  constexpr std::size_t mostDigits = 4;
  const std::size_t bracket = text.rfind('[');
  const std::string digits =
    bracket == std::string::npos ? "" : text.substr(bracket + 1, text.size() - bracket - 2);
  if (bracket == 0 || digits.empty() || digits.size() > mostDigits ||
    digits.find_first_not_of("0123456789") != std::string::npos)
  {
    value.Fail(
      "must be the name of a point array, or NAME[i] with a component's number i from 0 on");
  }
  return { text.substr(0, bracket), std::stoi(digits) };
}

MesoSceneColorBy ReadColorBy(const MesoSceneValue& value)
{
  MesoSceneColorBy colorBy;
  std::tie(colorBy.Array, colorBy.Component) = ReadArrayName(value);
  if (colorBy.IsHeight() && colorBy.Component)
  {
    value.Fail("height has no components");
  }
  return colorBy;
}

void ReadLookupTable(const MesoSceneValue& value, MesoSceneColorBy& colorBy)
{
  value.CheckKeys("lookup_table");
  value.With("name",
    [&](const MesoSceneValue& name)
    { colorBy.LookupTable = MesoReadName(name, "lookup table", MesoColorMapNames(), {}); });
  value.With("range", [&](const MesoSceneValue& range) { colorBy.Range = MesoReadRange(range); });
}

MesoSceneHeightUnit ReadValuesOf(const MesoSceneValue& value)
{
  return MesoReadName(value, "kind of values", { "height", "map" }, {}) == "map"
    ? MesoSceneHeightUnit::Map
    : MesoSceneHeightUnit::Height;
}

MesoSceneContours ReadContours(const MesoSceneValue& value)
{
  value.CheckKeys("contours");
  if (value.Has("spacing") == value.Has("values"))
  {
    value.Fail("needs either spacing or values");
  }
  MesoSceneContours contours;
  value.With("spacing",
    [&](const MesoSceneValue& spacing)
    { contours.Spacing = spacing.ToNumber(MesoSceneRanges::Positive); });
  value.With("values",
    [&](const MesoSceneValue& values)
    {
      for (const MesoSceneValue& element : values.ToList())
      {
        contours.Values.push_back(element.ToNumber());
      }
      if (contours.Values.empty() || contours.Values.size() > MesoContourLines::MostHeights)
      {
        values.Fail("needs 1 to " + std::to_string(MesoContourLines::MostHeights) + " numbers");
      }
    });
  value.With(
    "values_of", [&](const MesoSceneValue& unit) { contours.ValuesOf = ReadValuesOf(unit); });
  value.With("color",
    [&](const MesoSceneValue& color)
    { contours.Color = color.ToNumbers<3>(MesoSceneRanges::Fraction); });
  value.With("width",
    [&](const MesoSceneValue& width)
    {
      contours.Width = width.ToNumber({ 0., MesoContourLines::MostWidth, true });
      if (contours.Width == 0.)
      {
        width.Fail("must be more than 0");
      }
    });
  return contours;
}

/// `true`, or an object.
std::optional<MesoSceneScalarBar> ReadScalarBar(
  const MesoSceneValue& value, const MesoSceneColorBy& colorBy)
{
  if (value.IsBoolean())
  {
    return value.ToBoolean() ? std::make_optional(MesoSceneScalarBar()) : std::nullopt;
  }
  value.CheckKeys("scalar_bar");
  MesoSceneScalarBar bar;
  value.With("title", [&](const MesoSceneValue& title) { bar.Title = title.ToText(); });
  value.With("units", [&](const MesoSceneValue& units) { bar.Units = units.ToText(); });
  value.With("values_of",
    [&](const MesoSceneValue& unit)
    {
      if (!colorBy.IsHeight())
      {
        unit.Fail("is for color_by height");
      }
      bar.ValuesOf = ReadValuesOf(unit);
    });
  return bar;
}

}

MesoSceneMesh MesoReadSceneMesh(const MesoSceneValue& value)
{
  MesoSceneMesh mesh;
  if (value.IsString())
  {
    mesh.File = value.ToFileName();
    return mesh;
  }
  MesoCheckNamesKind(value, "shape");
  mesh.Shape = MesoReadName(value.At("shape"), "shape", MesoShapeNames(), {});
  value.CheckKeys("shape_" + mesh.Shape);
  for (const MesoParameter& parameter : MesoShapeParameters(mesh.Shape))
  {
    value.With(parameter.Key,
      [&](const MesoSceneValue& numbers)
      { mesh.Parameters[parameter.Key] = MesoReadParameter(numbers, parameter); });
  }
  const std::string problem = MesoShapeProblem(mesh.Shape, mesh.Parameters);
  if (!problem.empty())
  {
    value.Fail(problem);
  }
  return mesh;
}

MesoScenePart MesoReadScenePart(const MesoSceneValue& value)
{
  value.CheckKeys("part");
  MesoScenePart part;
  std::tie(part.By, part.Component) = ReadArrayName(value.At("by"));
  part.Range = MesoReadRange(value.At("range"));
  return part;
}

MesoSceneMaterial MesoReadSceneMaterial(const MesoSceneValue& value)
{
  value.CheckKeys("material");
  MesoSceneMaterial material;
  const auto fraction = [&](const char* key, double& target)
  {
    value.With(key,
      [&](const MesoSceneValue& number) { target = number.ToNumber(MesoSceneRanges::Fraction); });
  };
  const auto flag = [&](const char* key, bool& target)
  { value.With(key, [&](const MesoSceneValue& boolean) { target = boolean.ToBoolean(); }); };
  value.With("color",
    [&](const MesoSceneValue& color)
    { material.Color = color.ToNumbers<3>(MesoSceneRanges::Fraction); });
  value.With(
    "color_map", [&](const MesoSceneValue& name) { material.ColorMap = name.ToFileName(); });
  value.With(
    "normal_map", [&](const MesoSceneValue& name) { material.NormalMap = name.ToFileName(); });
  if (!value.Has("normal_map"))
  {
    value.Refuse({ "normal_map_y" }, "there is no normal_map that it is of");
  }
  value.With("normal_map_y",
    [&](const MesoSceneValue& way) {
      material.NormalMapDown = MesoReadName(way, "way of green", { "up", "down" }, {}) == "down";
    });
  if (value.Has("color_by"))
  {
    value.Refuse({ "color_map" }, "there is a color_by already; only one of them gives the color");
    material.ColorBy = ReadColorBy(value.At("color_by"));
    value.With("lookup_table",
      [&](const MesoSceneValue& table) { ReadLookupTable(table, *material.ColorBy); });
    value.With("scalar_bar",
      [&](const MesoSceneValue& bar)
      { material.ScalarBar = ReadScalarBar(bar, *material.ColorBy); });
  }
  else
  {
    value.Refuse({ "lookup_table", "scalar_bar" }, "there is no color_by that it is of");
  }
  value.With("contours",
    [&](const MesoSceneValue& contours) { material.Contours = ReadContours(contours); });
  fraction("ambient", material.Ambient);
  fraction("diffuse", material.Diffuse);
  fraction("specular", material.Specular);
  fraction("opacity", material.Opacity);
  // vtkProperty clamps the power to 128 without a word.
  value.With("specular_power",
    [&](const MesoSceneValue& power) {
      material.SpecularPower = power.ToNumber({ 0., 128., true });
    });
  flag("two_sided", material.TwoSided);
  flag("edges", material.Edges);
  return material;
}
