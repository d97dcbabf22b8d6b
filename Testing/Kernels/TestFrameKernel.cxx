// solveFrame: round trips over lengths 1e-6 to 1e6, anisotropy and shear, and what it refuses.

#include "KernelTypes.h"

#include <cmath>

template <typename Kernels>
class FrameKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Vec3;

  Vec3 RandomDirection()
  {
    Vec3 v;
    do
    {
      v = Vec3(this->Random(-1., 1.), this->Random(-1., 1.), this->Random(-1., 1.));
    } while (glm::dot(v, v) > 1 || glm::dot(v, v) < 0.01);
    return glm::normalize(v);
  }

  /// Largest error of solving for a known x, relative to the bound that Frame.glsl states: an error
  /// of 4 epsilons of the shares' summed lengths, over the volume, along each axis.
  double ErrorOverBound(const glm::dvec3 (&axes)[3], const glm::dvec3& known)
  {
    // The axes as the kernel sees them; the right-hand side rounds once more, within the bound.
    glm::dvec3 seen[3];
    for (int i = 0; i < 3; ++i)
    {
      seen[i] = glm::dvec3(Vec3(axes[i]));
    }
    const glm::dvec3 sum = known.x * seen[0] + known.y * seen[1] + known.z * seen[2];
    Vec3 x;
    EXPECT_TRUE(this->Kernel.solveFrame(Vec3(seen[0]), Vec3(seen[1]), Vec3(seen[2]), Vec3(sum), x));
    const double volume = std::abs(glm::dot(
      glm::normalize(seen[0]), glm::cross(glm::normalize(seen[1]), glm::normalize(seen[2]))));
    double lengths = 0.;
    for (int i = 0; i < 3; ++i)
    {
      lengths += std::abs(known[i]) * glm::length(seen[i]);
    }
    const double bound = 4. * double(this->Epsilon) * lengths / volume;
    double worst = 0.;
    for (int i = 0; i < 3; ++i)
    {
      worst = std::max(worst, std::abs(double(x[i]) - known[i]) * glm::length(seen[i]) / bound);
    }
    return worst;
  }

  typename KernelTest<Kernels>::Frame Kernel;
};
TYPED_TEST_SUITE(FrameKernel, BothKernels, KernelNames);

TYPED_TEST(FrameKernel, FindsCoordinatesAtAnyLengths)
{
  double worst = 0.;
  for (int run = 0; run < 20000; ++run)
  {
    // Each axis has a length of its own, 1e-6 to 1e6: anisotropy far over 1000:1.
    glm::dvec3 axes[3];
    glm::dvec3 known;
    const double scale = std::pow(10., this->Random(-6., 6.));
    for (int i = 0; i < 3; ++i)
    {
      const double length = std::pow(10., this->Random(-6., 6.));
      axes[i] = length * glm::dvec3(this->RandomDirection());
      known[i] = scale * this->Random(-1., 1.) / length;
    }
    const double volume = glm::dot(
      glm::normalize(axes[0]), glm::cross(glm::normalize(axes[1]), glm::normalize(axes[2])));
    if (std::abs(volume) > 2e-4)
    {
      worst = std::max(worst, this->ErrorOverBound(axes, known));
    }
  }
  EXPECT_LT(worst, 1.);
}

TYPED_TEST(FrameKernel, FindsCoordinatesInShearedAndMirroredFrames)
{
  double worst = 0.;
  for (int run = 0; run < 20000; ++run)
  {
    // The second axis leans towards the first to 2e-4 radians, as a stretched chart's may.
    const glm::dvec3 a(this->RandomDirection());
    const glm::dvec3 side = glm::normalize(glm::cross(a, glm::dvec3(this->RandomDirection())));
    const double angle = std::pow(10., this->Random(-3.7, 0.));
    const double hand = run % 2 == 0 ? 1. : -1.;
    const glm::dvec3 axes[3] = { 1000. * a, std::cos(angle) * a + std::sin(angle) * hand * side,
      0.05 * glm::cross(a, side) };
    const glm::dvec3 known(this->Random(-1., 1.), this->Random(-1., 1.), this->Random(-1., 1.));
    worst = std::max(worst, this->ErrorOverBound(axes, known));
  }
  EXPECT_LT(worst, 1.);
}

TYPED_TEST(FrameKernel, ScalesExactly)
{
  using Vec3 = typename TestFixture::Vec3;
  using Real = typename TestFixture::Real;
  for (int run = 0; run < 1000; ++run)
  {
    const Vec3 a = this->RandomDirection();
    const Vec3 b = this->RandomDirection();
    const Vec3 c = this->RandomDirection();
    const Vec3 r = this->RandomDirection();
    Vec3 x;
    Vec3 scaled;
    const bool solved = this->Kernel.solveFrame(a, b, c, r, x);
    const Real up = std::ldexp(Real(1), 20);
    const Real down = std::ldexp(Real(1), -20);
    ASSERT_EQ(solved, this->Kernel.solveFrame(up * a, down * b, c, down * r, scaled));
    EXPECT_EQ(scaled, Vec3(down * down * x.x, x.y, down * x.z));
  }
}

TYPED_TEST(FrameKernel, RefusesDegenerateFrames)
{
  using Vec3 = typename TestFixture::Vec3;
  using Real = typename TestFixture::Real;
  const Vec3 a(1, 0, 0);
  const Vec3 b(0, 2, 0);
  const Vec3 c(0, 0, 3);
  const Vec3 r(1, 1, 1);
  const Real tiny = Real(1e-7); // radians
  const Real nan = Real(NotANumber);
  const Vec3 bad[][4] = { { Vec3(0), b, c, r }, { a, Vec3(0), c, r },
    { a, b, Vec3(0), r },                                                     // no length
    { a, a, c, r }, { a, Real(-1e6) * a, c, r }, { a, b, a + b, r },          // in a plane
    { a, Vec3(1, tiny, 0), c, r }, { Real(1e6) * a, Vec3(1, tiny, 0), c, r }, // nearly
    { Vec3(nan, 0, 0), b, c, r }, { a, Vec3(1, nan, 0), c, r }, { a, b, Vec3(0, nan, 1), r },
    { a, b, c, Vec3(0, nan, 1) }, { a, b, c, Vec3(Real(Infinite), 0, 0) },
    { Vec3(Real(Infinite), 0, 0), b, c, r }, { a, b, c, Vec3(Real(1e30), 0, 0) },
    { Vec3(Real(1e-30), 0, 0), b, c, r } };
  int row = 0;
  for (const auto& [badA, badB, badC, badR] : bad)
  {
    Vec3 x(7);
    EXPECT_FALSE(this->Kernel.solveFrame(badA, badB, badC, badR, x)) << "row " << row;
    EXPECT_EQ(x, Vec3(0)) << "row " << row;
    ++row;
  }
}

TYPED_TEST(FrameKernel, TakesTheZeroVector)
{
  using Vec3 = typename TestFixture::Vec3;
  Vec3 x(7);
  EXPECT_TRUE(this->Kernel.solveFrame(Vec3(1, 0, 0), Vec3(0, 2, 0), Vec3(1, 1, 1), Vec3(0), x));
  EXPECT_EQ(x, Vec3(0));
}
