// The quadric in texture space against the same geometry written out in object space, and its
// derivatives against differences.

#include "KernelTypes.h"

#include <cmath>

template <typename Kernels>
class QuadricKernel : public KernelTest<Kernels>
{
public:
  using typename KernelTest<Kernels>::Real;
  using typename KernelTest<Kernels>::Vec2;
  using typename KernelTest<Kernels>::Vec3;

  Vec3 RandomVector(double size)
  {
    return Vec3(this->Random(-size, size), this->Random(-size, size), this->Random(-size, size));
  }

  /// A point's frame, sheared by up to 60 degrees, mirrored or not, stretched by up to 10 : 1.
  struct Chart
  {
    glm::dvec3 Normal;
    glm::dvec3 Tangent;
    glm::dvec3 Bitangent;
    glm::dvec2 Scale;
    glm::dvec3 Quadric; ///< a, b, c
  };

  Chart RandomChart()
  {
    Chart chart;
    chart.Normal = glm::normalize(glm::dvec3(this->RandomVector(1.)) + glm::dvec3(1.5, 0., 0.));
    const glm::dvec3 other(this->RandomVector(1.));
    chart.Tangent = glm::normalize(glm::cross(chart.Normal, other + glm::dvec3(0., 1.5, 0.)));
    const glm::dvec3 across = glm::cross(chart.Normal, chart.Tangent);
    const double shear = this->Random(-1., 1.);
    const double side = this->Random(-1., 1.) < 0. ? -1. : 1.;
    chart.Bitangent = std::sin(shear) * chart.Tangent + side * std::cos(shear) * across;
    chart.Scale = { std::pow(10., this->Random(-0.5, 0.5)),
      std::pow(10., this->Random(-0.5, 0.5)) };
    chart.Quadric = glm::dvec3(this->RandomVector(1.));
    return chart;
  }

  Vec3 OverTexture(const Chart& chart) const
  {
    return this->Kernel.quadricOverTexture(Vec3(chart.Quadric), Vec3(chart.Tangent),
      Vec3(chart.Bitangent), Vec3(chart.Normal), Vec2(chart.Scale));
  }

  static Vec3 Metric(const Chart& chart, double depth)
  {
    return Vec3(glm::dvec3(chart.Scale.x * chart.Scale.x,
                  chart.Scale.x * chart.Scale.y * glm::dot(chart.Tangent, chart.Bitangent),
                  chart.Scale.y * chart.Scale.y) /
      (depth * depth));
  }

  /// The base in object space, from its definition: z = a x^2 + b y^2 + c x y below the plane.
  static glm::dvec3 Base(const Chart& chart, double u, double v)
  {
    const glm::dvec3 inPlane =
      chart.Scale.x * u * chart.Tangent + chart.Scale.y * v * chart.Bitangent;
    const double x = glm::dot(inPlane, chart.Tangent);
    const double y = glm::dot(inPlane, glm::cross(chart.Normal, chart.Tangent));
    const glm::dvec3& q = chart.Quadric;
    return inPlane - (q.x * x * x + q.y * y * y + q.z * x * y) * chart.Normal;
  }

  static glm::dvec3 BaseNormal(const Chart& chart, double u, double v)
  {
    const double step = 1e-5;
    const glm::dvec3 alongU = Base(chart, u + step, v) - Base(chart, u - step, v);
    const glm::dvec3 alongV = Base(chart, u, v + step) - Base(chart, u, v - step);
    const glm::dvec3 normal = glm::normalize(glm::cross(alongU, alongV));
    return glm::dot(normal, chart.Normal) < 0. ? -normal : normal;
  }

  /// From texture space to object space.
  static glm::dvec3 ToObject(const Chart& chart, double depth, const Vec3& texture)
  {
    return double(texture.x) * chart.Scale.x * chart.Tangent +
      double(texture.y) * chart.Scale.y * chart.Bitangent -
      double(texture.z) * depth * chart.Normal;
  }

  typename KernelTest<Kernels>::Quadric Kernel;
};
TYPED_TEST_SUITE(QuadricKernel, BothKernels, KernelNames);

TYPED_TEST(QuadricKernel, IsTheSameSurfaceInTextureSpace)
{
  for (int run = 0; run < 2000; ++run)
  {
    const auto chart = this->RandomChart();
    const auto quadric = this->OverTexture(chart);
    const double u = this->Random(-1., 1.);
    const double v = this->Random(-1., 1.);
    const double expected = -glm::dot(this->Base(chart, u, v), chart.Normal);
    const double found = this->Kernel.quadricDepth(quadric, typename TestFixture::Vec2(u, v));
    // Ten products of numbers up to 20.
    ASSERT_NEAR(found, expected, 200. * double(this->Epsilon));
  }
}

TYPED_TEST(QuadricKernel, HasNoAxesWithoutATangent)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  EXPECT_EQ(this->Kernel.quadricOverTexture(
              Vec3(1, 1, 1), Vec3(0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec2(1, 1)),
    Vec3(0));
}

TYPED_TEST(QuadricKernel, DistanceAlongARayIsTheQuadraticOfLeaveShell)
{
  using Real = typename TestFixture::Real;
  using Vec2 = typename TestFixture::Vec2;
  for (int run = 0; run < 2000; ++run)
  {
    const auto quadric = this->RandomVector(2.);
    const auto ray = this->RandomVector(2.);
    const Real t = this->Random(0., 1.);
    const Real bend = this->Kernel.quadricDepth(quadric, Vec2(ray.x, ray.y));
    ASSERT_NEAR(this->Kernel.distanceToQuadric(quadric, t * ray), t * (ray.z - t * bend),
      100 * this->Epsilon);
  }
}

