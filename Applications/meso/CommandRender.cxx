#include "CommandRender.h"

#include "MesoAtomicFile.h"
#include "MesoSceneAttributes.h"
#include "MesoSceneBuilder.h"
#include "RenderResults.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <set>
#include <unistd.h>

namespace
{
const std::vector<std::string> AOVGroups = { "coverage", "depth", "texcoord", "relief", "normal",
  "shadow", "object", "fetches", "iterations", "all" };
constexpr int LargestSize = 16384;

std::string Joined(const std::vector<std::string>& names)
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
  std::vector<std::string> parts; // empty ones as well, which no list of names takes
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

std::array<int, 2> ParseSize(const std::string& text)
{
  int width = 0;
  int height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 ||
    height < 1 || width > LargestSize || height > LargestSize)
  {
    throw CLI::ValidationError("--size",
      "'" + text + "' is no size such as 800x600 (1 to " + std::to_string(LargestSize) + " each)");
  }
  return { width, height };
}

template <typename T>
T ParseName(const char* option, const std::string& text, std::optional<T> value,
  const std::vector<std::string>& choices)
{
  if (!value)
  {
    throw CLI::ValidationError(option, "'" + text + "' is none of " + Joined(choices));
  }
  return *value;
}

std::vector<std::string> ParseGroups(const std::string& text)
{
  std::vector<std::string> groups = SplitAtCommas(text);
  for (const std::string& group : groups)
  {
    if (std::find(AOVGroups.begin(), AOVGroups.end(), group) == AOVGroups.end())
    {
      throw CLI::ValidationError("--aov", "'" + group + "' is none of " + Joined(AOVGroups));
    }
  }
  return groups;
}

/// A bar on the terminal's last line for work of over a second; nothing where output is piped.
class ProgressBar
{
public:
  void operator()(double part)
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

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/// `x.png` gives `x.aov.exr`.
std::string AOVFileName(const std::string& picture)
{
  return picture.substr(0, picture.size() - 4) + ".aov.exr";
}
}

CommandRender::CommandRender(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("render", "Render a scene file to a picture, off screen.");
  command->add_option("SCENE", this->SceneFile, "Scene file (JSON)")->required();
  command->add_option("-o,--output", this->Output, "Picture to write, ending in .png")
    ->required()
    ->check(
      [](const std::string& name)
      {
        const bool png = name.size() > 4 && name.compare(name.size() - 4, 4, ".png") == 0;
        return png ? std::string() : "'" + name + "' is no file name that ends in .png";
      });
  command->add_option_function<std::string>(
    "--size", [this](const std::string& text) { this->Size = ParseSize(text); },
    "Width and height in pixels (default: 800x600)");
  command->add_option_function<std::string>(
    "--technique",
    [this](const std::string& text)
    {
      this->Technique =
        ParseName("--technique", text, MesoTechniqueFromName(text), MesoTechniqueNames());
    },
    "Technique in place of the scene's: " + Joined(MesoTechniqueNames()));
  command->add_option_function<std::string>(
    "--quality",
    [this](const std::string& text) {
      this->Quality = ParseName("--quality", text, MesoQualityFromName(text), MesoQualityNames());
    },
    "Quality in place of the scene's: " + Joined(MesoQualityNames()));
  command->add_option_function<std::string>(
    "--effects",
    [this](const std::string& text)
    {
      MesoEffectChoice choice;
      choice.Auto = text == "auto" || text == "all";
      if (!choice.Auto && text != "none")
      {
        for (const std::string& name : SplitAtCommas(text))
        {
          choice.Named.Set(
            ParseName("--effects", name, MesoEffectFromName(name), MesoEffectNames()), true);
        }
      }
      this->Effects = choice;
    },
    "auto, all, none, or a list of " + Joined(MesoEffectNames()));
  command->add_option_function<std::string>(
    "--aov", [this](const std::string& text) { this->Channels = ParseGroups(text); },
    "Numbers of every pixel, written beside the picture as .aov.exr: a list of " +
      Joined(AOVGroups));
  command->add_option("--samples", this->Samples, "Samples a pixel of the picture (default: 1)")
    ->check(CLI::Range(1, 4096));
  command->add_option("--stats", this->StatsFile, "JSON file for the figures of cost")
    ->check([](const std::string& name)
      { return name.empty() ? std::string("'' is no file name") : std::string(); });
  command->footer("Example: meso render scene.json -o scene.png --size 800x600 --samples 8");
}

