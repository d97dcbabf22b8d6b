#include "MesoHeightMap.h"

#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double LargestGreyDifference = 8. / 255.; // what JPEG does to the channels of a grey map

struct Conversion
{
  const void* Values;
  int Components;
  vtkIdType Count;
  std::array<double, 2> Range;
  double TypeRange; ///< from black to white where no range is given
  bool IsDepth;
  float* Heights;
};

/// Counts of what was met, for the warnings.
struct Findings
{
  vtkIdType NotFinite = 0;
  vtkIdType Clamped = 0;
  double ChannelDifference = 0.;
  bool HasAlpha = false; ///< that is not opaque everywhere
};

template <typename T>
Findings Convert(const Conversion& work)
{
  Findings findings;
  const T* pixel = static_cast<const T*>(work.Values);
  const double low = work.Range[0];
  const double span = work.Range[1] - work.Range[0];
  const int colors = work.Components < 3 ? 1 : 3;
  const int alpha = work.Components == 2 ? 1 : work.Components == 4 ? 3 : -1;
  for (vtkIdType i = 0; i < work.Count; ++i, pixel += work.Components)
  {
    const double stored = static_cast<double>(pixel[0]);
    findings.NotFinite += std::isfinite(stored) ? 0 : 1;
    for (int k = 1; k < colors; ++k)
    {
      findings.ChannelDifference =
        std::max(findings.ChannelDifference, std::abs(static_cast<double>(pixel[k]) - stored));
    }
    findings.HasAlpha |= alpha >= 0 && static_cast<double>(pixel[alpha]) != work.TypeRange;
    const double value = (stored - low) / span;
    findings.Clamped += value < 0. || value > 1. ? 1 : 0;
    const double clamped = std::min(std::max(value, 0.), 1.);
    work.Heights[i] = static_cast<float>(work.IsDepth ? 1. - clamped : clamped);
  }
  return findings;
}

std::string RangeText(const std::array<double, 2>& range)
{
  return "[" + MesoNumberText(range[0]) + ", " + MesoNumberText(range[1]) + "]";
}
}

MesoHeights MesoToHeights(
  vtkImageData* map, bool isDepth, const std::optional<std::array<double, 2>>& range)
{
  int size[3] = { 0, 0, 0 };
  if (map)
  {
    map->GetDimensions(size);
  }
  if (!map || size[0] < 1 || size[1] < 1 || size[2] < 1 || !map->GetScalarPointer())
  {
    throw MesoInputError("the map has no pixels");
  }
  if (size[2] != 1)
  {
    throw MesoInputError("the map is a volume, not an image");
  }
  const int type = map->GetScalarType();
  if (type != VTK_UNSIGNED_CHAR && type != VTK_UNSIGNED_SHORT && type != VTK_FLOAT)
  {
    throw MesoInputError(std::string("the map has values of type ") + map->GetScalarTypeAsString() +
      "; unsigned char, unsigned short and float are taken");
  }
  Conversion work;
  work.TypeRange = type == VTK_UNSIGNED_CHAR ? 255. : type == VTK_UNSIGNED_SHORT ? 65535. : 1.;
  work.Range = range.value_or(std::array<double, 2>{ 0., work.TypeRange });
  if (!(work.Range[0] < work.Range[1]) || !std::isfinite(work.Range[1] - work.Range[0]))
  {
    throw MesoInputError("the range " + RangeText(work.Range) + " does not rise");
  }

  MesoHeights heights;
  heights.Image = vtkSmartPointer<vtkImageData>::New();
  heights.Image->SetDimensions(size);
  heights.Image->SetSpacing(map->GetSpacing());
  heights.Image->SetOrigin(map->GetOrigin());
  heights.Image->AllocateScalars(VTK_FLOAT, 1);
  heights.Numbers = { work.Range[isDepth ? 1 : 0], work.Range[isDepth ? 0 : 1] };
  work.Values = map->GetScalarPointer();
  work.Components = map->GetNumberOfScalarComponents();
  work.Count = static_cast<vtkIdType>(size[0]) * size[1];
  work.IsDepth = isDepth;
  work.Heights = static_cast<float*>(heights.Image->GetScalarPointer());
  const Findings findings = type == VTK_UNSIGNED_CHAR ? Convert<unsigned char>(work)
    : type == VTK_UNSIGNED_SHORT                      ? Convert<unsigned short>(work)
                                                      : Convert<float>(work);
  if (findings.NotFinite > 0)
  {
    throw MesoInputError(std::to_string(findings.NotFinite) + " values of the map are not finite");
  }
  heights.NumberOfClamped = findings.Clamped;
  if (findings.Clamped > 0)
  {
    heights.Warnings.push_back(std::to_string(findings.Clamped) + " of " +
      std::to_string(work.Count) + " values lie outside the range " + RangeText(work.Range) +
      " and are set to its ends");
  }
  if (findings.ChannelDifference > LargestGreyDifference * work.TypeRange)
  {
    heights.Warnings.emplace_back("the map is not grey; its first channel is taken");
  }
  if (findings.HasAlpha)
  {
    heights.Warnings.emplace_back("the map's alpha channel is not used");
  }
  return heights;
}
