// Stored numbers to heights: ranges, polarity, precision, clamping, and what is noted or refused.

#include "MesoHeightMap.h"
#include "MesoScene.h" // for MesoInputError

#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
template <typename T>
vtkSmartPointer<vtkImageData> MakeMap(int type, int components, const std::vector<T>& values)
{
  auto map = vtkSmartPointer<vtkImageData>::New();
  map->SetDimensions(int(values.size()) / components, 1, 1);
  map->SetSpacing(0.5, 0.25, 1.);
  map->AllocateScalars(type, components);
  std::copy(values.begin(), values.end(), static_cast<T*>(map->GetScalarPointer()));
  return map;
}

using Bytes = std::vector<unsigned char>;
using Shorts = std::vector<unsigned short>;
using Floats = std::vector<float>;

float HeightAt(const MesoHeights& heights, int column)
{
  return *static_cast<float*>(heights.Image->GetScalarPointer(column, 0, 0));
}

std::string MessageOf(
  vtkImageData* map, const std::optional<std::array<double, 2>>& range = std::nullopt)
{
  try
  {
    MesoToHeights(map, false, range);
  }
  catch (const MesoInputError& error)
  {
    return error.what();
  }
  return "taken without an error";
}
}

TEST(HeightMap, DefaultRangesByType)
{
  const auto bytes =
    MesoToHeights(MakeMap<unsigned char>(VTK_UNSIGNED_CHAR, 1, Bytes{ 0, 51, 255 }), false);
  EXPECT_EQ(HeightAt(bytes, 0), 0.f);
  EXPECT_EQ(HeightAt(bytes, 1), float(51. / 255.));
  EXPECT_EQ(HeightAt(bytes, 2), 1.f);
  const auto shorts = MesoToHeights(
    MakeMap<unsigned short>(VTK_UNSIGNED_SHORT, 1, Shorts{ 0, 1, 65534, 65535 }), false);
  EXPECT_EQ(HeightAt(shorts, 1), float(1. / 65535.));
  EXPECT_EQ(HeightAt(shorts, 2), float(65534. / 65535.));
  EXPECT_EQ(HeightAt(shorts, 3), 1.f);
  const auto floats = MesoToHeights(MakeMap<float>(VTK_FLOAT, 1, Floats{ 0.f, 0.1f, 1.f }), false);
  EXPECT_EQ(HeightAt(floats, 1), 0.1f);
  for (const auto& heights : { bytes, shorts, floats })
  {
    EXPECT_EQ(heights.NumberOfClamped, 0);
    EXPECT_TRUE(heights.Warnings.empty());
    EXPECT_EQ(heights.Image->GetScalarType(), VTK_FLOAT);
    EXPECT_EQ(heights.Image->GetNumberOfScalarComponents(), 1);
    EXPECT_EQ(heights.Image->GetSpacing()[1], 0.25);
  }
}

TEST(HeightMap, DepthIsTurnedOver)
{
  const auto map = MakeMap<unsigned char>(VTK_UNSIGNED_CHAR, 1, Bytes{ 0, 51, 255 });
  const auto depth = MesoToHeights(map, true);
  EXPECT_EQ(HeightAt(depth, 0), 1.f) << "an all-0 depth map is the base surface, exactly";
  EXPECT_EQ(HeightAt(depth, 1), float(1. - 51. / 255.));
  EXPECT_EQ(HeightAt(depth, 2), 0.f);
}

