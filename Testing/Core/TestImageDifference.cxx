// The comparator must be able to fail: each way in which VTK 9.1's own passes a wrong picture is
// refused here, with the default limits, and what drivers may do is let through.

#include "MesoImageDifference.h"
#include "MesoTestPicture.h"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace
{
double At(vtkImageData* image, int x, int y, int channel)
{
  const int* size = image->GetDimensions();
  return image->GetScalarComponentAsDouble(
    (x + size[0]) % size[0], (y + size[1]) % size[1], 0, channel);
}

/// The picture with a square of red pixels in the middle of the ball.
vtkSmartPointer<vtkImageData> WithSquare(vtkImageData* picture, int width)
{
  return MesoChangedPicture(picture,
    [width](vtkImageData* image, int x, int y, int c)
    {
      const bool inside = x >= 150 && x < 150 + width && y >= 150 && y < 150 + width;
      return inside ? (c == 0 ? 255. : 0.) : At(image, x, y, c);
    });
}

class ImageDifference : public testing::Test
{
protected:
  vtkSmartPointer<vtkImageData> Picture = MesoTestPicture();

  template <typename Change>
  MesoImageDifference After(Change change, const MesoImageLimits& limits = {})
  {
    return MesoCompareImages(MesoChangedPicture(this->Picture, change), this->Picture, limits);
  }
};
}

TEST_F(ImageDifference, PassesIdentical)
{
  const auto result = MesoCompareImages(MesoTestPicture(), this->Picture, MesoImageLimits::Exact());
  EXPECT_TRUE(result.Within) << result.Describe();
  EXPECT_EQ(result.SmallPixels, 0);
  EXPECT_EQ(result.Mean, 0.);
}

TEST_F(ImageDifference, FailsWhenBrighterBy4Percent)
{
  const auto result =
    this->After([](vtkImageData* i, int x, int y, int c) { return 1.04 * At(i, x, y, c); });
  EXPECT_FALSE(result.Within) << result.Describe();
}

TEST_F(ImageDifference, FailsWhenRolledByOnePixel)
{
  for (const auto& [dx, dy] : { std::pair<int, int>{ 1, 0 }, { 0, 1 }, { -1, 0 }, { 0, -1 } })
  {
    const auto result = this->After([dx = dx, dy = dy](vtkImageData* i, int x, int y, int c)
      { return At(i, x + dx, y + dy, c); });
    EXPECT_FALSE(result.Within) << dx << ", " << dy << ": " << result.Describe();
  }
}

TEST_F(ImageDifference, FailsWhenBlurred)
{
  const auto result = this->After(
    [](vtkImageData* i, int x, int y, int c)
    {
      double sum = 0.;
      for (int k = 0; k < 9; ++k)
      {
        sum += At(i, x + k % 3 - 1, y + k / 3 - 1, c);
      }
      return sum / 9.;
    });
  EXPECT_FALSE(result.Within) << result.Describe();
}

TEST_F(ImageDifference, FailsWithOneRedSquare)
{
  const auto result = MesoCompareImages(WithSquare(this->Picture, 5), this->Picture);
  EXPECT_FALSE(result.Within) << result.Describe();
  EXPECT_EQ(result.LargePixels, 25);
  EXPECT_TRUE(MesoCompareImages(WithSquare(this->Picture, 3), this->Picture).Within)
    << "9 of 90000 may differ much";
}

TEST_F(ImageDifference, FailsWithAnySingleValueChangedUnderExactLimits)
{
  const auto result = this->After([](vtkImageData* i, int x, int y, int c)
    { return At(i, x, y, c) + (x == 299 && y == 299 && c == 2 ? 1. : 0.); },
    MesoImageLimits::Exact());
  EXPECT_FALSE(result.Within);
  EXPECT_EQ(result.SmallPixels, 1);
  EXPECT_EQ(result.ChannelMaximum[2], 1);
  EXPECT_EQ(result.ChannelMaximum[0], 0);
}

TEST_F(ImageDifference, PassesWhatDriversDo)
{
  // 2 of 255 everywhere, and one pixel of a silhouette (9 of 90000 may differ much).
  const auto result = this->After(
    [](vtkImageData* i, int x, int y, int c)
    {
      const double rounding = (x + y) % 5 - 2;
      return x == 150 && y == 49 ? 255. - At(i, x, y, c) : At(i, x, y, c) + rounding;
    });
  EXPECT_TRUE(result.Within) << result.Describe();
  EXPECT_EQ(result.SmallPixels, 1);
  EXPECT_EQ(result.LargePixels, 1);
}

TEST_F(ImageDifference, CountsAgainstTheLimits)
{
  MesoImageLimits limits = { 2, 16.5 / 90000., 32, 16.5 / 90000. };
  EXPECT_TRUE(MesoCompareImages(WithSquare(this->Picture, 4), this->Picture, limits).Within);
  limits.LargeFraction = 15.5 / 90000.;
  EXPECT_FALSE(MesoCompareImages(WithSquare(this->Picture, 4), this->Picture, limits).Within);
}

TEST_F(ImageDifference, RefusesOtherShapes)
{
  const auto other = vtkSmartPointer<vtkImageData>::New();
  other->SetDimensions(300, 299, 1);
  other->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto size = MesoCompareImages(other, this->Picture);
  EXPECT_FALSE(size.Within);
  EXPECT_NE(size.Problem.find("300x299"), std::string::npos) << size.Problem;

  other->SetDimensions(300, 300, 1);
  other->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  EXPECT_FALSE(MesoCompareImages(other, this->Picture).Within);
  other->AllocateScalars(VTK_FLOAT, 3);
  EXPECT_FALSE(MesoCompareImages(other, other).Within) << "float images are not for this";
  EXPECT_FALSE(MesoCompareImages(nullptr, this->Picture).Within);
  EXPECT_FALSE(MesoCompareImages(this->Picture, nullptr).Within);
}

TEST_F(ImageDifference, ComparesFiles)
{
  const std::string folder = testing::TempDir() + "MesoImageDifference";
  const std::string a = folder + "/a.png";
  const std::string b = folder + "/b.png";
  ASSERT_TRUE(MesoWritePNG(this->Picture, a));
  ASSERT_TRUE(MesoWritePNG(WithSquare(this->Picture, 5), b));
  EXPECT_TRUE(MesoCompareImageFiles(a, a, MesoImageLimits::Exact()).Within);
  EXPECT_EQ(MesoCompareImageFiles(a, b).LargePixels, 25);
  EXPECT_TRUE(MesoCompareImages(MesoReadPNG(a), this->Picture, MesoImageLimits::Exact()).Within)
    << "a PNG does not come back as it was written";

  const std::string missing = folder + "/missing.png";
  EXPECT_NE(MesoCompareImageFiles(a, missing).Problem.find(missing), std::string::npos);
  std::ofstream(b) << "no PNG";
  EXPECT_NE(MesoCompareImageFiles(b, a).Problem.find(b), std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST_F(ImageDifference, DrawsTheDifference)
{
  const auto changed = MesoChangedPicture(this->Picture,
    [](vtkImageData* i, int x, int y, int c)
    { return At(i, x, y, c) + (x == 3 && y == 7 && c == 1 ? 5. : 0.); });
  const auto picture = MesoDifferencePicture(changed, this->Picture);
  EXPECT_EQ(At(picture, 3, 7, 1), 80.);
  EXPECT_EQ(At(picture, 3, 7, 0), 0.);
  EXPECT_EQ(At(picture, 4, 7, 1), 0.);
}
