// The rest of a path is the same way, and starts where it is outside.

#include "KernelTypes.h"

#include <cmath>

template <typename Kernels>
class PathCut : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::HeightField;
};

TYPED_TEST_SUITE(PathCut, BothKernels, KernelNames);

TYPED_TEST(PathCut, TheRestIsTheSameWay)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const typename TestFixture::HeightField field(4, 4, MesoWrap::Repeat, this->RandomHeights(16));
  for (int i = 0; i < 1000; ++i)
  {
    const auto whole = field.bentPath(Vec2(this->Random(-2., 2.), this->Random(-2., 2.)),
      Vec2(this->Random(-3., 3.), this->Random(-3., 3.)), this->Random(0., 1.),
      this->Random(0., 1.), this->Random(-1., 1.), this->Random(0.1, 2.));
    const Real from = this->Random(0., 1.);
    const auto rest = field.restOfPath(whole, from);
    const Real part = this->Random(0., 1.);
    const Real inWhole = from + (1 - from) * part;
    const Real tolerance = 40 * this->Epsilon;
    EXPECT_NEAR(field.pathDepth(rest, part), field.pathDepth(whole, inWhole), tolerance) << i;
    const Vec2 here = rest.MapStart + part * rest.MapSpan;
    const Vec2 there = whole.MapStart + inWhole * whole.MapSpan;
    EXPECT_NEAR(here.x, there.x, tolerance) << i;
    EXPECT_NEAR(here.y, there.y, tolerance) << i;
    EXPECT_EQ(rest.DepthEnd, whole.DepthEnd);
  }
}

TYPED_TEST(PathCut, StartsWhereThePathIsOutside)
{
  using Vec2 = typename TestFixture::Vec2;
  // A wall: height 1 for u in [1/4, 1/2], else 0; a level path at depth 1/2 runs along u.
  const typename TestFixture::HeightField field(64, 1, MesoWrap::Clamp,
    MakeHeights(64, 1, [](int column, int) { return column >= 16 && column < 32 ? 1. : 0.; }));
  auto path = field.straightPath(Vec2(0., 0.5), Vec2(0., 0.), 0.5, 0.5);
  path.MapSpan = Vec2(1., 0.);
  int fetches = 0;
  EXPECT_EQ(field.partOutside(path, 0.125, 64, fetches), 0.125);
  EXPECT_EQ(fetches, 1);
  // From inside the wall to the first step behind it: at most one of 64 after u = 1/2.
  const double outside = field.partOutside(path, 0.375, 64, fetches);
  EXPECT_GE(outside, 0.5);
  EXPECT_LE(outside, 0.5 + 1. / 64. + 1e-6);
  EXPECT_EQ(fetches, 1 + static_cast<int>(std::lround((outside - 0.375) * 64.)));
  // Inside to its end.
  path.MapSpan = Vec2(0.45, 0.);
  EXPECT_EQ(field.partOutside(path, 0.8, 64, fetches), 1.);
}