void CommandRender::Override(std::vector<MesoSceneNode>& nodes) const
{
  for (MesoSceneNode& node : nodes)
  {
    MesoMesostructureOptions& options = node.Mesostructure;
    // A node without a map has nothing that another technique could draw.
    if (this->Technique && (node.Map || *this->Technique == MesoTechnique::Plain))
    {
      options.Technique = *this->Technique;
      options.Effects = MesoEffectChoice();
    }
    options.Quality = this->Quality.value_or(options.Quality);
    if (this->Effects && options.Technique != MesoTechnique::Plain)
    {
      const MesoEffects missing =
        this->Effects->Named.Without(MesoEffectsOfTechnique(options.Technique));
      if (!missing.Empty())
      {
        throw MesoInputError("--effects: the technique " +
          std::string(MesoName(options.Technique)) + " of node '" + node.Name +
          "' does not provide " + missing.Names().front());
      }
      options.Effects = *this->Effects;
    }
    this->Override(node.Children);
  }
}

void CommandRender::CheckFileNames() const
{
  std::set<std::filesystem::path> targets;
  for (const std::string& name : { this->Output,
         this->Channels.empty() ? std::string() : AOVFileName(this->Output), this->StatsFile })
  {
    if (!name.empty())
    {
      const MesoAtomicFile possible(name); // which throws where it is not
      if (!targets.insert(std::filesystem::weakly_canonical(name)).second)
      {
        throw MesoInputError(name + ": two results cannot go to one file");
      }
    }
  }
}

int CommandRender::Run()
{
  MesoScene scene = MesoReadScene(this->SceneFile);
  this->Override(scene.Nodes);
  this->CheckFileNames();

  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(this->Size[0], this->Size[1]);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  const std::string device = window->GetGLRenderer();
  if (device.empty())
  {
    return 1; // the window has said why
  }
  std::cerr << "meso: rendering on " << device << "\n";

  const auto start = std::chrono::steady_clock::now();
  MesoSceneBuilder builder;
  builder.Build(scene, renderer);
  for (const std::string& warning : builder.GetWarnings())
  {
    std::cerr << "meso: warning: " << warning << "\n";
  }
  const double prepareSeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  // All is rendered before anything is written, so that a job that fails leaves nothing.
  const std::string picture = RenderPicture(window, renderer, this->Samples, ProgressBar());
  for (const auto& object : builder.GetObjects())
  {
    if (!object.Mapper->GetWhyPlain().empty())
    {
      throw MesoInputError("node " + std::to_string(object.Number) + " '" + object.Name +
        "': " + object.Mapper->GetWhyPlain());
    }
  }
  vtkNew<vtkMesoAOVPass> pass;
  std::string stats;
  if (!this->Channels.empty() || !this->StatsFile.empty())
  {
    CaptureAOVs(window, renderer, builder, pass);
  }
  if (!this->StatsFile.empty())
  {
    stats = MeasureStats(window, renderer, builder, pass, prepareSeconds);
  }
  pass->ReleaseGraphicsResources(window);

  if (!this->Channels.empty())
  {
    const double aspect = double(this->Size[0]) / this->Size[1];
    WriteAOVs(pass, ChannelsOfGroups(this->Channels, pass),
      MesoAttributesOfScene(builder, renderer, aspect), AOVFileName(this->Output));
  }
  if (!this->StatsFile.empty())
  {
    MesoAtomicFile::Write(this->StatsFile, stats.data(), stats.size());
  }
  MesoAtomicFile::Write(this->Output, picture.data(), picture.size());
  return 0;
}
