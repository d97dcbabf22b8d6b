#include "BakeKind.h"

#include "CommandLine.h"
#include "MesoAlgorithmRun.h"
#include "MesoAtomicFile.h"
#include "MesoHeightMap.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkMesoImageReader.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>
#include <sys/resource.h>

namespace
{
void Warn(const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
  {
    std::cerr << "meso: warning: " << warning << "\n";
  }
}

std::array<double, 2> ParseRange(const std::string& text)
{
  const auto range = ParsePair(text);
  if (!range || !((*range)[0] < (*range)[1]))
  {
    throw CLI::ValidationError(
      "--range", "'" + text + "' is no range such as 0,255, the first less than the second");
  }
  return *range;
}

/// Shows a progress bar.
class ShowProgress : public vtkCommand
{
public:
  static ShowProgress* New() { return new ShowProgress; }
  void Execute(vtkObject*, unsigned long, void* part) override
  {
    this->Bar(*static_cast<double*>(part));
  }

private:
  ProgressBar Bar;
};
}

void BakeInput::AddOptions(CLI::App& command)
{
  command.add_option("INPUT", this->FileName, "Height map (image file)")->required();
  command.add_flag("--depth-map", this->IsDepth, "Brighter is deeper, not higher");
  command.add_option_function<std::string>(
    "--range", [this](const std::string& text) { this->Range = ParseRange(text); },
    "LO,HI: stored numbers that stand for 0 and 1 (default: all that 8 or 16 bit hold; 0,1)");
  command.add_option_function<std::string>(
    "--wrap",
    [this](const std::string& text)
    {
      const auto wrap = MesoWrapFromName(text);
      if (!wrap)
      {
        throw CLI::ValidationError(
          "--wrap", "'" + text + "' is none of " + JoinNames(MesoWrapNames()));
      }
      this->Wrap = *wrap;
    },
    "What lies outside of the map (default: repeat): " + JoinNames(MesoWrapNames()));
}

vtkSmartPointer<vtkImageData> BakeInput::Read() const
{
  std::vector<std::string> warnings;
  vtkNew<vtkMesoImageReader> reader;
  reader->SetFileName(this->FileName.c_str());
  MesoRunAlgorithm(reader, this->FileName, warnings);
  Warn(warnings);
  try
  {
    MesoHeights heights = MesoToHeights(reader->GetOutput(), this->IsDepth, this->Range);
    for (const std::string& warning : heights.Warnings)
    {
      Warn({ this->FileName + ": " + warning });
    }
    return heights.Image;
  }
  catch (const MesoInputError& problem)
  {
    throw MesoInputError(this->FileName + ": " + problem.what());
  }
}

void BakeOutput::AddOptions(CLI::App& command, const std::string& what)
{
  command.add_option("-o,--output", this->FileName, what)->required();
  AddStatsOption(command, this->StatsFile, "JSON file for time and memory");
}

void BakeOutput::Check(
  const std::vector<std::string>& inputs, const std::vector<std::string>& more) const
{
  std::vector<std::string> results = { this->FileName, this->StatsFile };
  results.insert(results.end(), more.begin(), more.end());
  CheckFileNames(results, inputs);
}

void BakeOutput::Update(vtkAlgorithm* algorithm)
{
  vtkNew<ShowProgress> progress;
  algorithm->AddObserver(vtkCommand::ProgressEvent, progress);
  std::vector<std::string> warnings;
  const auto start = std::chrono::steady_clock::now();
  MesoRunAlgorithm(algorithm, this->FileName, warnings);
  this->Seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Warn(warnings);
}

void BakeOutput::WriteStats(const char* kind, vtkImageData* table,
  const std::vector<std::pair<std::string, double>>& more) const
{
  if (this->StatsFile.empty())
  {
    return;
  }
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  constexpr std::int64_t BytesPerKibibyte = 1024;
  nlohmann::ordered_json stats;
  stats["kind"] = kind;
  stats["size"] = { table->GetDimensions()[0], table->GetDimensions()[1],
    table->GetDimensions()[2] };
  stats["bake_s"] = this->Seconds;
  stats["peak_memory_bytes"] = usage.ru_maxrss * BytesPerKibibyte;
  for (const auto& [name, number] : more)
  {
    stats[name] = number;
  }
  stats["version"] = MESO_VERSION;
  const std::string text = stats.dump(2) + "\n";
  MesoAtomicFile::Write(this->StatsFile, text.data(), text.size());
}
