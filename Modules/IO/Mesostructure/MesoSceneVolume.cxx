#include "MesoSceneVolume.h"

#include "MesoSceneParameters.h"
#include "MesoVolumePattern.h"

namespace
{
void ReadSize(const MesoSceneValue& value, MesoSceneVolume& volume)
{
  value.With("size",
    [&](const MesoSceneValue& size)
    {
      const MesoSceneRange voxels = { 2., MesoVolumeMaximumSize, true };
      volume.Size.emplace();
      const auto list = size.ToList(volume.Size->size());
      for (std::size_t axis = 0; axis < volume.Size->size(); ++axis)
      {
        (*volume.Size)[axis] = static_cast<int>(list[axis].ToInteger(voxels));
      }
    });
}

void ReadPart(const MesoSceneValue& value, const char* key, MesoSceneVolume& volume)
{
  value.With(key,
    [&](const MesoSceneValue& part)
    {
      volume.Crop = part.ToNumbers<6>();
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        if (!((*volume.Crop)[2 * axis] < (*volume.Crop)[2 * axis + 1]))
        {
          part.Fail(
            "is [x0, x1, y0, y1, z0, z1], of each two numbers the first less than the second");
        }
      }
    });
}

MesoSceneVolume ReadMeshTile(const MesoSceneValue& value)
{
  MesoSceneVolume volume;
  volume.IsMesh = true;
  if (value.IsString())
  {
    volume.File = value.ToFileName();
    return volume;
  }
  MesoCheckNamesKind(value, "file");
  value.CheckKeys("mesh_tile");
  volume.File = value.At("file").ToFileName();
  ReadPart(value, "box", volume);
  ReadSize(value, volume);
  return volume;
}

MesoSceneVolume ReadVolume(const MesoSceneValue& value)
{
  MesoSceneVolume volume;
  if (value.IsString())
  {
    volume.File = value.ToFileName();
    return volume;
  }
  if (!value.Has("file") && !value.Has("pattern"))
  {
    value.Fail("must be a file name, or an object with the key file or pattern");
  }
  if (value.Has("file"))
  {
    value.CheckKeys("volume_file");
    volume.File = value.At("file").ToFileName();
    value.With(
      "threshold", [&](const MesoSceneValue& number) { volume.Threshold = number.ToNumber(); });
    value.With("solid",
      [&](const MesoSceneValue& side)
      {
        volume.SolidBelow =
          MesoReadName(side, "side of the threshold", { "above", "below" }, {}) == "below";
      });
    ReadPart(value, "crop", volume);
    value.With("blend",
      [&](const MesoSceneValue& part) {
        volume.Blend = part.ToNumber({ 0., 0.5, true });
      });
    ReadSize(value, volume);
    return volume;
  }
  volume.Pattern =
    MesoReadName(value.At("pattern"), "volume pattern", MesoVolumePatternNames(), {});
  value.CheckKeys("volume_" + volume.Pattern);
  ReadSize(value, volume);
  MesoReadPatternValues(
    value, MesoVolumePatternParameters(volume.Pattern), volume.Seed, volume.Parameters);
  const std::string problem = MesoVolumePatternProblem(volume.Pattern, volume.Parameters);
  if (!problem.empty())
  {
    value.Fail(problem);
  }
  return volume;
}
}

std::optional<MesoSceneVolume> MesoReadSceneVolume(const MesoSceneValue& mesostructure)
{
  std::optional<MesoSceneVolume> volume;
  mesostructure.With("volume",
    [&](const MesoSceneValue& value)
    {
      mesostructure.Refuse({ "tile_mesh", "height_map", "depth_map", "relief_map" },
        "there is a volume already; only one of them is taken");
      volume = ReadVolume(value);
    });
  mesostructure.With("tile_mesh",
    [&](const MesoSceneValue& value)
    {
      mesostructure.Refuse({ "height_map", "depth_map", "relief_map" },
        "there is a tile_mesh already; only one of them is taken");
      volume = ReadMeshTile(value);
    });
  return volume;
}
