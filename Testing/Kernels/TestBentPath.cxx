// leaveShell and the search along bent paths: where rays leave the shell, against the roots in
// double, and what they meet on the way, in closed form.

#include "KernelTypes.h"

#include <cmath>

template <typename Kernels>
class BentPath : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::HeightField;

  double RandomSize() { return std::pow(10., this->Random(-6., 6.)); }
  double RandomSign() { return this->Random(-1., 1.) < 0. ? -1. : 1.; }

  /// The first root of depth + slope t - bend t^2 = 0 or 1 by the textbook's formula in long double,
  /// or infinity.
  static long double FirstRoot(
    long double depth, long double slope, long double bend, long double target)
  {
    const long double c = depth - target;
    const long double never = std::numeric_limits<long double>::infinity();
    if (bend == 0)
    {
      const long double t = slope == 0 ? never : -c / slope;
      return t > 0 ? t : never;
    }
    const long double discriminant = slope * slope + 4 * bend * c;
    if (discriminant < 0)
    {
      return never;
    }
    const long double root = std::sqrt(discriminant);
    long double first = never;
    for (const long double t : { (slope - root) / (2 * bend), (slope + root) / (2 * bend) })
    {
      first = t > 0 && t < first ? t : first;
    }
    return first;
  }

  typename KernelTest<Kernels>::Quadric Kernel;
};
TYPED_TEST_SUITE(BentPath, BothKernels, KernelNames);

TYPED_TEST(BentPath, LeavesTheShellAtTheFirstRoot)
{
  using Real = typename TestFixture::Real;
  int tops = 0;
  int bottoms = 0;
  for (int run = 0; run < 200000; ++run)
  {
    const Real depth = this->Random(0., 1.);
    const Real slope = Real(this->RandomSign() * this->RandomSize());
    const Real bend = Real(this->RandomSign() * this->RandomSize());
    Real end;
    const Real found = this->Kernel.leaveShell(depth, slope, bend, end);
    const long double top = this->FirstRoot(depth, slope, bend, 0);
    const long double bottom = this->FirstRoot(depth, slope, bend, 1);
    // Where the ray all but touches the bottom, both answers are right to within rounding.
    const double discriminant = double(slope) * slope - 4. * double(bend) * (1. - double(depth));
    if (slope > 0 && std::abs(discriminant) < 1e-5 * double(slope) * slope)
    {
      continue;
    }
    const long double first = std::min(top, bottom);
    (end == 0 ? tops : bottoms) += 1;
    ASSERT_EQ(end, top < bottom ? 0 : 1) << depth << " " << slope << " " << bend;
    // The discriminant's rounding counts for more the nearer it is to 0.
    const double condition = 1. + double(slope) * slope / std::abs(discriminant);
    // The textbook's root itself cancels, in its 64 bits.
    const double room = std::min(double(depth), 1. - double(depth));
    const double textbook = 1e-18 * (1. + double(slope) * slope / (std::abs(double(bend)) * room));
    ASSERT_NEAR(double(found / Real(first)), 1., 8. * double(this->Epsilon) * condition + textbook)
      << depth << " " << slope << " " << bend;
  }
  EXPECT_GT(tops, 20000);
  EXPECT_GT(bottoms, 20000);
}

TYPED_TEST(BentPath, KeepsTheDigitsThatTheTextbookLoses)
{
  using Real = typename TestFixture::Real;
  // All but straight: the bottom is met at 1 + bend, to first order.
  const Real bend = Real(0.3) * this->Epsilon;
  Real end;
  const Real found = this->Kernel.leaveShell(0, 1, bend, end);
  EXPECT_EQ(end, 1);
  EXPECT_NEAR(found, 1 + bend, 2 * this->Epsilon);
  const Real naive = (1 - std::sqrt(1 - 4 * bend)) / (2 * bend);
  EXPECT_GT(std::abs(naive - 1), 0.01) << "the textbook's formula is as good";
}

TYPED_TEST(BentPath, EdgesOfTheShell)
{
  using Real = typename TestFixture::Real;
  const Real never = this->Kernel.QuadricNever;
  struct Case
  {
    Real Depth, Slope, Bend, Time, End;
  };
  const Case cases[] = {
    { 0, 2, 0, Real(0.5), 1 },                                 // straight down
    { 0, 2, 4, Real(0.5), 0 },                                 // back at the surface
    { 0, -1, 3, 0, 0 },                                        // leaves at once,
    { 0, -1, -3, 0, 0 },                                       // even where it would come back
    { 0, 0, 1, 0, 0 },                                         // along a convex base
    { Real(0.5), 0, 0, never, 1 },                             // along a plane
    { Real(0.5), 0, 2, Real(0.5), 0 },                         // along a convex base, inside
    { Real(0.5), 0, -2, Real(0.5), 1 },                        // and along a concave one
    { Real(0.75), -1, Real(0.25), std::sqrt(Real(7)) - 2, 0 }, // up
    { Real(0.75), -1, -1, (1 + std::sqrt(Real(2))) / 2, 1 },   // up, but the base comes up faster
    { 1, 1, 0, 0, 1 },                                         // at the bottom, down
    { 1, -2, 0, Real(0.5), 0 },                                // at the bottom, up
  };
  for (const Case& c : cases)
  {
    Real end = -1;
    const Real time = this->Kernel.leaveShell(c.Depth, c.Slope, c.Bend, end);
    EXPECT_NEAR(
      time / std::max(c.Time, Real(1)), c.Time / std::max(c.Time, Real(1)), 4 * this->Epsilon)
      << c.Depth << " " << c.Slope << " " << c.Bend;
    EXPECT_EQ(end, c.End) << c.Depth << " " << c.Slope << " " << c.Bend;
  }
}

