#include "MesoImageError.h"

#include "MesoScene.h" // for MesoInputError

namespace
{
void CheckSize(const std::string& name, int width, int height, const std::string& otherName,
  int otherWidth, int otherHeight)
{
  if (width != otherWidth || height != otherHeight)
  {
    throw MesoInputError(name + ": the size is " + std::to_string(width) + "x" +
      std::to_string(height) + ", that of " + otherName + " " + std::to_string(otherWidth) + "x" +
      std::to_string(otherHeight));
  }
}
}

MesoImageError MesoCompareRenderings(const MesoRendering& truth, const MesoRendering& test)
{
  MesoImageError error;
  if (truth.AOVs && test.AOVs)
  {
    MesoCheckComparable(*truth.AOVs, truth.Name, *test.AOVs, test.Name);
    error.Width = truth.AOVs->Width;
    error.Height = truth.AOVs->Height;
    error.Geometry = MesoCompareGeometry(*truth.AOVs, *test.AOVs);
  }
  if (truth.Picture && test.Picture)
  {
    const int width = error.Width = truth.Picture->Width;
    const int height = error.Height = truth.Picture->Height;
    CheckSize(test.Name, test.Picture->Width, test.Picture->Height, truth.Name, width, height);
    if (error.Geometry)
    {
      CheckSize("the AOVs of " + truth.Name, truth.AOVs->Width, truth.AOVs->Height, "its picture",
        width, height);
    }
    error.Picture = MesoComparePictures(
      *truth.Picture, *test.Picture, error.Geometry ? error.Geometry->Counts : std::vector<bool>());
  }
  if (!error.Geometry && !error.Picture)
  {
    throw MesoInputError(truth.Name + " and " + test.Name + " have nothing that can be compared");
  }
  return error;
}

std::vector<MesoFigure> MesoFiguresOfError(const MesoImageError& error)
{
  const MesoGeometryError geometry = error.Geometry.value_or(MesoGeometryError());
  const MesoPictureError picture = error.Picture.value_or(MesoPictureError());
  const std::string depthUnit = geometry.DepthInScale ? "D" : "world unit";
  const auto count = [&](std::size_t pixels)
  { return error.Geometry ? double(pixels) : MesoGeometryError::NotKnown; };
  return {
    { "coverage_iou", "1", geometry.CoverageIou },
    { "silhouette_px_mean", "pixel", geometry.SilhouetteMean },
    { "silhouette_px_max", "pixel", geometry.SilhouetteMaximum },
    { "depth_rms", depthUnit, geometry.Depth.Rms },
    { "depth_p95", depthUnit, geometry.Depth.P95 },
    { "depth_max", depthUnit, geometry.Depth.Maximum },
    { "texcoord_p50", "texel", geometry.Texcoord.P50 },
    { "texcoord_p95", "texel", geometry.Texcoord.P95 },
    { "texcoord_p99", "texel", geometry.Texcoord.P99 },
    { "texcoord_max", "texel", geometry.Texcoord.Maximum },
    { "normal_mean", "degree", geometry.Normal.Mean },
    { "normal_p95", "degree", geometry.Normal.P95 },
    { "shadow_attached", "1", geometry.ShadowAttached },
    { "shadow_cast", "1", geometry.ShadowCast },
    { "nan_pixels", "pixels", count(geometry.NanPixels) },
    { "void_pixels", "pixels", count(geometry.VoidPixels) },
    { "extra_pixels", "pixels", count(geometry.ExtraPixels) },
    { "hole_pixels", "pixels", count(geometry.HolePixels) },
    { "boundary_pixels", "pixels", count(geometry.BoundaryPixels) },
    { "other_object_pixels", "pixels", count(geometry.OtherObjectPixels) },
    { "both_pixels", "pixels", count(geometry.BothPixels) },
    { "flip_mean", "1", picture.FlipMean },
    { "ssim", "1", picture.Ssim },
    { "rmse", "1", picture.Rmse },
  };
}
