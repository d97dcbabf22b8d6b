// Where a straight ray is over a base that is known by an image of it: a torus and a sphere, whose
// depths have a closed form.

#include "KernelTypes.h"

#include <cmath>
#include <functional>
#include <stdexcept>

namespace
{
/// An image of a base, read as the kernel asks for it.
template <typename Real>
class BaseTexels
{
public:
  using Vec2 = glm::vec<2, Real>;
  using Vec3 = glm::vec<3, Real>;
  using Vec4 = glm::vec<4, Real>;
  using Surface = std::function<glm::dvec3(double u, double v)>;

  /// Texel centres at (i + 0.5) / size of [0, 1] x [0, 1].
  void Bake(
    int columns, int rows, bool wrapsU, bool wrapsV, const Surface& position, const Surface& normal)
  {
    this->Size = { columns, rows };
    this->Wraps = { wrapsU, wrapsV };
    for (int row = 0; row < rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        const double u = (column + 0.5) / columns;
        const double v = (row + 0.5) / rows;
        this->Positions.emplace_back(Vec3(position(u, v)), Real(1));
        this->Normals.emplace_back(normal(u, v));
      }
    }
  }
  void Forget(int column, int row) { this->Positions[row * this->Size.x + column].w = 0; }

  Vec4 fetchBasePosition(const glm::ivec2& texel) const { return this->Positions[this->At(texel)]; }
  Vec3 fetchBaseNormal(const glm::ivec2& texel) const { return this->Normals[this->At(texel)]; }
  glm::ivec2 baseSize() const { return this->Size; }
  glm::bvec2 baseWraps() const { return this->Wraps; }
  Vec2 baseScale() const { return Vec2(this->Size); }
  Vec2 baseOffset() const { return Vec2(Real(-0.5)); }

private:
  std::size_t At(const glm::ivec2& texel) const
  {
    if (texel.x < 0 || texel.y < 0 || texel.x >= this->Size.x || texel.y >= this->Size.y)
    {
      throw std::out_of_range("a texel outside of the image");
    }
    return std::size_t(texel.y) * std::size_t(this->Size.x) + std::size_t(texel.x);
  }

  glm::ivec2 Size{ 0, 0 };
  glm::bvec2 Wraps{ false, false };
  std::vector<Vec4> Positions;
  std::vector<Vec3> Normals;
};
}

namespace MesoKernels
{
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic error "-Wdouble-promotion"
#endif
namespace Float
{
class BaseSurface : public BaseTexels<float>
{
public:
#include "MesoBaseSurfaceFloat.h"
};
}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
namespace Double
{
class BaseSurface : public BaseTexels<double>
{
public:
#include "MesoBaseSurfaceDouble.h"
};
}
}

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Around = 1.; // the torus
constexpr double Tube = 0.4;

glm::dvec3 TorusNormal(double u, double v)
{
  return { std::cos(2. * Pi * v) * std::cos(2. * Pi * u),
    std::cos(2. * Pi * v) * std::sin(2. * Pi * u), std::sin(2. * Pi * v) };
}

glm::dvec3 Torus(double u, double v)
{
  return Around * glm::dvec3(std::cos(2. * Pi * u), std::sin(2. * Pi * u), 0.) +
    Tube * TorusNormal(u, v);
}

/// Depth below the torus, in units of 1.
double BelowTorus(const glm::dvec3& x)
{
  return Tube - std::hypot(std::hypot(x.x, x.y) - Around, x.z);
}
}

struct FloatBase
{
  using Real = float;
  using Frame = MesoKernels::Float::Frame;
  using HeightField = MesoKernels::Float::HeightField;
  using Quadric = MesoKernels::Float::Quadric;
  using Base = MesoKernels::Float::BaseSurface;
};

struct DoubleBase
{
  using Real = double;
  using Frame = MesoKernels::Double::Frame;
  using HeightField = MesoKernels::Double::HeightField;
  using Quadric = MesoKernels::Double::Quadric;
  using Base = MesoKernels::Double::BaseSurface;
};

template <typename Kernels>
class BaseSurfaceKernel : public KernelTest<Kernels>
{
public:
  using Base = typename Kernels::Base;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::Vec3;

  static Base BakedTorus(int columns = 512, int rows = 256)
  {
    Base base;
    base.Bake(columns, rows, true, true, Torus, TorusNormal);
    return base;
  }
};
using BothBases = testing::Types<FloatBase, DoubleBase>;
TYPED_TEST_SUITE(BaseSurfaceKernel, BothBases, KernelNames);

