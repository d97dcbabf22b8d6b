// The certified search misses nothing and finds nothing that is not there: random paths, straight and
// bent, over the maps on which others fail, in every wrap mode.

#include "HeightSearchCases.h"

#include <sstream>

template <typename Kernels>
class CertifiedSearch : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::HeightField;
  using Path = typename HeightField::HeightPath;

  enum class Bend
  {
    None,
    Convex,
    Concave
  };

  /// From above the map, at its top or in it, to anywhere.
  Path RandomPath(const SearchMap& map, Bend bend)
  {
    Path path;
    const double length = std::pow(10., double(this->Random(-1., 1.7))); // texels
    const double azimuth = this->Generator() % 4 == 0 ? 1.5707963267948966 * (this->Generator() % 4)
                                                      : double(this->Random(0., 6.2832));
    // Some run along lines of texel centres, where patches meet.
    const bool onLine = this->Generator() % 8 == 0;
    const Vec2 start(this->Random(-1.5, 2.5), this->Random(-1.5, 2.5));
    const Vec2 size(Real(map.Width), Real(map.Height));
    path.MapStart = onLine ? (glm::floor(start * size) + Real(0.5)) / size : start;
    path.MapSpan = Vec2(Real(length * std::cos(azimuth)), Real(length * std::sin(azimuth))) / size;
    const bool fromTop = this->Generator() % 2 == 0;
    path.DepthStart = fromTop ? Real(0) : this->Random(-0.2, 1.);
    path.DepthEnd = this->Generator() % 3 == 0 ? Real(1) : this->Random(0., 1.);
    path.Sag = bend == Bend::None ? Real(0)
      : bend == Bend::Convex      ? this->Random(0., 3.)
                                  : -this->Random(0., 3.);
    return path;
  }

  /// Depth by which numbers of this kind may be off: a few roundings of texel coordinates and depths,
  /// and what MesoMakeHeightCones rounds up, so that 8 bits stay what they are.
  double Tolerance(const TrueClearance& truth) const
  {
    return 6. * double(this->Epsilon) * (truth.Size() + truth.DepthSize()) + 2e-7;
  }

  /// texels: that the path may go over.
  void ExpectTrue(
    const HeightField& field, const TrueClearance& truth, double texels, const Path& path)
  {
    const double tolerance = this->Tolerance(truth);
    const auto hit = field.searchCertified(path);
    const double end = hit.Hit ? double(hit.Part) : 1.;
    const double least = truth.Least(end);
    if (hit.Hit)
    {
      // Past the first meeting by rounding alone; a start inside is the hit itself.
      ASSERT_TRUE(hit.Part == 0 || std::abs(truth.At(end)) <= tolerance)
        << "hits at " << end << " where the clearance is " << truth.At(end);
      ASSERT_TRUE(hit.Part != 0 || truth.At(0.) <= tolerance);
      ASSERT_NEAR(double(hit.RayDepth), truth.Depth(end), tolerance);
    }
    ASSERT_TRUE(hit.Part == 0 || !(least < -tolerance))
      << (hit.Hit ? "hits at " : "misses up to ") << end << " after clearance " << least;
    ASSERT_LE(hit.Iterations, texels);

    int fetches = 0;
    const bool blocked = field.occludedCertified(path, fetches) > 0;
    if (path.DepthStart > 0)
    {
      const double whole = truth.Least(1.);
      ASSERT_TRUE(blocked ? whole < tolerance : whole > -tolerance)
        << "blocked " << blocked << " with clearance " << whole;
    }
  }

  static double TexelsOf(const SearchMap& map, const Path& path)
  {
    return std::abs(path.MapSpan.x) * map.Width + std::abs(path.MapSpan.y) * map.Height + 4;
  }

  static std::string Describe(const SearchMap& map, MesoWrap wrap, const Path& path)
  {
    std::ostringstream text;
    text << map.Name << ", wrap " << MesoName(wrap) << std::hexfloat << ": start "
         << path.MapStart.x << " " << path.MapStart.y << ", span " << path.MapSpan.x << " "
         << path.MapSpan.y << ", depth " << path.DepthStart << " to " << path.DepthEnd << ", sag "
         << path.Sag;
    return text.str();
  }

  void ExpectTrueForAll(Bend bend, int raysPerCase)
  {
    for (const SearchMap& map : HardMaps(this->Generator))
    {
      for (MesoWrap wrap : AllWraps)
      {
        const auto field = FieldOf<HeightField>(map, wrap);
        for (int ray = 0; ray < raysPerCase; ++ray)
        {
          const Path path = this->RandomPath(map, bend);
          this->ExpectTrue(field, TrueClearance(map, wrap, path), TexelsOf(map, path), path);
          ASSERT_FALSE(this->HasFatalFailure()) << Describe(map, wrap, path);
        }
      }
    }
  }

  /// Levels of maps' pyramids, above the maps themselves.
  void ExpectTrueOnLevels(Bend bend, int raysPerLevel)
  {
    for (const SearchMap& map : HardMaps(this->Generator))
    {
      const auto pyramid = MesoMakeHeightPyramid(map.Width, map.Height, map.Heights.data());
      for (int number = 1; number <= static_cast<int>(pyramid.size()); ++number)
      {
        const SearchMap level = LevelOf(map, pyramid, number);
        for (MesoWrap wrap : AllWraps)
        {
          const auto field = FieldOf<HeightField>(map, wrap, pyramid, number);
          for (int ray = 0; ray < raysPerLevel; ++ray)
          {
            const Path path = this->RandomPath(level, bend);
            this->ExpectTrue(field, TrueClearance(level, wrap, path), TexelsOf(level, path), path);
            ASSERT_FALSE(this->HasFatalFailure())
              << Describe(map, wrap, path) << ", level " << number;
          }
        }
      }
    }
  }
};
TYPED_TEST_SUITE(CertifiedSearch, BothKernels, KernelNames);

