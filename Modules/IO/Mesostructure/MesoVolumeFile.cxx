#include "MesoVolumeFile.h"

#include "MesoFileBytes.h"
#include "MesoImageFile.h"
#include "MesoMeshFormats.h" // for MesoExtensionOf
#include "MesoScene.h"       // for MesoInputError
#include "MesoVolumeFormats.h"
#include "MesoVolumeNumbers.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace
{
/// Throws where a stack of images is no volume, before memory is taken for it.
void CheckStack(
  const MesoImageHeader& header, int slices, MesoSamples samples, const std::string& fileName)
{
  const std::size_t channels = header.ChannelNames.size();
  if (samples == MesoSamples::Numbers ? channels != 1 : channels < 3)
  {
    throw MesoInputError(fileName + ": has " + std::to_string(channels) +
      (channels == 1 ? " channel" : " channels") +
      (samples == MesoSamples::Numbers ? "; a volume has one number a sample"
                                       : "; colors need three numbers a sample"));
  }
  if (slices < 2)
  {
    throw MesoInputError(
      fileName + ": holds " + std::to_string(slices) + " image; a volume has one for each slice");
  }
  if (std::max({ header.Width, header.Height, slices }) > MesoVolumeLargestSide)
  {
    throw MesoInputError(fileName + ": holds more than " + std::to_string(MesoVolumeLargestSide) +
      " samples along a side");
  }
  const std::uint64_t bytes =
    std::uint64_t(header.NumberOfValues()) * header.BytesPerValue() * std::uint64_t(slices);
  if (bytes > MesoVolumeMostBytes)
  {
    throw MesoInputError(fileName + ": takes more than 2 GiB in memory");
  }
  // What a file of that size holds at most, by the densest of TIFF's codes (LZW: 4096 bytes by 12 bits).
  constexpr std::uint64_t mostOfOne = 4096;
  if (bytes > std::filesystem::file_size(fileName) * mostOfOne)
  {
    throw MesoInputError(fileName + ": holds fewer samples than its images' sizes say");
  }
}

vtkSmartPointer<vtkImageData> ReadStack(const std::string& fileName, MesoSamples samples)
{
  MesoImageInput input(fileName);
  const MesoImageHeader& header = input.Header();
  const int slices = input.CountImages(MesoVolumeLargestSide);
  CheckStack(header, slices, samples, fileName);
  const std::size_t slice = header.NumberOfValues() * header.BytesPerValue();
  using Type = MesoImageHeader::Type;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(header.Width, header.Height, slices);
  image->AllocateScalars(header.ValueType == Type::UnsignedChar ? VTK_UNSIGNED_CHAR
      : header.ValueType == Type::UnsignedShort                 ? VTK_UNSIGNED_SHORT
                                                                : VTK_FLOAT,
    static_cast<int>(header.ChannelNames.size()));
  auto* target = static_cast<char*>(image->GetScalarPointer());
  for (int k = 0; k < slices; ++k)
  {
    input.Read(target + std::size_t(k) * slice, MesoImageInput::RowOrder::BottomFirst, k);
  }
  return image;
}

/// The threshold between two groups of numbers whose means are furthest apart, weighted by how many each
/// has: Otsu, "A threshold selection method from gray-level histograms", 1979.
double PartingOf(vtkDataArray* numbers, double least, double most)
{
  constexpr int bins = 256;
  std::array<double, bins> counts{};
  for (vtkIdType i = 0; i < numbers->GetNumberOfTuples(); ++i)
  {
    const double part = (numbers->GetComponent(i, 0) - least) / (most - least);
    if (part >= 0. && part <= 1.)
    {
      ++counts[static_cast<std::size_t>(std::min(part * bins, bins - 1.))];
    }
  }
  double all = 0.;
  double sum = 0.;
  for (int bin = 0; bin < bins; ++bin)
  {
    all += counts[bin];
    sum += bin * counts[bin];
  }
  double below = 0.;
  double sumBelow = 0.;
  double best = 0.;
  // Where nothing lies between two groups any number there parts them as well: their middle is taken.
  double first = 0.5 * bins;
  double last = first;
  for (int bin = 0; bin + 1 < bins; ++bin)
  {
    below += counts[bin];
    sumBelow += bin * counts[bin];
    if (below > 0. && below < all)
    {
      const double apart = sumBelow / below - (sum - sumBelow) / (all - below);
      const double variance = below * (all - below) * apart * apart;
      if (variance > best)
      {
        best = variance;
        first = bin + 1.;
      }
      last = variance == best ? bin + 1. : last;
    }
  }
  return least + (most - least) * 0.5 * (first + last) / bins;
}
}

