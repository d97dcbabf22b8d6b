// Cones: no step along a path goes through relief, whatever the path's bend; and the search that takes
// such steps ends, hits what is there and finds what equal steps find.

#include "HeightSearchCases.h"

template <typename Kernels>
class ConeSearch : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::HeightField;
  using Path = typename HeightField::HeightPath;

  Path RandomPath(const SearchMap& map, double sag)
  {
    const double length = std::pow(10., double(this->Random(-0.5, 2.)));
    const double azimuth = double(this->Random(0., 6.2832));
    const Vec2 size(Real(map.Width), Real(map.Height));
    Path path;
    path.MapStart = Vec2(this->Random(-1.5, 2.5), this->Random(-1.5, 2.5));
    path.MapSpan = Vec2(Real(length * std::cos(azimuth)), Real(length * std::sin(azimuth))) / size;
    path.DepthStart = this->Random(-0.1, 0.6);
    path.DepthEnd = this->Random(0., 1.);
    path.Sag = Real(sag);
    return path;
  }

  /// What numbers of this kind, and MesoMakeHeightCones, may be off by in depth.
  double Tolerance(const TrueClearance& truth) const
  {
    return 6. * double(this->Epsilon) * (truth.Size() + truth.DepthSize()) + 2e-7;
  }
};
TYPED_TEST_SUITE(ConeSearch, BothKernels, KernelNames);

TYPED_TEST(ConeSearch, StepsGoThroughNoRelief)
{
  using Real = typename TestFixture::Real;
  int longSteps = 0;
  for (const SearchMap& map : HardMaps(this->Generator))
  {
    for (MesoWrap wrap : AllWraps)
    {
      const auto field = FieldOf<typename TestFixture::HeightField>(map, wrap);
      for (int run = 0; run < 1500; ++run)
      {
        // Concave bases bend into the cone: what is free for a straight ray is not for theirs.
        const double sags[] = { 0., this->Random(0., 3.), this->Random(-3., 0.) };
        const auto path = this->RandomPath(map, sags[run % 3]);
        const auto near = field.pathNearOrigin(path);
        const TrueClearance truth(map, wrap, near);
        const Real part = this->Random(0., 1.);
        const double free = double(field.freePartAt(field.texelPath(near, 0), part));
        ASSERT_GE(free, 0.);
        const double end = std::min(1., double(part) + free);
        longSteps += (end - double(part)) * truth.Size() > 4. ? 1 : 0;
        for (int i = 0; free > 0. && i <= 64; ++i)
        {
          const double there = double(part) + i / 64. * (end - double(part));
          ASSERT_GE(truth.At(there), -this->Tolerance(truth))
            << map.Name << ", wrap " << MesoName(wrap) << ", sag " << path.Sag << ", from " << part
            << " by " << free << ", inside at " << there;
        }
      }
    }
  }
  EXPECT_GT(longSteps, 10000); // else nothing has been tried
}

TYPED_TEST(ConeSearch, EndsAtItsStepsAndOnTheRelief)
{
  for (const SearchMap& map : HardMaps(this->Generator))
  {
    for (MesoWrap wrap : AllWraps)
    {
      const auto field = FieldOf<typename TestFixture::HeightField>(map, wrap);
      for (int run = 0; run < 300; ++run)
      {
        const auto path = this->RandomPath(map, run % 2 == 0 ? 0. : double(this->Random(-2., 2.)));
        const TrueClearance truth(map, wrap, path);
        const auto hit = field.searchCone(path, 24, 6);
        ASSERT_LE(hit.Iterations, 24 + 6) << map.Name;
        if (hit.Hit && hit.Part > 0)
        {
          // Within the last bracket of 1/24, halved six times.
          const double slope = truth.Size() + truth.DepthSize();
          ASSERT_LE(
            std::abs(truth.At(double(hit.Part))), slope / (24 << 6) + this->Tolerance(truth));
        }
        int fetches = 0;
        field.occludedCone(path, 24, fetches);
        ASSERT_LE(fetches, 2 * 24);
      }
    }
  }
}

TYPED_TEST(ConeSearch, FindsALevelAsItFindsAMapOfItsOwn)
{
  for (const SearchMap& map : HardMaps(this->Generator))
  {
    const auto pyramid = MesoMakeHeightPyramid(map.Width, map.Height, map.Heights.data());
    for (int number = 1; number <= static_cast<int>(pyramid.size()); ++number)
    {
      const SearchMap level = LevelOf(map, pyramid, number);
      for (MesoWrap wrap : AllWraps)
      {
        const auto asLevel = FieldOf<typename TestFixture::HeightField>(map, wrap, pyramid, number);
        const auto asMap = FieldOf<typename TestFixture::HeightField>(level, wrap);
        for (int run = 0; run < 100; ++run)
        {
          const auto path = this->RandomPath(level, double(this->Random(-2., 2.)));
          const auto found = asLevel.searchCone(path, 24, 6);
          const auto expected = asMap.searchCone(path, 24, 6);
          ASSERT_EQ(found.Hit, expected.Hit) << map.Name << ", level " << number;
          ASSERT_EQ(found.Part, expected.Part) << map.Name << ", level " << number;
          int fetches = 0;
          int expectedFetches = 0;
          ASSERT_EQ(
            asLevel.occludedCone(path, 24, fetches), asMap.occludedCone(path, 24, expectedFetches));
          ASSERT_EQ(fetches, expectedFetches);
        }
      }
    }
  }
}

TYPED_TEST(ConeSearch, TakesFewStepsOverOpenGround)
{
  using Real = typename TestFixture::Real;
  // A post on a floor: cones carry a ray from afar near to it.
  std::vector<float> heights(64 * 64, 0.f);
  heights[32 * 64 + 32] = 1.f;
  const SearchMap map = { "post", 64, 64, heights };
  const auto field = FieldOf<typename TestFixture::HeightField>(map, MesoWrap::Repeat);
  const Real row = Real(32.5) / 64;
  const auto path = field.straightPath({ Real(0.1), row }, { Real(0.8), 0 }, Real(0.05), 1);
  const auto cone = field.searchCone(path, 256, 8);
  const auto linear = field.searchLinearBinary(path, 256, 8);
  ASSERT_TRUE(cone.Hit);
  ASSERT_TRUE(linear.Hit);
  EXPECT_NEAR(cone.RayDepth, linear.RayDepth, 1e-5);
  EXPECT_LT(cone.Iterations, linear.Iterations / 3);
  // Light that comes over the floor is not blocked, light from behind the post is.
  int fetches = 0;
  EXPECT_EQ(
    field.occludedCone(
      field.straightPath({ Real(0.7), row }, { Real(-0.6), 0 }, Real(0.9), 0), 256, fetches),
    0);
  EXPECT_EQ(field.occludedCone(
              field.straightPath({ Real(0.7), row }, { Real(-0.6), 0 }, Real(0.9), Real(0.6)), 256,
              fetches),
    0);
  EXPECT_EQ(field.occludedCone(
              field.straightPath({ Real(0.3), row }, { Real(-0.9), 0 }, Real(0.9), Real(0.5)), 256,
              fetches),
    1);
}
