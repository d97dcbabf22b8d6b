// Wrapping and bilinear heights: against definitions written apart, exact where they must be.

#include "KernelTypes.h"

#include <climits>
#include <cstdint>

template <typename Kernels>
class HeightFieldKernel : public KernelTest<Kernels>
{
};
TYPED_TEST_SUITE(HeightFieldKernel, BothKernels, KernelNames);

namespace
{
// By definition, in numbers too large to overflow.
int WrappedByDefinition(std::int64_t i, std::int64_t n, MesoWrap wrap)
{
  const auto modulo = [](std::int64_t a, std::int64_t b) { return (a % b + b) % b; };
  if (wrap == MesoWrap::Repeat)
  {
    return int(modulo(i, n));
  }
  if (wrap == MesoWrap::Clamp)
  {
    return int(i < 0 ? 0 : (i >= n ? n - 1 : i));
  }
  const std::int64_t inPeriod = modulo(i, 2 * n);
  return int(inPeriod < n ? inPeriod : 2 * n - 1 - inPeriod);
}
}

TYPED_TEST(HeightFieldKernel, WrapsAnyTexelAsDefined)
{
  const typename TestFixture::HeightField kernel(1, 1, MesoWrap::Repeat, { 0.f });
  for (MesoWrap wrap : AllWraps)
  {
    for (int n : { 1, 2, 3, 7, 8, 255, 256, 4096, INT_MAX })
    {
      for (int i = -50; i <= 50; ++i)
      {
        ASSERT_EQ(kernel.wrapTexel(i, n, int(wrap)), WrappedByDefinition(i, n, wrap))
          << i << " " << n;
      }
      for (int i : { INT_MIN, INT_MIN + 1, -n, -n - 1, n - 1, n, INT_MAX - 1, INT_MAX })
      {
        ASSERT_EQ(kernel.wrapTexel(i, n, int(wrap)), WrappedByDefinition(i, n, wrap))
          << i << " " << n;
      }
      std::uniform_int_distribution<int> any(INT_MIN, INT_MAX);
      for (int run = 0; run < 1000; ++run)
      {
        const int i = any(this->Generator);
        ASSERT_EQ(kernel.wrapTexel(i, n, int(wrap)), WrappedByDefinition(i, n, wrap))
          << i << " " << n;
      }
    }
  }
}

TYPED_TEST(HeightFieldKernel, WrapsNearTexelsLikeAnyAndStaysInside)
{
  const typename TestFixture::HeightField kernel(1, 1, MesoWrap::Repeat, { 0.f });
  for (MesoWrap wrap : AllWraps)
  {
    for (int n : { 1, 2, 3, 7, 256 })
    {
      for (int i = -2; i <= (wrap == MesoWrap::Mirror ? 2 * n + 1 : n + 1); ++i)
      {
        ASSERT_EQ(kernel.wrapNearTexel(i, n, int(wrap)), WrappedByDefinition(i, n, wrap))
          << i << " " << n;
      }
      for (int i : { INT_MIN, -1000, 1000, INT_MAX })
      {
        ASSERT_GE(kernel.wrapNearTexel(i, n, int(wrap)), 0);
        ASSERT_LT(kernel.wrapNearTexel(i, n, int(wrap)), n);
      }
    }
  }
}

TYPED_TEST(HeightFieldKernel, GivesTexelsAtTheirCentres)
{
  using Real = typename TestFixture::Real;
  const std::vector<float> heights = this->RandomHeights(8 * 4);
  for (MesoWrap wrap : AllWraps)
  {
    const typename TestFixture::HeightField field(8, 4, wrap, heights);
    for (int row = 0; row < 4; ++row)
    {
      for (int column = 0; column < 8; ++column)
      {
        const Real u = (Real(column) + Real(0.5)) / 8;
        const Real v = (Real(row) + Real(0.5)) / 4;
        ASSERT_EQ(field.bilinearHeight({ u, v }), Real(heights[std::size_t(row * 8 + column)]));
      }
    }
  }
}

TYPED_TEST(HeightFieldKernel, GivesConstantMapsExactly)
{
  using Real = typename TestFixture::Real;
  for (float height : { 0.f, 0.1f, 0.7f, 1.f })
  {
    const typename TestFixture::HeightField field(
      7, 5, MesoWrap::Repeat, std::vector<float>(35, height));
    for (int run = 0; run < 1000; ++run)
    {
      ASSERT_EQ(
        field.bilinearHeight({ this->Random(-3., 3.), this->Random(-3., 3.) }), Real(height));
    }
  }
}

TYPED_TEST(HeightFieldKernel, GivesRampsExactlyUpToRounding)
{
  using Real = typename TestFixture::Real;
  // h = 0.1 + 0.5 u + 0.3 v at the centres of 10 x 6 texels is the same between them.
  const std::vector<float> heights = MakeHeights(10, 6,
    [](int column, int row) { return 0.1 + 0.5 * (column + 0.5) / 10. + 0.3 * (row + 0.5) / 6.; });
  const typename TestFixture::HeightField field(10, 6, MesoWrap::Clamp, heights);
  for (int run = 0; run < 1000; ++run)
  {
    const Real u = this->Random(0.05, 0.95);
    const Real v = this->Random(1. / 12., 11. / 12.);
    // The map's own heights are floats: 1 ulp below 1 is 6e-8.
    ASSERT_NEAR(field.bilinearHeight({ u, v }), Real(0.1) + Real(0.5) * u + Real(0.3) * v, 3e-7);
  }
}

