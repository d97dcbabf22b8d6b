// The kernel of tables over view and curvature: points of a ray over a circle, and the axes' edges.

#include "KernelTypes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
const double Pi = std::acos(-1.);

template <typename Table, typename Real>
class Check
{
public:
  const Table Kernel = {};
  const Real Epsilon = std::numeric_limits<Real>::epsilon();

  typename Table::VDMLayout Layout(int stores, int nodes) const
  {
    typename Table::VDMLayout layout = {};
    layout.Stores = stores;
    layout.Nodes = nodes;
    layout.Polars = 8;
    layout.Curvatures = 16;
    layout.FirstCurvature = -2;
    layout.LastCurvature = 3;
    layout.Depth = Real(0.2);
    layout.Range = 1;
    return layout;
  }

  /// The point at a length of a ray, by the plane's own coordinates in double precision.
  static typename Table::VDMPoint PointAt(double polar, double c, double length)
  {
    const double along = length * std::sin(polar);
    const double inwards = length * std::cos(polar);
    typename Table::VDMPoint point = {};
    point.RayLength = Real(length);
    if (c == 0.)
    {
      point.Offset = Real(along);
      point.Depth = Real(inwards);
      return point;
    }
    // (1 - sqrt((1 - c z)^2 + (c x)^2)) / c, without the difference
    const double square = 2. * c * inwards - c * c * length * length;
    point.Depth = Real(square / c / (1. + std::sqrt(1. - square)));
    point.Offset = Real(std::atan2(c * along, 1. - c * inwards) / c);
    return point;
  }

  void PointsComeBack()
  {
    for (const double c : { -2., -0.3, -1e-3, -1e-7, 0., 1e-7, 1e-3, 0.3, 1., 3. })
    {
      for (const double polar : { 0., 1e-4, 0.1, 0.7, 1.2, 1.5 })
      {
        const double sine = std::sin(polar);
        const double cosine = std::cos(polar);
        for (int i = 0; i < 20; ++i)
        {
          const double length = 0.15 / cosine * i / 20.;
          const auto expected = PointAt(polar, c, length);
          if (double(expected.Depth) > 0.2 || double(expected.Depth) < 0. ||
            c * length * cosine > 0.9)
          {
            continue; // out of the relief, or beyond the centre
          }
          for (int stores = 0; stores < 3; ++stores)
          {
            if (stores == Table::VDMStoresOffset && polar < 1e-3)
            {
              continue; // an offset says nothing of a ray that has none
            }
            const auto layout = this->Layout(stores, 0);
            const Real number =
              this->Kernel.vdmNumber(layout, Real(sine), Real(cosine), Real(c), expected);
            const auto point =
              this->Kernel.vdmPoint(layout, Real(sine), Real(cosine), Real(c), number);
            // Near its deepest point a depth says little of where the ray is: the error of the root.
            const double slack = stores == Table::VDMStoresDepth
              ? 4. * std::sqrt(double(this->Epsilon)) * (1. + length)
              : 100. * double(this->Epsilon) * (1. + length) / std::max(cosine, 0.05);
            EXPECT_NEAR(point.Offset, expected.Offset, slack) << c << " " << polar << " " << length;
            EXPECT_NEAR(point.RayLength, expected.RayLength, slack)
              << c << " " << polar << " " << length << " " << stores;
            EXPECT_NEAR(point.Depth, expected.Depth, slack) << c << " " << polar << " " << length;
          }
        }
      }
    }
  }

  void EdgesOfAxesAreTheirEnds()
  {
    for (int nodes = 0; nodes < 3; ++nodes)
    {
      const auto layout = this->Layout(0, nodes);
      for (int i = 0; i < layout.Polars; ++i)
      {
        EXPECT_NEAR(this->Kernel.vdmPolarPlace(layout, this->Kernel.vdmPolarAt(layout, Real(i))),
          double(i), 1e-4)
          << nodes;
      }
      EXPECT_EQ(this->Kernel.vdmPolarPlace(layout, 0), 0);
      EXPECT_NEAR(this->Kernel.vdmPolarPlace(layout, Real(Pi / 2.)), 7., 1e-5);
      EXPECT_EQ(this->Kernel.vdmPolarPlace(layout, 2), 7);
    }
    const auto layout = this->Layout(0, 0);
    EXPECT_EQ(this->Kernel.vdmCurvaturePlace(layout, -2), 0);
    EXPECT_EQ(this->Kernel.vdmCurvaturePlace(layout, -50), 0);
    EXPECT_NEAR(this->Kernel.vdmCurvaturePlace(layout, 0), 6., 1e-5);
    EXPECT_EQ(this->Kernel.vdmCurvaturePlace(layout, 3), 15);
    EXPECT_EQ(this->Kernel.vdmCurvaturePlace(layout, 1e6f), 15);
    auto single = layout;
    single.Curvatures = 1;
    EXPECT_EQ(this->Kernel.vdmCurvaturePlace(single, 1), 0);
  }

