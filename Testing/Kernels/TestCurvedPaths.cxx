// Ways through a height map over bases that are no parabola: circles, distances across the view ray, and
// cubics, against the geometry that they stand for; and what a search meets on them.

#include "KernelTypes.h"

#include <algorithm>
#include <cmath>

struct FloatPaths : FloatKernels
{
  using AcrossField = MesoKernels::Float::AcrossField;
  using CircleField = MesoKernels::Float::CircleField;
  using CubicField = MesoKernels::Float::CubicField;
};

struct DoublePaths : DoubleKernels
{
  using AcrossField = MesoKernels::Double::AcrossField;
  using CircleField = MesoKernels::Double::CircleField;
  using CubicField = MesoKernels::Double::CubicField;
};

template <typename Kernels>
class CurvedPaths : public KernelTest<Kernels>
{
public:
  using AcrossField = typename Kernels::AcrossField;
  using CircleField = typename Kernels::CircleField;
  using CubicField = typename Kernels::CubicField;
  using typename KernelTest<Kernels>::Vec2;

  /// A map of one height.
  template <typename Field>
  static Field Flat(float height)
  {
    return Field(4, 4, MesoWrap::Repeat, std::vector<float>(16, height));
  }
  double RandomCurvature()
  {
    const double size = std::pow(10., this->Random(-9., 0.));
    return this->Random(-1., 1.) < 0. ? -size : size;
  }
};
using BothPaths = testing::Types<FloatPaths, DoublePaths>;
TYPED_TEST_SUITE(CurvedPaths, BothPaths, KernelNames);

TYPED_TEST(CurvedPaths, ACirclesDepthAndArcAreThoseOfTheCircle)
{
  using Real = typename TestFixture::Real;
  const auto field = this->template Flat<typename TestFixture::CircleField>(0.5f);
  double naiveWorst = 0.;
  for (int run = 0; run < 100000; ++run)
  {
    const Real curvature = Real(this->RandomCurvature());
    const Real x = this->Random(-0.9, 0.9);
    const Real z = this->Random(-0.1, 0.9);
    const long double k = curvature;
    const long double radius = 1 / k;
    const long double side = k > 0 ? 1 : -1;
    const long double depth = side *
      (std::abs(radius) - std::sqrt(static_cast<long double>(x) * x + (radius - z) * (radius - z)));
    // Three products of numbers below 2; long double cancels in 1 / k at 1e-19 / k.
    const double bound = 16. * double(this->Epsilon) + 1e-18 / std::abs(double(k));
    ASSERT_NEAR(field.depthBelowCircle(curvature, x, z), double(depth), bound) << curvature;
    const long double arc = std::atan2(k * x, 1 - k * z) / (k * x);
    if (x != 0)
    {
      ASSERT_NEAR(field.arcPerLength(curvature, x, z) / Real(arc), 1.,
        16. * double(this->Epsilon) / std::max(0.05, 1. - double(k) * double(z)) + 3e-8)
        << curvature << " " << x << " " << z;
    }
    const Real r = 1 / curvature;
    const Real naive = Real(side) * (std::abs(r) - std::sqrt(x * x + (r - z) * (r - z)));
    naiveWorst = std::max(naiveWorst, std::abs(double(naive) - double(depth)));
  }
  EXPECT_GT(naiveWorst, 1e4 * double(this->Epsilon)) << "the difference is as good";
}

