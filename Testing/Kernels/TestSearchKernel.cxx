// searchLinearBinary on the hard maps and rays: exact where a closed form says so, else the hit
// must lie on the relief to within the last bracket.

#include "KernelTypes.h"

#include <algorithm>
#include <cmath>

template <typename Kernels>
class SearchKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::HeightField;

  static constexpr int LinearSteps = 64;
  static constexpr int BinarySteps = 7;

  HeightField Constant(float height) const
  {
    return HeightField(4, 4, MesoWrap::Repeat, std::vector<float>(16, height));
  }

  /// Map coordinate per depth of a ray this many degrees off the normal over a relief 0.1 tile
  /// deep.
  static Vec2 Slope(double degrees, double azimuth = 0.7)
  {
    const double pi = std::acos(-1.);
    const double run = 0.1 * std::tan(degrees * pi / 180.);
    return Vec2(Real(run * std::cos(azimuth)), Real(run * std::sin(azimuth)));
  }

  /// A hit that is on the ray, and on the relief as closely as a last bracket allows in which
  /// heights differ by 1 from texel to texel.
  void ExpectOnRelief(const HeightField& field, const Vec2& entry, const Vec2& slope)
  {
    const auto hit =
      field.searchLinearBinary(field.straightPath(entry, slope, 0, 1), LinearSteps, BinarySteps);
    ASSERT_TRUE(hit.Hit);
    ASSERT_GE(hit.RayDepth, 0);
    ASSERT_LE(hit.RayDepth, 1);
    ASSERT_EQ(hit.Relief, hit.RayDepth);
    ASSERT_EQ(hit.MapCoord, entry + hit.Part * slope);
    ASSERT_LE(hit.Iterations, LinearSteps + BinarySteps);
    const double bracket = 1. / (LinearSteps << BinarySteps);
    const double steepest = 1. + double(std::abs(slope.x)) * field.mapSize().x +
      double(std::abs(slope.y)) * field.mapSize().y;
    const double clearance = 1. - double(field.bilinearHeight(hit.MapCoord)) - double(hit.RayDepth);
    const double rounding =
      16. * double(this->Epsilon) * steepest * (1. + double(std::abs(entry.x) + std::abs(entry.y)));
    ASSERT_LE(std::abs(clearance), steepest * bracket + rounding);
  }
};
TYPED_TEST_SUITE(SearchKernel, BothKernels, KernelNames);

TYPED_TEST(SearchKernel, HitsTheTopAtOnceAndExactly)
{
  using Vec2 = typename TestFixture::Vec2;
  const auto field = this->Constant(1.f);
  for (double degrees : { 0., 60., 89.99 })
  {
    const Vec2 entry(this->Random(-5., 5.), this->Random(-5., 5.));
    const auto hit =
      field.searchLinearBinary(field.straightPath(entry, this->Slope(degrees), 0, 1), 128, 8);
    EXPECT_TRUE(hit.Hit);
    EXPECT_EQ(hit.RayDepth, 0);
    EXPECT_EQ(hit.MapCoord, entry);
    EXPECT_EQ(hit.Relief, 0);
    EXPECT_EQ(hit.Iterations, 0);
    EXPECT_EQ(hit.Fetches, 1);
  }
}

TYPED_TEST(SearchKernel, HitsTheBottomExactly)
{
  using Vec2 = typename TestFixture::Vec2;
  const auto field = this->Constant(0.f);
  for (double degrees : { 0., 60., 89.99 })
  {
    const Vec2 entry(this->Random(-5., 5.), this->Random(-5., 5.));
    for (int steps = 1; steps <= 128; ++steps) // for some, steps * (1 / steps) is not 1
    {
      const auto hit =
        field.searchLinearBinary(field.straightPath(entry, this->Slope(degrees), 0, 1), steps, 8);
      EXPECT_TRUE(hit.Hit);
      EXPECT_EQ(hit.RayDepth, 1);
      EXPECT_EQ(hit.MapCoord, entry + this->Slope(degrees));
      EXPECT_EQ(hit.Iterations, steps + 8);
      EXPECT_EQ(hit.Fetches, 1 + steps + 2 + 8);
    }
  }
}

TYPED_TEST(SearchKernel, HitsFlatGroundUpToRounding)
{
  using Vec2 = typename TestFixture::Vec2;
  for (float height : { 0.1f, 0.5f, 0.63f, 0.99f })
  {
    const auto field = this->Constant(height);
    for (double degrees : { 0., 60., 89.99 })
    {
      const auto hit =
        field.searchLinearBinary(field.straightPath(Vec2(0), this->Slope(degrees), 0, 1), 16, 5);
      EXPECT_TRUE(hit.Hit);
      EXPECT_NEAR(hit.RayDepth, 1. - double(height), 2. * double(this->Epsilon));
    }
  }
}

