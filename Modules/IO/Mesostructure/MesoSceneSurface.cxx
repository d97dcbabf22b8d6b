#include "MesoSceneSurface.h"

#include "MesoPattern.h"
#include "MesoShape.h"

#include <algorithm>

namespace
{
const std::vector<std::string> LaterShapes = { "cube", "cone", "vase", "teapot", "undulating",
  "branch" };
const std::vector<std::string> LaterTechniques = { "bump", "normal", "normal-object", "parallax",
  "horizon", "displacement", "geometry-image", "relief-quadric", "relief-quadric-exact", "vdm",
  "gdm", "slices", "shell-sdf" };
const std::vector<std::string> LaterQualities = { "certified", "full" };

/// A word of a list, for ToChoice.
std::string ReadName(const MesoSceneValue& value, const std::string& kind,
  const std::vector<std::string>& names, const std::vector<std::string>& later)
{
  const std::string name = value.ToText();
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    value.FailChoice(kind, name, names, later);
  }
  return name;
}

/// A mesh or map that is no file name must be an object that says which built-in one is meant.
void CheckNamesKind(const MesoSceneValue& value, const std::string& key)
{
  if (!value.Has(key))
  {
    value.Fail("must be a file name, or an object with the key " + key);
  }
}

std::vector<double> ReadParameter(const MesoSceneValue& value, const MesoParameter& parameter)
{
  const MesoSceneRange range = { parameter.Minimum, parameter.Maximum, true };
  const auto read = [&](const MesoSceneValue& element)
  { return parameter.Integer ? element.ToInteger(range) : element.ToNumber(range); };
  if (parameter.Default.size() == 1)
  {
    return { read(value) };
  }
  std::vector<double> numbers;
  for (const MesoSceneValue& element : value.ToList(parameter.Default.size()))
  {
    numbers.push_back(read(element));
  }
  return numbers;
}

MesoSceneMap ReadMap(const MesoSceneValue& value)
{
  MesoSceneMap map;
  if (value.IsString())
  {
    map.File = value.ToFileName();
    return map;
  }
  CheckNamesKind(value, "pattern");
  map.Pattern = ReadName(value.At("pattern"), "pattern", MesoPatternNames(), {});
  value.CheckKeys("pattern_" + map.Pattern);
  value.With("size",
    [&](const MesoSceneValue& size)
    {
      const auto list = size.ToList(2);
      const MesoSceneRange texels = { 1., MesoPatternMaximumSize, true };
      map.Size = { static_cast<int>(list[0].ToInteger(texels)),
        static_cast<int>(list[1].ToInteger(texels)) };
    });
  value.With("seed",
    [&](const MesoSceneValue& seed)
    {
      const MesoSceneRange range = { 0., std::numeric_limits<std::uint32_t>::max(), true };
      map.Seed = static_cast<std::uint32_t>(seed.ToInteger(range));
    });
  for (const MesoParameter& parameter : MesoPatternParameters(map.Pattern))
  {
    value.With(parameter.Key,
      [&](const MesoSceneValue& number)
      { map.Parameters[parameter.Key] = ReadParameter(number, parameter).front(); });
  }
  // The values one by one are right; some do not go together.
  const std::string problem = MesoPatternProblem(map.Pattern, map.Parameters);
  if (!problem.empty())
  {
    value.Fail(problem);
  }
  return map;
}

MesoEffectChoice ReadEffects(const MesoSceneValue& value, MesoTechnique technique)
{
  const MesoEffects provided = MesoEffectsOfTechnique(technique);
  MesoEffectChoice choice;
  if (value.IsString())
  {
    const std::string word = ReadName(value, "choice of effects", { "auto", "all", "none" }, {});
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
}

MesoSceneMesh MesoReadSceneMesh(const MesoSceneValue& value)
{
  MesoSceneMesh mesh;
  if (value.IsString())
  {
    mesh.File = value.ToFileName();
    return mesh;
  }
  CheckNamesKind(value, "shape");
  mesh.Shape = ReadName(value.At("shape"), "shape", MesoShapeNames(), LaterShapes);
  value.CheckKeys("shape_" + mesh.Shape);
  for (const MesoParameter& parameter : MesoShapeParameters(mesh.Shape))
  {
    value.With(parameter.Key,
      [&](const MesoSceneValue& numbers)
      { mesh.Parameters[parameter.Key] = ReadParameter(numbers, parameter); });
  }
  const std::string problem = MesoShapeProblem(mesh.Shape, mesh.Parameters);
  if (!problem.empty())
  {
    value.Fail(problem);
  }
  return mesh;
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
      options.Technique = name.ToChoice<MesoTechnique>(
        "technique", &MesoTechniqueFromName, MesoTechniqueNames(), LaterTechniques);
    });
  value.With("quality",
    [&](const MesoSceneValue& name)
    {
      options.Quality = name.ToChoice<MesoQuality>(
        "quality", &MesoQualityFromName, MesoQualityNames(), LaterQualities);
    });
  value.With("wrap",
    [&](const MesoSceneValue& name)
    { options.Wrap = name.ToChoice<MesoWrap>("wrap", &MesoWrapFromName, MesoWrapNames()); });
  value.With("scale",
    [&](const MesoSceneValue& scale)
    { options.Scale = scale.ToNumber(MesoSceneRanges::NotNegative); });
  value.With("tiles",
    [&](const MesoSceneValue& tiles)
    { options.Tiles = tiles.ToNumbers<2>(MesoSceneRanges::Positive); });
  value.With("effects",
    [&](const MesoSceneValue& effects)
    { options.Effects = ReadEffects(effects, options.Technique); });

  if (value.Has("height_map"))
  {
    value.Refuse({ "depth_map" }, "there is a height_map already; only one map is taken");
    node.Map = ReadMap(value.At("height_map"));
  }
  value.With("depth_map",
    [&](const MesoSceneValue& map)
    {
      node.Map = ReadMap(map);
      node.Map->IsDepth = true;
    });
  const std::string technique = std::string("technique ") + MesoName(options.Technique);
  if (!node.Map)
  {
    value.Refuse(
      { "range", "sample_spacing" }, "there is no height_map or depth_map that it is of");
    if (options.Technique != MesoTechnique::Plain)
    {
      value.Fail(technique + " needs a height_map or a depth_map");
    }
    return;
  }
  if (options.Technique != MesoTechnique::Plain && !value.Has("scale"))
  {
    value.Fail(technique + " needs scale, the depth of its deepest point in object units");
  }
  value.With("range",
    [&](const MesoSceneValue& range)
    {
      node.Map->Range = range.ToNumbers<2>();
      if (!((*node.Map->Range)[0] < (*node.Map->Range)[1]))
      {
        range.Fail("the first number must be less than the second");
      }
    });
  value.With("sample_spacing",
    [&](const MesoSceneValue& spacing)
    { node.Map->SampleSpacing = spacing.ToNumbers<2>(MesoSceneRanges::Positive); });
}
