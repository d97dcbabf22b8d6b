#include "BenchResults.h"

#include "MesoAtomicFile.h"
#include "MesoOptions.h"
#include "MesoScene.h" // for MesoInputError

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <sys/utsname.h>
#include <thread>

namespace
{
using Json = BenchResults::Json;

const char* const FileFormat = "meso bench 1";

Json DescribeMachine()
{
  Json machine;
  std::ifstream cpus("/proc/cpuinfo");
  for (std::string line; std::getline(cpus, line);)
  {
    const std::size_t colon = line.find(": ");
    if (line.rfind("model name", 0) == 0 && colon != std::string::npos)
    {
      machine["processor"] = line.substr(colon + 2);
      break;
    }
  }
  machine["cores"] = std::thread::hardware_concurrency();
  utsname system;
  if (uname(&system) == 0)
  {
    machine["system"] = std::string(system.sysname) + " " + system.release;
  }
  return machine;
}

/// A row's place among those of its scene.
std::array<std::size_t, 4> Order(const Json& row)
{
  const auto place = [](const std::vector<std::string>& names, const std::string& name)
  { return std::size_t(std::find(names.begin(), names.end(), name) - names.begin()); };
  // "none", the row with all effects, comes last and is put first.
  const std::size_t effects = MesoEffectNames().size() + 1;
  const std::size_t searches = MesoSearchNames().size() + 1; // so does the quality's own search
  return { place(MesoTechniqueNames(), row["technique"]), place(MesoQualityNames(), row["quality"]),
    (place(MesoSearchNames(), row.value("search", "")) + 1) % searches,
    (place(MesoEffectNames(), row.value("without", "none")) + 1) % effects };
}

/// The rows of a scene in their order.
std::vector<Json> SortedOf(const Json& rows, const std::string& scene)
{
  std::vector<Json> sorted;
  for (const Json& row : rows)
  {
    if (row["scene"] == scene)
    {
      sorted.push_back(row);
    }
  }
  std::sort(
    sorted.begin(), sorted.end(), [](const Json& a, const Json& b) { return Order(a) < Order(b); });
  return sorted;
}

/// A value as CSV holds it.
std::string Field(const Json& value)
{
  if (value.is_null())
  {
    return "";
  }
  if (!value.is_string())
  {
    return value.dump();
  }
  std::string quoted = "\"";
  for (const char letter : value.get<std::string>())
  {
    quoted += letter == '"' ? "\"\"" : std::string(1, letter);
  }
  return quoted + "\"";
}

/// The figure of this name; null where there is none.
Json ValueOf(const Json& from, const std::string& name)
{
  return from.contains(name) ? from[name] : Json();
}

std::vector<std::string> NamesOfFigures(const Json& errors)
{
  std::vector<std::string> names;
  for (const auto& figure : errors.items())
  {
    if (!figure.value().is_structured() && figure.key() != "depth_unit")
    {
      names.push_back(figure.key());
    }
  }
  return names;
}

const char* const CostNames[] = { "ratio_to_floor", "clock", "runs", "fetches_mean", "fetches_max",
  "texel_reads_mean", "texel_reads_max", "gpu_bytes", "prepare_s", "triangles" };

/// A row by one truth.
void WriteLine(std::ostream& csv, const Json& row, const std::string& surface, const Json& error,
  const std::vector<std::string>& figures)
{
  for (const char* name : { "scene", "technique", "quality", "search", "status", "reason" })
  {
    csv << Field(ValueOf(row, name)) << ',';
  }
  csv << row["size"][0] << ',' << row["size"][1] << ',' << Field(surface) << ','
      << (ValueOf(row, "judged_by") == surface ? 1 : 0) << ','
      << Field(ValueOf(error, "depth_unit"));
  for (const std::string& figure : figures)
  {
    csv << ',' << Field(ValueOf(error, figure));
  }
  for (const char* clock : { "gpu_ms", "frame_ms" })
  {
    for (const char* part : { "median", "min", "max" })
    {
      csv << ',' << Field(ValueOf(ValueOf(row, clock), part));
    }
  }
  for (const char* name : CostNames)
  {
    csv << ',' << Field(ValueOf(row, name));
  }
  csv << ',' << Field(row["device"]) << ',' << Field(row["version"]) << '\n';
}
}

