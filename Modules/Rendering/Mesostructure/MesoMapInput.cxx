#include "MesoMapInput.h"

#include "MesoAlgorithmRun.h"
#include "MesoDemFile.h"
#include "MesoFileBytes.h"
#include "MesoMeshFormats.h"
#include "MesoMessage.h"
#include "MesoPolarity.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMesoImageReader.h"
#include "vtkMesoPatternSource.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double MostDeviation = 0.1; // of sample_spacing from what the surface has

bool IsDem(const MesoSceneMap& map)
{
  return MesoExtensionOf(map.File) == ".dem";
}

MesoStoredMap ReadDem(
  const MesoSceneMap& map, const std::string& place, std::vector<std::string>& warnings)
{
  MesoDem dem;
  try
  {
    dem = MesoParseDem(MesoReadBytes(map.File, MesoLargestDemFile, "an elevation file"), map.File);
  }
  catch (const MesoInputError& problem)
  {
    throw MesoInputError(place + ": " + problem.what());
  }
  for (const std::string& note : dem.Notes)
  {
    warnings.push_back(place + ": " + map.File + ": " + note);
  }
  MesoStoredMap stored;
  stored.Image = vtkSmartPointer<vtkImageData>::New();
  stored.Image->SetDimensions(dem.Width, dem.Height, 1);
  stored.Image->SetSpacing(dem.Spacing[0], dem.Spacing[1], 1.);
  stored.Image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(dem.Elevations.begin(), dem.Elevations.end(),
    static_cast<float*>(stored.Image->GetScalarPointer()));
  stored.Range = dem.Range;
  if (!(dem.Range[0] < dem.Range[1]))
  {
    stored.Range = { { dem.Range[0], dem.Range[0] + 1. } }; // a plain at height 0
  }
  return stored;
}

/// The alpha channel of a relief map, its depth (004, section 2.1).
vtkSmartPointer<vtkImageData> DepthOfReliefMap(const MesoSceneMap& map, vtkImageData* image,
  const std::string& place, std::vector<std::string>& warnings)
{
  vtkDataArray* values = image->GetPointData()->GetScalars();
  constexpr int channels = 4;
  if (values->GetNumberOfComponents() != channels)
  {
    throw MesoInputError(place + ": " + map.File + ": a relief map has four channels, normal and " +
      "depth, and this image has " + std::to_string(values->GetNumberOfComponents()));
  }
  auto depth = vtkSmartPointer<vtkImageData>::New();
  depth->SetExtent(image->GetExtent());
  auto alpha = vtkSmartPointer<vtkDataArray>::Take(values->NewInstance());
  alpha->SetNumberOfTuples(values->GetNumberOfTuples());
  alpha->CopyComponent(0, values, channels - 1);
  depth->GetPointData()->SetScalars(alpha);
  const std::string warning = MesoPolarityWarning(depth, image, true, true);
  if (!warning.empty())
  {
    warnings.push_back(place + ": " + map.File + ": " + warning);
  }
  return depth;
}
}

MesoStoredMap MesoReadMap(
  const MesoSceneMap& map, const std::string& place, std::vector<std::string>& warnings)
{
  MesoStoredMap stored;
  if (map.File.empty())
  {
    vtkNew<vtkMesoPatternSource> source;
    source->SetPattern(map.Pattern.c_str());
    source->SetSize(map.Size[0], map.Size[1]);
    source->SetSeed(map.Seed);
    for (const auto& parameter : map.Parameters)
    {
      source->SetParameter(parameter.first, parameter.second);
    }
    MesoRunAlgorithm(source, place, warnings);
    stored.Image = source->GetOutput();
  }
  else if (IsDem(map))
  {
    stored = ReadDem(map, place, warnings);
  }
  else
  {
    vtkNew<vtkMesoImageReader> reader;
    reader->SetFileName(map.File.c_str());
    MesoRunAlgorithm(reader, place, warnings);
    stored.Image = reader->GetOutput();
    if (map.IsReliefMap)
    {
      stored.Image = DepthOfReliefMap(map, stored.Image, place, warnings);
    }
  }
  stored.Range = map.Range ? map.Range : stored.Range;
  return stored;
}

std::optional<std::array<double, 2>> MesoSampleSpacing(
  const MesoSceneMap& map, vtkImageData* heights)
{
  if (map.SampleSpacing || !heights || !IsDem(map))
  {
    return map.SampleSpacing;
  }
  const double* spacing = heights->GetSpacing();
  return { { spacing[0], spacing[1] } };
}

void MesoCheckSampleSpacing(const MesoSceneNode& node, vtkImageData* heights, vtkPolyData* mesh,
  const std::string& place, std::vector<std::string>& warnings)
{
  vtkDataArray* scales = mesh->GetPointData()->GetArray("MesoTileScale");
  const auto said = node.Map ? MesoSampleSpacing(*node.Map, heights) : std::nullopt;
  if (!said || !scales || scales->GetNumberOfTuples() == 0)
  {
    return;
  }
  int samples[3];
  heights->GetDimensions(samples);
  std::array<double, 2> found{};
  bool isOff = false;
  for (int k = 0; k < 2; ++k)
  {
    std::vector<double> column(static_cast<std::size_t>(scales->GetNumberOfTuples()));
    for (std::size_t i = 0; i < column.size(); ++i)
    {
      column[i] = scales->GetComponent(static_cast<vtkIdType>(i), k);
    }
    const auto middle = column.begin() + static_cast<std::ptrdiff_t>(column.size() / 2);
    std::nth_element(column.begin(), middle, column.end());
    found[k] = *middle / (node.Mesostructure.Tiles[k] * samples[k]);
    isOff |= !(std::abs(found[k] - (*said)[k]) <= MostDeviation * (*said)[k]);
  }
  if (isOff)
  {
    const auto text = [](const std::array<double, 2>& spacing)
    { return MesoNumberText(float(spacing[0])) + " x " + MesoNumberText(float(spacing[1])); };
    warnings.push_back(place + ": the map's samples are " + text(*said) + " apart, but lie " +
      text(found) + " apart on this surface (median; texture coordinates and tiles say so)");
  }
}
