#include "CommandRender.h"

#include "CommandLine.h"
#include "MesoAtomicFile.h"
#include "MesoSceneAttributes.h"
#include "MesoSceneBuilder.h"
#include "RenderResults.h"
#include "vtkImageData.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <iostream>

namespace
{
const std::vector<std::string> AOVGroups = { "coverage", "depth", "texcoord", "relief", "normal",
  "shadow", "object", "fetches", "iterations", "all" };

template <typename T>
T ParseName(const char* option, const std::string& text, std::optional<T> value,
  const std::vector<std::string>& choices)
{
  if (!value)
  {
    throw CLI::ValidationError(option, "'" + text + "' is none of " + JoinNames(choices));
  }
  return *value;
}
}

CommandRender::CommandRender(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("render", "Render a scene file to a picture, off screen.");
  command->add_option("SCENE", this->SceneFile, "Scene file (JSON)")->required();
  AddOutputOption(*command, this->Output);
  AddSizeOption(*command, this->Size);
  command->add_option_function<std::string>(
    "--technique",
    [this](const std::string& text)
    {
      this->Technique =
        ParseName("--technique", text, MesoTechniqueFromName(text), MesoTechniqueNames());
    },
    "Technique in place of the scene's: " + JoinNames(MesoTechniqueNames()));
  command->add_option_function<std::string>(
    "--quality",
    [this](const std::string& text) {
      this->Quality = ParseName("--quality", text, MesoQualityFromName(text), MesoQualityNames());
    },
    "Quality in place of the scene's: " + JoinNames(MesoQualityNames()));
  command->add_option_function<std::string>(
    "--search",
    [this](const std::string& text)
    { this->Search = ParseName("--search", text, MesoSearchFromName(text), MesoSearchNames()); },
    "Search of height maps in place of the scene's: " + JoinNames(MesoSearchNames()));
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
    "auto, all, none, or a list of " + JoinNames(MesoEffectNames()));
  AddAOVOption(*command, AOVGroups, this->Channels);
  AddSamplesOption(*command, this->Samples);
  AddStatsOption(*command, this->StatsFile, "JSON file for the figures of cost");
  command->footer("Example: meso render scene.json -o scene.png --size 800x600 --samples 8");
}

void CommandRender::Override(std::vector<MesoSceneNode>& nodes) const
{
  for (MesoSceneNode& node : nodes)
  {
    MesoMesostructureOptions& options = node.Mesostructure;
    // A node without a map or a volume has nothing that another technique could draw.
    if (this->Technique &&
      (*this->Technique == MesoTechnique::Plain ||
        (node.Volume ? MesoUsesVolume(*this->Technique) : node.Map.has_value())))
    {
      options.Technique = *this->Technique;
      options.Effects = MesoEffectChoice();
      options.Search.reset(); // of the scene's technique
      if (!MesoHasSearches(options.Technique))
      {
        options.Interpolation = MesoInterpolation::Bilinear;
      }
    }
    options.Quality = this->Quality.value_or(options.Quality);
    if (this->Search && options.Technique != MesoTechnique::Plain)
    {
      options.Search = this->Search;
    }
    const std::string searchProblem = MesoSearchProblem(options);
    if (options.Technique != MesoTechnique::Plain && !searchProblem.empty())
    {
      throw MesoInputError("node '" + node.Name + "': " + searchProblem);
    }
    if (this->Effects)
    {
      const MesoEffects missing =
        this->Effects->Named.Without(MesoEffectsOfTechnique(options.Technique));
      // Plain nodes stand beside those that the effects are meant for.
      if (!missing.Empty() && options.Technique != MesoTechnique::Plain)
      {
        throw MesoInputError("--effects: the technique " +
          std::string(MesoName(options.Technique)) + " of node '" + node.Name +
          "' does not provide " + missing.Names().front());
      }
      options.Effects = { this->Effects->Auto, this->Effects->Named.Without(missing) };
    }
    this->Override(node.Children);
  }
}

int CommandRender::Run()
{
  MesoScene scene = MesoReadScene(this->SceneFile);
  this->Override(scene.Nodes);
  CheckFileNames({ this->Output, this->Channels.empty() ? std::string() : AOVFileName(this->Output),
                   this->StatsFile },
    { this->SceneFile });

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
  const std::string picture =
    PictureBytes(RenderPicture(window, renderer, this->Samples, ProgressBar()));
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
    CaptureAOVs(renderer, builder, pass);
  }
  if (!this->StatsFile.empty())
  {
    stats = MeasureStats(window, builder, pass, prepareSeconds);
  }
  pass->ReleaseGraphicsResources(window);

  if (!this->Channels.empty())
  {
    const double aspect = double(this->Size[0]) / this->Size[1];
    WriteAOVs(pass, ChannelsOfGroups(this->Channels, pass->GetChannelNames()),
      MesoAttributesOfScene(builder, renderer, aspect), AOVFileName(this->Output));
  }
  if (!this->StatsFile.empty())
  {
    MesoAtomicFile::Write(this->StatsFile, stats.data(), stats.size());
  }
  MesoAtomicFile::Write(this->Output, picture.data(), picture.size());
  return 0;
}
