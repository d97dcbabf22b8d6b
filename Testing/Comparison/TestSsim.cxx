// SSIM and RMSE against numbers computed with NumPy and SciPy (correlate1d of a window of 11 weights).

#include "MesoPictureError.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoSsim.h"
#include "PairsOfPictures.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

TEST(Ssim, EqualsAnIndependentComputation)
{
  const MesoPicture a = PairsOfPictures::Smooth(0, 128);
  const MesoPicture b = PairsOfPictures::Smooth(2, 140);
  const auto index = MesoSsim(a, b);
  EXPECT_NEAR(MesoComparePictures(a, b).Ssim, 0.928908076, 1e-6);
  EXPECT_NEAR(index[PairsOfPictures::At(0, 0)], 0.987743466, 1e-6);
  EXPECT_NEAR(index[PairsOfPictures::At(16, 12)], 0.970150948, 1e-6);
  const MesoPicture c = PairsOfPictures::Noisy(1);
  const MesoPicture d = PairsOfPictures::Noisy(2);
  EXPECT_NEAR(MesoComparePictures(c, d).Ssim, -0.008692213, 1e-6);
  EXPECT_NEAR(MesoSsim(c, d)[PairsOfPictures::At(0, 0)], -0.001027134, 1e-6);
  EXPECT_NEAR(MesoSsim(c, d)[PairsOfPictures::At(16, 12)], 0.098461820, 1e-6);
}

TEST(Ssim, OfConstantsIsTheTermOfMeans)
{
  // (2 a b + C1) / (a a + b b + C1) with a = 0, b = 1.
  for (const float index :
    MesoSsim(PairsOfPictures::Constant(0, 0, 0), PairsOfPictures::Constant(255, 255, 255)))
  {
    ASSERT_NEAR(index, 1e-4 / 1.0001, 1e-8);
  }
}

TEST(Ssim, OfEqualPicturesIsOne)
{
  const MesoPicture picture = PairsOfPictures::Noisy(7);
  for (const float index : MesoSsim(picture, picture))
  {
    ASSERT_NEAR(index, 1.f, 1e-6f);
  }
}

TEST(Ssim, RefusesDifferentSizes)
{
  MesoPicture small = PairsOfPictures::Constant(0, 0, 0);
  small.Width = 16;
  small.Height = 48;
  EXPECT_THROW(MesoSsim(PairsOfPictures::Constant(0, 0, 0), small), MesoInputError);
}

TEST(Rmse, IsOfLinearColour)
{
  EXPECT_NEAR(
    MesoComparePictures(PairsOfPictures::Smooth(0, 128), PairsOfPictures::Smooth(2, 140)).Rmse,
    0.070375627, 1e-7);
  // 188 is the sRGB code of nearly half the light.
  EXPECT_NEAR(MesoComparePictures(
                PairsOfPictures::Constant(0, 0, 0), PairsOfPictures::Constant(188, 188, 188))
                .Rmse,
    0.5029, 1e-4);
  // One channel of three: sqrt(1 / 3).
  EXPECT_NEAR(
    MesoComparePictures(PairsOfPictures::Constant(0, 0, 0), PairsOfPictures::Constant(0, 255, 0))
      .Rmse,
    std::sqrt(1. / 3.), 1e-7);
}

TEST(PictureError, TakesOnlyPixelsThatCount)
{
  const MesoPicture truth = PairsOfPictures::Constant(50, 60, 70);
  MesoPicture test = truth;
  std::fill_n(test.Rgb.begin() + std::ptrdiff_t(3 * PairsOfPictures::At(16, 12)), 3, 1.f);
  std::vector<bool> counts(truth.NumberOfPixels(), false);
  counts[PairsOfPictures::At(0, 0)] = true; // out of reach of both windows
  const MesoPictureError away = MesoComparePictures(truth, test, counts);
  EXPECT_EQ(away.FlipMean, 0.);
  EXPECT_NEAR(away.Ssim, 1., 1e-6);
  EXPECT_EQ(away.Rmse, 0.);
  counts[PairsOfPictures::At(16, 12)] = true;
  const MesoPictureError both = MesoComparePictures(truth, test, counts);
  EXPECT_NEAR(both.FlipMean, 0.5 * both.FlipMap[PairsOfPictures::At(16, 12)], 1e-7);
  double squares = 0.;
  for (const int code : { 50, 60, 70 })
  {
    squares += std::pow(1. - MesoLinearOfSRGB(code / 255.), 2);
  }
  EXPECT_NEAR(both.Rmse, std::sqrt(squares / 6.), 1e-7);
}

TEST(PictureError, OfNoPixelsIsNotKnown)
{
  const MesoPicture picture = PairsOfPictures::Noisy(8);
  const MesoPictureError error =
    MesoComparePictures(picture, picture, std::vector<bool>(picture.NumberOfPixels(), false));
  EXPECT_TRUE(std::isnan(error.FlipMean));
  EXPECT_TRUE(std::isnan(error.Ssim));
  EXPECT_TRUE(std::isnan(error.Rmse));
  EXPECT_THROW(MesoComparePictures(picture, picture, { true }), MesoInputError);
}
