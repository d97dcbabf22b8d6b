#include "MesoVolumeInput.h"

#include "MesoAlgorithmRun.h"
#include "vtkImageData.h"
#include "vtkMesoVolumeSource.h"
#include "vtkNew.h"

namespace
{
constexpr std::array<int, 3> DefaultSize = { 64, 64, 32 };
}

vtkSmartPointer<vtkImageData> MesoReadVolume(
  const MesoSceneVolume& volume, const std::string& place, std::vector<std::string>& warnings)
{
  if (!volume.File.empty())
  {
    throw MesoInputError(place + ": " + volume.File + ": volumes of files are not available yet");
  }
  vtkNew<vtkMesoVolumeSource> source;
  source->SetPattern(volume.Pattern.c_str());
  source->SetSize(volume.Size.value_or(DefaultSize).data());
  source->SetSeed(volume.Seed);
  for (const auto& [key, value] : volume.Parameters)
  {
    source->SetParameter(key, value);
  }
  MesoRunAlgorithm(source, place, warnings);
  return source->GetOutput();
}