TYPED_TEST(BaseSurfaceKernel, GivesPointsNormalsAndTheirDerivatives)
{
  using Vec2 = typename TestFixture::Vec2;
  const auto base = this->BakedTorus();
  for (int run = 0; run < 1000; ++run)
  {
    const double u = this->Random(-2., 2.);
    const double v = this->Random(-2., 2.);
    const auto point = base.baseAt(Vec2(u, v));
    ASSERT_TRUE(point.Known);
    // A chord's distance from its arc: an eighth of its length squared over the radius.
    const double chord = std::pow(2. * Pi * (Around + Tube) / 512., 2.) / 8. / Tube;
    ASSERT_LT(glm::length(glm::dvec3(point.Position) - Torus(u, v)), 2. * chord);
    ASSERT_LT(glm::length(glm::dvec3(point.Normal) - TorusNormal(u, v)), 4. * chord);
    const double step = 1e-4;
    const glm::dvec3 perU = (Torus(u + step, v) - Torus(u - step, v)) / (2. * step);
    const glm::dvec3 perV = (Torus(u, v + step) - Torus(u, v - step)) / (2. * step);
    // Constant in a texel: off by half a texel's turning.
    ASSERT_LT(glm::length(glm::dvec3(point.PerU) - perU), 0.02 * glm::length(perU));
    ASSERT_LT(glm::length(glm::dvec3(point.PerV) - perV), 0.03 * glm::length(perV));
    ASSERT_LT(glm::length(glm::dvec3(point.NormalPerV) - perV / Tube), 0.04 * 2. * Pi);
  }
}

TYPED_TEST(BaseSurfaceKernel, FindsThePlaceOfAPointUnderTheTorus)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  const auto base = this->BakedTorus();
  const Real scale = Real(0.12);
  double worst[4] = { 0., 0., 0., 0. };
  for (int run = 0; run < 2000; ++run)
  {
    const double u = this->Random(0., 1.);
    const double v = this->Random(0., 1.);
    const double depth = this->Random(0., 1.);
    const glm::dvec3 x = Torus(u, v) - depth * double(scale) * TorusNormal(u, v);
    // A guess that is off by half a radian, and by a third of the depth.
    Vec2 map(u + this->Random(-0.03, 0.03), v + this->Random(-0.08, 0.08));
    Real guess = Real(depth) + this->Random(-0.3, 0.3);
    for (int step = 0; step < 4; ++step)
    {
      const auto state = base.stepToBase(map, guess, scale, Vec3(x), Vec3(0, 0, -1));
      ASSERT_TRUE(state.Known);
      map = state.MapCoord;
      guess = state.Depth;
      worst[step] = std::max(worst[step], std::abs(double(guess) - depth));
    }
    // The image itself is off by a chord.
    ASSERT_NEAR(guess, depth, 1e-3);
    ASSERT_NEAR(map.x, u, 1e-4);
    ASSERT_NEAR(map.y, v, 1e-4);
  }
  EXPECT_LT(worst[1], 0.2 * worst[0]);
  EXPECT_LT(worst[2], 0.2 * worst[1]);
}

TYPED_TEST(BaseSurfaceKernel, FollowsARayToTheExactDepth)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  const auto base = this->BakedTorus();
  const Real scale = Real(0.12);
  int followed = 0;
  for (int run = 0; run < 3000; ++run)
  {
    const double u = this->Random(0., 1.);
    const double v = this->Random(0., 1.);
    const glm::dvec3 normal = TorusNormal(u, v);
    const glm::dvec3 direction = glm::normalize(
      glm::dvec3(this->Random(-1., 1.), this->Random(-1., 1.), this->Random(-1., 1.)));
    if (!(glm::dot(direction, normal) < -0.02))
    {
      continue;
    }
    const Vec3 start(Torus(u, v));
    const Vec3 along(direction);
    auto state = base.stepToBase(Vec2(u, v), 0, scale, start, along);
    ASSERT_NEAR(state.Rate.z, -glm::dot(direction, normal) / double(scale), 0.02 / double(scale));
    double time = 0.;
    for (int piece = 0; piece < 12 && state.Depth < 1 && state.Depth > Real(-0.01); ++piece)
    {
      const double length =
        std::min(0.3 / double(state.Turn), 1.1 / std::abs(double(state.Rate.z)));
      time += length;
      state = base.nextOverBase(state, Real(length), scale, start + Real(time) * along, along, 6);
      const double expected = BelowTorus(glm::dvec3(start) + time * direction) / double(scale);
      if (expected > 1.5 || expected < -0.5)
      {
        break;
      }
      ASSERT_TRUE(state.Known);
      // Half of 0.025 squared, of the radius 0.4, three times over.
      ASSERT_NEAR(state.Depth, expected, 0.003)
        << "run " << run << " piece " << piece << " length " << length << " v " << v << " miss "
        << state.Miss.x << " " << state.Miss.y << " " << state.Miss.z << " d.n "
        << glm::dot(direction, normal) << " turn " << state.Turn;
      ++followed;
    }
  }
  EXPECT_GT(followed, 1500);
}

