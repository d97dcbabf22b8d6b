// Figures of coverage: silhouette, voids, holes, boundary, pixels that are no numbers.

#include "HandMadeAOVs.h"
#include "MesoGeometryError.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
MesoGeometryError Compare(const HandMadeAOVs& truth, const HandMadeAOVs& test)
{
  return MesoCompareGeometry(MesoAOVsOfImage(truth.Image), MesoAOVsOfImage(test.Image));
}

constexpr int Width = 30;
constexpr int Height = 20;

/// Covered in columns 5 to 24.
HandMadeAOVs Stripe(int shift = 0)
{
  HandMadeAOVs aovs(Width, Height);
  aovs.CoverOnly([shift](int column, int) { return column >= 5 + shift && column < 25 + shift; });
  return aovs;
}

MesoPixelClass ClassAt(const MesoGeometryError& error, int column, int row)
{
  return error.Classes[std::size_t(row) * Width + column];
}
}

TEST(GeometryCoverage, OfAShiftedStripe)
{
  const MesoGeometryError error = Compare(Stripe(), Stripe(2));
  EXPECT_DOUBLE_EQ(error.CoverageIou, 18. / 22.);
  EXPECT_DOUBLE_EQ(error.SilhouetteMean, 2.);
  EXPECT_DOUBLE_EQ(error.SilhouetteMaximum, 2.);
  EXPECT_EQ(error.VoidPixels, 2u * Height);
  EXPECT_EQ(error.ExtraPixels, 2u * Height);
  EXPECT_EQ(error.BothPixels, 18u * Height);
  EXPECT_EQ(error.HolePixels, 0u) << "voids at the outline are no holes";
  EXPECT_EQ(ClassAt(error, 5, 0), MesoPixelClass::Missing);
  EXPECT_EQ(ClassAt(error, 25, 0), MesoPixelClass::Extra);
  EXPECT_EQ(ClassAt(error, 0, 0), MesoPixelClass::Empty);
  EXPECT_EQ(ClassAt(error, 10, 0), MesoPixelClass::Equal);
  EXPECT_TRUE(error.Counts[25]);
  EXPECT_FALSE(error.Counts[27]);
}

TEST(GeometryCoverage, OfNothing)
{
  HandMadeAOVs none(Width, Height);
  none.CoverOnly([](int, int) { return false; });
  const MesoGeometryError error = Compare(none, none);
  EXPECT_EQ(error.CoverageIou, 1.);
  EXPECT_EQ(error.SilhouetteMean, 0.);
  EXPECT_TRUE(std::isnan(error.Depth.Rms));
  const MesoGeometryError lost = Compare(Stripe(), none);
  EXPECT_EQ(lost.CoverageIou, 0.);
  EXPECT_TRUE(std::isnan(lost.SilhouetteMean));
  EXPECT_EQ(lost.VoidPixels, 20u * Height);
}

TEST(GeometryCoverage, HolesAreVoidsAwayFromTheOutline)
{
  HandMadeAOVs test = Stripe();
  test.Uncover(15, 10); // a hole of 3 that touch at corners
  test.Uncover(16, 11);
  test.Uncover(17, 10);
  test.Uncover(12, 0); // at the picture's edge, which is no outline
  test.Uncover(6, 5);  // 1.5 pixels from the outline: no hole
  for (int column = 6; column < 12; ++column)
  {
    test.Uncover(column, 15); // reaches the outline's neighbourhood
  }
  test.Uncover(7, 18); // 2.5 pixels from it: a hole
  const MesoGeometryError error = Compare(Stripe(), test);
  EXPECT_EQ(error.HolePixels, 5u);
  EXPECT_EQ(error.VoidPixels, 12u);
  EXPECT_EQ(ClassAt(error, 16, 11), MesoPixelClass::Hole);
  EXPECT_EQ(ClassAt(error, 12, 0), MesoPixelClass::Hole);
  EXPECT_EQ(ClassAt(error, 7, 18), MesoPixelClass::Hole);
  EXPECT_EQ(ClassAt(error, 6, 5), MesoPixelClass::Missing);
  EXPECT_EQ(ClassAt(error, 11, 15), MesoPixelClass::Missing);
}

TEST(GeometryCoverage, BoundaryIsInNoOtherFigure)
{
  // The truth reaches 3 columns past its base, at other depths; the test ends with the base.
  HandMadeAOVs truth = Stripe();
  truth.AddChannel("base");
  truth.Fill("base", [](int column, int) { return column >= 5 && column < 22 ? 1.f : 0.f; });
  truth.Fill(
    "depth", [](int column, int) { return column >= 22 ? 9.f : (column >= 5 ? 5.f : 0.f); });
  HandMadeAOVs test(Width, Height);
  test.CoverOnly([](int column, int) { return column >= 5 && column < 22; });
  const MesoGeometryError error = Compare(truth, test);
  EXPECT_EQ(error.BoundaryPixels, 3u * Height);
  EXPECT_EQ(error.VoidPixels, 0u);
  EXPECT_EQ(error.CoverageIou, 1.);
  EXPECT_EQ(error.SilhouetteMaximum, 0.);
  EXPECT_EQ(error.BothPixels, 17u * Height);
  EXPECT_EQ(error.Depth.Maximum, 0.);
  EXPECT_EQ(ClassAt(error, 22, 3), MesoPixelClass::Boundary);
  EXPECT_FALSE(error.Counts[22]);

  // A test that covers them as well, wrongly, is no different.
  const MesoGeometryError covered = Compare(truth, Stripe());
  EXPECT_EQ(covered.BoundaryPixels, 3u * Height);
  EXPECT_EQ(covered.CoverageIou, 1.);
  EXPECT_EQ(covered.Depth.Maximum, 0.);
  EXPECT_EQ(covered.ExtraPixels, 0u);

  // Without the channel there is no such class.
  truth.Hide("base");
  EXPECT_EQ(Compare(truth, test).BoundaryPixels, 0u);
  EXPECT_EQ(Compare(truth, test).VoidPixels, 3u * Height);
}

TEST(GeometryCoverage, PixelsThatAreNoNumbersAreCountedAndLeftOut)
{
  HandMadeAOVs test = Stripe();
  test.At("depth", 8, 8) = std::nanf("");
  test.At("relief", 9, 8) = INFINITY; // a channel that no figure uses
  test.At("coverage", 10, 8) = std::nanf("");
  test.At("shadow.0", 0, 0) = -INFINITY; // where nothing is covered
  const MesoGeometryError error = Compare(Stripe(), test);
  EXPECT_EQ(error.NanPixels, 4u);
  EXPECT_EQ(error.VoidPixels, 1u) << "NaN covers nothing";
  EXPECT_EQ(error.Depth.Count, 20u * Height - 3);
  EXPECT_EQ(error.Depth.Maximum, 0.);
  EXPECT_EQ(error.ShadowCast, 0.);
  EXPECT_EQ(ClassAt(error, 8, 8), MesoPixelClass::NotANumber);
  EXPECT_EQ(ClassAt(error, 10, 8), MesoPixelClass::NotANumber);
  EXPECT_EQ(ClassAt(error, 0, 0), MesoPixelClass::NotANumber);
}