TYPED_TEST(BentPath, MeetsAFlatFloorInClosedForm)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  // Over a sphere-like base a ray meets the floor at depth d where slope t - bend t^2 = d; what
  // comes back before that depth misses.
  int hits = 0;
  int misses = 0;
  for (int run = 0; run < 3000; ++run)
  {
    const float height = float(this->Random(0.05, 0.95));
    const typename TestFixture::HeightField field(
      4, 4, MesoWrap::Repeat, std::vector<float>(16, height));
    const double floor = 1. - double(height);
    const Real slope = this->Random(0.1, 4.);
    const Real bend = this->Random(-2., 4.);
    const Vec2 rate(this->Random(-1., 1.), this->Random(-1., 1.));
    Real end;
    const Real time = this->Kernel.leaveShell(0, slope, bend, end);
    const Vec2 start(this->Random(0., 1.), this->Random(0., 1.));
    const auto path = field.bentPath(start, rate, 0, end, bend, time);
    const auto hit = field.searchLinearBinary(path, 64, 7);
    const double discriminant = double(slope) * slope - 4. * double(bend) * floor;
    if (std::abs(discriminant) < 0.02)
    {
      continue; // touches the floor for less than a step
    }
    ASSERT_EQ(hit.Hit, discriminant > 0.);
    hits += hit.Hit ? 1 : 0;
    misses += hit.Hit ? 0 : 1;
    if (hit.Hit)
    {
      const double expected = 2. * floor / (double(slope) + std::sqrt(discriminant));
      // In the last of 64 * 2^7 parts the parabola is taken as straight.
      const double part = double(time) / (64 << 7);
      const double bound = std::abs(double(bend)) * part * part / std::sqrt(discriminant) +
        64. * double(this->Epsilon) * double(time) * (1. + 1. / std::sqrt(discriminant));
      ASSERT_NEAR(hit.Part * time, expected, bound);
      ASSERT_NEAR(hit.MapCoord.x, double(start.x) + expected * double(rate.x),
        bound + 4. * double(this->Epsilon));
      ASSERT_NEAR(
        hit.Relief, floor, 64. * double(this->Epsilon) + std::abs(double(bend)) * part * part);
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 100);
}

TYPED_TEST(BentPath, IsTheStraightOneWhereNothingBends)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const typename TestFixture::HeightField field(16, 16, MesoWrap::Repeat, this->RandomHeights(256));
  for (int run = 0; run < 300; ++run)
  {
    const Vec2 start(this->Random(0., 1.), this->Random(0., 1.));
    const Vec2 rate(this->Random(-0.2, 0.2), this->Random(-0.2, 0.2));
    Real end;
    const Real time = this->Kernel.leaveShell(0, 1, 0, end);
    const auto bent = field.searchLinearBinary(field.bentPath(start, rate, 0, end, 0, time), 64, 7);
    const auto straight = field.searchLinearBinary(field.straightPath(start, rate, 0, 1), 64, 7);
    ASSERT_EQ(bent.MapCoord, straight.MapCoord);
    ASSERT_EQ(bent.RayDepth, straight.RayDepth);
    ASSERT_EQ(bent.Fetches, straight.Fetches);
  }
}

TYPED_TEST(BentPath, ShadowsBendWithTheBase)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  // Ground at depth 0.8 with a wall one texel wide, up to depth 0.3, half a tile away. A ray that
  // rises from the ground by 0.2 a tile passes below the wall's top over a plane; a convex base
  // falls away beneath it, and lets it pass.
  std::vector<float> heights(32, 0.2f);
  heights[16] = 0.7f;
  const typename TestFixture::HeightField field(32, 1, MesoWrap::Clamp, heights);
  const auto blocked = [&](Real bend)
  {
    Real end;
    const Real time = this->Kernel.leaveShell(Real(0.79), Real(-0.2), bend, end);
    int fetches;
    return field.occludedLinear(
      field.bentPath(Vec2(0, 0), Vec2(1, 0), Real(0.79), end, bend, time), 256, fetches);
  };
  EXPECT_EQ(blocked(0), 1);
  EXPECT_EQ(blocked(1), 1); // depth 0.44 at the wall
  EXPECT_EQ(blocked(2), 0); // depth 0.19
  EXPECT_EQ(blocked(Real(-0.2)), 1);
}
