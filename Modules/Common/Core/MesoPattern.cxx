#include "MesoPattern.h"

#include "MesoPatternFields.h"
#include "MesoPatternTable.h"

#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace
{
MesoParameter Number(const char* key, double value, double least, double most)
{
  return MesoPatternTable::Number(key, value, least, most);
}

MesoParameter Count(const char* key, double value, double least, double most)
{
  return MesoPatternTable::Count(key, value, least, most);
}

MesoFieldPointer MakeField(
  const std::string& pattern, std::uint32_t seed, const MesoPatternValues& all)
{
  static const std::map<std::string, MesoFieldPointer (*)(std::uint32_t, const MesoPatternValues&)>
    seeded = { { "brick", &MesoMakeBrickField }, { "smooth", &MesoMakeSmoothField },
      { "noise", &MesoMakeNoiseField }, { "weave", &MesoMakeWeaveField },
      { "stone", &MesoMakeStoneField }, { "spikes", &MesoMakeSpikesField },
      { "pits", &MesoMakePitsField }, { "terrain", &MesoMakeTerrainField },
      { "waves", &MesoMakeWavesField } };
  const auto found = seeded.find(pattern);
  return found != seeded.end() ? found->second(seed, all)
    : pattern == "step"        ? MesoMakeStepField(all)
                               : MesoMakeCheckerboardField(all);
}

// Conditions between the values of several keys.
std::string JointProblem(const std::string& pattern, const MesoPatternValues& all)
{
  if (pattern == "brick")
  {
    if (all.at("offset") != 0. && std::fmod(all.at("rows"), 2.) != 0.)
    {
      return "'rows' must be even where 'offset' is not 0, else the bond does not tile";
    }
    if (all.at("mortar") > 0.8 * all.at("rows") / all.at("columns"))
    {
      return "'mortar' leaves no width to the bricks; fewer 'columns' or more 'rows' would";
    }
  }
  for (const auto& [name, key] : { std::pair{ "weave", "threads" }, { "checkerboard", "squares" } })
  {
    if (pattern == name && std::fmod(all.at(key), 2.) != 0.)
    {
      return std::string("'") + key + "' must be even, else the pattern does not tile";
    }
  }
  if ((pattern == "noise" || pattern == "terrain") &&
    all.at("frequency") * std::exp2(all.at("octaves") - 1.) > MesoPatternMaximumSize)
  {
    return "'frequency' * 2^('octaves' - 1) is above " + std::to_string(MesoPatternMaximumSize);
  }
  return {};
}

const MesoPatternTable& Table()
{
  static const MesoPatternTable table("pattern", &JointProblem,
    {
      { "brick",
        { Count("rows", 8., 1., 256.), Count("columns", 3., 1., 256.),
          Number("mortar", 0.14, 0., 0.8), Number("bevel", 0.1, 0.01, 0.5),
          Number("offset", 0.5, 0., 1.), Number("variation", 0.25, 0., 1.),
          Number("roughness", 0.35, 0., 1.) } },
      { "smooth", { Count("frequency", 3., 1., 8.), Number("falloff", 1., 0., 4.) } },
      { "noise",
        { Count("frequency", 4., 1., 1024.), Count("octaves", 5., 1., 10.),
          Number("gain", 0.5, 0., 1.) } },
      { "step", { Number("position", 0.5, 0., 1.), Number("low", 0., 0., 1.) } },
      { "weave",
        { Count("threads", 8., 2., 256.), Number("width", 0.85, 0.1, 0.95),
          Number("strands", 0.5, 0., 1.), Number("variation", 0.2, 0., 1.) } },
      { "stone",
        { Count("cells", 6., 1., 256.), Number("jitter", 0.8, 0., 1.),
          Number("joint", 0.08, 0., 0.5), Number("bevel", 0.25, 0.01, 1.),
          Number("variation", 0.5, 0., 1.), Number("roughness", 0.35, 0., 1.) } },
      { "spikes",
        { Count("count", 8., 1., 1024.), Number("radius", 0.4, 0.05, 0.5),
          Number("power", 1., 0.125, 8.), Number("variation", 0., 0., 1.) } },
      { "checkerboard",
        { Count("squares", 8., 2., MesoPatternMaximumSize), Number("low", 0., 0., 1.) } },
      { "pits",
        { Count("count", 8., 1., 1024.), Number("radius", 0.4, 0.05, 0.5),
          Number("variation", 0.5, 0., 1.) } },
      { "terrain",
        { Count("frequency", 3., 1., 256.), Count("octaves", 8., 1., 12.),
          Number("gain", 0.5, 0., 1.), Number("ridges", 0.6, 0., 1.),
          Number("warp", 0.25, 0., 1.) } },
      { "waves",
        { Number("time", 0., -1e6, 1e6), Count("waves", 16., 1., 64.),
          Number("frequency", 8., 1., 64.), Number("direction", 30., -360., 360.),
          Number("spread", 50., 0., 180.), Number("steepness", 0.4, 0., 1.) } },
    });
  return table;
}
}

std::vector<std::string> MesoPatternNames()
{
  return Table().Names();
}

std::vector<MesoParameter> MesoPatternParameters(const std::string& pattern)
{
  return Table().Parameters(pattern);
}

std::string MesoPatternProblem(const std::string& pattern, const MesoPatternValues& values)
{
  return Table().Problem(pattern, values);
}

MesoPattern::MesoPattern(
  const std::string& pattern, std::uint32_t seed, const MesoPatternValues& values)
  : Function(MakeField(pattern, seed, Table().Complete(pattern, values)))
{
}

double MesoPattern::At(double s, double t) const
{
  return std::clamp(this->Function->At(s - std::floor(s), t - std::floor(t)), 0., 1.);
}

void MesoPattern::Rows(std::array<int, 2> size, int first, int last, float* rows) const
{
  vtkSMPTools::For(first, last,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType j = begin; j < end; ++j)
      {
        float* row = rows + (j - first) * size[0];
        for (int i = 0; i < size[0]; ++i)
        {
          row[i] = static_cast<float>(this->At((i + 0.5) / size[0], (j + 0.5) / size[1]));
        }
      }
    });
}

std::vector<float> MesoMakePattern(const std::string& pattern, std::array<int, 2> size,
  std::uint32_t seed, const MesoPatternValues& parameters)
{
  for (int side : size)
  {
    if (side < 1 || side > MesoPatternMaximumSize)
    {
      throw std::invalid_argument("pattern '" + pattern + "': size " + std::to_string(size[0]) +
        " x " + std::to_string(size[1]) + ", allowed are 1 to " +
        std::to_string(MesoPatternMaximumSize) + " a side");
    }
  }
  const MesoPattern function(pattern, seed, parameters);
  std::vector<float> heights(static_cast<std::size_t>(size[0]) * size[1]);
  function.Rows(size, 0, size[1], heights.data());
  return heights;
}