TYPED_TEST(CurvedPaths, OnACircleARayMeetsAFloorInClosedForm)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  int hits = 0;
  int misses = 0;
  for (int run = 0; run < 3000; ++run)
  {
    const float height = float(this->Random(0.1, 0.9));
    const auto field = this->template Flat<typename TestFixture::CircleField>(height);
    const double floor = 1. - double(height);
    const double curvature = this->Random(-0.6, 0.8);
    const double angle = this->Random(0.05, 1.55);
    const double along = std::sin(angle);
    const double down = std::cos(angle);
    Real time;
    const auto path = field.circlePath(Real(curvature), Vec2(0.3, 0.4), 0, Vec2(along, 2. * along),
      Real(along), Real(down), field.QuadricNever, time);
    const auto hit = field.searchLinearBinary(path, 256, 8);
    // 2 c t - k t^2 = 2 d - k d^2.
    const double wanted = 2. * floor - curvature * floor * floor;
    const double discriminant = down * down - curvature * wanted;
    if (std::abs(discriminant) < 0.01)
    {
      continue; // touches the floor for less than a step
    }
    ASSERT_EQ(hit.Hit, discriminant > 0.) << "run " << run;
    hits += hit.Hit ? 1 : 0;
    misses += hit.Hit ? 0 : 1;
    if (hit.Hit)
    {
      const double t = wanted / (down + std::sqrt(discriminant));
      const double bound = 1e-4 + 3e3 * double(this->Epsilon);
      ASSERT_NEAR(double(hit.Part) * double(time), t, bound);
      const double arc = std::abs(curvature) > 1e-12
        ? std::atan2(curvature * along * t, 1. - curvature * down * t) / curvature
        : along * t;
      ASSERT_NEAR(hit.MapCoord.x, 0.3 + arc, bound);
      ASSERT_NEAR(hit.MapCoord.y, 0.4 + 2. * arc, 2. * bound);
      ASSERT_NEAR(hit.Relief, floor, bound);
    }
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(misses, 200);
}

TYPED_TEST(CurvedPaths, ARayFromInsideLeavesTheShellOfACircle)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const auto field = this->template Flat<typename TestFixture::CircleField>(0.5f);
  int tops = 0;
  for (int run = 0; run < 20000; ++run)
  {
    const Real curvature = this->Random(-0.6, 0.8);
    const Real start = this->Random(0.05, 0.95);
    const double angle = this->Random(0., 3.14);
    const Real along = Real(std::sin(angle));
    const Real down = Real(std::cos(angle));
    Real time;
    const auto path = field.circlePath(
      curvature, Vec2(0, 0), start, Vec2(1, 0), along, down, field.QuadricNever, time);
    if (!(time < 100))
    {
      continue; // along a base that is all but straight
    }
    tops += path.DepthEnd == 0 ? 1 : 0;
    const double there = field.depthBelowCircle(curvature, time * along, start + time * down);
    // A root's rounding, where the ray all but touches the shell's end.
    ASSERT_NEAR(there, path.DepthEnd, 64. * std::sqrt(double(this->Epsilon))) << "run " << run;
    const double half =
      field.depthBelowCircle(curvature, time / 2 * along, start + time / 2 * down);
    ASSERT_GT(half, -1e-3);
    ASSERT_LT(half, 1. + 1e-3);
  }
  EXPECT_GT(tops, 4000);
}

TYPED_TEST(CurvedPaths, BeyondTheCentreOfACircleThereIsAFloorStill)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const auto field = this->template Flat<typename TestFixture::CircleField>(0.f);
  for (const double curvature : { 0.97, 1., 1.5, 40., 1e6 })
  {
    for (const double angle : { 0., 0.1, 0.7, 1.5 })
    {
      Real time;
      const auto path = field.circlePath(Real(curvature), Vec2(0, 0), 0, Vec2(std::sin(angle), 0),
        Real(std::sin(angle)), Real(std::cos(angle)), field.QuadricNever, time);
      ASSERT_TRUE(field.pathIsSound(path));
      ASSERT_LT(double(time), 10.);
      for (int i = 0; i <= 64; ++i)
      {
        const Real part = Real(i) / 64;
        ASSERT_TRUE(std::isfinite(field.pathMap(path, part).x)) << curvature << " " << angle;
        ASSERT_TRUE(std::isfinite(field.pathDepth(path, part)));
      }
    }
    // Straight down, the floor is met.
    Real time;
    const auto down =
      field.circlePath(Real(curvature), Vec2(0, 0), 0, Vec2(0, 0), 0, 1, field.QuadricNever, time);
    ASSERT_EQ(down.DepthEnd, 1);
    ASSERT_TRUE(field.searchLinearBinary(down, 16, 5).Hit);
  }
}

