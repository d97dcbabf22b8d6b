#include "InfoVolume.h"

#include "MesoFileBytes.h"
#include "MesoImageFile.h"
#include "MesoMeshFormats.h"
#include "MesoVolume.h"
#include "MesoVolumeFile.h"
#include "vtkImageData.h"

#include <algorithm>

namespace
{
/// What a baked file says of itself near its beginning or its end is in its text.
bool IsBaked(const std::string& fileName)
{
  constexpr std::uintmax_t most = std::uintmax_t(2) << 30;
  return MesoReadBytes(fileName, most, "a VTK file").find("meso.kind") != std::string::npos;
}
}

nlohmann::ordered_json JsonOfTiling(const MesoTilingReport& tiling)
{
  nlohmann::ordered_json json;
  json["tiles"] = tiling.Verdict();
  json["step_across_border"] = tiling.AcrossBorder;
  json["step_inside"] = tiling.Inside;
  return json;
}

bool IsVolume(const std::string& fileName)
{
  const std::string extension = MesoExtensionOf(fileName);
  if (extension == ".vti")
  {
    return !IsBaked(fileName);
  }
  if (extension == ".tif" || extension == ".tiff")
  {
    return MesoImageInput(fileName).CountImages(1) > 1;
  }
  const auto& volumes = MesoVolumeExtensions();
  return std::find(volumes.begin(), volumes.end(), extension) != volumes.end();
}

nlohmann::ordered_json JsonOfVolume(const std::string& fileName)
{
  const auto volume = MesoReadVolumeFile(fileName);
  const MesoVolumeReport report = MesoReportVolume(volume);
  nlohmann::ordered_json json;
  json["file"] = fileName;
  json["kind"] = "volume";
  json["size"] = report.Size;
  json["spacing"] = report.Spacing;
  json["values"] = report.Type;
  json["least"] = report.Least;
  json["most"] = report.Most;
  json["mean"] = report.Mean;
  json["not_finite"] = report.NotFinite;
  json["threshold_that_parts_best"] = report.Parting;
  json["over_the_border_in_x"] = JsonOfTiling(report.Tiling[0]);
  json["over_the_border_in_y"] = JsonOfTiling(report.Tiling[1]);
  json["depth_in_tile_widths"] =
    report.Spacing[2] * report.Size[2] / (report.Spacing[0] * report.Size[0]);
  json["canonical"] = MesoVolumeProblem(volume).empty();
  json["warnings"] = nlohmann::ordered_json::array();
  if (report.NotFinite > 0)
  {
    json["warnings"].push_back(std::to_string(report.NotFinite) +
      " numbers are not finite: as a volume of a scene the file is refused");
  }
  return json;
}
