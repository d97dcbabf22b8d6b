#include "CommandLine.h"

#include "MesoAtomicFile.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <set>
#include <unistd.h>

namespace
{
constexpr int LargestSize = 16384;
}

std::string JoinNames(const std::vector<std::string>& names)
{
  std::string text;
  for (const std::string& name : names)
  {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

std::vector<std::string> SplitAtCommas(const std::string& text)
{
  std::vector<std::string> parts;
  for (std::size_t start = 0;;)
  {
    const std::size_t comma = text.find(',', start);
    parts.push_back(text.substr(start, comma - start));
    if (comma == std::string::npos)
    {
      return parts;
    }
    start = comma + 1;
  }
}

std::array<int, 2> ParseSize(const char* option, const std::string& text)
{
  int width = 0;
  int height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 ||
    height < 1 || width > LargestSize || height > LargestSize)
  {
    throw CLI::ValidationError(option,
      "'" + text + "' is no size such as 800x600 (1 to " + std::to_string(LargestSize) + " each)");
  }
  return { width, height };
}

std::optional<std::array<double, 2>> ParsePair(const std::string& text)
{
  std::array<double, 2> pair;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf%c", &pair[0], &pair[1], &rest) != 2)
  {
    return std::nullopt;
  }
  return pair;
}

void AddChoice(CLI::App& command, const std::string& option, const std::string& off,
  const std::string& on, bool& flag, const std::string& help)
{
  command.add_option_function<std::string>(
    option,
    [option, off, on, &flag](const std::string& text)
    {
      if (text != off && text != on)
      {
        throw CLI::ValidationError(option, "'" + text + "' is none of " + off + ", " + on);
      }
      flag = text == on;
    },
    help);
}

void AddOutputOption(CLI::App& command, std::string& output)
{
  command.add_option("-o,--output", output, "Picture to write, ending in .png")
    ->required()
    ->check(
      [](const std::string& name)
      {
        const bool png = name.size() > 4 && name.compare(name.size() - 4, 4, ".png") == 0;
        return png ? std::string() : "'" + name + "' is no file name that ends in .png";
      });
}

void AddSizeOption(CLI::App& command, std::array<int, 2>& size)
{
  command.add_option_function<std::string>(
    "--size", [&size](const std::string& text) { size = ParseSize("--size", text); },
    "Width and height in pixels (default: 800x600)");
}

void AddAOVOption(
  CLI::App& command, const std::vector<std::string>& groups, std::vector<std::string>& channels)
{
  command.add_option_function<std::string>(
    "--aov",
    [&groups, &channels](const std::string& text)
    {
      channels = SplitAtCommas(text);
      for (const std::string& group : channels)
      {
        if (std::find(groups.begin(), groups.end(), group) == groups.end())
        {
          throw CLI::ValidationError("--aov", "'" + group + "' is none of " + JoinNames(groups));
        }
      }
    },
    "Numbers of every pixel, written beside the picture as .aov.exr: a list of " +
      JoinNames(groups));
}

void AddSamplesOption(CLI::App& command, int& samples)
{
  command.add_option("--samples", samples, "Samples a pixel of the picture (default: 1)")
    ->check(CLI::Range(1, 4096));
}

void AddStatsOption(CLI::App& command, std::string& file, const std::string& help)
{
  command.add_option("--stats", file, help)
    ->check([](const std::string& name)
      { return name.empty() ? std::string("'' is no file name") : std::string(); });
}

std::string AOVFileName(const std::string& picture)
{
  return std::filesystem::path(picture).replace_extension(".aov.exr").string();
}

void CheckFileNames(const std::vector<std::string>& names, const std::vector<std::string>& inputs)
{
  std::set<std::filesystem::path> sources;
  for (const std::string& input : inputs)
  {
    sources.insert(std::filesystem::weakly_canonical(input));
  }
  std::set<std::filesystem::path> targets;
  for (const std::string& name : names)
  {
    if (!name.empty())
    {
      const MesoAtomicFile possible(name); // which throws where it is not
      const std::filesystem::path target = std::filesystem::weakly_canonical(name);
      if (sources.count(target) > 0)
      {
        throw MesoInputError(name + ": is read, so a result cannot go to it");
      }
      if (!targets.insert(target).second)
      {
        throw MesoInputError(name + ": two results cannot go to one file");
      }
    }
  }
}

std::vector<std::string> ChannelsOfGroups(
  const std::vector<std::string>& groups, const std::vector<std::string>& channels)
{
  std::vector<std::string> chosen;
  for (const std::string& channel : channels)
  {
    const std::string group =
      channel == "texel_reads" ? "fetches" : channel.substr(0, channel.find('.'));
    const bool wanted = std::any_of(groups.begin(), groups.end(),
      [&](const std::string& name) { return name == "all" || name == group; });
    if (wanted)
    {
      chosen.push_back(channel);
    }
  }
  return chosen;
}

std::string PictureBytes(vtkImageData* image)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return { reinterpret_cast<const char*>(bytes->GetPointer(0)),
    static_cast<std::size_t>(bytes->GetNumberOfValues()) };
}

void ProgressBar::operator()(double part)
{
  const auto now = std::chrono::steady_clock::now();
  if (isatty(STDERR_FILENO) && now - this->Start > std::chrono::seconds(1))
  {
    constexpr int Width = 40;
    const int filled = static_cast<int>(part * Width);
    std::cerr << "\r[" << std::string(filled, '#') << std::string(Width - filled, ' ') << "] "
              << static_cast<int>(part * 100.) << " %" << (part >= 1. ? "\n" : "") << std::flush;
  }
}
