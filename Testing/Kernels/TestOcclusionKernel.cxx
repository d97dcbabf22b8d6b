// occludedLinear: walls by hand, what never blocks, and its count of fetches.

#include "KernelTypes.h"

#include <cmath>

template <typename Kernels>
class OcclusionKernel : public KernelTest<Kernels>
{
public:
  /// Ground at height 0 with a wall of this height at texel 16 of 32.
  typename KernelTest<Kernels>::HeightField Wall(float height) const
  {
    std::vector<float> heights(32, 0.f);
    heights[16] = height;
    return typename KernelTest<Kernels>::HeightField(32, 1, MesoWrap::Clamp, heights);
  }
};
TYPED_TEST_SUITE(OcclusionKernel, BothKernels, KernelNames);

TYPED_TEST(OcclusionKernel, SeesTheWallThatIsHighEnough)
{
  using Real = typename TestFixture::Real;
  // From u = 1/4 on the ground, rising by 1 in 1/2: at the wall (u = 16.5/32) height 0.53.
  const typename TestFixture::Vec2 start(Real(0.25), 0);
  const typename TestFixture::Vec2 rise(Real(0.5), 0);
  int fetches = 0;
  const auto blocked = [&](float height, const typename TestFixture::Vec2& perHeight)
  {
    const auto wall = this->Wall(height);
    return wall.occludedLinear(wall.straightPath(start, -perHeight, 1, 0), 64, fetches);
  };
  EXPECT_EQ(blocked(0.8f, rise), 1);
  EXPECT_LT(fetches, 64);
  EXPECT_EQ(blocked(0.4f, rise), 0);
  EXPECT_EQ(fetches, 64);
  EXPECT_EQ(blocked(1.f, -rise), 0); // the other way
}

TYPED_TEST(OcclusionKernel, BlocksNothingOnFlatGround)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  for (float height : { 0.f, 0.3f, 1.f })
  {
    const typename TestFixture::HeightField field(
      4, 4, MesoWrap::Repeat, std::vector<float>(16, height));
    for (int run = 0; run < 500; ++run)
    {
      const Vec2 start(this->Random(-1., 1.), this->Random(-1., 1.));
      const Vec2 rise(this->Random(-9., 9.), this->Random(-9., 9.));
      int fetches = -1;
      ASSERT_EQ(field.occludedLinear(
                  field.straightPath(start, -rise, Real(1) - Real(height), 0), 64, fetches),
        0);
      ASSERT_EQ(fetches, height < 1.f ? 64 : 0);
    }
  }
}

TYPED_TEST(OcclusionKernel, DoesNotHangOnTheSamplersRounding)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  // A slope of one per 16 texels, lit along itself from just above: the sampler's 8-bit weights
  // alone would lay speckles on it.
  const std::vector<float> heights = MakeHeights(16, 1, [](int i, int) { return i / 16.; });
  typename TestFixture::HeightField field(16, 1, MesoWrap::Clamp, heights);
  field.SetWeightBits(8);
  for (int run = 0; run < 1000; ++run)
  {
    const Real u = this->Random(1. / 16., 12. / 16.);
    const Real depth = Real(1) - field.bilinearHeight(Vec2(u, 0)) - Real(1e-4);
    int fetches = 0;
    ASSERT_EQ(field.occludedLinear(
                field.straightPath(Vec2(u, 0), -Vec2(Real(0.999), 0), depth, 0), 64, fetches),
      0)
      << u;
  }
}

TYPED_TEST(OcclusionKernel, AgreesWithAFineMarchOnSmoothMaps)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const double pi = std::acos(-1.);
  const int size = 64;
  const std::vector<float> heights = MakeHeights(size, size,
    [=](int column, int row)
    {
      const double u = (column + 0.5) / size;
      const double v = (row + 0.5) / size;
      return 0.5 + 0.25 * std::cos(6. * pi * u) + 0.25 * std::sin(4. * pi * v + 2. * pi * u);
    });
  const typename TestFixture::HeightField field(size, size, MesoWrap::Repeat, heights);
  int blocked = 0;
  int different = 0;
  const int runs = 3000;
  for (int run = 0; run < runs; ++run)
  {
    const Vec2 start(this->Random(0., 1.), this->Random(0., 1.));
    const Vec2 rise(this->Random(-0.3, 0.3), this->Random(-0.3, 0.3));
    const double depth = 1. - double(field.bilinearHeight(start)) - 1e-3;
    bool truth = false;
    for (int i = 0; i < 4000 && depth > 0. && !truth; ++i)
    {
      const double risen = depth * i / 4000.;
      const Vec2 uv(Real(start.x + risen * rise.x), Real(start.y + risen * rise.y));
      truth = 1. - double(field.sampleHeight(uv)) < depth - risen - 1e-6;
    }
    int fetches = 0;
    const Real found =
      field.occludedLinear(field.straightPath(start, -rise, Real(depth), 0), 64, fetches);
    blocked += truth;
    different += (found == 1) != truth;
  }
  EXPECT_GT(blocked, runs / 20);
  EXPECT_LT(blocked, runs * 19 / 20);
  EXPECT_LT(different, runs / 100);
}

TYPED_TEST(OcclusionKernel, BlocksNothingWithoutARay)
{
  using Real = typename TestFixture::Real;
  const auto field = this->Wall(1.f);
  int fetches = -1;
  for (int argument = 0; argument < 5; ++argument)
  {
    Real numbers[5] = { Real(0.1), Real(0.2), Real(0.3), Real(0.4), Real(0.5) };
    numbers[argument] = Real(NotANumber);
    EXPECT_EQ(field.occludedLinear(field.straightPath({ numbers[0], numbers[1] },
                                     { -numbers[2], -numbers[3] }, numbers[4], 0),
                64, fetches),
      0);
    EXPECT_EQ(fetches, 0);
  }
  EXPECT_EQ(field.occludedLinear(
              field.straightPath({ Real(0.5), 0 }, { 0, 0 }, Real(-0.1), 0), 64, fetches),
    0);
  EXPECT_EQ(
    field.occludedLinear(field.straightPath({ Real(0.5), 0 }, { 0, 0 }, Real(0.5), 0), 0, fetches),
    0);
  EXPECT_EQ(fetches, 0);
}
