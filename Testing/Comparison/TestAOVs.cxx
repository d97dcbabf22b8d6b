// What pixels know, taken from files, and pairs that cannot be compared.

#include "HandMadeAOVs.h"
#include "MesoAOVs.h"
#include "MesoScene.h" // for MesoInputError

#include <cmath>
#include <gtest/gtest.h>

namespace
{
/// The line that refuses the pair, or "" where it is let pass.
std::string Refusal(const HandMadeAOVs& truth, const HandMadeAOVs& test)
{
  try
  {
    MesoCheckComparable(MesoAOVsOfImage(truth.Image), "truth", MesoAOVsOfImage(test.Image), "test");
    return "";
  }
  catch (const MesoInputError& problem)
  {
    return problem.what();
  }
}
}

TEST(AOVs, PointsLieOnThePixelsRays)
{
  HandMadeAOVs made(4, 2);
  made.Image.Attributes["meso.camera.position.x"] = 10.;
  MesoAOVs aovs = MesoAOVsOfImage(made.Image);
  ASSERT_TRUE(aovs.Camera);
  const auto corner = aovs.PointAt(7); // the last of row 1
  EXPECT_DOUBLE_EQ(corner[0], 10. + 5. * 0.75);
  EXPECT_DOUBLE_EQ(corner[1], -2.5);
  EXPECT_DOUBLE_EQ(corner[2], -5.);
  made.Image.Attributes["meso.camera.parallel"] = 1.;
  const auto parallel = MesoAOVsOfImage(made.Image).PointAt(0);
  EXPECT_DOUBLE_EQ(parallel[0], 10. - 0.75);
  EXPECT_DOUBLE_EQ(parallel[1], 0.5);
}

TEST(AOVs, WithoutCoverageAreRefused)
{
  HandMadeAOVs made(4, 2);
  made.Hide("coverage");
  EXPECT_THROW(MesoAOVsOfImage(made.Image), MesoInputError);
}

TEST(AOVs, WithHalfAGroupAreRefused)
{
  HandMadeAOVs made(4, 2);
  made.Hide("texcoord.v");
  EXPECT_THROW(MesoAOVsOfImage(made.Image), MesoInputError);
}

TEST(AOVs, WithAnAttributeOfTheWrongKindAreRefused)
{
  HandMadeAOVs made(4, 2);
  made.Image.Attributes["meso.1.scale"] = "deep";
  EXPECT_THROW(MesoAOVsOfImage(made.Image), MesoInputError);
}

TEST(AOVs, PairsThatDifferAreRefusedByOneLine)
{
  const HandMadeAOVs truth(4, 2);
  EXPECT_EQ(Refusal(truth, truth), "");
  EXPECT_EQ(Refusal(truth, HandMadeAOVs(2, 4)), "test: the size is 2x4, that of truth 4x2");
  HandMadeAOVs test = truth;
  test.Hide("depth");
  EXPECT_EQ(Refusal(truth, test), "test: the channel depth is missing, which truth has");
  EXPECT_EQ(Refusal(test, truth), "truth: the channel depth is missing, which test has");
  test = truth;
  test.AddChannel("shadow.1");
  EXPECT_EQ(Refusal(truth, test), "truth: the channel shadow.1 is missing, which test has");
  test = truth;
  test.Describe(2, 0.1, 16, 16);
  EXPECT_EQ(Refusal(truth, test), "test: the number of objects is 2, that of truth 1");
}

TEST(AOVs, ATruthOfNoNumbersIsRefused)
{
  HandMadeAOVs truth(4, 2);
  truth.At("normal.y", 3, 1) = std::nanf("");
  EXPECT_EQ(Refusal(truth, HandMadeAOVs(4, 2)),
    "truth: the pixel in column 3 of row 1 holds NaN or Inf, so this is no truth");
  EXPECT_EQ(Refusal(HandMadeAOVs(4, 2), truth), "") << "a test of no numbers is counted";
}