TYPED_TEST(CurvedPaths, AcrossTheRayAFloorIsMetAtItsDistance)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  int hits = 0;
  for (int run = 0; run < 2000; ++run)
  {
    const float height = float(this->Random(0.1, 0.9));
    const auto field = this->template Flat<typename TestFixture::AcrossField>(height);
    const double angle = this->Random(0.1, 1.5);
    const Vec3 view(std::sin(angle), 0, std::cos(angle));
    const Vec3 across = field.acrossView(Vec3(0, 0, -1), view);
    const Vec3 quadric(this->Random(-1., 1.), this->Random(-1., 1.), this->Random(-1., 1.));
    Real time;
    const auto path =
      field.acrossPath(quadric, across, Vec2(0.2, 0.1), Vec3(0), view, field.QuadricNever, time);
    if (!(time < 20))
    {
      continue;
    }
    const auto hit = field.searchLinearBinary(path, 256, 8);
    if (hit.Hit && hit.Part < 1)
    {
      ++hits;
      const Real t = hit.Part * time;
      const double jump = 1e-3 + 1e3 * double(this->Epsilon);
      const double distance = field.distanceAcross(quadric, across, t * view);
      // At the floor's distance, or where distances jump over it.
      const double later = field.distanceAcross(quadric, across, t * Real(1.001) * view);
      ASSERT_TRUE(std::abs(distance - (1. - double(height))) < jump || later > 1. - double(height))
        << "run " << run << " distance " << distance;
      ASSERT_NEAR(hit.MapCoord.x, 0.2 + double(t * view.x), 1e-5);
    }
    else if (path.DepthEnd >= 1)
    {
      ASSERT_TRUE(hit.Hit) << "through the bottom in run " << run;
    }
  }
  EXPECT_GT(hits, 800);
}

TYPED_TEST(CurvedPaths, ACubicHasItsEndsAndRates)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  const auto field = this->template Flat<typename TestFixture::CubicField>(0.4f);
  for (int run = 0; run < 2000; ++run)
  {
    // Of a cubic a + b w + c w^2 + d w^3 in each coordinate.
    const Vec3 a(this->Random(0., 1.), this->Random(0., 1.), this->Random(0., 0.3));
    const Vec3 b(this->Random(-1., 1.), this->Random(-1., 1.), this->Random(0., 2.));
    const Vec3 c(this->Random(-1., 1.), this->Random(-1., 1.), this->Random(-1., 1.));
    const Vec3 d(this->Random(-1., 1.), this->Random(-1., 1.), this->Random(-1., 1.));
    const auto at = [&](Real w) { return a + w * (b + w * (c + w * d)); };
    const Vec3 end = at(1);
    const auto path =
      field.cubicPath(Vec2(a), b, a.z, Vec2(end), b + Real(2) * c + Real(3) * d, end.z, Real(0.25));
    for (const double w : { 0., 0.1, 0.5, 0.77, 1. })
    {
      const Vec3 expected = at(Real(w));
      ASSERT_NEAR(field.pathMap(path, Real(w)).x, expected.x, 32. * double(this->Epsilon));
      ASSERT_NEAR(field.pathMap(path, Real(w)).y, expected.y, 32. * double(this->Epsilon));
      ASSERT_NEAR(field.pathDepth(path, Real(w)), expected.z, 32. * double(this->Epsilon));
    }
    EXPECT_EQ(field.pathSteps(path, 64), 16);
    // The flat floor at depth 0.6 is met where the cubic's depth is 0.6 first.
    const auto hit = field.searchLinearBinary(path, 512, 10);
    if (hit.Hit)
    {
      ASSERT_NEAR(at(hit.Part).z, 0.6, 1e-4);
    }
  }
}
