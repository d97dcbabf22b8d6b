// The kernel of horizon mapping: directions of a table, and a light's disc at a horizon.

#include "KernelTypes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
const MesoKernels::Double::Horizon Kernel;
const double Pi = std::acos(-1.);

glm::dvec2 DirectionOf(double turns)
{
  return { std::cos(2. * Pi * turns), std::sin(2. * Pi * turns) };
}
}

TEST(HorizonKernel, AzimuthsGoRoundOnce)
{
  for (int i = -50; i < 150; ++i)
  {
    const double turns = (i + 0.25) / 100.;
    double weight = -1.;
    const int before = Kernel.azimuthBefore(3. * DirectionOf(turns), 8, weight);
    const double place = 8. * (turns - std::floor(turns));
    EXPECT_EQ(before, static_cast<int>(std::floor(place))) << turns;
    EXPECT_NEAR(weight, place - std::floor(place), 1e-6) << turns;
  }
  EXPECT_EQ(Kernel.azimuthAfter(6, 8), 7);
  EXPECT_EQ(Kernel.azimuthAfter(7, 8), 0);
  // Just before a full turn, where a float rounds up to it.
  const MesoKernels::Float::Horizon rounded;
  float weight = -1.f;
  const int azimuth = rounded.azimuthBefore({ 1.f, -1e-12f }, 8, weight);
  EXPECT_TRUE(azimuth == 0 || azimuth == 7);
  EXPECT_GE(weight, 0.f);
  EXPECT_LT(weight, 1.f);
}

TEST(HorizonKernel, ADiscSetsAsItsAreaDoes)
{
  EXPECT_EQ(Kernel.discBelow(0.3, 0.2, 0.1), 0.);
  EXPECT_EQ(Kernel.discBelow(0.2, 0.3, 0.1), 1.);
  EXPECT_NEAR(Kernel.discBelow(0.2, 0.2, 0.1), 0.5, 1e-12);
  EXPECT_EQ(Kernel.discBelow(0.2, 0.1999, 0.), 0.); // a point
  EXPECT_EQ(Kernel.discBelow(0.1999, 0.2, 0.), 1.);
  // Against the chords' sum.
  constexpr int chords = 20000;
  for (const double offset : { -0.04, -0.01, 0.02, 0.045 })
  {
    double below = 0.;
    for (int k = 0; k < chords; ++k)
    {
      const double y = -0.05 + 0.1 * (k + 0.5) / chords; // of the disc's radius 0.05
      below += y < -offset ? std::sqrt(0.0025 - y * y) : 0.;
    }
    below *= 2. * 0.1 / chords / (Pi * 0.0025);
    EXPECT_NEAR(Kernel.discBelow(0.5 + offset, 0.5, 0.1), below, 1e-4) << offset;
  }
}
