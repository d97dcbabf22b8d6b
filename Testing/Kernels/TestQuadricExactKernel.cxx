// Distances across the view ray (Oliveira2005, section 3.1) against the geometry that defines them,
// at the discriminant's cases and where rays leave the shell.

#include "KernelTypes.h"

#include <algorithm>
#include <cmath>

template <typename Kernels>
class QuadricExactKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::Vec3;
  using Long3 = glm::vec<3, long double>;

  Vec3 RandomVector(double size)
  {
    return Vec3(this->Random(-size, size), this->Random(-size, size), this->Random(-size, size));
  }
  double RandomSign() { return this->Random(-1., 1.) < 0. ? -1. : 1.; }
  double RandomSize(double decades)
  {
    return this->RandomSign() * std::pow(10., this->Random(-decades, decades));
  }

  /// A ray into the surface (z down) at an angle to the normal, and its U, z down as well.
  struct View
  {
    Vec3 Direction;
    Vec3 Across;
  };
  View ViewAt(double angle, double azimuth) const
  {
    View view;
    view.Direction = Vec3(Real(std::sin(angle) * std::cos(azimuth)),
      Real(std::sin(angle) * std::sin(azimuth)), Real(std::cos(angle)));
    view.Across = this->Kernel.acrossView(Vec3(0, 0, -1), view.Direction);
    return view;
  }

  static long double Form(const Vec3& quadric, const Long3& m, const Long3& n)
  {
    return quadric.x * m.x * n.x + quadric.y * m.y * n.y + quadric.z * (m.x * n.y + m.y * n.x) / 2;
  }
  /// A, B and C of equation 6.
  static Long3 Coefficients(const Vec3& quadric, const Vec3& across, const Vec3& point)
  {
    const Long3 u(across);
    const Long3 p(point);
    return { Form(quadric, u, u), 2 * Form(quadric, p, u) - u.z, Form(quadric, p, p) - p.z };
  }
  /// What the kernel promises, in long double.
  static long double Expected(const Vec3& quadric, const Vec3& across, const Vec3& point)
  {
    const Long3 k = Coefficients(quadric, across, point);
    const long double discriminant = k.y * k.y - 4 * k.x * k.z;
    if (!(discriminant >= 0))
    {
      return -k.z;
    }
    const long double sum = -(k.y + std::copysign(std::sqrt(discriminant), k.y)) / 2;
    long double nearest = std::numeric_limits<long double>::infinity();
    for (const long double s : { sum / k.x, k.z / sum })
    {
      nearest = s > 0 && s < nearest ? s : nearest;
    }
    return nearest > 0 && nearest < 1e30L ? nearest : -k.z;
  }

  typename Kernels::QuadricExact Kernel;
};
TYPED_TEST_SUITE(QuadricExactKernel, BothKernels, KernelNames);

TYPED_TEST(QuadricExactKernel, AcrossIsAtRightAnglesInThePlaneOfRayAndNormal)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  double naiveWorst = 0.;
  for (int run = 0; run < 20000; ++run)
  {
    const Vec3 normal = glm::normalize(this->RandomVector(1.) + Vec3(2, 0, 0));
    const Vec3 aside = glm::normalize(glm::cross(normal, this->RandomVector(1.) + Vec3(0, 2, 0)));
    const double angle = std::pow(10., this->Random(-4., 0.19)); // to 90 degrees
    const Vec3 view =
      glm::normalize(Real(std::sin(angle)) * aside - Real(std::cos(angle)) * normal);
    const Vec3 across = this->Kernel.acrossView(normal, view);
    // The plane itself is known to Epsilon over the angle; in it the vector is right to rounding.
    const double room = 8. * double(this->Epsilon);
    ASSERT_NEAR(glm::length(across), 1., room);
    ASSERT_NEAR(glm::dot(across, view), 0., room);
    ASSERT_GT(glm::dot(across, normal), 0.);
    ASSERT_NEAR(glm::dot(across, glm::cross(normal, aside)), 0., room / angle);
    const Vec3 naive = glm::normalize(normal - glm::dot(normal, view) * view);
    naiveWorst = std::max(naiveWorst, std::abs(double(glm::dot(naive, view))));
  }
  EXPECT_GT(naiveWorst, 100. * double(this->Epsilon)) << "the difference is as good";
}