TYPED_TEST(SearchKernel, StartsBelowTheSurfaceWhereItStands)
{
  using Vec2 = typename TestFixture::Vec2;
  using Real = typename TestFixture::Real;
  const auto field = this->Constant(0.8f);
  const Vec2 entry(Real(0.3), Real(-7.25));
  for (double start : { 0.2 + 1e-6, 0.5, 1. })
  {
    const auto hit =
      field.searchLinearBinary(field.straightPath(entry, this->Slope(60.), Real(start), 1), 16, 5);
    EXPECT_TRUE(hit.Hit);
    EXPECT_EQ(hit.RayDepth, Real(start));
    EXPECT_EQ(hit.Relief, Real(start));
    EXPECT_EQ(hit.MapCoord, entry);
    EXPECT_EQ(hit.Iterations, 0);
  }
  const auto later =
    field.searchLinearBinary(field.straightPath(entry, this->Slope(60.), Real(0.1), 1), 16, 5);
  EXPECT_NEAR(later.RayDepth, 0.2, 1e-6);
  EXPECT_NEAR(later.MapCoord.x, entry.x + Real(0.1) * this->Slope(60.).x, 1e-6);
}

TYPED_TEST(SearchKernel, FindsTheStepOfAWallByHand)
{
  using Vec2 = typename TestFixture::Vec2;
  using Real = typename TestFixture::Real;
  // Depth 1 left of u = 0.5, 0 right of it, with a wall one texel wide (1/8) between centres at
  // 7/16 and 9/16: depth = (9/16 - u) * 8 there. A ray from u = 1/4 with 1/2 a depth meets it where
  // s = (9/16 - 1/4 - s/2) * 8, so s = 1/2, u = 1/2.
  const std::vector<float> heights = MakeHeights(8, 1, [](int i, int) { return i < 4 ? 0. : 1.; });
  const typename TestFixture::HeightField field(8, 1, MesoWrap::Clamp, heights);
  const auto hit = field.searchLinearBinary(
    field.straightPath({ Real(0.25), Real(0.5) }, { Real(0.5), 0 }, 0, 1), 128, 8);
  EXPECT_TRUE(hit.Hit);
  EXPECT_NEAR(hit.RayDepth, 0.5, 4. * double(this->Epsilon));
  EXPECT_NEAR(hit.MapCoord.x, 0.5, 4. * double(this->Epsilon));
  // From the other side the wall's top is met at once.
  EXPECT_EQ(
    field.searchLinearBinary(field.straightPath({ Real(0.75), 0 }, { Real(-0.5), 0 }, 0, 1), 128, 8)
      .RayDepth,
    0);
  EXPECT_EQ(
    field.searchLinearBinary(field.straightPath(Vec2(0, 0), Vec2(0, 0), 0, 1), 128, 8).RayDepth, 1);
}

TYPED_TEST(SearchKernel, FindsTheSameFromFurtherAlongTheRay)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  // A slope down from 1 to 0.5, so that each ray meets it once.
  const std::vector<float> heights = MakeHeights(16, 1, [](int i, int) { return 1. - i / 32.; });
  const typename TestFixture::HeightField field(16, 1, MesoWrap::Clamp, heights);
  for (int run = 0; run < 500; ++run)
  {
    const Vec2 entry(this->Random(0.1, 0.9), 0);
    const Vec2 slope(this->Random(0.1, 1.), this->Random(-9., 9.));
    const auto whole = field.searchLinearBinary(field.straightPath(entry, slope, 0, 1), 128, 8);
    const Real start = Real(0.9) * whole.RayDepth;
    const auto part =
      field.searchLinearBinary(field.straightPath(entry + start * slope, slope, start, 1), 128, 8);
    ASSERT_TRUE(part.Hit);
    ASSERT_NEAR(part.RayDepth, whole.RayDepth, 64. * double(this->Epsilon));
    ASSERT_NEAR(part.MapCoord.x, whole.MapCoord.x, 64. * double(this->Epsilon));
  }
}

