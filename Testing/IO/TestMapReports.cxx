// What is counted in images, and what normal maps say of the polarity of maps.

#include "MesoImageFile.h"
#include "MesoImageReport.h"
#include "MesoPolarity.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"
#include "TinyImages.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
constexpr int Size = 32;
constexpr double Turn = 2. * 3.14159265358979323846 / Size;

/// A smooth periodic height, and the direction of its normal in 8 bit.
double HeightAt(int i, int j)
{
  return std::sin(Turn * i) + std::cos(2. * Turn * j);
}

void FillMaps(vtkImageData* heights, vtkImageData* normals, double sign, bool isYUp)
{
  heights->SetDimensions(Size, Size, 1);
  heights->AllocateScalars(VTK_FLOAT, 1);
  normals->SetDimensions(Size, Size, 1);
  normals->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int j = 0; j < Size; ++j)
  {
    for (int i = 0; i < Size; ++i)
    {
      heights->SetScalarComponentFromDouble(i, j, 0, 0, sign * HeightAt(i, j));
      const double u = Turn * std::cos(Turn * i);
      const double v = -2. * Turn * std::sin(2. * Turn * j);
      const double length = std::sqrt(u * u + v * v + 1.);
      normals->SetScalarComponentFromDouble(i, j, 0, 0, 127.5 - 127.5 * u / length);
      normals->SetScalarComponentFromDouble(
        i, j, 0, 1, 127.5 - (isYUp ? 127.5 : -127.5) * v / length);
      normals->SetScalarComponentFromDouble(i, j, 0, 2, 127.5 + 127.5 / length);
    }
  }
}
}

TEST(Polarity, IsToldByTheNormalMap)
{
  using Reading = MesoPolarity::Reading;
  vtkNew<vtkImageData> heights;
  vtkNew<vtkImageData> normals;
  for (double sign : { 1., -1. })
  {
    for (bool isYUp : { true, false })
    {
      FillMaps(heights, normals, sign, isYUp);
      const MesoPolarity polarity = MesoComparePolarity(heights, normals);
      EXPECT_GT(sign * polarity.InU, 0.95);
      EXPECT_GT(sign * (isYUp ? 1. : -1.) * polarity.InV, 0.95);
      EXPECT_EQ(polarity.Says(isYUp), sign > 0. ? Reading::Height : Reading::Depth);
      EXPECT_EQ(polarity.LooksYDown(), !isYUp);
      EXPECT_EQ(MesoPolarityWarning(heights, normals, sign < 0., isYUp), "");
      EXPECT_NE(
        MesoPolarityWarning(heights, normals, sign > 0., isYUp)
          .find(sign > 0. ? "one of heights, not of depths" : "one of depths, not of heights"),
        std::string::npos);
      EXPECT_NE(MesoPolarityWarning(heights, normals, sign < 0., !isYUp)
                  .find(isYUp ? "point up, not down" : "point down, not up"),
        std::string::npos);
    }
  }
}

TEST(Polarity, SaysNothingOfMapsThatHaveNothingInCommon)
{
  vtkNew<vtkImageData> heights;
  vtkNew<vtkImageData> normals;
  FillMaps(heights, normals, 1., true);
  for (int j = 0; j < Size; ++j)
  {
    for (int i = 0; i < Size; ++i)
    {
      heights->SetScalarComponentFromDouble(i, j, 0, 0, 7.);
    }
  }
  const MesoPolarity flat = MesoComparePolarity(heights, normals);
  EXPECT_EQ(flat.InU, 0.);
  EXPECT_EQ(flat.Says(true), MesoPolarity::Reading::Unknown);
  EXPECT_EQ(MesoPolarityWarning(heights, normals, true, true), "");
  normals->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  EXPECT_EQ(MesoComparePolarity(heights, normals).InU, 0.);
}

TEST(ImageReport, CountsChannels)
{
  const TemporaryFolder folder;
  const auto indexed =
    MesoReportImage(folder.Write("a.png", TinyImages::BytesOf(TinyImages::IndexedPng)));
  EXPECT_EQ(indexed.Format, "png");
  EXPECT_EQ(indexed.StoredType, "uint8");
  ASSERT_EQ(indexed.Channels.size(), 3u);
  EXPECT_EQ(indexed.Channels[1].Name, "G");
  EXPECT_EQ(indexed.Channels[1].Least, 20.);
  EXPECT_EQ(indexed.Channels[1].Most, 80.);
  EXPECT_EQ(indexed.Channels[1].Mean, 50.);
  EXPECT_FALSE(indexed.HasColorProfile);

  const auto half =
    MesoReportImage(folder.Write("a.exr", TinyImages::BytesOf(TinyImages::HalfTwoPartExr)));
  EXPECT_EQ(half.StoredType, "half");
  EXPECT_EQ(half.Channels[0].Least, -2.);
  EXPECT_EQ(half.Notes.size(), 1u) << "several images";
}

TEST(ImageReport, CountsNumbersThatAreNone)
{
  const TemporaryFolder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float values[6] = { 1.f, nan, 2.f, 3.f, std::numeric_limits<float>::infinity(), 6.f };
  const std::string name = folder.PathOf("n.exr");
  MesoWriteImage(name, 3, 2, 1, MesoImageHeader::Type::Float, values);
  const auto report = MesoReportImage(name);
  EXPECT_EQ(report.Channels[0].NotFinite, 2u);
  EXPECT_EQ(report.Channels[0].Least, 1.);
  EXPECT_EQ(report.Channels[0].Most, 6.);
  EXPECT_EQ(report.Channels[0].Mean, 3.);
}

TEST(ImageReport, TellsWhetherAnImageTiles)
{
  const TemporaryFolder folder;
  std::vector<float> waves;
  std::vector<float> ramp;
  for (int j = 0; j < Size; ++j)
  {
    for (int i = 0; i < Size; ++i)
    {
      waves.push_back(float(HeightAt(i, j)));
      ramp.push_back(float(i) / Size);
    }
  }
  const std::string name = folder.PathOf("t.exr");
  MesoWriteImage(name, Size, Size, 1, MesoImageHeader::Type::Float, waves.data());
  const auto periodic = MesoReportImage(name);
  EXPECT_STREQ(periodic.Tiling[0].Verdict(), "yes");
  EXPECT_STREQ(periodic.Tiling[1].Verdict(), "yes");
  EXPECT_GT(periodic.Tiling[0].Ratio(), 0.5);
  MesoWriteImage(name, Size, Size, 1, MesoImageHeader::Type::Float, ramp.data());
  const auto rising = MesoReportImage(name);
  EXPECT_STREQ(rising.Tiling[0].Verdict(), "no");
  EXPECT_NEAR(rising.Tiling[0].Ratio(), Size - 1., 1e-3);
  EXPECT_EQ(rising.Tiling[1].Ratio(), 0.);
}