const std::vector<std::string>& MesoVolumeExtensions()
{
  static const std::vector<std::string> extensions = { ".vti", ".nrrd", ".nhdr", ".mhd", ".mha",
    ".tif", ".tiff" };
  return extensions;
}

vtkSmartPointer<vtkImageData> MesoReadVolumeFile(const std::string& fileName, MesoSamples samples)
{
  const std::string extension = MesoExtensionOf(fileName);
  if (extension == ".tif" || extension == ".tiff")
  {
    return ReadStack(fileName, samples);
  }
  const auto& known = MesoVolumeExtensions();
  if (std::find(known.begin(), known.end(), extension) == known.end())
  {
    std::string names;
    for (const std::string& name : known)
    {
      names += (names.empty() ? "" : ", ") + name;
    }
    throw MesoInputError(fileName + ": is no volume: its name ends in none of " + names);
  }
  const std::string bytes = MesoReadBytes(fileName, MesoVolumeMostBytes, "a volume file");
  return extension == ".vti"                       ? MesoParseVti(bytes, fileName)
    : extension == ".nrrd" || extension == ".nhdr" ? MesoParseNrrd(bytes, fileName)
                                                   : MesoParseMetaImage(bytes, fileName);
}

MesoVolumeReport MesoReportVolume(vtkImageData* volume)
{
  MesoVolumeReport report;
  volume->GetDimensions(report.Size.data());
  volume->GetSpacing(report.Spacing.data());
  vtkDataArray* numbers = volume->GetPointData()->GetScalars();
  report.Type = numbers->GetDataTypeAsString();
  double sum = 0.;
  std::size_t finite = 0;
  double steps[2][2] = {};
  std::size_t counts[2][2] = {};
  vtkIdType place = 0;
  for (int k = 0; k < report.Size[2]; ++k)
  {
    for (int j = 0; j < report.Size[1]; ++j)
    {
      for (int i = 0; i < report.Size[0]; ++i, ++place)
      {
        const double number = numbers->GetComponent(place, 0);
        if (!std::isfinite(number))
        {
          ++report.NotFinite;
          continue;
        }
        report.Least = finite == 0 ? number : std::min(report.Least, number);
        report.Most = finite == 0 ? number : std::max(report.Most, number);
        sum += number;
        ++finite;
        const int along[2] = { i, j };
        const vtkIdType strides[2] = { 1, report.Size[0] };
        for (int axis = 0; axis < 2; ++axis)
        {
          const bool isBorder = along[axis] + 1 == report.Size[axis];
          const vtkIdType next = place + strides[axis] * (isBorder ? 1 - report.Size[axis] : 1);
          const double step = std::abs(numbers->GetComponent(next, 0) - number);
          if (report.Size[axis] > 1 && std::isfinite(step))
          {
            steps[axis][isBorder ? 1 : 0] += step;
            ++counts[axis][isBorder ? 1 : 0];
          }
        }
      }
    }
  }
  report.Mean = finite == 0 ? 0. : sum / double(finite);
  report.Parting =
    report.Least < report.Most ? PartingOf(numbers, report.Least, report.Most) : report.Most;
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto mean = [&](int part)
    { return counts[axis][part] == 0 ? 0. : steps[axis][part] / double(counts[axis][part]); };
    report.Tiling[axis].Inside = mean(0);
    report.Tiling[axis].AcrossBorder = mean(1);
  }
  return report;
}
