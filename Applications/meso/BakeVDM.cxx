#include "BakeVDM.h"

#include "CommandLine.h"
#include "MesoBakeCache.h"
#include "MesoBakeParts.h"
#include "MesoBakedFile.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMesoVDM.h"
#include "vtkNew.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <iostream>
#include <map>

namespace
{
const std::map<std::string, MesoVDMNodes> NodeNames = { { "edges", MesoVDMNodes::Edges },
  { "centres", MesoVDMNodes::Centres }, { "graded", MesoVDMNodes::Graded } };
const std::map<std::string, MesoVDMStores> StoredNames = { { "distance", MesoVDMStores::Distance },
  { "depth", MesoVDMStores::Depth }, { "offset", MesoVDMStores::Offset } };
const std::map<std::string, MesoVDMCurved> CurvedNames = { { "exact", MesoVDMCurved::Exact },
  { "bent", MesoVDMCurved::Bent } };

template <typename T>
std::string NameOf(const std::map<std::string, T>& names, T value)
{
  for (const auto& [name, named] : names)
  {
    if (named == value)
    {
      return name;
    }
  }
  return {};
}

/// An option that takes one of a few words.
template <typename T>
void AddChoice(CLI::App& command, const std::string& option, T& target,
  const std::map<std::string, T>& names, const std::string& what)
{
  std::vector<std::string> words;
  words.reserve(names.size());
  for (const auto& [name, value] : names)
  {
    words.push_back(name);
  }
  const std::string all = JoinNames(words);
  command.add_option_function<std::string>(
    option,
    [option, &target, &names, all](const std::string& text)
    {
      const auto named = names.find(text);
      if (named == names.end())
      {
        throw CLI::ValidationError(option, "'" + text + "' is none of " + all);
      }
      target = named->second;
    },
    what + " (default: " + NameOf(names, target) + "): " + all);
}

/// "N,MIN,MAX"
void ParseCurvatures(const std::string& text, MesoVDMLayout& layout)
{
  const std::size_t comma = text.find(',');
  const auto range = comma == std::string::npos ? std::nullopt : ParsePair(text.substr(comma + 1));
  const auto count = ParsePair(text.substr(0, comma) + ",0");
  if (!range || !count || (*count)[0] != std::floor((*count)[0]) || !((*count)[0] >= 1.) ||
    !((*count)[0] <= 64.))
  {
    throw CLI::ValidationError("--curvatures",
      "'" + text + "' is no number of 1 to 64, smallest and largest, such as 16,-2,3");
  }
  layout.Curvatures = static_cast<int>((*count)[0]);
  layout.FirstCurvature = (*range)[0];
  layout.LastCurvature = (*range)[1];
}
}

void BakeVDM::AddOptions(CLI::App& command)
{
  command.description("Where each ray into a height map's relief meets it, over curved bases too.");
  this->Input.AddOptions(command);
  this->Output.AddOptions(command, "Baked file to write (.vti)");
  command.add_option_function<std::string>(
    "--size",
    [this](const std::string& text)
    {
      const std::array<int, 2> size = ParseSize("--size", text);
      this->Layout.Width = size[0];
      this->Layout.Height = size[1];
    },
    "WxH: texels, to which the map is resampled (default: 128x128)");
  command
    .add_option("--depth", this->Layout.Depth, "Depth of the deepest point in tiles (default: 0.1)")
    ->check(CLI::Range(1e-6, 16.));
  command.add_option_function<std::string>(
    "--directions",
    [this](const std::string& text)
    {
      const std::array<int, 2> directions = ParseSize("--directions", text);
      this->Layout.Azimuths = directions[0];
      this->Layout.Polars = directions[1];
    },
    "PHIxTHETA: azimuths and polar angles (default: 32x8)");
  command.add_option_function<std::string>(
    "--curvatures", [this](const std::string& text) { ParseCurvatures(text, this->Layout); },
    "N,MIN,MAX: curvatures of the base, 1 / tile, convex positive (default: 16,-2,3)");
  command.add_option_function<std::string>(
    "--rank",
    [this](const std::string& text)
    {
      const auto ranks = ParsePair(text);
      if (!ranks || !((*ranks)[0] >= 0.) || !((*ranks)[1] >= 0.) || !((*ranks)[0] <= 64.) ||
        !((*ranks)[1] <= 64.))
      {
        throw CLI::ValidationError("--rank", "'" + text + "' is no pair of ranks such as 8,4");
      }
      this->Ranks = { static_cast<int>((*ranks)[0]), static_cast<int>((*ranks)[1]) };
    },
    "VDM,MVM: factors of distances and of outlines; 0,0: the table itself (default: 8,4)");
  command.add_option("--bits", this->Bits, "Bits of a factor's weight (default: 8)")
    ->check(CLI::IsMember({ 8, 16 }));
  command
    .add_option("--resume-after", this->Patience,
      "Seconds after which what is finished is kept in the cache, for a bake that is stopped to go "
      "on from (default: 10)")
    ->check(CLI::Range(0., 1e9));
  AddChoice(command, "--nodes", this->Layout.Nodes, NodeNames, "Where the polar angles lie");
  AddChoice(command, "--stores", this->Layout.Stores, StoredNames, "What is stored");
  AddChoice(command, "--curved", this->Curved, CurvedNames,
    "How other curvatures than 0 are baked: rays through the bent relief, or flat points bent");
  command.footer("Example: meso bake vdm stone.png -o stone.vdm.vti --depth 0.08");
}