// The guess that Newton's method begins with errs by the third order of the time alone.
TYPED_TEST(BaseSurfaceKernel, GuessesARaysPlaceToSecondOrder)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  const double radius = 0.4;
  const auto normal = [](double u, double) { return glm::dvec3(std::cos(u), std::sin(u), 0.); };
  typename TestFixture::Base base;
  base.Bake(
    1000, 4, false, false,
    [&](double u, double v) { return radius * normal(u, v) + glm::dvec3(0., 0., v); }, normal);
  const Real scale = Real(0.12);
  const Vec2 map(Real(0.4), Real(0.5));
  const Vec3 start(radius * normal(0.4, 0.) + glm::dvec3(0., 0., 0.5));
  const Vec3 along(
    glm::normalize(-normal(0.4, 0.) + glm::dvec3(-std::sin(0.4), std::cos(0.4), 0.)));
  const auto state = base.stepToBase(map, 0, scale, start, along);
  const auto missAfter = [&](double time)
  {
    const auto next =
      base.nextOverBase(state, Real(time), scale, start + Real(time) * along, along, 1);
    return std::abs(double(next.Miss.x));
  };
  EXPECT_GT(missAfter(0.12), 1e-3);
  EXPECT_NEAR(missAfter(0.12) / missAfter(0.06), 8., 2.5);
}

TYPED_TEST(BaseSurfaceKernel, BendAndTurnAreThoseOfTheSphere)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  const double radius = 2.;
  const auto normal = [](double u, double v)
  {
    const double latitude = (v - 0.5) * 2.;
    return glm::dvec3(
      std::cos(latitude) * std::cos(u), std::cos(latitude) * std::sin(u), std::sin(latitude));
  };
  typename TestFixture::Base base;
  base.Bake(
    400, 400, false, false, [&](double u, double v) { return radius * normal(u, v); }, normal);
  const glm::dvec3 n = normal(0.4, 0.6);
  const glm::dvec3 aside = glm::normalize(glm::cross(n, glm::dvec3(1., 2., 3.)));
  const glm::dvec3 direction = 0.8 * aside - 0.6 * n;
  const double scale = 0.1;
  const auto state = base.stepToBase(
    Vec2(0.4, 0.6), 0, typename TestFixture::Real(scale), Vec3(radius * n), Vec3(direction));
  EXPECT_NEAR(state.Rate.z, 0.6 / scale, 0.02);
  EXPECT_NEAR(state.Turn, 0.8 / radius, 0.002);
  EXPECT_NEAR(state.Bend, 0.5 * 0.64 / radius / scale, 0.005);
}

TYPED_TEST(BaseSurfaceKernel, KnowsWhatItDoesNotKnow)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  auto base = this->BakedTorus(64, 32);
  base.Forget(10, 10);
  EXPECT_FALSE(base.baseAt(Vec2(10.4 / 64., 10.6 / 32.)).Known);
  EXPECT_TRUE(base.baseAt(Vec2(12.4 / 64., 10.6 / 32.)).Known);
  // Over the end of an image that does not close.
  typename TestFixture::Base open;
  open.Bake(64, 32, true, false, Torus, TorusNormal);
  EXPECT_TRUE(open.baseAt(Vec2(1.2, 0.5)).Known);
  EXPECT_FALSE(open.baseAt(Vec2(0.5, 1.001)).Known);
  EXPECT_FALSE(open.baseAt(Vec2(0.5, -0.4)).Known);
  // No volume: a base whose lines along v have no length, as at a pole.
  typename TestFixture::Base pole;
  pole.Bake(
    16, 16, false, false, [](double u, double) { return glm::dvec3(u, 0., 0.); },
    [](double, double) { return glm::dvec3(0., 0., 1.); });
  const auto state = pole.stepToBase(Vec2(0.5, 0.5), 0, 1, Vec3(0.5, 0, 0), Vec3(0, 0, -1));
  EXPECT_FALSE(state.Known);
  for (const double value : { double(state.Rate.x), double(state.Depth), double(state.Bend),
         double(state.MapCoord.y), double(state.Turn) })
  {
    EXPECT_TRUE(std::isfinite(value));
  }
  EXPECT_FALSE(base.stepToBase(Vec2(0.5, 0.5), 0, 0, Vec3(0), Vec3(0, 0, -1)).Known) << "D = 0";
}
