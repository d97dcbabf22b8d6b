#include "CommandReference.h"

#include "CommandLine.h"
#include "MesoAtomicFile.h"
#include "MesoReference.h"
#include "vtkImageData.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace
{
const std::vector<std::string> AOVGroups = { "coverage", "depth", "texcoord", "relief", "normal",
  "shadow", "object", "fetches", "iterations", "base", "all" };

/// Some channels of an image, in the order given.
MesoExrImage Chosen(const MesoExrImage& all, const std::vector<std::string>& channels)
{
  MesoExrImage image;
  image.Width = all.Width;
  image.Height = all.Height;
  image.ChannelNames = channels;
  const std::size_t pixels = std::size_t(all.Width) * all.Height;
  std::vector<std::size_t> places;
  places.reserve(channels.size());
  for (const std::string& channel : channels)
  {
    places.push_back(std::find(all.ChannelNames.begin(), all.ChannelNames.end(), channel) -
      all.ChannelNames.begin());
  }
  image.Data.reserve(pixels * places.size());
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    for (std::size_t place : places)
    {
      image.Data.push_back(all.Data[pixel * all.ChannelNames.size() + place]);
    }
  }
  return image;
}

std::string StatsText(const MesoReferenceCounters& counters, const char* surface,
  const std::array<int, 2>& size, int samples, int bounces)
{
  nlohmann::ordered_json stats;
  stats["surface"] = surface;
  stats["size"] = size;
  stats["samples"] = samples;
  stats["bounces"] = bounces;
  stats["rays"] = counters.Rays;
  stats["seconds"] = counters.Seconds;
  stats["rays_per_second"] =
    counters.Seconds > 0. ? static_cast<double>(counters.Rays) / counters.Seconds : 0.;
  stats["prepare_s"] = counters.PrepareSeconds;
  stats["memory_bytes"] = counters.MemoryBytes;
  stats["largest_residual"] = counters.LargestResidual;
  stats["blocks"] = counters.Blocks;
  stats["pieces"] = counters.Pieces;
  stats["unresolved_cells"] = counters.UnresolvedCells;
  stats["triangles"] = counters.Triangles;
  stats["degenerate_triangles"] = counters.DegenerateTriangles;
  stats["version"] = MESO_VERSION;
  return stats.dump(2) + "\n";
}
}

CommandReference::CommandReference(CLI::App& app)
{
  CLI::App* command =
    app.add_subcommand("reference", "Ray trace a scene file over its true surface.");
  command->add_option("SCENE", this->SceneFile, "Scene file (JSON)")->required();
  AddOutputOption(*command, this->Output);
  AddSizeOption(*command, this->Size);
  AddChoice(*command, "--surface", "mesh", "smooth", this->Smooth,
    "What lies under the relief: the nodes' meshes (mesh, the default), or the closed forms of "
    "their built-in shapes (smooth)");
  AddAOVOption(*command, AOVGroups, this->Channels);
  AddSamplesOption(*command, this->Samples);
  command
    ->add_option("--bounces", this->Bounces,
      "Diffuse surfaces that light may come over, one path a sample (default: 0)")
    ->check(CLI::Range(0, 64));
  AddStatsOption(*command, this->StatsFile, "JSON file for cost and exactness");
  command->footer("Example: meso reference scene.json -o truth.png --size 800x600 --aov all");
}

int CommandReference::Run()
{
  const MesoScene scene = MesoReadScene(this->SceneFile);
  CheckFileNames({ this->Output, this->Channels.empty() ? std::string() : AOVFileName(this->Output),
                   this->StatsFile },
    { this->SceneFile });
  const MesoReference reference(
    scene, this->Smooth ? MesoReference::Surface::Smooth : MesoReference::Surface::Mesh);
  for (const std::string& warning : reference.GetWarnings())
  {
    std::cerr << "meso: warning: " << warning << "\n";
  }
  ProgressBar bar;
  const MesoReferenceResult result = reference.Render(
    this->Size[0], this->Size[1], this->Samples,
    [&](double part)
    {
      bar(part);
      return true;
    },
    this->Bounces);
  if (!this->Channels.empty())
  {
    const MesoExrImage image =
      Chosen(result.AOVs, ChannelsOfGroups(this->Channels, result.AOVs.ChannelNames));
    MesoWriteExr(AOVFileName(this->Output), image.Width, image.Height, image.ChannelNames,
      image.Data.data(), result.AOVs.Attributes);
  }
  if (!this->StatsFile.empty())
  {
    const char* surface = this->Smooth ? "smooth" : "mesh";
    const std::string stats =
      StatsText(result.Counters, surface, this->Size, this->Samples, this->Bounces);
    MesoAtomicFile::Write(this->StatsFile, stats.data(), stats.size());
  }
  const std::string picture = PictureBytes(result.Picture);
  MesoAtomicFile::Write(this->Output, picture.data(), picture.size());
  return 0;
}
