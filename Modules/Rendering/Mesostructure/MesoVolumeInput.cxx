#include "MesoVolumeInput.h"

#include "MesoAlgorithmRun.h"
#include "MesoMeshReport.h"
#include "MesoMessage.h"
#include "MesoVolume.h"
#include "MesoVolumeFile.h"
#include "vtkImageData.h"
#include "vtkMesoMeshReader.h"
#include "vtkMesoMeshTile.h"
#include "vtkMesoSignedDistance.h"
#include "vtkMesoVolumeSource.h"
#include "vtkMesoVolumeTile.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace
{
constexpr std::array<int, 3> DefaultSize = { 64, 64, 32 };

vtkSmartPointer<vtkImageData> MakePattern(
  const MesoSceneVolume& volume, const std::string& place, std::vector<std::string>& warnings)
{
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

vtkSmartPointer<vtkImageData> ReadMesh(
  const MesoSceneVolume& volume, const std::string& place, std::vector<std::string>& warnings)
{
  vtkNew<vtkMesoMeshReader> reader;
  reader->SetFileName(volume.File.c_str());
  MesoRunAlgorithm(reader, place, warnings);
  const MesoMeshReport report = MesoReportMesh(reader->GetOutput());
  if (report.BoundaryEdges > 0 || report.TurnedEdges > 0)
  {
    throw MesoInputError(place + ": " + volume.File + ": is not closed: " +
      std::to_string(report.BoundaryEdges) + " edges have one triangle, and " +
      std::to_string(report.TurnedEdges) + " have two of opposite winding");
  }
  vtkNew<vtkMesoMeshTile> tile;
  tile->SetInputConnection(reader->GetOutputPort());
  tile->SetSize(volume.Size.value_or(DefaultSize).data());
  if (volume.Crop)
  {
    std::array<double, 6> box = *volume.Crop;
    tile->SetBox(box.data());
  }
  MesoRunAlgorithm(tile, place + ": " + volume.File, warnings);
  return tile->GetOutput();
}

/// The tile's samples as whole numbers.
std::array<int, 6> SamplesOf(const MesoSceneVolume& volume, const std::string& place)
{
  std::array<int, 6> samples{};
  for (std::size_t i = 0; volume.Crop && i < samples.size(); ++i)
  {
    const double number = (*volume.Crop)[i];
    if (!(number >= 0. && number <= std::numeric_limits<int>::max()) ||
      number != std::floor(number))
    {
      throw MesoInputError(place + ": crop is of whole numbers of samples, 0 or more");
    }
    samples[i] = static_cast<int>(number);
  }
  return samples;
}

void WarnOfSeams(vtkImageData* tile, const std::string& place, std::vector<std::string>& warnings)
{
  const MesoVolumeReport report = MesoReportVolume(tile);
  for (int axis = 0; axis < 2; ++axis)
  {
    const MesoTilingReport& tiling = report.Tiling[axis];
    if (std::string(tiling.Verdict()) == "no")
    {
      std::ostringstream warning;
      warning << place << ": the volume does not tile in " << (axis == 0 ? "x" : "y")
              << ": the step over its border is "
              << MesoNumberText(static_cast<float>(tiling.AcrossBorder)) << ", inside it is "
              << MesoNumberText(static_cast<float>(tiling.Inside))
              << " (means); blend makes it tile";
      warnings.push_back(warning.str());
    }
  }
}

vtkSmartPointer<vtkImageData> ReadFile(
  const MesoSceneVolume& volume, const std::string& place, std::vector<std::string>& warnings)
{
  vtkSmartPointer<vtkImageData> image;
  try
  {
    image = MesoReadVolumeFile(volume.File);
  }
  catch (const MesoInputError& problem)
  {
    throw MesoInputError(place + ": " + problem.what());
  }
  const std::string inFile = place + ": " + volume.File;
  if (MesoVolumeProblem(image).empty() && !volume.Size && !volume.Crop && !volume.Threshold)
  {
    return image; // distances already
  }
  vtkNew<vtkMesoVolumeTile> tile;
  tile->SetInputData(image);
  tile->SetCrop(SamplesOf(volume, place).data());
  tile->SetBlend(volume.Blend);
  MesoRunAlgorithm(tile, inFile, warnings);
  WarnOfSeams(tile->GetOutput(), inFile, warnings);
  const MesoVolumeReport report = MesoReportVolume(tile->GetOutput());
  if (report.NotFinite > 0)
  {
    throw MesoInputError(
      inFile + ": " + std::to_string(report.NotFinite) + " numbers are not finite");
  }
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < size.size(); ++axis)
  {
    size[axis] =
      volume.Size ? (*volume.Size)[axis] : std::min(report.Size[axis], DefaultSize[axis]);
  }
  tile->SetSize(size.data());
  if (report.Least == report.Most && !volume.Threshold)
  {
    throw MesoInputError(inFile + ": holds one number alone, so threshold must say what is solid");
  }

  vtkNew<vtkMesoSignedDistance> distance;
  distance->SetInputConnection(tile->GetOutputPort());
  distance->SetThreshold(volume.Threshold.value_or(report.Parting));
  distance->SetSolidBelow(volume.SolidBelow);
  MesoRunAlgorithm(distance, inFile, warnings);
  vtkSmartPointer<vtkImageData> canonical = distance->GetOutput();
  double range[2];
  canonical->GetPointData()->GetScalars()->GetRange(range);
  if (range[0] >= 0. || range[1] < 0.)
  {
    warnings.push_back(inFile + ": all of the volume is " + (range[0] >= 0. ? "empty" : "solid") +
      " at this threshold");
  }
  return canonical;
}
}

vtkSmartPointer<vtkImageData> MesoReadVolume(
  const MesoSceneVolume& volume, const std::string& place, std::vector<std::string>& warnings)
{
  return volume.File.empty() ? MakePattern(volume, place, warnings)
    : volume.IsMesh          ? ReadMesh(volume, place, warnings)
                             : ReadFile(volume, place, warnings);
}

vtkSmartPointer<vtkImageData> MesoColoredVolume(
  vtkImageData* volume, const std::string& file, const std::string& place)
{
  std::string problem;
  auto colored = vtkSmartPointer<vtkImageData>::New();
  colored->ShallowCopy(volume);
  try
  {
    problem = MesoSetVolumeColors(colored, MesoReadVolumeFile(file, MesoSamples::Colors));
  }
  catch (const MesoInputError& failure)
  {
    throw MesoInputError(place + ": " + failure.what());
  }
  if (!problem.empty())
  {
    throw MesoInputError(place + ": " + file + ": " + problem);
  }
  return colored;
}