TEST(HeightMap, RangeIsInStoredNumbersAndClampingIsCounted)
{
  // Metres of a terrain, as 16 bit numbers and as floats.
  const std::array<double, 2> range = { 236., 1076. };
  const auto shorts = MesoToHeights(
    MakeMap<unsigned short>(VTK_UNSIGNED_SHORT, 1, Shorts{ 236, 656, 1076, 200, 2000 }), false,
    range);
  EXPECT_EQ(HeightAt(shorts, 0), 0.f);
  EXPECT_EQ(HeightAt(shorts, 1), 0.5f);
  EXPECT_EQ(HeightAt(shorts, 2), 1.f);
  EXPECT_EQ(HeightAt(shorts, 3), 0.f);
  EXPECT_EQ(HeightAt(shorts, 4), 1.f);
  EXPECT_EQ(shorts.NumberOfClamped, 2);
  EXPECT_EQ(shorts.Warnings,
    (std::vector<std::string>{ "2 of 5 values lie outside the range [236, "
                               "1076] and are set to its ends" }));
  const auto floats = MesoToHeights(MakeMap<float>(VTK_FLOAT, 1, Floats{ -646.f, 564.f }), true,
    std::array<double, 2>{ -646., 564. });
  EXPECT_EQ(HeightAt(floats, 0), 1.f);
  EXPECT_EQ(HeightAt(floats, 1), 0.f);
  EXPECT_EQ(MesoToHeights(MakeMap<float>(VTK_FLOAT, 1, Floats{ 300.f }), false).NumberOfClamped, 1);
}

TEST(HeightMap, ColorChannelsAndAlpha)
{
  const auto grey =
    MesoToHeights(MakeMap<unsigned char>(VTK_UNSIGNED_CHAR, 3, Bytes{ 100, 108, 92 }), false);
  EXPECT_EQ(HeightAt(grey, 0), float(100. / 255.));
  EXPECT_TRUE(grey.Warnings.empty());
  const auto color =
    MesoToHeights(MakeMap<unsigned char>(VTK_UNSIGNED_CHAR, 3, Bytes{ 100, 100, 109 }), false);
  EXPECT_EQ(HeightAt(color, 0), float(100. / 255.));
  ASSERT_EQ(color.Warnings.size(), 1u);
  EXPECT_NE(color.Warnings[0].find("is not grey"), std::string::npos);
  const auto opaque =
    MesoToHeights(MakeMap<unsigned char>(VTK_UNSIGNED_CHAR, 4, Bytes{ 9, 9, 9, 255 }), false);
  EXPECT_TRUE(opaque.Warnings.empty());
  const auto veiled =
    MesoToHeights(MakeMap<unsigned char>(VTK_UNSIGNED_CHAR, 2, Bytes{ 9, 200 }), false);
  ASSERT_EQ(veiled.Warnings.size(), 1u);
  EXPECT_NE(veiled.Warnings[0].find("alpha"), std::string::npos);
}

TEST(HeightMap, Refusals)
{
  const auto map = MakeMap<float>(VTK_FLOAT, 1, Floats{ 0.f, 1.f });
  EXPECT_EQ(MessageOf(map, std::array<double, 2>{ 1., 1. }), "the range [1, 1] does not rise");
  EXPECT_EQ(MessageOf(map, std::array<double, 2>{ 2., 1. }), "the range [2, 1] does not rise");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(MessageOf(map, std::array<double, 2>{ 0., nan }), "the range [0, nan] does not rise");
  EXPECT_EQ(MessageOf(MakeMap<float>(VTK_FLOAT, 1, Floats{ 0.f, float(nan) })),
    "1 values of the map are not finite");
  EXPECT_EQ(MessageOf(nullptr), "the map has no pixels");
  vtkNew<vtkImageData> empty;
  EXPECT_EQ(MessageOf(empty), "the map has no pixels");
  vtkNew<vtkImageData> volume;
  volume->SetDimensions(2, 2, 2);
  volume->AllocateScalars(VTK_FLOAT, 1);
  EXPECT_EQ(MessageOf(volume), "the map is a volume, not an image");
  vtkNew<vtkImageData> integers;
  integers->SetDimensions(2, 2, 1);
  integers->AllocateScalars(VTK_INT, 1);
  EXPECT_NE(MessageOf(integers).find("values of type int"), std::string::npos);
}
