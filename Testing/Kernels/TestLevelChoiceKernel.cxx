// The levels of a height map's pyramid that a pixel sees: of gentle relief by the pixel's size alone, of steep relief
// none that lacks much of its slopes.

#include "KernelTypes.h"

#include <algorithm>
#include <cmath>

template <typename Kernels>
class LevelChoiceKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using Kernel = typename Kernels::LevelChoice;
  static constexpr int Levels = Kernel::ComparedLevels;

  /// A relief, as steep along u as along v, each of whose levels lacks another share of the mean square slope.
  struct Relief
  {
    Relief(double square, double shareOfEach)
      : Square(square)
    {
      this->Lost[0] = Vec2(Real(0.5 * square));
      for (int level = 1; level < Levels; ++level)
      {
        this->Lost[level] = Vec2(Real(0.5 * square * std::min(level * shareOfEach, 1.)));
      }
    }
    double Square;
    Vec2 Lost[Levels];
  };

  /// Of a pixel that is so many texels wide and high.
  typename Kernel::PixelLevels Choose(
    const Relief& relief, double width, double height, Real perLength = 1, int last = 10)
  {
    // Turned, as the map may lie any way on the screen.
    const double angle = double(this->Random(0., 6.2832));
    const Vec2 stepX(Real(width * std::cos(angle)), Real(width * std::sin(angle)));
    const Vec2 stepY(Real(-height * std::sin(angle)), Real(height * std::cos(angle)));
    return this->Choice.levelsOfPixel(stepX, stepY, relief.Lost, Vec2(perLength), last);
  }

  Kernel Choice;
};
TYPED_TEST_SUITE(LevelChoiceKernel, BothKernels, KernelNames);

TYPED_TEST(LevelChoiceKernel, GentleReliefIsSeenAtThePixelsSize)
{
  const typename TestFixture::Relief gentle(0.5, 0.2);
  for (int run = 0; run < 500; ++run)
  {
    const double shorter = std::exp2(double(this->Random(-2., 9.)));
    const double longer = shorter * std::exp2(double(this->Random(0., 4.)));
    const bool wide = run % 2 == 0;
    const auto levels = this->Choose(gentle, wide ? longer : shorter, wide ? shorter : longer);
    // A texel is half to one of the shorter side, or the map's own is larger.
    const double texel = std::exp2(double(levels.Searched));
    EXPECT_LE(texel, std::max(1.001 * shorter, 1.));
    EXPECT_TRUE(texel > 0.499 * shorter || levels.Searched == 10);
    const double shaded = std::clamp(0.5 * std::log2(shorter * longer) - 1., 0., 10.);
    EXPECT_NEAR(double(levels.Shaded), shaded, 1e-4);
  }
}

TYPED_TEST(LevelChoiceKernel, SteepReliefKeepsItsSlopes)
{
  using Kernel = typename TestFixture::Kernel;
  for (int run = 0; run < 500; ++run)
  {
    const double share = double(this->Random(0.005, 0.6));
    const double square = double(this->Random(6., 400.));
    const typename TestFixture::Relief steep(square, share);
    const auto levels = this->Choose(steep, 3000., 3000.);
    // However large the pixel is: up to where a share of the slopes is lacking, and no level less.
    const double searched = std::min(double(Kernel::SearchedShare) / share, 10.);
    EXPECT_LE(double(levels.Searched), searched + 1e-4);
    EXPECT_GT(double(levels.Searched), searched - 1.0001);
    EXPECT_NEAR(
      double(levels.Shaded), std::min(double(Kernel::ShadedShare) / share, 10.), 1e-3 * searched);
  }
}

TYPED_TEST(LevelChoiceKernel, SlopesAreThoseOfTheSurface)
{
  using Real = typename TestFixture::Real;
  // The same map, ten times as deep.
  const typename TestFixture::Relief relief(0.5, 0.1);
  EXPECT_EQ(this->Choose(relief, 2000., 2000.).Searched, 10);
  EXPECT_EQ(this->Choose(relief, 2000., 2000., Real(100)).Searched, 2);
  // From gentle to steep what is shaded falls without a jump.
  double before = std::log2(2000.) - 1.;
  for (double depth = 0.5; depth < 10.; depth *= 1.01)
  {
    const double level = double(this->Choose(relief, 2000., 2000., Real(depth * depth)).Shaded);
    EXPECT_LE(level, before + 1e-4) << depth;
    EXPECT_GT(level, before - 0.25) << depth;
    before = level;
  }
  EXPECT_NEAR(before, 1., 1e-3);
}

TYPED_TEST(LevelChoiceKernel, WhatIsNoNumberChoosesTheMap)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const typename TestFixture::Relief relief(0.5, 0.25);
  for (double odd : { NotANumber, Infinite })
  {
    const Vec2 none = { Real(odd), Real(odd) };
    for (const auto& levels :
      { this->Choice.levelsOfPixel(none, none, relief.Lost, Vec2(Real(1)), 10),
        this->Choice.levelsOfPixel(none, Vec2(Real(1)), relief.Lost, Vec2(Real(1)), 10) })
    {
      EXPECT_GE(levels.Searched, 0);
      EXPECT_LE(levels.Searched, 10);
      EXPECT_TRUE(levels.Shaded >= 0 && levels.Shaded <= 10);
    }
  }
  EXPECT_EQ(this->Choice.levelsOfPixel(Vec2(Real(0)), Vec2(Real(0)), relief.Lost, Vec2(Real(1)), 10)
              .Searched,
    0);
  EXPECT_EQ(this->Choose(relief, 100., 100., Real(1), 0).Searched, 0); // no pyramid
  // Charts without a length: nothing is rough, or finitely so.
  for (double odd : { NotANumber, Infinite, 1e30 })
  {
    const Vec2 rough =
      this->Choice.roughnessOfLevel(Real(8), relief.Lost, relief.Lost, Vec2(Real(odd)));
    EXPECT_TRUE(double(rough.x) >= 0. && double(rough.x) <= 1e6) << odd << ": " << rough.x;
  }
}

TYPED_TEST(LevelChoiceKernel, ALevelThatLacksMostOfTheSlopesIsRough)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const typename TestFixture::Relief relief(0.4, 0.125); // from level 8 on all is lacking
  Vec2 roughness[TestFixture::Levels];
  for (int level = 0; level < TestFixture::Levels; ++level)
  {
    roughness[level] = Vec2(Real(0.01 * level), Real(0.02 * level));
  }
  const auto of = [&](double level, double perLength = 1.)
  {
    return this->Choice.roughnessOfLevel(
      Real(level), relief.Lost, roughness, Vec2(Real(perLength)));
  };
  EXPECT_EQ(double(of(0.).y), 0.);
  EXPECT_EQ(double(of(3.1).y), 0.); // lacks 39 %
  EXPECT_NEAR(double(of(4.5).x), (4.5 / 8. - 0.4) / 0.4 * 0.045, 1e-6);
  EXPECT_NEAR(double(of(4.5).y), (4.5 / 8. - 0.4) / 0.4 * 0.09, 1e-6);
  EXPECT_NEAR(double(of(7.).y), 0.14, 1e-6); // 88 %
  EXPECT_NEAR(double(of(7., 3.).y), 3. * 0.14, 1e-6);
  // Without a step from level to level.
  for (double level = 0.; level < 9.; level += 0.01)
  {
    EXPECT_LT(double(of(level + 0.01).y) - double(of(level).y), 0.002);
    EXPECT_GE(double(of(level + 0.01).y), double(of(level).y) - 1e-6);
  }
}