void BakeVDM::Run()
{
  this->Output.Check({ this->Input.GetFileName() });
  vtkNew<vtkMesoVDM> filter;
  filter->SetInputData(this->Input.Read());
  filter->SetWrap(this->Input.GetWrap());
  filter->SetLayout(this->Layout);
  filter->SetCurved(this->Curved);
  filter->SetRanks(this->Ranks.data());
  filter->SetBits(this->Bits);

  MesoBaked baked;
  baked.Kind = this->GetName();
  baked.Parameters["depth"] = std::vector<double>{ this->Layout.Depth };
  baked.Parameters["directions"] =
    std::vector<double>{ double(this->Layout.Azimuths), double(this->Layout.Polars) };
  baked.Parameters["curvatures"] = std::vector<double>{ double(this->Layout.Curvatures),
    this->Layout.FirstCurvature, this->Layout.LastCurvature };
  baked.Parameters["nodes"] = NameOf(NodeNames, this->Layout.Nodes);
  baked.Parameters["stores"] = NameOf(StoredNames, this->Layout.Stores);
  baked.Parameters["curved"] = NameOf(CurvedNames, this->Curved);

  // Rays are the same whatever ranks and bits their numbers end as.
  std::map<std::string, MesoBakedParameter> rays = baked.Parameters;
  rays["version"] = std::vector<double>{ MesoVDMVersion };
  rays["heights"] = MesoContentOf(vtkImageData::SafeDownCast(filter->GetInput()));
  rays["size"] = std::vector<double>{ double(this->Layout.Width), double(this->Layout.Height) };
  MesoBakeParts parts(this->GetName(), rays, this->Patience);
  filter->SetParts({ [&](int azimuth, float* numbers, std::size_t count)
    { return parts.Take(azimuth, numbers, count); },
    [&](int azimuth, const float* numbers, std::size_t count)
    { parts.Keep(azimuth, numbers, count); } });
  this->Output.Update(filter);

  baked.Parameters["rank"] = std::vector<double>{ double(this->Ranks[0]), double(this->Ranks[1]) };
  baked.Table = filter->GetOutput();
  MesoWriteBaked(this->Output.GetFileName(), baked);
  parts.Remove();
  if (parts.GetTaken() > 0)
  {
    std::cout << "went on from " << parts.GetTaken() << " of " << this->Layout.Azimuths
              << " azimuths that an earlier bake left\n";
  }
  if (!parts.GetProblem().empty())
  {
    std::cerr << "meso: warning: parts were not kept: " << parts.GetProblem() << "\n";
  }
  this->WriteStats(filter, parts.GetTaken());
}

void BakeVDM::WriteStats(vtkMesoVDM* filter, int taken) const
{
  vtkFieldData* data = filter->GetOutput()->GetFieldData();
  std::vector<std::pair<std::string, double>> stats = { { "rays_s", filter->GetRaySeconds() },
    { "factors_s", filter->GetFactorSeconds() }, { "azimuths_taken", double(taken) },
    { "between_angles_rms_tiles",
      data->GetArray("AngularError")->GetTuple1(0) * this->Layout.Range() } };
  if (vtkDataArray* errors = data->GetArray("FactorErrors"))
  {
    constexpr double RightAngle = 90.;
    stats.emplace_back("factors_rms_tiles", errors->GetTuple1(0) * this->Layout.Range());
    stats.emplace_back("factors_max_tiles", errors->GetTuple1(1) * this->Layout.Range());
    stats.emplace_back("outline_rms_degrees", errors->GetTuple1(2) * RightAngle);
  }
  this->Output.WriteStats(this->GetName(), filter->GetOutput(), stats);
}