  void SteeperAnglesGoOnToTheNormal()
  {
    for (int nodes = 0; nodes < 3; ++nodes)
    {
      const auto layout = this->Layout(0, nodes);
      const auto first = this->Kernel.vdmPolarAt(layout, 0);
      const auto steeper = [&](Real polar)
      { return this->Kernel.vdmSteeper(layout, std::tan(Real(0.5) * polar)); };
      EXPECT_NEAR(steeper(first), 0., 1e-5) << nodes;
      EXPECT_EQ(steeper(Real(1.2)), 0) << nodes;
      if (nodes == Table::VDMNodesEdges)
      {
        EXPECT_EQ(first, 0);
        continue;
      }
      EXPECT_NEAR(steeper(0), 1., 1e-5) << nodes;
      // Nearly even between, as places are.
      EXPECT_NEAR(steeper(Real(0.5) * first), 0.5, 0.01) << nodes;
    }
  }

  void DirectionsGoRoundAndDown()
  {
    using Vec3 = glm::vec<3, Real>;
    typename Table::VDMDirection direction;
    for (int i = 0; i < 64; ++i)
    {
      const double turns = (i + 0.25) / 64.;
      ASSERT_TRUE(this->Kernel.vdmDirection(
        Vec3(2. * std::cos(2. * Pi * turns), 2. * std::sin(2. * Pi * turns), 5.), Real(0.2),
        direction));
      EXPECT_NEAR(direction.Turns, turns, 1e-6);
      EXPECT_NEAR(direction.Length, std::sqrt(5.), 1e-6);
      EXPECT_NEAR(direction.Sine, 2. / std::sqrt(5.), 1e-6);
      EXPECT_NEAR(direction.HalfTangent, std::tan(0.5 * std::atan(2.)), 1e-6);
    }
    // Just before a full turn, straight down, and in the plane.
    ASSERT_TRUE(this->Kernel.vdmDirection(Vec3(1, Real(-1e-12), 1), 1, direction));
    EXPECT_GE(direction.Turns, 0);
    EXPECT_LE(direction.Turns, 1);
    ASSERT_TRUE(this->Kernel.vdmDirection(Vec3(0, 0, 3), 1, direction));
    EXPECT_EQ(direction.HalfTangent, 0);
    EXPECT_EQ(direction.Over.x, 0);
    EXPECT_FALSE(this->Kernel.vdmDirection(Vec3(1, 0, 0), 1, direction));
    EXPECT_FALSE(this->Kernel.vdmDirection(Vec3(1, 0, -1), 1, direction));
    EXPECT_FALSE(this->Kernel.vdmDirection(Vec3(1, 0, Real(NotANumber)), 1, direction));
    ASSERT_TRUE(this->Kernel.vdmDirection(Vec3(1, 0, Real(1e-9)), 1, direction));
    EXPECT_GT(direction.Cosine, 0);
    EXPECT_LT(direction.HalfTangent, Real(1));
  }

