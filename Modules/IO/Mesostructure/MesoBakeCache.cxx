#include "MesoBakeCache.h"

#include "MesoChecksum.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkPointData.h"

#include <cstdlib>
#include <filesystem>

namespace
{
/// The kept table, or one without a Table where there is none that is whole and what is wanted.
MesoBaked ReadKept(const std::string& file, const std::string& kind,
  const std::map<std::string, MesoBakedParameter>& parameters)
{
  std::error_code error;
  if (!std::filesystem::exists(file, error))
  {
    return {};
  }
  try
  {
    MesoBaked kept = MesoReadBaked(file, kind);
    if (kept.Parameters == parameters)
    {
      return kept;
    }
  }
  catch (const MesoInputError&)
  {
    // Damaged, or of another version: it is baked again and replaced.
  }
  return {};
}

void Keep(const std::string& file, const MesoBaked& baked, std::vector<std::string>& warnings)
{
  try
  {
    std::filesystem::create_directories(std::filesystem::path(file).parent_path());
    MesoWriteBaked(file, baked);
  }
  catch (const std::exception& problem)
  {
    warnings.push_back("what was baked is not kept for the next time (MESO_CACHE names another "
                       "folder, or none): " +
      std::string(problem.what()));
  }
}
}

std::string MesoContentOf(vtkImageData* image)
{
  MesoChecksum sum;
  sum.AddGrid(image);
  vtkPointData* data = image->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    sum.Add(data->GetAbstractArray(i));
  }
  return sum.Text();
}

std::string MesoBakeName(
  const std::string& kind, const std::map<std::string, MesoBakedParameter>& parameters)
{
  MesoChecksum sum;
  sum.Add(MesoBakedFormat);
  for (const auto& [name, parameter] : parameters)
  {
    sum.Add(name);
    sum.Add(static_cast<std::int64_t>(parameter.index()));
    if (const auto* text = std::get_if<std::string>(&parameter))
    {
      sum.Add(*text);
    }
    else
    {
      const auto& numbers = std::get<std::vector<double>>(parameter);
      sum.Add(static_cast<std::int64_t>(numbers.size()));
      sum.Add(numbers.data(), numbers.size() * sizeof(double));
    }
  }
  return kind + "-" + sum.Text();
}

std::string MesoBakeCacheFolder()
{
  if (const char* folder = std::getenv("MESO_CACHE"))
  {
    return folder;
  }
  const char* caches = std::getenv("XDG_CACHE_HOME");
  if (caches && *caches)
  {
    return std::string(caches) + "/meso";
  }
  const char* home = std::getenv("HOME");
  return home && *home ? std::string(home) + "/.cache/meso" : std::string();
}

MesoBaked MesoBakeOnce(const std::string& kind,
  const std::map<std::string, MesoBakedParameter>& parameters,
  const std::function<vtkSmartPointer<vtkImageData>()>& bake, std::vector<std::string>& warnings)
{
  const std::string folder = MesoBakeCacheFolder();
  const std::string file = folder + "/" + MesoBakeName(kind, parameters) + ".vti";
  if (!folder.empty())
  {
    MesoBaked kept = ReadKept(file, kind, parameters);
    if (kept.Table)
    {
      return kept;
    }
  }
  MesoBaked baked;
  baked.Kind = kind;
  baked.Parameters = parameters;
  baked.Table = bake();
  if (!folder.empty())
  {
    Keep(file, baked, warnings);
  }
  return baked;
}
