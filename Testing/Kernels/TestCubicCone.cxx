// Steps along cubic paths by cones of free space: no relief is stepped through, over the maps on which
// others fail, and open ground takes few.

#include "HeightSearchCases.h"

#include <type_traits>

template <typename Kernels>
class CubicCone : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using Vec3 = glm::vec<3, Real>;
  using Field = std::conditional_t<sizeof(Real) == sizeof(float), MesoKernels::Float::CubicField,
    MesoKernels::Double::CubicField>;
  using Path = typename Field::HeightPath;

  /// A piece of a ray over a bent base: ends and rates that differ by as much as half a radian's turn makes
  /// them, and now and then a path that turns back.
  Path RandomPath(const Field& field, const SearchMap& map)
  {
    const double length = std::pow(10., double(this->Random(-0.5, 1.5))); // texels
    const double azimuth = this->Random(0., 6.2832);
    const Vec2 size(Real(map.Width), Real(map.Height));
    const Vec2 span =
      Vec2(Real(length * std::cos(azimuth)), Real(length * std::sin(azimuth))) / size;
    const Vec2 start(this->Random(-1.5, 2.5), this->Random(-1.5, 2.5));
    const Real depth = this->Random(-0.2, 0.8);
    const Real fall = this->Random(-0.3, 1.2);
    const double spread = this->Generator() % 8 == 0 ? 2.5 : 0.6;
    const auto rate = [&]
    {
      return Vec3(span.x * (1 + this->Random(-spread, spread)),
        span.y * (1 + this->Random(-spread, spread)), fall + this->Random(-1., 1.));
    };
    const Vec3 rateStart = rate();
    const Vec3 rateEnd = rate();
    return field.cubicPath(start, rateStart, depth, start + span, rateEnd, depth + fall, 1);
  }

  /// Clearance of a path at a part, in double, by the definition.
  static double TrueClearanceAt(
    const TrueSurface& surface, const SearchMap& map, const Path& path, double part)
  {
    const double at = double(path.Window.x) + part * double(path.Window.y);
    const auto on = [at](double start, double span, double sag, double twist)
    { return start + at * span + at * (1. - at) * (sag + at * twist); };
    const double x =
      on(path.MapStart.x, path.MapSpan.x, path.MapSag.x, path.MapTwist.x) * map.Width;
    const double y =
      on(path.MapStart.y, path.MapSpan.y, path.MapSag.y, path.MapTwist.y) * map.Height;
    const double depth = on(path.Depth0, path.DepthSpan, path.DepthSag, path.DepthTwist);
    return 1. -
      surface.Height(x - 0.5, y - 0.5, long(std::floor(x - 0.5)), long(std::floor(y - 0.5))) -
      depth;
  }
};
TYPED_TEST_SUITE(CubicCone, BothKernels, KernelNames);

TYPED_TEST(CubicCone, StepsGoThroughNoRelief)
{
  using Real = typename TestFixture::Real;
  int longSteps = 0;
  for (const SearchMap& map : HardMaps(this->Generator))
  {
    for (MesoWrap wrap : AllWraps)
    {
      const auto field = FieldOf<typename TestFixture::Field>(map, wrap);
      const TrueSurface surface(map, wrap);
      for (int run = 0; run < 600; ++run)
      {
        auto path = this->RandomPath(field, map);
        path = run % 3 == 0 ? field.restOfPath(path, this->Random(0., 0.9)) : path;
        const auto near = field.pathNearOrigin(path);
        const Real part = this->Random(0., 0.95);
        const double free = double(field.freePartAt(field.texelPath(near, 0), part));
        ASSERT_GE(free, 0.);
        const double end = std::min(1., double(part) + free);
        const double texels = (end - double(part)) * double(near.Window.y) *
          (std::abs(double(near.MapSpan.x)) * map.Width +
            std::abs(double(near.MapSpan.y)) * map.Height);
        longSteps += texels > 4. ? 1 : 0;
        for (int i = 0; free > 0. && i <= 100; ++i)
        {
          const double there = double(part) + i / 100. * (end - double(part));
          // Numbers are off by their rounding in texels, over which heights change by 1 at most.
          ASSERT_GE(TestFixture::TrueClearanceAt(surface, map, near, there),
            -400. * double(this->Epsilon) - 2e-7)
            << map.Name << ", wrap " << MesoName(wrap) << ", from " << part << " to " << end
            << " at " << there;
        }
      }
    }
  }
  EXPECT_GT(longSteps, 500);
}

TYPED_TEST(CubicCone, TakesFewStepsOverOpenGround)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  std::vector<float> heights(64 * 64, 0.1f);
  heights[32 * 64 + 50] = 1.f;
  const SearchMap map = { "a spike on a plain", 64, 64, heights };
  const auto field = FieldOf<typename TestFixture::Field>(map, MesoWrap::Clamp);
  // Past the spike, over a base that bends away.
  const auto path = field.cubicPath(
    Vec2(0.05, 0.3), Vec3(0.8, 0.1, 1.2), 0, Vec2(0.85, 0.42), Vec3(0.8, 0.14, 0.8), 1, 1);
  const auto few = field.searchCone(path, 256, 8);
  const auto many = field.searchLinearBinary(path, 4096, 8);
  ASSERT_TRUE(few.Hit && many.Hit);
  EXPECT_NEAR(few.Part, many.Part, 1e-4);
  EXPECT_LT(few.Iterations, 60); // of 256, 8 of them halvings
}