TYPED_TEST(QuadricKernel, NormalIsThatOfTheSurface)
{
  using Vec2 = typename TestFixture::Vec2;
  using Real = typename TestFixture::Real;
  const double depth = 0.3;
  for (int run = 0; run < 2000; ++run)
  {
    const auto chart = this->RandomChart();
    const double u = this->Random(-0.5, 0.5);
    const double v = this->Random(-0.5, 0.5);
    Real root;
    const auto normal = this->Kernel.quadricNormal(
      this->OverTexture(chart) / Real(depth), this->Metric(chart, depth), Vec2(u, v), root);
    const glm::dvec3 inObject = this->ToObject(chart, depth, normal);
    // The inverse of the metric loses digits with the shear; the differences are good to 1e-9.
    const double bound = std::max(1e-8, 1000. * double(this->Epsilon));
    ASSERT_NEAR(glm::length(inObject), depth, bound);
    ASSERT_NEAR(glm::distance(inObject / depth, this->BaseNormal(chart, u, v)), 0., bound);
  }
}

TYPED_TEST(QuadricKernel, NormalStaysWhereTheMetricHasNoArea)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  using Real = typename TestFixture::Real;
  const Real far = Real(1e30);
  for (const Vec3& metric : { Vec3(0), Vec3(1, 1, 1), Vec3(1, 0, 0), Vec3(far, 0, far) })
  {
    Real root;
    const auto normal = this->Kernel.quadricNormal(Vec3(1, 2, 3), metric, Vec2(1, 1), root);
    ASSERT_TRUE(std::isfinite(normal.x + normal.y + normal.z + root));
    ASSERT_LT(normal.z, 0);
  }
}

TYPED_TEST(QuadricKernel, NormalsDerivativeIsThatOfDifferences)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  using Real = typename TestFixture::Real;
  const Real step = std::cbrt(this->Epsilon); // where rounding and curvature of a difference meet
  for (int run = 0; run < 2000; ++run)
  {
    const Vec3 quadric = this->RandomVector(2.);
    const Vec3 metric(this->Random(0.5, 2.), this->Random(-0.4, 0.4), this->Random(0.5, 2.));
    const Vec2 at(this->Random(-0.5, 0.5), this->Random(-0.5, 0.5));
    const Vec2 direction(this->Random(-1., 1.), this->Random(-1., 1.));
    Real root;
    const Vec3 difference =
      (this->Kernel.quadricNormal(quadric, metric, at + step * direction, root) -
        this->Kernel.quadricNormal(quadric, metric, at - step * direction, root)) /
      (2 * step);
    const Vec3 found = this->Kernel.quadricNormalDerivative(quadric, metric, at, direction);
    // Third derivatives of up to 1e3 here.
    ASSERT_NEAR(glm::distance(found, difference), 0., 2e3 * double(step * step));
  }
}

TYPED_TEST(QuadricKernel, CrossIsThatOfTheDisplacedSurface)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  using Real = typename TestFixture::Real;
  const double depth = 0.1;
  for (int run = 0; run < 1000; ++run)
  {
    const auto chart = this->RandomChart();
    // Depth d = 1/2 + g . (u, v) around the point, so its gradient is g and the heights' is -g.
    const glm::dvec2 gradient(this->Random(-2., 2.), this->Random(-2., 2.));
    const glm::dvec2 at(this->Random(-0.2, 0.2), this->Random(-0.2, 0.2));
    const auto surface = [&](double u, double v)
    {
      const double relief = 0.5 + glm::dot(gradient, glm::dvec2(u, v) - at);
      return this->Base(chart, u, v) - relief * depth * this->BaseNormal(chart, u, v);
    };
    const double step = 1e-4;
    const glm::dvec3 expected =
      glm::normalize(glm::cross(surface(at.x + step, at.y) - surface(at.x - step, at.y),
        surface(at.x, at.y + step) - surface(at.x, at.y - step)));

    const Vec3 cross = this->Kernel.displacedCross(this->OverTexture(chart) / Real(depth),
      this->Metric(chart, depth), Vec2(at), Real(0.5), Vec2(-gradient));
    const glm::dvec3 u = this->ToObject(chart, depth, Vec3(1, 0, 0));
    const glm::dvec3 v = this->ToObject(chart, depth, Vec3(0, 1, 0));
    const glm::dvec3 down = this->ToObject(chart, depth, Vec3(0, 0, 1));
    const glm::dvec3 found = glm::normalize(double(cross.x) * glm::cross(v, down) +
      double(cross.y) * glm::cross(down, u) + double(cross.z) * glm::cross(u, v));
    // Differences of differences, 1e-10 / 1e-4 / 1e-5 at worst.
    ASSERT_NEAR(glm::distance(found, expected), 0., std::max(2e-4, 1e4 * double(this->Epsilon)));
  }
}

TYPED_TEST(QuadricKernel, CrossOfAPlaneIsTheGradientItself)
{
  using Vec2 = typename TestFixture::Vec2;
  using Vec3 = typename TestFixture::Vec3;
  for (int run = 0; run < 200; ++run)
  {
    const Vec2 gradient(this->Random(-9., 9.), this->Random(-9., 9.));
    const Vec3 metric(this->Random(0.5, 2.), this->Random(-0.4, 0.4), this->Random(0.5, 2.));
    ASSERT_EQ(
      this->Kernel.displacedCross(Vec3(0), metric, Vec2(1, 2), this->Random(0., 1.), gradient),
      Vec3(gradient.x, gradient.y, 1));
  }
}
