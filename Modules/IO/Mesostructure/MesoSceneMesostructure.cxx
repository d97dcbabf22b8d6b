#include "MesoSceneMesostructure.h"

#include "MesoPattern.h"
#include "MesoSceneParameters.h"
#include "MesoSceneVolume.h"

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
    value.Refuse(
      { "segments", "exits", "stack" }, technique + " has no prisms that rays run through");
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
  else
  {
    value.Refuse({ "stack" }, technique + " draws no slices");
  }
  value.With("stack",
    [&](const MesoSceneValue& kind)
    { options.Stack = kind.ToChoice<MesoStack>("stack", &MesoStackFromName, MesoStackNames()); });
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
  value.With("range", [&](const MesoSceneValue& range) { node.Map->Range = MesoReadRange(range); });
  value.With("sample_spacing",
    [&](const MesoSceneValue& spacing)
    { node.Map->SampleSpacing = spacing.ToNumbers<2>(MesoSceneRanges::Positive); });
}
