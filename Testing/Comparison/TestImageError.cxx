// Pictures and AOVs together, and the list of figures.

#include "HandMadeAOVs.h"
#include "MesoImageError.h"
#include "MesoScene.h" // for MesoInputError
#include "PairsOfPictures.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
constexpr int Width = PairsOfPictures::Width;
constexpr int Height = PairsOfPictures::Height;

MesoRendering Rendering(const MesoPicture& picture, const HandMadeAOVs& aovs)
{
  return { "rendering", picture, MesoAOVsOfImage(aovs.Image) };
}

double Figure(const MesoImageError& error, const std::string& name)
{
  for (const MesoFigure& figure : MesoFiguresOfError(error))
  {
    if (figure.Name == name)
    {
      return figure.Value;
    }
  }
  ADD_FAILURE() << "no figure is called " << name;
  return 0.;
}
}

TEST(ImageError, PicturesCountWhereEitherCovers)
{
  // Truth and test cover one column each; the pictures differ far away from both as well.
  HandMadeAOVs truth(Width, Height);
  truth.CoverOnly([](int column, int) { return column == 2; });
  HandMadeAOVs test(Width, Height);
  test.CoverOnly([](int column, int) { return column == 3; });
  const MesoPicture black = PairsOfPictures::Constant(0, 0, 0);
  const MesoPicture other =
    PairsOfPictures::Of([](int x, int, int) { return x == 3 || x > 20 ? 255 : 0; });
  const MesoImageError error =
    MesoCompareRenderings(Rendering(black, truth), Rendering(other, test));
  EXPECT_NEAR(Figure(error, "rmse"), std::sqrt(0.5), 1e-7);
  EXPECT_EQ(Figure(error, "coverage_iou"), 0.);
  EXPECT_EQ(error.Width, Width);
  EXPECT_EQ(error.Height, Height);
}

TEST(ImageError, OfPicturesAloneLeavesTheRestUnknown)
{
  const MesoRendering truth{ "a", PairsOfPictures::Smooth(0, 128), {} };
  const MesoRendering test{ "b", PairsOfPictures::Smooth(2, 140), {} };
  const MesoImageError error = MesoCompareRenderings(truth, test);
  EXPECT_NEAR(Figure(error, "ssim"), 0.928908076, 1e-6);
  EXPECT_TRUE(std::isnan(Figure(error, "coverage_iou")));
  EXPECT_TRUE(std::isnan(Figure(error, "nan_pixels")));
  EXPECT_TRUE(std::isnan(Figure(error, "texcoord_p95")));
}

TEST(ImageError, OfAOVsAloneLeavesPicturesUnknown)
{
  const HandMadeAOVs aovs(4, 4);
  const MesoRendering rendering{ "a", {}, MesoAOVsOfImage(aovs.Image) };
  const MesoImageError error = MesoCompareRenderings(rendering, rendering);
  EXPECT_EQ(Figure(error, "coverage_iou"), 1.);
  EXPECT_EQ(Figure(error, "nan_pixels"), 0.);
  EXPECT_TRUE(std::isnan(Figure(error, "flip_mean")));
}

TEST(ImageError, RefusesWhatDoesNotFit)
{
  const MesoRendering picture{ "a", PairsOfPictures::Constant(0, 0, 0), {} };
  const MesoRendering aovs{ "b", {}, MesoAOVsOfImage(HandMadeAOVs(4, 4).Image) };
  EXPECT_THROW(MesoCompareRenderings(picture, aovs), MesoInputError);
  EXPECT_THROW(MesoCompareRenderings(Rendering(*picture.Picture, HandMadeAOVs(4, 4)),
                 Rendering(*picture.Picture, HandMadeAOVs(4, 4))),
    MesoInputError);
}
