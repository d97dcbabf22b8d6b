#include "CommandBench.h"

#include "BenchProgress.h"
#include "BenchReport.h"
#include "BenchScaling.h"
#include "BenchScene.h"
#include "CommandLine.h"
#include "MesoAtomicFile.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <iostream>
#include <set>

namespace
{
/// The values that a list of names stands for.
template <typename T>
std::vector<T> ParseList(const char* option, const std::string& text,
  std::optional<T> (*valueOf)(const std::string&), const std::vector<std::string>& choices)
{
  std::vector<T> values;
  for (const std::string& name : SplitAtCommas(text))
  {
    const std::optional<T> value = valueOf(name);
    if (!value)
    {
      throw CLI::ValidationError(option, "'" + name + "' is none of " + JoinNames(choices));
    }
    values.push_back(*value);
  }
  return values;
}

/// The name of what draws. Throws where nothing does.
std::string DeviceName()
{
  vtkNew<vtkMesoEGLRenderWindow> window;
  const std::string device = window->GetGLRenderer();
  if (device.empty())
  {
    throw MesoInputError("there is no device to draw with");
  }
  return device;
}

void MakeFolder(const std::string& folder)
{
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem || !std::filesystem::is_directory(folder))
  {
    throw MesoInputError(folder + ": this folder cannot be made");
  }
  const MesoAtomicFile possible(folder + "/results.json"); // which throws where it is not
}
}

CommandBench::CommandBench(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("bench",
    "Judge and time scenes in techniques and qualities; write tables, plots and a report.");
  command->add_option("SCENE", this->Settings.SceneFiles, "Scene files (JSON)")->required();
  command
    ->add_option("-o,--output", this->Settings.Folder,
      "Folder for results.csv, results.json, report.html and pictures. What it holds already of "
      "the same scenes and settings is kept")
    ->required();
  command->add_option_function<std::string>(
    "--techniques",
    [this](const std::string& text)
    {
      this->Techniques =
        ParseList("--techniques", text, MesoTechniqueFromName, MesoTechniqueNames());
    },
    "List of techniques (default: all, those of volumes for what is drawn as a volume): " +
      JoinNames(MesoTechniqueNames()));
  command->add_option_function<std::string>(
    "--qualities",
    [this](const std::string& text)
    { this->Qualities = ParseList("--qualities", text, MesoQualityFromName, MesoQualityNames()); },
    "List of qualities (default: all): " + JoinNames(MesoQualityNames()));
  command->add_option_function<std::string>(
    "--searches",
    [this](const std::string& text)
    { this->Searches = ParseList("--searches", text, MesoSearchFromName, MesoSearchNames()); },
    "List of searches of height maps, each with each quality that it goes with (default: what the "
    "quality stands for): " +
      JoinNames(MesoSearchNames()));
  command->add_option_function<std::string>(
    "--size", [this](const std::string& text) { this->Size = ParseSize("--size", text); },
    "Width and height in pixels (default: 512x384, quick: 192x144)");
  command->add_flag(
    "--quick", this->Settings.Quick, "Small pictures and few runs, for a first look");
  command->add_flag("--ablation", this->Settings.Ablation,
    "Measure also what each effect costs and what it is worth");
  command->add_flag("--scaling", this->Settings.Scaling,
    "Measure also how time grows with pixels, triangles, texels of the map and lights");
  command->add_flag("--fresh", this->Settings.Fresh,
    "Do all again, as after a change of the program, which the folder cannot see");
  command->footer("Example: meso bench Data/Bench/*.json -o bench --quick");
}

void CommandBench::AddSearches(const BenchArm& arm, std::vector<BenchArm>& arms) const
{
  std::vector<std::optional<MesoSearch>> searches(this->Searches.begin(), this->Searches.end());
  if (searches.empty() || !MesoHasSearches(arm.Technique))
  {
    searches = { std::nullopt };
  }
  for (const std::optional<MesoSearch>& search : searches)
  {
    MesoMesostructureOptions options;
    options.Technique = arm.Technique;
    options.Quality = *arm.Quality;
    options.Search = search;
    if (MesoSearchProblem(options).empty())
    {
      arms.push_back(arm);
      arms.back().Search = search;
    }
  }
}

std::vector<BenchArm> CommandBench::Arms() const
{
  std::vector<BenchArm> arms;
  for (const std::string& technique : MesoTechniqueNames())
  {
    const MesoTechnique value = *MesoTechniqueFromName(technique);
    const auto& wanted = this->Techniques;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), value) == wanted.end())
    {
      continue;
    }
    if (!MesoHasQualities(value))
    {
      arms.push_back(
        { value, std::nullopt, std::nullopt, false, std::nullopt }); // which has one setting
      continue;
    }
    for (const std::string& quality : MesoQualityNames())
    {
      const MesoQuality level = *MesoQualityFromName(quality);
      const auto& levels = this->Qualities;
      if (levels.empty() || std::find(levels.begin(), levels.end(), level) != levels.end())
      {
        this->AddSearches({ value, level, std::nullopt, false, std::nullopt }, arms);
      }
    }
  }
  return arms;
}

int CommandBench::Run()
{
  if (this->Settings.Quick)
  {
    this->Settings.Size = { 192, 144 };
    this->Settings.WarmUp = 1;
    this->Settings.Runs = 7;
  }
  this->Settings.Size = this->Size.value_or(this->Settings.Size);
  this->Settings.Arms = this->Arms();
  this->Settings.MapsAsVolumes = !this->Techniques.empty();

  const std::string device = DeviceName();
  std::vector<BenchScene> scenes;
  std::set<std::string> names;
  double steps = 0.;
  for (const std::string& file : this->Settings.SceneFiles)
  {
    scenes.emplace_back(this->Settings, file, device);
    steps += scenes.back().Steps();
    if (!names.insert(scenes.back().Name()).second)
    {
      throw MesoInputError(
        file + ": another scene is called '" + scenes.back().Name() + "' as well");
    }
  }
  MakeFolder(this->Settings.Folder);
  BenchResults results(this->Settings.Folder, this->Settings.Fresh);
  results.Describe(device);
  std::cerr << "meso: rendering on " << device << "\n";

  BenchProgress progress;
  progress.SetTotal(steps + (this->Settings.Scaling ? StepsOfScaling(this->Settings) : 0.));
  bool failed = false;
  for (const BenchScene& scene : scenes)
  {
    failed = !scene.Run(results, progress) || failed;
    WriteReport(results, this->Settings.Folder);
  }
  if (this->Settings.Scaling)
  {
    const std::string key = KeyOfScaling(this->Settings, device);
    const auto& before = results.All()["scaling"];
    if (before.is_null() || before["key"] != key)
    {
      results.SetScaling(
        { { "key", key }, { "series", MeasureScaling(this->Settings, progress) } });
      results.Save();
      WriteReport(results, this->Settings.Folder);
    }
  }
  progress.End();
  for (const auto& scene : results.All()["scenes"])
  {
    if (names.count(scene["scene"]) && scene["status"] != "ok")
    {
      std::cerr << "meso: " << scene["scene"].get<std::string>() << ": "
                << scene["reason"].get<std::string>() << "\n";
    }
  }
  return failed ? 1 : 0;
}
