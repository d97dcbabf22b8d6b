#include "BakeVolume.h"

#include "CommandLine.h"
#include "MesoMeshFormats.h"
#include "MesoVolumeInput.h"
#include "MesoVolumePattern.h"
#include "vtkImageData.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace
{
std::array<int, 3> ParseVoxels(const std::string& text)
{
  std::array<int, 3> size{};
  char rest = 0;
  const bool isSize =
    std::sscanf(text.c_str(), "%dx%dx%d%c", size.data(), &size[1], &size[2], &rest) == 3 &&
    *std::min_element(size.begin(), size.end()) >= 2 &&
    *std::max_element(size.begin(), size.end()) <= MesoVolumeMaximumSize;
  if (!isSize)
  {
    throw CLI::ValidationError("--size",
      "'" + text + "' is no size such as 64x64x32 (2 to " + std::to_string(MesoVolumeMaximumSize) +
        " each)");
  }
  return size;
}

std::array<double, 6> ParseBox(const std::string& text)
{
  std::array<double, 6> box{};
  char rest = 0;
  const bool isBox = std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf%c", box.data(), &box[1],
                       &box[2], &box[3], &box[4], &box[5], &rest) == 6 &&
    box[0] < box[1] && box[2] < box[3] && box[4] < box[5];
  if (!isBox)
  {
    throw CLI::ValidationError(
      "--crop", "'" + text + "' is no X0,X1,Y0,Y1,Z0,Z1, of each two the first less");
  }
  return box;
}
}

void BakeVolume::AddOptions(CLI::App& command)
{
  command
    .add_option("INPUT", this->Input,
      "Volume file (.vti, .nrrd, .mhd, .mha, .tif), closed mesh that fills a tile, or one of " +
        JoinNames(MesoVolumePatternNames()))
    ->required();
  command.add_option_function<std::string>(
    "--size", [this](const std::string& text) { this->Volume.Size = ParseVoxels(text); },
    "WxHxD: voxels (default: 64x64x32; of a volume file its own up to that)");
  command.add_option("--threshold", this->Volume.Threshold,
    "The number at the surface (default: what parts the numbers best, Otsu)");
  AddChoice(command, "--solid", "above", "below", this->Volume.SolidBelow,
    "The side of the threshold where the solid is: above (default) or below");
  command.add_option_function<std::string>(
    "--crop", [this](const std::string& text) { this->Volume.Crop = ParseBox(text); },
    "X0,X1,Y0,Y1,Z0,Z1: the tile, in samples from 0, or in a mesh's units (default: all)");
  command
    .add_option("--blend", this->Volume.Blend,
      "Part of the width and height that is faded into what lies beside it, so that it tiles")
    ->check(CLI::Range(0., 0.5));
  command.add_option("--seed", this->Volume.Seed, "Of a built-in volume (default: 1)");
  command.add_option_function<std::vector<std::string>>(
    "--parameter",
    [this](const std::vector<std::string>& texts)
    {
      for (const std::string& text : texts)
      {
        const std::size_t equals = text.find('=');
        double value = 0.;
        if (equals == std::string::npos ||
          !CLI::detail::lexical_cast(text.substr(equals + 1), value))
        {
          throw CLI::ValidationError("--parameter", "'" + text + "' is no KEY=NUMBER");
        }
        this->Volume.Parameters[text.substr(0, equals)] = value;
      }
    },
    "KEY=NUMBER of a built-in volume; may be repeated");
}

const MesoSceneVolume& BakeVolume::Resolve()
{
  const auto isOneOf = [](const std::string& word, const std::vector<std::string>& words)
  { return std::find(words.begin(), words.end(), word) != words.end(); };
  if (isOneOf(this->Input, MesoVolumePatternNames()))
  {
    this->Volume.Pattern = this->Input;
    const std::string problem =
      MesoVolumePatternProblem(this->Volume.Pattern, this->Volume.Parameters);
    if (!problem.empty())
    {
      throw MesoInputError(problem);
    }
    return this->Volume;
  }
  this->Volume.File = this->Input;
  this->Volume.IsMesh = isOneOf(MesoExtensionOf(this->Input), MesoMeshExtensions());
  return this->Volume;
}

vtkSmartPointer<vtkImageData> BakeVolume::Read() const
{
  std::vector<std::string> warnings;
  const auto volume = MesoReadVolume(this->Volume, "INPUT", warnings);
  for (const std::string& warning : warnings)
  {
    std::cerr << "meso: warning: " << warning << "\n";
  }
  return volume;
}
