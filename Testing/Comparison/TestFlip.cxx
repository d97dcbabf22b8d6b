// FLIP against the authors' own program, a computation by hand, and properties that it must have.

#include "MesoFlip.h"
#include "MesoScene.h" // for MesoInputError
#include "PairsOfPictures.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

namespace
{
double Mean(const std::vector<float>& values)
{
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}
}

// The numbers are those of the Python package flip-evaluator 1.7 (NVlabs) at 67 pixels per degree. It
// computes in float and with rounded matrices, which moves a value by up to 3e-5.
TEST(Flip, EqualsTheAuthorsProgram)
{
  const auto smooth = MesoFlip(PairsOfPictures::Smooth(0, 128), PairsOfPictures::Smooth(2, 140));
  EXPECT_NEAR(Mean(smooth), 0.2009295, 5e-5);
  EXPECT_NEAR(smooth[PairsOfPictures::At(0, 0)], 0.1570073, 5e-5);
  EXPECT_NEAR(smooth[PairsOfPictures::At(16, 12)], 0.1786907, 5e-5);
  EXPECT_NEAR(smooth[PairsOfPictures::At(23, 5)], 0.1265826, 5e-5);
  const auto noisy = MesoFlip(PairsOfPictures::Noisy(1), PairsOfPictures::Noisy(2));
  EXPECT_NEAR(Mean(noisy), 0.4631650, 5e-5);
  EXPECT_NEAR(noisy[PairsOfPictures::At(0, 0)], 0.5154648, 5e-5);
  EXPECT_NEAR(noisy[PairsOfPictures::At(16, 12)], 0.3123660, 5e-5);
  EXPECT_NEAR(noisy[PairsOfPictures::At(23, 5)], 0.3554960, 5e-5);
}

// Where colours are constant, no blur and no feature plays a part: the numbers are the paper's
// formulas in double precision, computed with NumPy.
TEST(Flip, OfConstantColoursIsTheColourErrorAlone)
{
  struct
  {
    int Truth[3];
    int Test[3];
    double Error;
  } const pairs[] = {
    { { 0, 0, 0 }, { 255, 255, 255 }, 0.967379761 },
    { { 0, 255, 0 }, { 0, 0, 255 }, 1. }, // the largest distance of all colours
    { { 100, 100, 100 }, { 110, 110, 110 }, 0.153460569 },
    { { 200, 30, 30 }, { 30, 30, 200 }, 0.952009385 },
    { { 10, 10, 10 }, { 20, 10, 10 }, 0.052920381 },
  };
  for (const auto& pair : pairs)
  {
    const auto errors =
      MesoFlip(PairsOfPictures::Constant(pair.Truth[0], pair.Truth[1], pair.Truth[2]),
        PairsOfPictures::Constant(pair.Test[0], pair.Test[1], pair.Test[2]));
    for (const float error : errors)
    {
      ASSERT_NEAR(error, pair.Error, 1e-6) << "red " << pair.Truth[0] << ", " << pair.Test[0];
    }
  }
}

TEST(Flip, OfEqualPicturesIsZero)
{
  for (const auto& picture : { PairsOfPictures::Noisy(3), PairsOfPictures::Smooth(1, 90) })
  {
    for (const float error : MesoFlip(picture, picture))
    {
      ASSERT_EQ(error, 0.f);
    }
  }
}

TEST(Flip, DoesNotChangeWhenPicturesChangePlaces)
{
  const MesoPicture a = PairsOfPictures::Noisy(4);
  const MesoPicture b = PairsOfPictures::Smooth(0, 10);
  EXPECT_EQ(MesoFlip(a, b), MesoFlip(b, a));
}

TEST(Flip, LiesBetweenZeroAndOne)
{
  // Stripes of the farthest colours, turned round: largest errors of colour and of features.
  const auto stripes = [](int turn)
  {
    return PairsOfPictures::Of([turn](int x, int, int channel)
      { return channel == ((x + turn) % 2 == 0 ? 1 : 2) ? 255 : 0; });
  };
  for (const double pixelsPerDegree : { 5., 67., 1000. })
  {
    for (const float error : MesoFlip(stripes(0), stripes(1), pixelsPerDegree))
    {
      ASSERT_GE(error, 0.f);
      ASSERT_LE(error, 1.f);
    }
  }
}

TEST(Flip, GrowsWithTheDifference)
{
  double before = 0.;
  for (int step = 1; step <= 8; ++step)
  {
    const double mean =
      Mean(MesoFlip(PairsOfPictures::Smooth(0, 100), PairsOfPictures::Smooth(0, 100 + 12 * step)));
    EXPECT_GT(mean, before) << step;
    before = mean;
  }
}

TEST(Flip, SeesLessFromAfar)
{
  const MesoPicture a = PairsOfPictures::Noisy(5);
  const MesoPicture b = PairsOfPictures::Noisy(6);
  EXPECT_GT(Mean(MesoFlip(a, b, 20.)), 1.1 * Mean(MesoFlip(a, b, 67.)));
}

TEST(Flip, OfASinglePixelIsFeltNearIt)
{
  const MesoPicture grey = PairsOfPictures::Constant(90, 90, 90);
  MesoPicture dotted = grey;
  std::fill_n(dotted.Rgb.begin() + std::ptrdiff_t(3 * PairsOfPictures::At(4, 20)), 3, 1.f);
  const auto errors = MesoFlip(grey, dotted);
  EXPECT_EQ(std::max_element(errors.begin(), errors.end()) - errors.begin(),
    std::ptrdiff_t(PairsOfPictures::At(4, 20)));
  EXPECT_EQ(errors[PairsOfPictures::At(31, 3)], 0.f);
}

TEST(Flip, RefusesDifferentSizes)
{
  MesoPicture small = PairsOfPictures::Constant(0, 0, 0);
  small.Width = 16;
  small.Height = 48; // as many pixels
  EXPECT_THROW(MesoFlip(PairsOfPictures::Constant(0, 0, 0), small), MesoInputError);
  EXPECT_THROW(MesoFlip(small, small, 0.), MesoInputError);
}