TYPED_TEST(QuadricExactKernel, AlongTheNormalThereIsNoAcross)
{
  using Vec3 = typename TestFixture::Vec3;
  EXPECT_EQ(this->Kernel.acrossView(Vec3(0, 0, 1), Vec3(0, 0, -1)), Vec3(0));
  EXPECT_EQ(this->Kernel.acrossView(Vec3(0, 0, 1), Vec3(0, 0, 1)), Vec3(0));
  // Equation 7 then.
  const Vec3 quadric(1, 2, 3);
  const Vec3 point(typename TestFixture::Real(0.1), 0, typename TestFixture::Real(0.5));
  EXPECT_EQ(this->Kernel.distanceAcross(quadric, Vec3(0), point),
    this->Kernel.distanceToQuadric(quadric, point));
}

TYPED_TEST(QuadricExactKernel, IsTheNearestPointAcross)
{
  using Vec3 = typename TestFixture::Vec3;
  const double epsilon = double(this->Epsilon);
  int byDistance = 0;
  int byDepth = 0;
  for (int run = 0; run < 200000; ++run)
  {
    const auto view = this->ViewAt(this->Random(0.01, 1.57), this->Random(0., 6.28));
    const Vec3 quadric(this->RandomSize(3.), this->RandomSize(3.), this->RandomSize(3.));
    const Vec3 point = this->Random(0., 2.) * view.Direction;
    const auto k = this->Coefficients(quadric, view.Across, point);
    const long double discriminant = k.y * k.y - 4 * k.x * k.z;
    // Rounding of each coefficient, against the parts that it is the sum of.
    const glm::dvec3 size = glm::abs(glm::dvec3(quadric));
    const double most = size.x + size.y + size.z;
    const double of = double(glm::dot(point, point));
    const double roundA = 4. * epsilon * most;
    const double roundB = 8. * epsilon * (most * std::sqrt(of) + 1.);
    const double roundC = 8. * epsilon * (most * of + std::sqrt(of));
    const double roundD = 2. * std::abs(double(k.y)) * roundB + roundB * roundB +
      4. * (std::abs(double(k.x)) * roundC + std::abs(double(k.z)) * roundA + roundA * roundC) +
      4. * epsilon * (double(k.y * k.y) + 4. * std::abs(double(k.x * k.z)));
    if (std::abs(double(discriminant)) < 4. * roundD || std::abs(double(k.x)) < roundA ||
      std::abs(double(k.y)) < roundB || std::abs(double(k.z)) < 2. * roundC || k.z > 0)
    {
      continue; // both answers are right to within rounding, or the point lies above
    }
    const double expected = double(this->Expected(quadric, view.Across, point));
    const double found = this->Kernel.distanceAcross(quadric, view.Across, point);
    const double root = std::sqrt(std::abs(double(discriminant)));
    (discriminant > 0 ? byDistance : byDepth) += 1;
    // First order of the rounded coefficients over the root, and of the division.
    const double bound = discriminant > 0
      ? (roundC + expected * roundB + expected * expected * roundA) / root * 2. +
        8. * epsilon * expected + expected * roundD / (double(discriminant))
      : roundC;
    ASSERT_NEAR(found, expected, bound) << "run " << run;
  }
  EXPECT_GT(byDistance, 30000);
  EXPECT_GT(byDepth, 5000);
}

TYPED_TEST(QuadricExactKernel, KeepsTheDigitsThatTheReportsFormulaLoses)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  // All but flat along U: A = 1e-3 of an epsilon.
  const auto view = this->ViewAt(0.8, 0.);
  const Vec3 quadric(Real(1e-3) * this->Epsilon, 0, 0);
  const Vec3 point = Real(0.5) * view.Direction;
  const double expected = double(this->Expected(quadric, view.Across, point));
  EXPECT_NEAR(
    this->Kernel.distanceAcross(quadric, view.Across, point), expected, 8. * double(this->Epsilon));
  const Real a = quadric.x * view.Across.x * view.Across.x;
  const Real b = 2 * quadric.x * point.x * view.Across.x - view.Across.z;
  const Real c = quadric.x * point.x * point.x - point.z;
  const double naive = (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
  EXPECT_GT(std::abs(naive - expected), 0.1) << "the report's formula is as good";
}

TYPED_TEST(QuadricExactKernel, OnAPlaneIsTheDepthOverTheSineOfTheViewAngle)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  for (const double degrees : { 0.1, 1., 10., 45., 80., 89.9 })
  {
    const double angle = degrees * 3.14159265358979 / 180.;
    const auto view = this->ViewAt(angle, 0.7);
    const double found =
      this->Kernel.distanceAcross(Vec3(0), view.Across, Real(0.3) * view.Direction);
    const double expected = 0.3 * std::cos(angle) / std::sin(angle);
    // U is known to rounding over the sine.
    EXPECT_NEAR(found / expected, 1., 16. * double(this->Epsilon) / std::sin(2. * angle));
  }
}