// 14 maps, 3 wrap modes, 2 kinds of numbers: 84 cases, 1.008 million rays in all.
TYPED_TEST(CertifiedSearch, MissesNothingAlongStraightPaths)
{
  this->ExpectTrueForAll(TestFixture::Bend::None, 4000);
}

TYPED_TEST(CertifiedSearch, MissesNothingAlongPathsOverConvexBases)
{
  this->ExpectTrueForAll(TestFixture::Bend::Convex, 4000);
}

TYPED_TEST(CertifiedSearch, MissesNothingAlongPathsOverConcaveBases)
{
  this->ExpectTrueForAll(TestFixture::Bend::Concave, 4000);
}

TYPED_TEST(CertifiedSearch, MissesNothingOnLevelsOfThePyramid)
{
  for (auto bend :
    { TestFixture::Bend::None, TestFixture::Bend::Convex, TestFixture::Bend::Concave })
  {
    this->ExpectTrueOnLevels(bend, 600);
  }
}

TYPED_TEST(CertifiedSearch, HitsFlatGroundExactly)
{
  using Real = typename TestFixture::Real;
  for (MesoWrap wrap : AllWraps)
  {
    const SearchMap top = { "top", 3, 2, std::vector<float>(6, 1.f) };
    const SearchMap floor = { "floor", 3, 2, std::vector<float>(6, 0.f) };
    const SearchMap middle = { "middle", 3, 2, std::vector<float>(6, 0.25f) };
    for (int run = 0; run < 200; ++run)
    {
      const auto onTop = FieldOf<typename TestFixture::HeightField>(top, wrap);
      const auto onFloor = FieldOf<typename TestFixture::HeightField>(floor, wrap);
      const auto onMiddle = FieldOf<typename TestFixture::HeightField>(middle, wrap);
      const auto path = onTop.straightPath({ this->Random(-3., 3.), this->Random(-3., 3.) },
        { this->Random(-9., 9.), this->Random(-9., 9.) }, 0, 1);
      const auto high = onTop.searchCertified(path);
      EXPECT_TRUE(high.Hit);
      EXPECT_EQ(high.Part, 0);
      EXPECT_EQ(high.MapCoord, path.MapStart);
      // The path's end lies on the floor: it is met there, not missed.
      const auto low = onFloor.searchCertified(path);
      ASSERT_TRUE(low.Hit);
      EXPECT_EQ(low.Part, 1);
      EXPECT_EQ(low.RayDepth, 1);
      EXPECT_EQ(low.Iterations, 1); // one cone carries it there
      const auto between = onMiddle.searchCertified(path);
      ASSERT_TRUE(between.Hit);
      EXPECT_NEAR(between.RayDepth, 0.75, 64. * double(this->Epsilon));
      EXPECT_NEAR(
        onMiddle.searchCertified(onMiddle.straightPath({ 0, 0 }, { 0, 0 }, 0, 1)).RayDepth,
        Real(0.75), 2. * double(this->Epsilon));
    }
  }
}

TYPED_TEST(CertifiedSearch, GoesOnExactlyThousandsOfTilesAway)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  const SearchMap map = { "noise", 64, 64, this->RandomHeights(64 * 64) };
  const auto field = FieldOf<typename TestFixture::HeightField>(map, MesoWrap::Repeat);
  std::uniform_int_distribution<int> part(0, 511);
  for (int run = 0; run < 300; ++run)
  {
    const Vec2 entry(Real(part(this->Generator)) / 512, Real(part(this->Generator)) / 512);
    const Vec2 slope(this->Random(-0.3, 0.3), this->Random(-0.3, 0.3));
    const auto here = field.searchCertified(field.straightPath(entry, slope, 0, 1));
    const auto there =
      field.searchCertified(field.straightPath(entry + Vec2(10000, -10000), slope, 0, 1));
    ASSERT_TRUE(here.Hit && there.Hit);
    ASSERT_EQ(here.RayDepth, there.RayDepth);
  }
}

TYPED_TEST(CertifiedSearch, IsBoundedAndNeverEndsInAMiss)
{
  using Real = typename TestFixture::Real;
  // A groove between walls leads past more texels than the search goes over one by one.
  const SearchMap map = { "groove", 1, 4, { 0.f, 1.f, 1.f, 1.f } };
  const auto field = FieldOf<typename TestFixture::HeightField>(map, MesoWrap::Repeat);
  const Real middle = Real(0.125);
  auto path = field.straightPath({ 0, middle }, { 0, 0 }, Real(0.5), Real(0.9));
  path.MapSpan = { Real(200000), Real(1e-3) };
  const auto hit = field.searchCertified(path);
  EXPECT_TRUE(hit.Hit);
  EXPECT_LE(hit.Iterations, 65536);
  int fetches = 0;
  EXPECT_EQ(field.occludedCertified(path, fetches), 1);
  // What is not finite is no path.
  for (double odd : { NotANumber, Infinite })
  {
    path.Sag = Real(odd);
    EXPECT_FALSE(field.searchCertified(path).Hit);
    EXPECT_EQ(field.occludedCertified(path, fetches), 0);
  }
}
