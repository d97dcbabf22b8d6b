#include "MesoSceneSurface.h"

#include "MesoColorMap.h"
#include "MesoContourLines.h"
#include "MesoPattern.h"
#include "MesoSceneParameters.h"
#include "MesoSceneVolume.h"
#include "MesoShape.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace
{

constexpr double MostFactors = 12.;
constexpr double MostFactorsOfVolumes = 64.;

MesoSceneMap ReadMap(const MesoSceneValue& value)
{
  MesoSceneMap map;
  if (value.IsString())
  {
    map.File = value.ToFileName();
    return map;
  }
  MesoCheckNamesKind(value, "pattern");
  map.Pattern = MesoReadName(value.At("pattern"), "pattern", MesoPatternNames(), {});
  value.CheckKeys("pattern_" + map.Pattern);
  value.With("size",
    [&](const MesoSceneValue& size)
    {
      const auto list = size.ToList(2);
      const MesoSceneRange texels = { 1., MesoPatternMaximumSize, true };
      map.Size = { static_cast<int>(list[0].ToInteger(texels)),
        static_cast<int>(list[1].ToInteger(texels)) };
    });
  MesoReadPatternValues(value, MesoPatternParameters(map.Pattern), map.Seed, map.Parameters);
  // The values one by one are right; some do not go together.
  const std::string problem = MesoPatternProblem(map.Pattern, map.Parameters);
  if (!problem.empty())
  {
    value.Fail(problem);
  }
  return map;
}

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

/// [from, to], the one less than the other.
std::array<double, 2> ReadRange(const MesoSceneValue& value)
{
  const auto range = value.ToNumbers<2>();
  if (!(range[0] < range[1]))
  {
    value.Fail("the first number must be less than the second");
  }
  return range;
}

void ReadLookupTable(const MesoSceneValue& value, MesoSceneColorBy& colorBy)
{
  value.CheckKeys("lookup_table");
  value.With("name",
    [&](const MesoSceneValue& name)
    { colorBy.LookupTable = MesoReadName(name, "lookup table", MesoColorMapNames(), {}); });
  value.With("range", [&](const MesoSceneValue& range) { colorBy.Range = ReadRange(range); });
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

MesoEffectChoice ReadEffects(const MesoSceneValue& value, MesoTechnique technique)
{
  const MesoEffects provided = MesoEffectsOfTechnique(technique);
  MesoEffectChoice choice;
  if (value.IsString())
  {
    const std::string word =
      MesoReadName(value, "choice of effects", { "auto", "all", "none" }, {});
    choice.Auto = word == "auto";
    choice.Named = word == "all" ? provided : MesoEffects();
    return choice;
  }
  choice.Auto = false;
  for (const MesoSceneValue& element : value.ToList())
  {
    const auto effect =
      element.ToChoice<MesoEffect>("effect", &MesoEffectFromName, MesoEffectNames());
    if (!provided.Has(effect))
    {
      std::string names;
      for (const std::string& name : provided.Names())
      {
        names += (names.empty() ? "" : ", ") + name;
      }
      element.Fail(std::string("technique ") + MesoName(technique) + " does not provide " +
        MesoName(effect) + " (it provides " + (names.empty() ? "no effects" : names) + ")");
    }
    choice.Named.Set(effect, true);
  }
  return choice;
}

/// How the map is read between its texels, and where they are smaller than pixels.
void ReadSampling(const MesoSceneValue& value, MesoMesostructureOptions& options)
{
  const std::string refusal =
    std::string("technique ") + MesoName(options.Technique) + " has no choice of it";
  if (!MesoHasSearches(options.Technique))
  {
    value.Refuse({ "interpolation" }, refusal);
    if (options.Technique != MesoTechnique::VDM)
    {
      value.Refuse({ "filter" }, refusal);
    }
  }
  value.With("interpolation",
    [&](const MesoSceneValue& kind)
    {
      options.Interpolation = kind.ToChoice<MesoInterpolation>(
        "interpolation", &MesoInterpolationFromName, MesoInterpolationNames());
    });
  value.With("filter",
    [&](const MesoSceneValue& kind) {
      options.Filter = kind.ToChoice<MesoFilter>("filter", &MesoFilterFromName, MesoFilterNames());
    });
}

/// What is said of a volume's shell; the volume itself, or the map that is made one, has been read.
void ReadShell(const MesoSceneValue& value, MesoSceneNode& node)
{
  MesoMesostructureOptions& options = node.Mesostructure;
  const std::string technique = std::string("technique ") + MesoName(options.Technique);
  if (!MesoUsesVolume(options.Technique))
  {
    value.Refuse({ "segments", "exits" }, technique + " has no prisms that rays run through");
    value.Refuse({ "volume_colors" }, technique + " draws no volume");
    return;
  }
  const bool tabled = options.Technique == MesoTechnique::GDM;
  if (!node.Baked.empty())
  {
    value.Refuse({ "volume", "tile_mesh", "height_map", "depth_map", "relief_map" },
      "the baked table has its volume in it");
  }
  else if (!node.Volume && !node.Map)
  {
    value.Fail(technique + " needs a volume, a tile_mesh or a height_map" +
      (tabled ? ", or a baked table" : ""));
  }
  if (!value.Has("scale"))
  {
    value.Fail(technique + " needs scale, the thickness of its shell in object units");
  }
  if (options.Scale == 0.)
  {
    value.At("scale").Fail("a shell needs some thickness");
  }
  if (!value.Has("reference") && !node.Map)
  {
    options.Reference = 0.;
  }
  if (options.Wrap != MesoWrap::Repeat)
  {
    value.At("wrap").Fail("a volume repeats");
  }
  value.With("volume_colors",
    [&](const MesoSceneValue& colors) { node.VolumeColors = colors.ToFileName(); });
  if (options.Technique == MesoTechnique::Slices)
  {
    value.Refuse({ "segments", "exits" }, technique + " has no rays that run through prisms");
  }
  value.With("exits",
    [&](const MesoSceneValue& kind)
    { options.Exits = kind.ToChoice<MesoExits>("exits", &MesoExitsFromName, MesoExitsNames()); });
  value.With("segments",
    [&](const MesoSceneValue& number) {
      options.Segments = static_cast<int>(number.ToInteger({ 1., MesoMostSegments, true }));
    });
}

void CheckHasScale(const MesoSceneValue& value, const std::string& technique)
{
  if (!value.Has("scale"))
  {
    value.Fail(technique + " needs scale, the height of its relief in object units");
  }
}

/// What techniques that look tables up have to choose.
void ReadTable(const MesoSceneValue& value, MesoSceneNode& node)
{
  MesoMesostructureOptions& options = node.Mesostructure;
  const bool tabled =
    options.Technique == MesoTechnique::VDM || options.Technique == MesoTechnique::GDM;
  const std::string technique = std::string("technique ") + MesoName(options.Technique);
  if (options.Technique == MesoTechnique::VDM && options.Wrap != MesoWrap::Repeat)
  {
    value.At("wrap").Fail(technique + " has a table of a tile that repeats");
  }
  value.With("rank",
    [&](const MesoSceneValue& ranks)
    {
      if (!tabled)
      {
        ranks.Fail(technique + " has no table with factors");
      }
      if (options.Quality == MesoQuality::Full)
      {
        ranks.Fail("quality full is the table itself, without factors");
      }
      if (options.Technique == MesoTechnique::GDM)
      {
        options.Rank = { static_cast<int>(ranks.ToInteger({ 1., MostFactorsOfVolumes, true })), 0 };
        return;
      }
      const MesoSceneRange range = { 1., MostFactors, true };
      const auto list = ranks.ToList(2);
      options.Rank = { static_cast<int>(list[0].ToInteger(range)),
        static_cast<int>(list[1].ToInteger(range)) };
    });
  value.With("baked",
    [&](const MesoSceneValue& file)
    {
      if (!tabled && options.Technique != MesoTechnique::GeometryImage)
      {
        file.Fail(technique + " has no use for a baked table");
      }
      node.Baked = file.ToFileName();
    });
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
  part.Range = ReadRange(value.At("range"));
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

void MesoReadSceneMesostructure(const MesoSceneValue& value, MesoSceneNode& node)
{
  value.CheckKeys("mesostructure");
  MesoMesostructureOptions& options = node.Mesostructure;
  value.With("technique",
    [&](const MesoSceneValue& name)
    {
      options.Technique =
        name.ToChoice<MesoTechnique>("technique", &MesoTechniqueFromName, MesoTechniqueNames());
    });
  const std::string name = MesoName(options.Technique);
  node.Material.NormalMapOfObject = options.Technique == MesoTechnique::NormalObject;
  value.With("quality",
    [&](const MesoSceneValue& quality)
    {
      options.Quality =
        quality.ToChoice<MesoQuality>("quality", &MesoQualityFromName, MesoQualityNames());
    });
  value.With("search",
    [&](const MesoSceneValue& search)
    {
      options.Search =
        search.ToChoice<MesoSearch>("search", &MesoSearchFromName, MesoSearchNames());
    });
  value.With("wrap",
    [&](const MesoSceneValue& name)
    { options.Wrap = name.ToChoice<MesoWrap>("wrap", &MesoWrapFromName, MesoWrapNames()); });
  value.With("scale",
    [&](const MesoSceneValue& scale)
    { options.Scale = scale.ToNumber(MesoSceneRanges::NotNegative); });
  value.With("reference",
    [&](const MesoSceneValue& reference)
    { options.Reference = reference.ToNumber(MesoSceneRanges::Fraction); });
  value.With("tiles",
    [&](const MesoSceneValue& tiles)
    { options.Tiles = tiles.ToNumbers<2>(MesoSceneRanges::Positive); });
  value.With("quadric",
    [&](const MesoSceneValue& kind)
    {
      if (!MesoBendsRelief(options.Technique))
      {
        kind.Fail("technique " + name + " has no quadric");
      }
      options.Quadric =
        kind.ToChoice<MesoQuadricKind>("quadric", &MesoQuadricKindFromName, MesoQuadricKindNames());
    });
  value.With("curved",
    [&](const MesoSceneValue& kind)
    {
      if (options.Technique != MesoTechnique::ReliefQuadric)
      {
        kind.Fail("technique " + name + " has no choice of curved bases; relief-quadric has");
      }
      options.Curved = kind.ToChoice<MesoCurvedKind>(
        "curved base", &MesoCurvedKindFromName, MesoCurvedKindNames());
    });
  ReadSampling(value, options);
  const std::string searchProblem = MesoSearchProblem(options);
  if (!searchProblem.empty())
  {
    value.At(options.Search ? "search" : "quality").Fail(searchProblem);
  }
  value.With("parallax",
    [&](const MesoSceneValue& kind)
    {
      if (options.Technique != MesoTechnique::Parallax)
      {
        kind.Fail("technique " + name + " has no parallax to choose");
      }
      options.Parallax = kind.ToChoice<MesoParallaxKind>(
        "parallax", &MesoParallaxKindFromName, MesoParallaxKindNames());
    });
  value.With("curvature_at",
    [&](const MesoSceneValue& kind)
    {
      if (options.Technique != MesoTechnique::VDM)
      {
        kind.Fail("technique " + name + " has no choice of where curvature is taken; vdm has");
      }
      options.CurvatureAt = kind.ToChoice<MesoCurvatureAt>(
        "place of curvature", &MesoCurvatureAtFromName, MesoCurvatureAtNames());
    });
  value.With("penumbra",
    [&](const MesoSceneValue& angle)
    {
      if (options.Technique != MesoTechnique::Horizon &&
        options.Technique != MesoTechnique::Displacement)
      {
        angle.Fail("technique " + name + " has no penumbra");
      }
      options.Penumbra = angle.ToNumber({ 0., 90., true });
    });
  ReadTable(value, node);
  value.With("facet_pixels",
    [&](const MesoSceneValue& pixels)
    {
      if (options.Technique != MesoTechnique::Displacement &&
        options.Technique != MesoTechnique::GeometryImage)
      {
        pixels.Fail("technique " + name + " does not cut by pixels");
      }
      options.FacetPixels = pixels.ToNumber(MesoSceneRanges::NotNegative);
    });
  if (options.Technique == MesoTechnique::GeometryImage)
  {
    value.Refuse({ "height_map", "depth_map", "relief_map" },
      "technique geometry-image draws the mesh itself, without relief");
  }
  value.With("effects",
    [&](const MesoSceneValue& effects)
    { options.Effects = ReadEffects(effects, options.Technique); });

  node.Volume = MesoReadSceneVolume(value);
  if (value.Has("height_map"))
  {
    value.Refuse(
      { "depth_map", "relief_map" }, "there is a height_map already; only one map is taken");
    node.Map = ReadMap(value.At("height_map"));
  }
  value.With("depth_map",
    [&](const MesoSceneValue& map)
    {
      value.Refuse({ "relief_map" }, "there is a depth_map already; only one map is taken");
      node.Map = ReadMap(map);
      node.Map->IsDepth = true;
    });
  value.With("relief_map",
    [&](const MesoSceneValue& file)
    {
      node.Map = MesoSceneMap();
      node.Map->File = file.ToFileName();
      node.Map->IsDepth = true;
      node.Map->IsReliefMap = true;
    });
  ReadShell(value, node);
  const std::string technique = std::string("technique ") + MesoName(options.Technique);
  if (!node.Map)
  {
    value.Refuse({ "range", "sample_spacing" },
      "there is no height_map or depth_map or relief_map that it is of");
    const bool mapped = options.Technique == MesoTechnique::Normal ||
      options.Technique == MesoTechnique::NormalObject;
    if (!node.Baked.empty())
    {
      CheckHasScale(value, technique);
      return;
    }
    if (MesoUsesHeightMap(options.Technique) && !(mapped && !node.Material.NormalMap.empty()))
    {
      value.Fail("technique " + name + " needs a height_map or a depth_map" +
        (mapped ? ", or a normal_map of the material" : ""));
    }
    return;
  }
  if (MesoUsesHeightMap(options.Technique))
  {
    CheckHasScale(value, technique);
  }
  value.With("range", [&](const MesoSceneValue& range) { node.Map->Range = ReadRange(range); });
  value.With("sample_spacing",
    [&](const MesoSceneValue& spacing)
    { node.Map->SampleSpacing = spacing.ToNumbers<2>(MesoSceneRanges::Positive); });
}
