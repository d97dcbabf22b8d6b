#include "InfoPolarity.h"

#include "MesoPolarity.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkImageData.h"
#include "vtkMesoImageReader.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <filesystem>

namespace
{
namespace fs = std::filesystem;

/// The normal map's file, or an empty name.
std::string NormalMapBeside(const std::string& fileName)
{
  const fs::path path = fileName;
  const std::string stem = path.stem().string();
  for (const std::string word : { "height", "depth", "displacement", "disp", "bump" })
  {
    const std::size_t place = stem.rfind(word);
    if (place == std::string::npos)
    {
      continue;
    }
    for (const char* normal : { "normal", "nor_gl", "normal_gl", "nor", "nrm" })
    {
      for (const std::string& extension : { path.extension().string(), std::string(".png"),
             std::string(".jpg"), std::string(".exr"), std::string(".tif") })
      {
        std::string name = stem;
        const fs::path beside =
          path.parent_path() / (name.replace(place, word.size(), normal) + extension);
        std::error_code error;
        if (fs::is_regular_file(beside, error))
        {
          return beside.string();
        }
      }
    }
  }
  return {};
}

/// Null where the file cannot be read.
vtkSmartPointer<vtkImageData> ReadImage(const std::string& fileName)
{
  vtkNew<vtkMesoImageReader> reader;
  vtkNew<vtkCallbackCommand> quiet; // the report of the image itself says what is wrong
  quiet->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
  reader->AddObserver(vtkCommand::ErrorEvent, quiet);
  reader->AddObserver(vtkCommand::WarningEvent, quiet);
  reader->SetFileName(fileName.c_str());
  reader->Update();
  return reader->GetErrorMessage().empty() ? reader->GetOutput() : nullptr;
}
}

nlohmann::ordered_json JsonOfPolarity(const std::string& fileName)
{
  const std::string beside = NormalMapBeside(fileName);
  const auto map = beside.empty() ? nullptr : ReadImage(fileName);
  const auto normals = map ? ReadImage(beside) : nullptr;
  if (!normals)
  {
    return nullptr;
  }
  const MesoPolarity polarity = MesoComparePolarity(map, normals);
  const bool isYUp = !polarity.LooksYDown();
  const auto reading = polarity.Says(isYUp);
  nlohmann::ordered_json json;
  json["normal_map"] = beside;
  json["correlation_in_u"] = polarity.InU;
  json["correlation_in_v"] = polarity.InV;
  json["brighter_is"] = reading == MesoPolarity::Reading::Height ? "higher"
    : reading == MesoPolarity::Reading::Depth                    ? "deeper"
                                                                 : "not told";
  json["y_of_normals"] = reading == MesoPolarity::Reading::Unknown ? "not told"
    : isYUp                                                        ? "up"
                                                                   : "down";
  return json;
}