TYPED_TEST(QuadricExactKernel, BehindThePointThereIsNoDistance)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  // A point of a light's ray above the tangent plane of a concave base, a little below the base: the
  // line along U meets the base behind the point only, and the report's formula says so, as if the
  // point lay outside.
  const auto view = this->ViewAt(0.7853981633974483, 0.);
  const Vec3 quadric(-1, 0, 0);
  const Vec3 point(Real(0.8), 0, Real(-0.6));
  const auto k = this->Coefficients(quadric, view.Across, point);
  const long double discriminant = k.y * k.y - 4 * k.x * k.z;
  ASSERT_GT(double(discriminant), 0.);
  ASSERT_LT(double((-k.y + std::sqrt(discriminant)) / (2 * k.x)), 0.) << "the report's";
  EXPECT_NEAR(
    this->Kernel.distanceAcross(quadric, view.Across, point), 0.04, 8. * double(this->Epsilon));
}

TYPED_TEST(QuadricExactKernel, StaysFiniteForWhatNoSurfaceIsLike)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  const Real sizes[] = { 0, Real(1e-18), Real(1e-6), 1, Real(1e4) };
  for (const Real a : sizes)
  {
    for (const Real b : sizes)
    {
      for (int signs = 0; signs < 8; ++signs)
      {
        const Vec3 quadric(
          (signs & 1) != 0 ? -a : a, (signs & 2) != 0 ? -b : b, (signs & 4) != 0 ? a : -b);
        for (const double angle : { 0., 1e-7, 1e-4, 0.5, 1.5707, 1.57079632 })
        {
          const auto view = this->ViewAt(angle, 0.3);
          Real end = -1;
          const Real time =
            this->Kernel.leaveAcross(quadric, view.Across, Vec3(0), view.Direction, end);
          ASSERT_TRUE(time >= 0 && time <= this->Kernel.QuadricNever);
          ASSERT_TRUE(end == 0 || end == 1);
          for (const Real t : { Real(0), Real(1e-9), Real(0.1), Real(1000) })
          {
            ASSERT_TRUE(
              std::isfinite(this->Kernel.distanceAcross(quadric, view.Across, t * view.Direction)));
          }
        }
      }
    }
  }
}

TYPED_TEST(QuadricExactKernel, LeavesTheShellWhereTheDistanceSays)
{
  using Real = typename TestFixture::Real;
  using Vec3 = typename TestFixture::Vec3;
  int tops = 0;
  int bottoms = 0;
  for (int run = 0; run < 4000; ++run)
  {
    const auto view = this->ViewAt(this->Random(0.02, 1.55), this->Random(0., 6.28));
    const Vec3 quadric(this->Random(-3., 3.), this->Random(-3., 3.), this->Random(-3., 3.));
    // The eye's ray, or a light's from a point inside.
    Vec3 start(0);
    Vec3 direction = view.Direction;
    if (run % 2 == 1)
    {
      start = this->Random(0., 0.5) * view.Direction;
      direction = glm::normalize(this->RandomVector(1.) - Vec3(0, 0, 2));
      const Real depth = this->Kernel.distanceAcross(quadric, view.Across, start);
      if (!(depth > Real(0.05) && depth < Real(0.95)))
      {
        continue;
      }
    }
    Real end = -1;
    const Real time = this->Kernel.leaveAcross(quadric, view.Across, start, direction, end);
    const auto depthAt = [&](double t) {
      return double(this->Kernel.distanceAcross(quadric, view.Across, start + Real(t) * direction));
    };
    const double last = std::min(double(time), 50.);
    // Inside before, to within rounding that a root of the discriminant magnifies.
    const double step = std::max(last, 0.01) / 500.;
    for (int i = 1; i < 500 && last > 0.; ++i)
    {
      const double depth = depthAt(i * step);
      const double slack = 2e3 * std::sqrt(double(this->Epsilon)) * (i < 5 || i > 495 ? 1. : 0.02);
      ASSERT_TRUE(i * step > last || (depth > -slack && depth < 1. + slack))
        << "run " << run << " step " << i << " depth " << depth << " of time " << time;
    }
    if (time < this->Kernel.QuadricNever)
    {
      (end == 0 ? tops : bottoms) += 1;
      // Outside after, if only for a moment.
      bool outside = false;
      for (double later = 1e-7; later < 1e-2 && !outside; later *= 1.5)
      {
        const double after = depthAt(double(time) + later * (double(time) + 0.01));
        outside = end == 0 ? after <= 1e-3 : after >= 1. - 1e-3;
      }
      ASSERT_TRUE(outside) << "run " << run << " time " << time << " end " << end;
    }
  }
  EXPECT_GT(tops, 300);
  EXPECT_GT(bottoms, 1000);
}