TYPED_TEST(SearchKernel, StandsOnEveryHardMap)
{
  using Vec2 = typename TestFixture::Vec2;
  struct Map
  {
    int Width;
    int Height;
    std::vector<float> Heights;
  };
  std::vector<float> spike(32 * 32, 0.f);
  spike[16 * 32 + 16] = 1.f;
  std::vector<float> slot(32 * 32, 1.f);
  slot[16 * 32 + 16] = 0.f;
  const std::vector<float> checkerboard =
    MakeHeights(16, 16, [](int column, int row) { return (column + row) % 2; });
  const Map maps[] = { { 32, 32, spike }, { 32, 32, slot }, { 16, 16, checkerboard },
    { 1, 1, { 0.4f } }, { 1, 9, this->RandomHeights(9) }, { 9, 1, this->RandomHeights(9) },
    { 37, 23, this->RandomHeights(37 * 23) } };
  for (const Map& map : maps)
  {
    for (MesoWrap wrap : AllWraps)
    {
      typename TestFixture::HeightField field(map.Width, map.Height, wrap, map.Heights);
      for (int bits : { 0, 8 }) // of the sampler, which the hit must not depend on
      {
        field.SetWeightBits(bits);
        for (double degrees : { 0., 30., 60., 85., 89.9, 89.99 })
        {
          for (int run = 0; run < 40; ++run)
          {
            const Vec2 entry(this->Random(-1., 2.), this->Random(-1., 2.));
            this->ExpectOnRelief(field, entry, this->Slope(degrees, this->Random(0., 6.28)));
            if (this->HasFatalFailure())
            {
              FAIL() << map.Width << " x " << map.Height << ", wrap " << int(wrap) << ", "
                     << degrees << " degrees, entry " << entry.x << " " << entry.y;
            }
          }
        }
      }
    }
  }
}

TYPED_TEST(SearchKernel, FindsSpikeAndSlotStraightDown)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  for (float ground : { 0.f, 1.f })
  {
    std::vector<float> heights(32 * 32, ground);
    heights[16 * 32 + 16] = 1.f - ground;
    const typename TestFixture::HeightField field(32, 32, MesoWrap::Repeat, heights);
    for (int run = 0; run < 500; ++run)
    {
      const Vec2 uv(this->Random(15. / 32., 18. / 32.), this->Random(15. / 32., 18. / 32.));
      const auto hit = field.searchLinearBinary(field.straightPath(uv, Vec2(0), 0, 1), 16, 5);
      ASSERT_TRUE(hit.Hit);
      ASSERT_NEAR(hit.RayDepth, Real(1) - field.bilinearHeight(uv), 4 * this->Epsilon);
    }
  }
}

TYPED_TEST(SearchKernel, TakesTheNearerOfTwoWalls)
{
  using Real = typename TestFixture::Real;
  std::vector<float> heights(32, 0.f);
  heights[8] = 1.f;
  heights[20] = 1.f;
  const typename TestFixture::HeightField field(32, 1, MesoWrap::Repeat, heights);
  // Both walls stand in the way of a ray that runs one tile while it sinks; the first is met.
  const auto hit =
    field.searchLinearBinary(field.straightPath({ 0, 0 }, { Real(1), 0 }, 0, 1), 128, 8);
  EXPECT_GT(hit.MapCoord.x, 7.5 / 32.);
  EXPECT_LT(hit.MapCoord.x, 8.5 / 32.);
}

TYPED_TEST(SearchKernel, GoesOnExactlyThousandsOfTilesAway)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const int size = 64;
  const typename TestFixture::HeightField field(
    size, size, MesoWrap::Repeat, this->RandomHeights(size * size));
  std::uniform_int_distribution<int> part(0, 511);
  for (int run = 0; run < 300; ++run)
  {
    const Vec2 entry(Real(part(this->Generator)) / 512, Real(part(this->Generator)) / 512);
    const auto here =
      field.searchLinearBinary(field.straightPath(entry, this->Slope(60.), 0, 1), 64, 7);
    const auto there = field.searchLinearBinary(
      field.straightPath(entry + Vec2(10000, -10000), this->Slope(60.), 0, 1), 64, 7);
    ASSERT_EQ(here.RayDepth, there.RayDepth);
    // The sum itself is what a float makes of it.
    ASSERT_NEAR(there.MapCoord.x - 10000, here.MapCoord.x, 10001 * double(this->Epsilon));
  }
}