std::string BenchKey(const std::string& bytes)
{
  std::uint64_t sum = 14695981039346656037u;
  for (const char byte : bytes)
  {
    sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211u;
  }
  char text[17];
  std::snprintf(text, sizeof(text), "%016llx", static_cast<unsigned long long>(sum));
  return text;
}

BenchResults::BenchResults(const std::string& folder, bool fresh)
  : Folder(folder)
{
  this->Content = { { "format", FileFormat }, { "machine", DescribeMachine() }, { "device", "" },
    { "version", MESO_VERSION }, { "scenes", Json::array() }, { "rows", Json::array() },
    { "ablations", Json::array() }, { "scaling", nullptr } };
  const std::string name = folder + "/results.json";
  std::ifstream file(name);
  if (!file)
  {
    return;
  }
  const Json before = Json::parse(file, nullptr, false);
  if (!before.is_object() || before.value("format", "") != FileFormat)
  {
    throw MesoInputError(name + ": is there, but is no result of this meso bench");
  }
  if (!fresh)
  {
    this->Content["scenes"] = before["scenes"];
    this->Content["rows"] = before["rows"];
    this->Content["ablations"] = before.value("ablations", Json::array());
    this->Content["scaling"] = before.value("scaling", Json());
  }
}

void BenchResults::Describe(const std::string& device)
{
  this->Content["device"] = device;
}

const Json* BenchResults::FindScene(const std::string& name, const std::string& key) const
{
  for (const Json& scene : this->Content["scenes"])
  {
    if (scene["scene"] == name && scene["key"] == key)
    {
      return &scene;
    }
  }
  return nullptr;
}

const Json* BenchResults::FindRow(const std::string& key) const
{
  for (const char* kind : { "rows", "ablations" })
  {
    for (const Json& row : this->Content[kind])
    {
      if (row["key"] == key)
      {
        return &row;
      }
    }
  }
  return nullptr;
}

void BenchResults::SetScene(Json scene)
{
  for (Json& other : this->Content["scenes"])
  {
    if (other["scene"] == scene["scene"])
    {
      other = std::move(scene);
      return;
    }
  }
  this->Content["scenes"].push_back(std::move(scene));
}

void BenchResults::SetRow(Json row)
{
  Json& rows = this->Content[row.contains("without") ? "ablations" : "rows"];
  for (Json& other : rows)
  {
    if (other["scene"] == row["scene"] && Order(other) == Order(row))
    {
      other = std::move(row);
      return;
    }
  }
  rows.push_back(std::move(row));
}

std::vector<Json> BenchResults::RowsOf(const std::string& scene) const
{
  return SortedOf(this->Content["rows"], scene);
}

std::vector<Json> BenchResults::AblationsOf(const std::string& scene) const
{
  return SortedOf(this->Content["ablations"], scene);
}

std::string BenchResults::Csv() const
{
  // Figures of error have the names that the first row has them by.
  std::vector<std::string> figures;
  for (const Json& row : this->Content["rows"])
  {
    if (figures.empty() && row["status"] == "ok")
    {
      figures = NamesOfFigures(row["errors"].front());
    }
  }
  std::ostringstream csv;
  csv << "scene,technique,quality,search,status,reason,width,height,surface,judged,depth_unit";
  for (const std::string& figure : figures)
  {
    csv << ',' << figure;
  }
  csv << ",gpu_ms_median,gpu_ms_min,gpu_ms_max,frame_ms_median,frame_ms_min,frame_ms_max";
  for (const char* name : CostNames)
  {
    csv << ',' << name;
  }
  csv << ",device,version\n";
  for (const Json& scene : this->Content["scenes"])
  {
    for (const Json& row : this->RowsOf(scene["scene"]))
    {
      if (row["status"] != "ok")
      {
        WriteLine(csv, row, "", Json::object(), figures);
        continue;
      }
      for (const auto& error : row["errors"].items())
      {
        WriteLine(csv, row, error.key(), error.value(), figures);
      }
    }
  }
  return csv.str();
}

void BenchResults::Save() const
{
  const std::string json = this->Content.dump(1) + "\n";
  MesoAtomicFile::Write(this->Folder + "/results.json", json.data(), json.size());
  const std::string csv = this->Csv();
  MesoAtomicFile::Write(this->Folder + "/results.csv", csv.data(), csv.size());
}
