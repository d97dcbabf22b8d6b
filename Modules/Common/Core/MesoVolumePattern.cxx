#include "MesoVolumePattern.h"

#include "MesoPatternTable.h"
#include "MesoVolumeFields.h"
#include "vtkSMPTools.h"

#include <cmath>

namespace
{
MesoParameter Number(const char* key, double value, double least, double most)
{
  return MesoPatternTable::Number(key, value, least, most);
}

MesoParameter Count(const char* key, double value, double most)
{
  return MesoPatternTable::Count(key, value, 1., most);
}

MesoParameter Depth(double value)
{
  return Number("depth", value, 0.01, 4.);
}

MesoVolumeFieldPointer MakeField(
  const std::string& pattern, std::uint32_t seed, const MesoPatternValues& all)
{
  return pattern == "weave" ? MesoMakeWeaveVolume(all)
    : pattern == "chain"    ? MesoMakeChainVolume(all)
    : pattern == "grid"     ? MesoMakeGridVolume(all)
    : pattern == "scales"   ? MesoMakeScalesVolume(seed, all)
    : pattern == "bark"     ? MesoMakeBarkVolume(seed, all)
                            : MesoMakeFoamVolume(seed, all);
}

/// Conditions between the values of several keys.
std::string JointProblem(const std::string& pattern, const MesoPatternValues& all)
{
  for (const auto& [name, key] :
    { std::pair{ "weave", "threads" }, { "chain", "links" }, { "scales", "rows" } })
  {
    if (pattern == name && std::fmod(all.at(key), 2.) != 0.)
    {
      return std::string("'") + key + "' must be even, else the pattern does not tile";
    }
  }
  if (pattern == "chain")
  {
    if (all.at("width") < 2. * all.at("wire"))
    {
      return "'width' leaves no room for the next link: at least 2 'wire'";
    }
    if (2. * MesoHalfHeightOfChain(all) > all.at("depth"))
    {
      return "the links are higher than 'depth'; more 'links' are smaller";
    }
  }
  return {};
}

const MesoPatternTable& Table()
{
  static const MesoPatternTable table("volume pattern", &JointProblem,
    {
      { "weave",
        { Depth(0.25), { "threads", { 4. }, 2., 64., true }, Number("width", 0.8, 0.1, 1.),
          Number("thickness", 0.9, 0.1, 1.) } },
      { "chain",
        { Depth(0.25), { "links", { 4. }, 2., 64., true }, Count("rows", 4., 64.),
          Number("wire", 0.14, 0.02, 0.25), Number("width", 0.4, 0.05, 1.) } },
      { "grid",
        { Depth(0.25), Count("bars", 4., 64.), Number("width", 0.35, 0.05, 0.95),
          Number("thickness", 0.5, 0.05, 1.), Number("rounding", 0.5, 0., 1.) } },
      { "scales",
        { Depth(0.25), { "rows", { 4. }, 2., 64., true }, Count("columns", 4., 64.),
          Number("overlap", 0.6, 0., 1.), Number("thickness", 0.1, 0.02, 0.4),
          Number("ground", 0.1, 0., 0.5), Number("variation", 0.15, 0., 1.) } },
      { "bark",
        { Depth(0.2), Count("columns", 5., 64.), Count("rows", 2., 64.),
          Number("crack", 0.12, 0.01, 0.4), Number("undercut", 0.9, 0., 2.),
          Number("roughness", 0.35, 0., 1.) } },
      { "foam",
        { Depth(0.25), Count("bubbles", 4., 64.), Number("radius", 0.6, 0.1, 0.8),
          Number("jitter", 0.6, 0., 1.), Number("variation", 0.3, 0., 1.) } },
    });
  return table;
}
}

std::vector<std::string> MesoVolumePatternNames()
{
  return Table().Names();
}

std::vector<MesoParameter> MesoVolumePatternParameters(const std::string& pattern)
{
  return Table().Parameters(pattern);
}

std::string MesoVolumePatternProblem(const std::string& pattern, const MesoPatternValues& values)
{
  return Table().Problem(pattern, values);
}

MesoVolumePattern::MesoVolumePattern(
  const std::string& pattern, std::uint32_t seed, const MesoPatternValues& values)
{
  const MesoPatternValues all = Table().Complete(pattern, values);
  this->Depth = all.at("depth");
  this->Function = MakeField(pattern, seed, all);
}

double MesoVolumePattern::At(double x, double y, double z) const
{
  return this->Function->At(x - std::floor(x), y - std::floor(y), z * this->Depth);
}

void MesoVolumePattern::Slices(std::array<int, 3> size, int first, int last, float* values) const
{
  const vtkIdType rows = vtkIdType(last - first) * size[1];
  vtkSMPTools::For(0, rows,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const vtkIdType slice = first + row / size[1];
        const double z = (double(slice) + 0.5) / size[2];
        const double y = (double(row % size[1]) + 0.5) / size[1];
        for (int i = 0; i < size[0]; ++i)
        {
          values[row * size[0] + i] = static_cast<float>(this->At((i + 0.5) / size[0], y, z));
        }
      }
    });
}
