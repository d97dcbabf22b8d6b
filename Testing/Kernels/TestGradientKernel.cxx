// heightGradient and patchGradient against ramps, closed forms and finite differences.

#include "KernelTypes.h"

#include <cmath>

template <typename Kernels>
class GradientKernel : public KernelTest<Kernels>
{
};
TYPED_TEST_SUITE(GradientKernel, BothKernels, KernelNames);

TYPED_TEST(GradientKernel, IsTheRampsSlope)
{
  using Vec2 = typename TestFixture::Vec2;
  // Exact in float: multiples of 1/64. Slopes per map coordinate: 16/64 and -8 * 2/64.
  const std::vector<float> heights =
    MakeHeights(16, 8, [](int column, int row) { return float(20 + column - 2 * row) / 64.f; });
  const typename TestFixture::HeightField field(16, 8, MesoWrap::Clamp, heights);
  for (int run = 0; run < 1000; ++run)
  {
    // A texel and a half from the edge the clamp does not reach.
    const Vec2 uv(this->Random(1.5 / 16., 14.5 / 16.), this->Random(1.5 / 8., 6.5 / 8.));
    ASSERT_NEAR(field.heightGradient(uv).x, 0.25, 4 * this->Epsilon);
    ASSERT_NEAR(field.heightGradient(uv).y, -0.25, 4 * this->Epsilon);
    ASSERT_NEAR(field.patchGradient(uv).x, 0.25, 4 * this->Epsilon);
    ASSERT_NEAR(field.patchGradient(uv).y, -0.25, 4 * this->Epsilon);
  }
}

TYPED_TEST(GradientKernel, IsTheCentralDifferenceAtTexelCentresAndBilinearBetween)
{
  using Vec2 = typename TestFixture::Vec2;
  using Real = typename TestFixture::Real;
  const int columns = 8;
  const int rows = 4;
  const std::vector<float> heights = this->RandomHeights(columns * rows);
  for (MesoWrap wrap : AllWraps)
  {
    const typename TestFixture::HeightField field(columns, rows, wrap, heights);
    const auto height = [&](int column, int row)
    {
      return double(field.fetchHeight(
        { field.wrapTexel(column, columns, int(wrap)), field.wrapTexel(row, rows, int(wrap)) }));
    };
    const auto centre = [&](int column, int row)
    {
      return glm::dvec2((height(column + 1, row) - height(column - 1, row)) / 2. * columns,
        (height(column, row + 1) - height(column, row - 1)) / 2. * rows);
    };
    for (int run = 0; run < 2000; ++run)
    {
      const int column = int(this->Generator() % unsigned(columns));
      const int row = int(this->Generator() % unsigned(rows));
      const glm::dvec2 weight(this->Random(0., 1.), this->Random(0., 1.));
      const glm::dvec2 below = glm::mix(centre(column, row), centre(column + 1, row), weight.x);
      const glm::dvec2 above =
        glm::mix(centre(column, row + 1), centre(column + 1, row + 1), weight.x);
      const glm::dvec2 expected = glm::mix(below, above, weight.y);
      const Vec2 uv(Real((column + weight.x + 0.5) / columns), Real((row + weight.y + 0.5) / rows));
      if (wrap == MesoWrap::Clamp && (uv.x > 1 || uv.y > 1))
      {
        continue; // beyond the map a clamped map is read at its edge
      }
      // Gradients up to 8, weights off by 8 ulps of a coordinate.
      ASSERT_NEAR(field.heightGradient(uv).x, expected.x, 200. * double(this->Epsilon));
      ASSERT_NEAR(field.heightGradient(uv).y, expected.y, 200. * double(this->Epsilon));
    }
  }
}

TYPED_TEST(GradientKernel, ConvergesToASmoothMapsSlope)
{
  using Vec2 = typename TestFixture::Vec2;
  const double pi = std::acos(-1.);
  double worst[2] = { 0., 0. };
  for (int level = 0; level < 2; ++level)
  {
    const int size = 64 << level;
    const std::vector<float> heights = MakeHeights(size, size,
      [=](int column, int row)
      {
        return 0.5 + 0.25 * std::cos(2. * pi * (column + 0.5) / size) +
          0.25 * std::sin(4. * pi * (row + 0.5) / size);
      });
    const typename TestFixture::HeightField field(size, size, MesoWrap::Repeat, heights);
    for (int run = 0; run < 2000; ++run)
    {
      const Vec2 uv(this->Random(-1., 2.), this->Random(-1., 2.));
      const Vec2 gradient = field.heightGradient(uv);
      worst[level] = std::max(
        worst[level], std::abs(double(gradient.x) + 0.5 * pi * std::sin(2. * pi * double(uv.x))));
      worst[level] = std::max(
        worst[level], std::abs(double(gradient.y) - pi * std::cos(4. * pi * double(uv.y))));
    }
  }
  EXPECT_LT(worst[0], 0.05);
  EXPECT_LT(worst[1], worst[0] / 3.5); // second order: a fourth, but for float heights
}

TYPED_TEST(GradientKernel, OfThePatchIsItsFiniteDifference)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const int columns = 6;
  const int rows = 10;
  const std::vector<float> heights = this->RandomHeights(columns * rows);
  for (MesoWrap wrap : { MesoWrap::Repeat, MesoWrap::Mirror })
  {
    const typename TestFixture::HeightField field(columns, rows, wrap, heights);
    const Real step = Real(1) / 128; // exact; bilinear: differences within a patch are exact too
    for (int run = 0; run < 2000; ++run)
    {
      const Vec2 texel(Real(int(this->Generator() % 24u)) - 12 + this->Random(0.1, 0.9),
        Real(int(this->Generator() % 40u)) - 20 + this->Random(0.1, 0.9));
      const Vec2 uv = (texel + Real(0.5)) / Vec2(columns, rows);
      const Vec2 gradient = field.patchGradient(uv);
      const Real alongU =
        (field.bilinearHeight(uv + Vec2(step, 0)) - field.bilinearHeight(uv - Vec2(step, 0))) /
        (2 * step);
      const Real alongV =
        (field.bilinearHeight(uv + Vec2(0, step)) - field.bilinearHeight(uv - Vec2(0, step))) /
        (2 * step);
      // 64 heights' rounding apart, each off by the 4 ulps of a coordinate times 10 texels.
      ASSERT_NEAR(gradient.x, alongU, 64. * 80. * double(this->Epsilon));
      ASSERT_NEAR(gradient.y, alongV, 64. * 80. * double(this->Epsilon));
    }
  }
}

TYPED_TEST(GradientKernel, TurnsRoundInTheMirror)
{
  using Vec2 = typename TestFixture::Vec2;
  const typename TestFixture::HeightField field(8, 8, MesoWrap::Mirror, this->RandomHeights(64));
  for (int run = 0; run < 1000; ++run)
  {
    const Vec2 uv(this->Random(0., 1.), this->Random(0., 1.));
    const Vec2 gradient = field.heightGradient(uv);
    const Vec2 mirrored = field.heightGradient(Vec2(-uv.x, 2 - uv.y));
    ASSERT_NEAR(mirrored.x, -gradient.x, 200. * double(this->Epsilon));
    ASSERT_NEAR(mirrored.y, -gradient.y, 200. * double(this->Epsilon));
  }
}
