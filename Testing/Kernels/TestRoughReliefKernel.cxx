// Relief that is averaged away, against integrals over normally distributed slopes.

#include "KernelTypes.h"

#include <algorithm>
#include <cmath>

template <typename Kernels>
class RoughReliefKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::Vec3;

  Vec3 Direction(double degrees, double azimuth)
  {
    const double polar = degrees * 3.14159265358979 / 180.;
    return Vec3(Real(std::sin(polar) * std::cos(azimuth)),
      Real(std::sin(polar) * std::sin(azimuth)), Real(std::cos(polar)));
  }

  /// The mean of a function of the slope.
  template <typename Function>
  static double Mean(Vec2 mean, Vec2 variance, Function function)
  {
    double sum = 0.;
    double weights = 0.;
    constexpr int Steps = 60;
    for (int i = -Steps; i <= Steps; ++i)
    {
      for (int j = -Steps; j <= Steps; ++j)
      {
        const double x = 5. * i / Steps;
        const double y = 5. * j / Steps;
        const double weight = std::exp(-0.5 * (x * x + y * y));
        weights += weight;
        sum += weight *
          function(double(mean.x) + x * std::sqrt(double(variance.x)),
            double(mean.y) + y * std::sqrt(double(variance.y)));
      }
    }
    return sum / weights;
  }

  typename Kernels::RoughRelief Rough;
};
TYPED_TEST_SUITE(RoughReliefKernel, BothKernels, KernelNames);

TYPED_TEST(RoughReliefKernel, HidesWhatFacesTheDirectionTwice)
{
  using Vec2 = typename TestFixture::Vec2;
  for (double degrees : { 10., 45., 70., 80. })
  {
    for (double azimuth : { 0., 0.7, 2.5 })
    {
      const auto out = this->Direction(degrees, azimuth);
      const Vec2 mean(0.1f, -0.05f);
      const Vec2 variance(0.4f, 0.1f);
      // The surface towards the direction, per that of its mean plane: what is more of it hides behind itself.
      const double plane =
        double(out.z) - double(mean.x) * double(out.x) - double(mean.y) * double(out.y);
      const double facing = this->Mean(mean, variance,
        [&](double x, double y) { return std::max(0., out.z - x * out.x - y * out.y); });
      EXPECT_NEAR(double(this->Rough.hiddenPerSeen(out, mean, variance)), facing / plane - 1.,
        0.01 + 0.03 * (facing / plane - 1.))
        << degrees << ", " << azimuth;
    }
  }
}

TYPED_TEST(RoughReliefKernel, ShadesByTheMeanOfWhatIsSeen)
{
  using Vec2 = typename TestFixture::Vec2;
  for (double view : { 0., 45., 75. })
  {
    for (double light : { 20., 50., 70. })
    {
      for (double apart : { 0., 1.5, 3. })
      {
        const auto seenFrom = this->Direction(view, 0.3);
        const auto litFrom = this->Direction(light, 0.3 + apart);
        const Vec2 mean(0.1f, 0.2f);
        const Vec2 variance(0.3f, 0.15f);
        const auto facing = [](const auto& out, double x, double y)
        { return std::max(0., double(out.z) - x * double(out.x) - y * double(out.y)); };
        const double lit = this->Mean(mean, variance,
          [&](double x, double y) {
            return facing(seenFrom, x, y) * facing(litFrom, x, y) / std::sqrt(1. + x * x + y * y);
          });
        const double seen =
          this->Mean(mean, variance, [&](double x, double y) { return facing(seenFrom, x, y); });
        // Nine slopes stand for all.
        EXPECT_NEAR(
          double(this->Rough.meanCosine(seenFrom, litFrom, mean, variance)), lit / seen, 0.06)
          << view << ", " << light << ", " << apart;
      }
    }
  }
}

TYPED_TEST(RoughReliefKernel, OfNoRoughnessIsItsMean)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  for (int run = 0; run < 500; ++run)
  {
    const auto view = this->Direction(double(this->Random(0., 85.)), double(this->Random(0., 6.)));
    const auto light = this->Direction(double(this->Random(0., 85.)), double(this->Random(0., 6.)));
    const Vec2 mean(Real(this->Random(-0.05, 0.05)), Real(this->Random(-0.05, 0.05)));
    const double plane = std::max(
      0., double(light.z) - double(mean.x) * double(light.x) - double(mean.y) * double(light.y));
    const double size =
      std::sqrt(1. + double(mean.x) * double(mean.x) + double(mean.y) * double(mean.y));
    EXPECT_NEAR(
      double(this->Rough.meanCosine(view, light, mean, Vec2(Real(0)))), plane / size, 1e-5);
    EXPECT_EQ(double(this->Rough.litShare(view, light, mean, Vec2(Real(0)))), 1.);
  }
}

TYPED_TEST(RoughReliefKernel, IsLitWhereItIsLookedAtFrom)
{
  using Vec2 = typename TestFixture::Vec2;
  const Vec2 mean(0.f, 0.f);
  const Vec2 variance(0.5f, 0.5f);
  const auto grazing = this->Direction(80., 1.);
  // What is seen from where the light is has no shadow; from elsewhere it has, and more from above.
  EXPECT_NEAR(double(this->Rough.litShare(grazing, grazing, mean, variance)), 1., 1e-6);
  const double across =
    double(this->Rough.litShare(this->Direction(80., 4.), grazing, mean, variance));
  const double above =
    double(this->Rough.litShare(this->Direction(0., 0.), grazing, mean, variance));
  EXPECT_LT(across, 0.8);
  EXPECT_LT(above, across);
  EXPECT_GT(above, 0.);
  // Slopes across a direction hide nothing of it.
  EXPECT_EQ(double(this->Rough.hiddenPerSeen(this->Direction(80., 0.), mean, Vec2(0.f, 0.5f))), 0.);
}
