// Barycentric lattices point by point, steps on edges that neighbours share, and displaced normals
// against finite differences of the surface that they are of.

#include "KernelTypes.h"

#include <cmath>
#include <set>

template <typename Kernels>
class GridKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::Vec3;

  typename Kernels::Grid Kernel;
};
TYPED_TEST_SUITE(GridKernel, BothKernels, KernelNames);

TYPED_TEST(GridKernel, NumbersEachPointOnceRowByRow)
{
  int number = 0;
  for (int row = 0; row <= 2000; ++row)
  {
    for (int place = 0; place <= row; ++place)
    {
      const glm::ivec2 at = this->Kernel.latticePoint(number++);
      ASSERT_EQ(at.x, row - place) << number;
      ASSERT_EQ(at.y, place) << number;
    }
  }
}

TYPED_TEST(GridKernel, StepsOnAnEdgeAreAllItsSegmentsEndsFromEitherSide)
{
  for (int segments = 1; segments <= 40; ++segments)
  {
    for (int rows = segments; rows <= 80; ++rows)
    {
      std::set<int> met;
      int before = 0;
      for (int step = 0; step <= rows; ++step)
      {
        const int along = this->Kernel.stepOnEdge(step, rows, segments);
        ASSERT_GE(along, before);
        before = along;
        met.insert(along);
        // A neighbour that counts from the other end has its points at the same places.
        ASSERT_EQ(this->Kernel.stepOnEdge(rows - step, rows, -segments), along);
      }
      ASSERT_EQ(int(met.size()), segments + 1);
      ASSERT_EQ(*met.rbegin(), segments);
    }
  }
}

TYPED_TEST(GridKernel, DerivativesAreThoseOfALinearFunction)
{
  for (int run = 0; run < 1000; ++run)
  {
    const auto random = [&]() { return this->Random(-2., 2.); };
    using Vec2 = typename TestFixture::Vec2;
    using Vec3 = typename TestFixture::Vec3;
    const Vec3 perU(random(), random(), random());
    const Vec3 perV(random(), random(), random());
    const Vec2 a(random(), random());
    const Vec2 b(random(), random());
    const double area = std::abs(double(a.x) * b.y - double(a.y) * b.x);
    Vec3 foundU;
    Vec3 foundV;
    const bool found = this->Kernel.perMapCoord(a, b, typename TestFixture::Real(0.2),
      a.x * perU + a.y * perV, b.x * perU + b.y * perV, foundU, foundV);
    if (std::abs(area - 0.2) > 1e-5)
    {
      ASSERT_EQ(found, area > 0.2);
    }
    const double most = 400. * double(this->Epsilon);
    ASSERT_LT(glm::length(foundU - (found ? perU : Vec3(0))), most);
    ASSERT_LT(glm::length(foundV - (found ? perV : Vec3(0))), most);
  }
}

namespace
{
/// A sphere of radius 2 over its angles u and v, and relief on it.
struct Ball
{
  double Scale = 0.3;
  double Reference = 0.25;

  static glm::dvec3 Normal(double u, double v)
  {
    return { std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v) };
  }
  static double Height(double u, double v)
  {
    return 0.5 + 0.3 * std::sin(5. * u + 1.) * std::cos(4. * v);
  }
  static glm::dvec2 Gradient(double u, double v)
  {
    return { 1.5 * std::cos(5. * u + 1.) * std::cos(4. * v),
      -1.2 * std::sin(5. * u + 1.) * std::sin(4. * v) };
  }
  glm::dvec3 At(double u, double v) const
  {
    return (2. + this->Scale * (Height(u, v) - this->Reference)) * Normal(u, v);
  }
  /// By central differences.
  glm::dvec3 TrueNormal(double u, double v) const
  {
    const double step = 1e-5;
    return glm::normalize(glm::cross(this->At(u + step, v) - this->At(u - step, v),
      this->At(u, v + step) - this->At(u, v - step)));
  }
};

double Degrees(const glm::dvec3& a, const glm::dvec3& b)
{
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180. / std::acos(-1.);
}
}

TYPED_TEST(GridKernel, NormalsAreThoseOfTheDisplacedSurface)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  using Real = typename TestFixture::Real;
  const Ball ball;
  double worst = 0.;
  double worstFirstOrder = 0.;
  for (int run = 0; run < 2000; ++run)
  {
    const double u = this->Random(-3., 3.);
    const double v = this->Random(-1.2, 1.2);
    const glm::dvec3 n = Ball::Normal(u, v);
    const glm::dvec3 perU(-std::cos(v) * std::sin(u), std::cos(v) * std::cos(u), 0.);
    const glm::dvec3 perV(-std::sin(v) * std::cos(u), -std::sin(v) * std::sin(u), std::cos(v));
    const auto normal = [&](double turn, double mirror)
    {
      // Positions are twice as far out as unit normals. Mirrored: u counts backwards.
      return glm::dvec3(this->Kernel.displacedNormal(Vec3(mirror * 2. * perU), Vec3(2. * perV),
        Vec3(n), Vec3(mirror * turn * perU), Vec3(turn * perV),
        Vec2(glm::dvec2(mirror, 1.) * Ball::Gradient(u, v)),
        Real(Ball::Height(u, v) - ball.Reference), Real(ball.Scale)));
    };
    const glm::dvec3 truth = ball.TrueNormal(u, v);
    worst = std::max({ worst, Degrees(normal(1., 1.), truth), Degrees(normal(1., -1.), truth) });
    worstFirstOrder = std::max(worstFirstOrder, Degrees(normal(0., 1.), truth));
  }
  EXPECT_LT(worst, sizeof(Real) == sizeof(float) ? 5e-4 : 1e-6);
  // Without the base's curvature slopes are too steep by (h - r) D / R, up to 8 %.
  EXPECT_GT(worstFirstOrder, 0.5);
  EXPECT_LT(worstFirstOrder, 3.);
}

TYPED_TEST(GridKernel, NormalsOfNoReliefAreTheBases)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  using Real = typename TestFixture::Real;
  const Vec3 normal = glm::normalize(Vec3(1, 2, 3));
  const Vec3 zero(0);
  const auto with = [&](const Vec3& perU, const Vec3& perV, const Vec2& gradient)
  {
    return this->Kernel.displacedNormal(
      perU, perV, normal, zero, zero, gradient, Real(-0.5), Real(0.1));
  };
  EXPECT_LT(Degrees(with(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec2(0)), normal), 1e-4);
  // Neither direction nor side: collapsed coordinates, what is not finite.
  EXPECT_EQ(with(zero, Vec3(0, 1, 0), Vec2(1, 1)), normal);
  EXPECT_EQ(with(Vec3(1, 0, 0), Vec3(2, 0, 0), Vec2(0)), normal);
  EXPECT_EQ(with(Vec3(Real(NotANumber)), Vec3(0, 1, 0), Vec2(1, 1)), normal);
  EXPECT_EQ(with(Vec3(1, 0, 0), Vec3(0, 1, 0), Vec2(Real(Infinite), 0)), normal);
}