TYPED_TEST(SearchKernel, TakesNoRayThatIsNotFinite)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const typename TestFixture::HeightField field(8, 8, MesoWrap::Repeat, this->RandomHeights(64));
  for (double odd : { NotANumber, Infinite, -Infinite })
  {
    for (int argument = 0; argument < 5; ++argument)
    {
      Real numbers[5] = { Real(0.1), Real(0.2), Real(0.3), Real(0.4), 0 };
      numbers[argument] = Real(odd);
      const auto hit = field.searchLinearBinary(
        field.straightPath({ numbers[0], numbers[1] }, { numbers[2], numbers[3] }, numbers[4], 1),
        128, 8);
      EXPECT_FALSE(hit.Hit);
      EXPECT_EQ(hit.RayDepth, 0);
      EXPECT_EQ(hit.MapCoord, Vec2(0));
      EXPECT_EQ(hit.Relief, 0);
      EXPECT_EQ(hit.Fetches, 0);
    }
  }
  // A map with holes of NaN: the result is finite, hit or not.
  std::vector<float> heights = this->RandomHeights(64);
  for (std::size_t i = 0; i < heights.size(); i += 3)
  {
    heights[i] = float(NotANumber);
  }
  const typename TestFixture::HeightField holes(8, 8, MesoWrap::Repeat, heights);
  for (int run = 0; run < 500; ++run)
  {
    const auto hit = holes.searchLinearBinary(
      holes.straightPath({ this->Random(0., 1.), this->Random(0., 1.) }, this->Slope(60.), 0, 1),
      32, 6);
    ASSERT_TRUE(std::isfinite(hit.RayDepth + hit.MapCoord.x + hit.MapCoord.y + hit.Relief));
  }
}

TYPED_TEST(SearchKernel, TakesAnyNumberOfSteps)
{
  const auto field = this->Constant(0.5f);
  for (int steps : { -1, 0, 1 })
  {
    const auto hit =
      field.searchLinearBinary(field.straightPath({ 0, 0 }, { 0, 0 }, 0, 1), steps, -1);
    EXPECT_TRUE(hit.Hit);
    EXPECT_NEAR(hit.RayDepth, 0.5, 2. * double(this->Epsilon));
    EXPECT_EQ(hit.Iterations, 1);
  }
}

TYPED_TEST(SearchKernel, SecantsStandOnTheReliefAsHalvingsDo)
{
  using Vec2 = typename TestFixture::Vec2;
  // Walls and crests: the secants' bracket is one texel or more here, and may hold kinks.
  const std::vector<float> heights =
    MakeHeights(16, 16, [](int column, int row) { return column % 4 < 2 ? 1. : 0.05 * row; });
  const typename TestFixture::HeightField field(16, 16, MesoWrap::Repeat, heights);
  for (int run = 0; run < 2000; ++run)
  {
    const Vec2 entry(this->Random(-1., 2.), this->Random(-1., 2.));
    const Vec2 slope = this->Slope(75., this->Random(0., 6.28));
    const auto path = field.straightPath(entry, slope, 0, 1);
    const auto halved = field.searchLinearBinary(path, 64, 8);
    const auto secant = field.searchLinearSecant(path, 64, 4);
    ASSERT_EQ(halved.Hit, secant.Hit);
    const double step = 1. / 64.;
    ASSERT_NEAR(secant.RayDepth, halved.RayDepth, 1.01 * step) << "not the same first meeting";
    const double clearance =
      1. - double(field.bilinearHeight(secant.MapCoord)) - double(secant.RayDepth);
    // Four secants of a bracket with at most two kinks leave a tenth of a step at worst.
    ASSERT_LE(std::abs(clearance), 0.1) << entry.x << " " << entry.y << " " << slope.x;
    ASSERT_LE(secant.Iterations, 64 + 4);
    ASSERT_EQ(secant.TexelReads, 4 * secant.Fetches);
  }
}

TYPED_TEST(SearchKernel, OneSecantSolvesWhatIsStraight)
{
  using Real = typename TestFixture::Real;
  const std::vector<float> heights = MakeHeights(16, 1, [](int i, int) { return 1. - i / 32.; });
  const typename TestFixture::HeightField field(16, 1, MesoWrap::Clamp, heights);
  const auto path = field.straightPath({ Real(0.2), 0 }, { Real(0.3), 0 }, 0, 1);
  const auto none = field.searchLinearSecant(path, 3, 0);
  const auto one = field.searchLinearSecant(path, 3, 1);
  EXPECT_TRUE(one.Hit);
  EXPECT_EQ(one.Iterations, none.Iterations + 1);
  // Depth (16 u - 1/2) / 32 meets u = .2 + .3 s where s (1 - .15) = .1 - 1/64.
  EXPECT_NEAR(one.RayDepth, (0.1 - 1. / 64.) / 0.85, 8. * double(this->Epsilon));
}