  void CurvatureIsEulers()
  {
    using Vec2 = glm::vec<2, Real>;
    using Vec3 = glm::vec<3, Real>;
    const Vec3 x(1, 0, 0);
    const Vec3 y(0, 1, 0);
    const Vec2 curvatures(3, -1);
    for (const double polar : { 1e-3, 0.3, 1.2, Pi / 2. })
    {
      for (const double azimuth : { 0., 0.4, Pi / 2., 2. })
      {
        const Vec3 v(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
          std::cos(polar));
        const double expected =
          3. * std::cos(azimuth) * std::cos(azimuth) - std::sin(azimuth) * std::sin(azimuth);
        EXPECT_NEAR(this->Kernel.curvatureAlong(curvatures, x, y, v), expected, 1e-3);
      }
    }
    EXPECT_EQ(this->Kernel.curvatureAlong(curvatures, x, y, Vec3(0, 0, 1)), 0); // V || N
    // An umbilic: any pair of directions, along any view.
    const Vec3 a(Real(0.6), Real(0.8), 0);
    const Vec3 b(Real(-0.8), Real(0.6), 0);
    EXPECT_NEAR(
      this->Kernel.curvatureAlong(Vec2(2, 2), a, b, Vec3(Real(0.3), Real(0.2), Real(0.9))), 2.,
      1e-5);
  }

  void LightComesOutWhereItWouldComeIn()
  {
    for (const double c : { -2., 0., 1e-6, 0.5, 3. })
    {
      for (const double polar : { 0.1, 0.8, 1.3 })
      {
        for (const double length : { 0.05, 0.3 })
        {
          const auto point = PointAt(polar, c, length);
          const double psi = c * double(point.Offset);
          if (double(point.Depth) < 0. || double(point.Depth) > 0.3)
          {
            continue;
          }
          // At the point the ray's angle from the inward normal has grown by psi.
          Real sineOut = 0;
          Real cosineOut = 0;
          const auto out = this->Kernel.vdmWayOut(Real(c), point.Depth, Real(std::sin(polar + psi)),
            Real(std::cos(polar + psi)), sineOut, cosineOut);
          const double slack = 30. * std::sqrt(double(this->Epsilon));
          EXPECT_NEAR(sineOut, std::sin(polar), slack);
          EXPECT_NEAR(out.Offset, point.Offset, slack) << c << " " << polar << " " << length;
          EXPECT_NEAR(out.RayLength, length, slack) << c << " " << polar << " " << length;
        }
      }
    }
  }

  void NeverGivesWhatIsNoNumber()
  {
    for (const double c : { -2., 0., 3. })
    {
      for (const double cosine : { 1e-4, 0.01, 1. })
      {
        for (int stores = 0; stores < 3; ++stores)
        {
          for (const double stored : { 0., 1e-9, 0.5, 1. })
          {
            const auto point = this->Kernel.vdmPoint(this->Layout(stores, 0),
              Real(std::sqrt(1. - cosine * cosine)), Real(cosine), Real(c), Real(stored));
            EXPECT_TRUE(std::isfinite(point.Offset) && std::isfinite(point.RayLength) &&
              std::isfinite(point.Depth))
              << c << " " << cosine << " " << stores << " " << stored;
          }
        }
      }
    }
  }
};

using FloatCheck = Check<MesoKernels::Float::VDMTable, float>;
using DoubleCheck = Check<MesoKernels::Double::VDMTable, double>;
}

TEST(VDMKernel, PointsComeBackFromWhatIsStored)
{
  FloatCheck().PointsComeBack();
  DoubleCheck().PointsComeBack();
}

TEST(VDMKernel, EdgesOfAxesAreTheirEnds)
{
  FloatCheck().EdgesOfAxesAreTheirEnds();
  DoubleCheck().EdgesOfAxesAreTheirEnds();
}

TEST(VDMKernel, SteeperAnglesGoOnToTheNormal)
{
  FloatCheck().SteeperAnglesGoOnToTheNormal();
  DoubleCheck().SteeperAnglesGoOnToTheNormal();
}

TEST(VDMKernel, DirectionsGoRoundAndDown)
{
  FloatCheck().DirectionsGoRoundAndDown();
  DoubleCheck().DirectionsGoRoundAndDown();
}

TEST(VDMKernel, CurvatureIsEulers)
{
  FloatCheck().CurvatureIsEulers();
  DoubleCheck().CurvatureIsEulers();
}

TEST(VDMKernel, LightComesOutWhereItWouldComeIn)
{
  FloatCheck().LightComesOutWhereItWouldComeIn();
  DoubleCheck().LightComesOutWhereItWouldComeIn();
}

TEST(VDMKernel, NeverGivesWhatIsNoNumber)
{
  FloatCheck().NeverGivesWhatIsNoNumber();
  DoubleCheck().NeverGivesWhatIsNoNumber();
}