TYPED_TEST(HeightFieldKernel, AgreesWithASamplerOfItsOwnWriting)
{
  using Vec2 = typename TestFixture::Vec2;
  const glm::ivec2 sizes[] = { { 1, 1 }, { 1, 9 }, { 9, 1 }, { 2, 2 }, { 7, 5 }, { 64, 64 } };
  for (MesoWrap wrap : AllWraps)
  {
    for (const glm::ivec2& size : sizes)
    {
      const typename TestFixture::HeightField field(
        size.x, size.y, wrap, this->RandomHeights(size.x * size.y));
      for (int run = 0; run < 2000; ++run)
      {
        const Vec2 uv(this->Random(-4., 4.), this->Random(-4., 4.));
        // A coordinate's ulp, 4 at most, moves a weight by size ulps; heights differ by 1 at most.
        const double bound = 8. * double(this->Epsilon) * std::max(size.x, size.y);
        ASSERT_NEAR(field.bilinearHeight(uv), field.sampleHeight(uv), bound);
      }
    }
  }
}

TYPED_TEST(HeightFieldKernel, IsContinuousAcrossTheWrap)
{
  using Vec2 = typename TestFixture::Vec2;
  using Real = typename TestFixture::Real;
  const int size = 16;
  for (MesoWrap wrap : AllWraps)
  {
    const typename TestFixture::HeightField field(
      size, size, wrap, this->RandomHeights(size * size));
    for (Real edge : { Real(-2), Real(-1), Real(0), Real(1), Real(2) })
    {
      for (int run = 0; run < 200; ++run)
      {
        const Real along = this->Random(-2., 2.);
        const Real near = this->Random(0., 1e-4);
        // A map of heights in [0,1] rises by `size` per map coordinate at most.
        const double bound = double(2 * near * size) + 8. * double(this->Epsilon) * size;
        ASSERT_NEAR(field.bilinearHeight(Vec2(edge - near, along)),
          field.bilinearHeight(Vec2(edge + near, along)), bound);
        ASSERT_NEAR(field.bilinearHeight(Vec2(along, edge - near)),
          field.bilinearHeight(Vec2(along, edge + near)), bound);
      }
    }
  }
}

TYPED_TEST(HeightFieldKernel, LosesNothingThousandsOfTilesAway)
{
  using Vec2 = typename TestFixture::Vec2;
  using Real = typename TestFixture::Real;
  const int size = 64;
  const std::vector<float> heights = this->RandomHeights(size * size);
  std::uniform_int_distribution<int> part(0, 511);
  for (MesoWrap wrap : { MesoWrap::Repeat, MesoWrap::Mirror })
  {
    const typename TestFixture::HeightField field(size, size, wrap, heights);
    for (int run = 0; run < 1000; ++run)
    {
      // 512ths are exact in a float next to 10000.
      const Vec2 uv(Real(part(this->Generator)) / 512, Real(part(this->Generator)) / 512);
      for (Real tiles : { Real(-10000), Real(-2), Real(2), Real(10000) })
      {
        ASSERT_EQ(field.bilinearHeight(uv), field.bilinearHeight(uv + Vec2(tiles, -tiles)));
        ASSERT_EQ(field.heightGradient(uv), field.heightGradient(uv + Vec2(tiles, -tiles)));
      }
    }
  }
}

TYPED_TEST(HeightFieldKernel, SurvivesWhatIsNoCoordinate)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  for (MesoWrap wrap : AllWraps)
  {
    const typename TestFixture::HeightField field(3, 5, wrap, this->RandomHeights(15));
    for (double odd : { NotANumber, Infinite, -Infinite, 1e30, -1e30, 1e-40, 3e9 })
    {
      for (const Vec2& uv :
        { Vec2(Real(odd), Real(0.3)), Vec2(Real(0.3), Real(odd)), Vec2(Real(odd)) })
      {
        ASSERT_GE(field.bilinearHeight(uv), 0) << odd;
        ASSERT_LE(field.bilinearHeight(uv), 1) << odd;
        const Vec2 gradient = field.heightGradient(uv) + field.patchGradient(uv);
        ASSERT_LE(std::abs(gradient.x) + std::abs(gradient.y), 32) << odd;
      }
    }
  }
}

TYPED_TEST(HeightFieldKernel, RefusesMapsWithoutTheirHeights)
{
  using HeightField = typename TestFixture::HeightField;
  EXPECT_THROW(HeightField(2, 2, MesoWrap::Repeat, { 0.f, 0.f, 0.f }), std::invalid_argument);
  EXPECT_THROW(HeightField(0, 2, MesoWrap::Repeat, {}), std::invalid_argument);
  EXPECT_THROW(HeightField(-1, -1, MesoWrap::Repeat, { 0.f }), std::invalid_argument);
}
