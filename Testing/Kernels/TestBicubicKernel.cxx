// Heights and gradients of the cubic B-spline: constants, ramps, waves whose height is known, differences,
// smoothness across texel lines, and the range that it stays in.

#include "KernelTypes.h"

#include <algorithm>
#include <cmath>

namespace
{
template <typename Real>
using BicubicOf = std::conditional_t<sizeof(Real) == sizeof(float),
  MesoKernels::Float::BicubicField, MesoKernels::Double::BicubicField>;
constexpr double Pi = 3.14159265358979323846;
}

template <typename Kernels>
class BicubicKernel : public KernelTest<Kernels>
{
public:
  using Field = BicubicOf<typename Kernels::Real>;
};
TYPED_TEST_SUITE(BicubicKernel, BothKernels, KernelNames);

TYPED_TEST(BicubicKernel, ConstantsAreExactAndRampsAreKept)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const std::vector<float> ramp =
    MakeHeights(16, 8, [](int column, int row) { return float(20 + column - 2 * row) / 64.f; });
  const typename TestFixture::Field sloped(16, 8, MesoWrap::Clamp, ramp);
  for (float height : { 0.f, 0.3f, 1.f })
  {
    const typename TestFixture::Field flat(3, 2, MesoWrap::Repeat, std::vector<float>(6, height));
    for (int run = 0; run < 200; ++run)
    {
      const Vec2 uv(this->Random(-3., 3.), this->Random(-3., 3.));
      ASSERT_EQ(flat.mapHeight(uv), Real(height));
      ASSERT_EQ(flat.mapFacet(uv), Vec2(0, 0));
    }
  }
  for (int run = 0; run < 500; ++run)
  {
    // Two texels and a half from the border the clamp does not reach.
    const Vec2 uv(this->Random(2.5 / 16., 13.5 / 16.), this->Random(2.5 / 8., 5.5 / 8.));
    const double x = 16. * double(uv.x) - 0.5;
    const double y = 8. * double(uv.y) - 0.5;
    ASSERT_NEAR(sloped.mapHeight(uv), (20. + x - 2. * y) / 64., 8. * double(this->Epsilon));
    ASSERT_NEAR(sloped.mapFacet(uv).x, 0.25, 8. * double(this->Epsilon));
    ASSERT_NEAR(sloped.mapFacet(uv).y, -0.25, 8. * double(this->Epsilon));
  }
}

TYPED_TEST(BicubicKernel, AWaveKeepsTheShareOfItsHeightThatTheBasisSays)
{
  // At a texel's centre the weights are 1/6, 4/6, 1/6: of a wave of p texels (2 + cos(2 pi / p)) / 3.
  using Real = typename TestFixture::Real;
  for (int period : { 2, 3, 4, 8, 24 })
  {
    const std::vector<float> wave = MakeHeights(
      24, 1, [&](int column, int) { return 0.5 + 0.5 * std::cos(2. * Pi * column / period); });
    const typename TestFixture::Field field(24, 1, MesoWrap::Repeat, wave);
    const double share = (2. + std::cos(2. * Pi / period)) / 3.;
    for (int texel = 0; texel < 24; ++texel)
    {
      const double expected = 0.5 + 0.5 * share * std::cos(2. * Pi * texel / period);
      ASSERT_NEAR(field.mapHeight({ Real((texel + 0.5) / 24.), Real(0.3) }), expected, 3e-6)
        << period;
    }
  }
}

TYPED_TEST(BicubicKernel, TheGradientIsThatOfTheHeightAndHasNoJumps)
{
  for (MesoWrap wrap : AllWraps)
  {
    const std::vector<float> heights = this->RandomHeights(7 * 5);
    const MesoKernels::Double::BicubicField exact(7, 5, wrap, heights);
    const typename TestFixture::Field field(7, 5, wrap, heights);
    using Real = typename TestFixture::Real;
    const double step = 1e-5;
    for (int run = 0; run < 1000; ++run)
    {
      // Along every other run on a line of texel centres, where bilinear patches have their edges.
      const double u = run % 2 ? double(this->Random(-2., 2.)) : (run % 60 - 20. + 0.5) / 7.;
      const double v = double(this->Random(-2., 2.));
      const double alongU =
        (exact.mapHeight({ u + step, v }) - exact.mapHeight({ u - step, v })) / (2. * step);
      const double alongV =
        (exact.mapHeight({ u, v + step }) - exact.mapHeight({ u, v - step })) / (2. * step);
      const bool atBorder = wrap == MesoWrap::Clamp &&
        (std::abs(u) < 1e-4 || std::abs(u - 1.) < 1e-4 || std::abs(v) < 1e-4 ||
          std::abs(v - 1.) < 1e-4);
      if (atBorder)
      {
        continue; // from there on the map is level
      }
      const auto gradient = field.mapFacet({ Real(u), Real(v) });
      ASSERT_NEAR(gradient.x, alongU, 1e-3) << u << " " << v;
      ASSERT_NEAR(gradient.y, alongV, 1e-3) << u << " " << v;
      ASSERT_NEAR(field.mapHeight({ Real(u), Real(v) }), exact.mapHeight({ u, v }), 1e-5);
    }
  }
}

TYPED_TEST(BicubicKernel, StaysInTheRangeOfTheTexelsAround)
{
  using Vec2 = typename TestFixture::Vec2;
  // Within [0, 1] by more than the kernel's own clamp would mend.
  const std::vector<float> checkers =
    MakeHeights(9, 6, [](int column, int row) { return (column * row) % 2 ? 0.75 : 0.25; });
  for (MesoWrap wrap : AllWraps)
  {
    const typename TestFixture::Field field(9, 6, wrap, checkers);
    for (int run = 0; run < 2000; ++run)
    {
      const Vec2 uv(this->Random(-3., 3.), this->Random(-3., 3.));
      ASSERT_GE(field.mapHeight(uv), 0.25 - double(this->Epsilon));
      ASSERT_LE(field.mapHeight(uv), 0.75 + double(this->Epsilon));
    }
    for (double odd : { NotANumber, Infinite, -Infinite, 1e30 })
    {
      const auto height = field.mapHeight(Vec2(odd, 0.5));
      ASSERT_TRUE(height >= 0 && height <= 1) << odd;
      ASSERT_TRUE(std::isfinite(field.mapFacet(Vec2(odd, odd)).x)) << odd;
    }
  }
}

TYPED_TEST(BicubicKernel, SearchesFindItsSurface)
{
  using Vec2 = typename TestFixture::Vec2;
  using Real = typename TestFixture::Real;
  const typename TestFixture::Field field(12, 12, MesoWrap::Repeat, this->RandomHeights(144));
  int found = 0;
  for (int run = 0; run < 500; ++run)
  {
    const Vec2 start(this->Random(-1., 1.), this->Random(-1., 1.));
    const Vec2 along(this->Random(-0.5, 0.5), this->Random(-0.5, 0.5));
    const auto path = field.straightPath(start, along, Real(0), Real(1));
    const auto binary = field.searchLinearBinary(path, 256, 20);
    const auto secant = field.searchLinearSecant(path, 256, 20);
    ASSERT_TRUE(binary.Hit);
    ASSERT_TRUE(secant.Hit);
    ASSERT_NEAR(binary.RayDepth, 1. - double(field.mapHeight(binary.MapCoord)), 2e-5);
    found += std::abs(double(binary.RayDepth - secant.RayDepth)) < 2e-5 ? 1 : 0;
  }
  EXPECT_GT(found, 480); // of the others one step holds several crossings
}
