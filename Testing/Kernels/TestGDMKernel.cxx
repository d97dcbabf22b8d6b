// Places in a table of distances, and its numbers between them, whole and as factors.

#include "KernelTypes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{
const double Pi = std::acos(-1.);
constexpr glm::ivec3 Size = { 3, 5, 4 };
constexpr glm::ivec2 Directions = { 8, 7 };

using Number = std::function<double(int i, int j, int k, int azimuth, int polar)>;

std::vector<float> Table(const Number& number)
{
  std::vector<float> table;
  for (int a = 0; a < Directions.x; ++a)
  {
    for (int j = 0; j < Size.y; ++j)
    {
      for (int i = 0; i < Size.x; ++i)
      {
        for (int t = 0; t < Directions.y; ++t)
        {
          for (int k = 0; k < Size.z; ++k)
          {
            table.push_back(static_cast<float>(number(i, j, k, a, t)));
          }
        }
      }
    }
  }
  return table;
}

glm::dvec3 Direction(double theta, double phi)
{
  return { std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta) };
}

/// Different at every place, without a pattern.
double Scrambled(int i, int j, int k, int a, int t)
{
  const double x = std::sin(12.9898 * i + 78.233 * j + 37.719 * k + 4.581 * a + 9.137 * t) * 4375.5;
  return x - std::floor(x);
}
}

template <typename Kernels>
class GDMKernel : public testing::Test
{
};
using BothReals = testing::Types<MesoKernels::Float::GDMWhole, MesoKernels::Double::GDMWhole>;
TYPED_TEST_SUITE(GDMKernel, BothReals);

TYPED_TEST(GDMKernel, ReadsEachNumberAtItsOwnPointAndDirection)
{
  const TypeParam kernel(Size, Directions, false, 0, Table(Scrambled));
  for (int t = 1; t + 1 < Directions.y; ++t)
  {
    for (int a = 0; a < Directions.x; ++a)
    {
      for (int k = 0; k < Size.z; ++k)
      {
        const auto direction = Direction(Pi * t / (Directions.y - 1), 2. * Pi * a / Directions.x);
        const glm::dvec3 position = { 1.5 / Size.x, 4.5 / Size.y, k / 3. };
        EXPECT_NEAR(kernel.gdmDistance(position, direction), Scrambled(1, 4, k, a, t), 2e-5)
          << t << " " << a << " " << k;
      }
    }
  }
}

TYPED_TEST(GDMKernel, GoesRoundInPhi)
{
  // A number for each azimuth; half a step before the first is between the last and the first.
  const TypeParam kernel(
    Size, Directions, false, 0, Table([](int, int, int, int a, int) { return a; }));
  const double step = 2. * Pi / Directions.x;
  const auto at = [&](double phi) {
    return kernel.gdmDistance({ 0.5, 0.5, 0.5 }, Direction(0.5 * Pi, phi));
  };
  EXPECT_NEAR(at(-0.5 * step), 3.5, 1e-4);
  EXPECT_NEAR(at(-0.25 * step), 1.75, 1e-4);
  EXPECT_NEAR(at(2. * Pi + 2.25 * step), 2.25, 1e-4);
  EXPECT_NEAR(at(7. * step), 7., 1e-4);
  EXPECT_LT(kernel.gdmAzimuth({ 1., -1e-12, 0. }), 8.); // though a float rounds it to a whole turn
  EXPECT_NEAR(kernel.gdmDistance({ 0.5, 0.5, 0.5 }, { 1., -1e-12, 0. }), 0., 1e-4);
}

TYPED_TEST(GDMKernel, EndsInThetaAtThePoles)
{
  const TypeParam kernel(
    Size, Directions, false, 0, Table([](int, int, int, int, int t) { return t; }));
  const auto at = [&](const glm::dvec3& direction) {
    return kernel.gdmDistance({ 0.5, 0.5, 0.5 }, direction);
  };
  EXPECT_EQ(at({ 0., 0., 1. }), 0.);
  EXPECT_NEAR(at({ 0., 0., -1. }), 6., 1e-6);
  EXPECT_NEAR(at({ 1e-9, 0., -1. }), 6., 1e-6);
  EXPECT_NEAR(at({ 1., 0., 0. }), 3., 1e-6);
  EXPECT_NEAR(at({ 0., -5., 0. }), 3., 1e-6); // of any length
  EXPECT_NEAR(at(Direction(0.75 * Pi, 1.)), 4.5, 1e-5);
}

TYPED_TEST(GDMKernel, StepsEvenlyInTheCosineWhereAsked)
{
  const TypeParam kernel(
    Size, Directions, true, 0, Table([](int, int, int, int, int t) { return t; }));
  for (const double cosine : { 1., 0.7, 0.1, -0.35, -1. })
  {
    const auto direction = 2. * Direction(std::acos(cosine), 0.3);
    EXPECT_NEAR(kernel.gdmDistance({ 0.5, 0.5, 0.5 }, direction), 3. * (1. - cosine), 1e-5);
  }
}

TYPED_TEST(GDMKernel, RepeatsInTheTileAndEndsInZ)
{
  const TypeParam kernel(Size, Directions, false, 0, Table(Scrambled));
  const auto direction = Direction(1.1, 0.4);
  const auto at = [&](double x, double y, double z) {
    return kernel.gdmDistance({ x, y, z }, direction);
  };
  EXPECT_NEAR(at(0.1, 0.2, 0.3), at(5.1, -2.8, 0.3), 1e-4);
  EXPECT_NEAR(at(0., 0.3, 0.3), 0.5 * (at(0.5 / 3., 0.3, 0.3) + at(2.5 / 3., 0.3, 0.3)), 1e-5);
  EXPECT_NEAR(at(0.3, 0., 0.3), 0.5 * (at(0.3, 0.1, 0.3) + at(0.3, 0.9, 0.3)), 1e-5);
  EXPECT_EQ(at(0.3, 0.3, 1.), at(0.3, 0.3, 7.));
  EXPECT_EQ(at(0.3, 0.3, 0.), at(0.3, 0.3, -0.2));
  EXPECT_EQ(kernel.gdmLevel(1.), 3.);
  EXPECT_NEAR(at(0.3, 0.3, 0.5), 0.5 * (at(0.3, 0.3, 1. / 3.) + at(0.3, 0.3, 2. / 3.)), 1e-5);
}

TEST(GDMFactorsKernel, IsTheWholeTableThatItsProductsAreOf)
{
  // Five products at random, in two fours of which three are nothing.
  constexpr int rank = 8;
  const int rows = Size.x * Size.y * Directions.x;
  const int columns = Directions.y * Size.z;
  std::vector<float> weights;
  std::vector<float> functions;
  for (int r = 0; r < rows * rank; ++r)
  {
    weights.push_back(r % rank < 5 ? static_cast<float>(Scrambled(r, 1, 2, 3, 4)) : 0.f);
  }
  for (int c = 0; c < columns * rank; ++c)
  {
    functions.push_back(c % rank < 5 ? static_cast<float>(Scrambled(4, 3, 2, 1, c)) : 0.f);
  }
  std::vector<float> table;
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      float sum = 0.f;
      for (int r = 0; r < rank; ++r)
      {
        sum += weights[row * rank + r] * functions[column * rank + r];
      }
      table.push_back(sum);
    }
  }
  const MesoKernels::Double::GDMWhole whole(Size, Directions, false, 0, table);
  const MesoKernels::Double::GDMFactors factored(Size, Directions, false, rank, weights, functions);
  for (int n = 0; n < 400; ++n)
  {
    const glm::dvec3 position = { 3. * Scrambled(n, 0, 0, 0, 0) - 1., Scrambled(n, 1, 0, 0, 0),
      Scrambled(n, 2, 0, 0, 0) };
    const auto direction = Direction(Pi * Scrambled(n, 3, 0, 0, 0), 9. * Scrambled(n, 4, 0, 0, 0));
    EXPECT_NEAR(
      factored.gdmDistance(position, direction), whole.gdmDistance(position, direction), 1e-5)
      << n;
  }
  EXPECT_GT(whole.gdmDistance({ 0.2, 0.3, 0.4 }, { 0., 1., 1. }), 0.);
}

TEST(GDMFactorsKernel, IsNeverNegative)
{
  const int rows = Size.x * Size.y * Directions.x;
  const int columns = Directions.y * Size.z;
  const MesoKernels::Double::GDMFactors kernel(Size, Directions, false, 4,
    std::vector<float>(4 * rows, 1.f), std::vector<float>(4 * columns, -1.f));
  EXPECT_EQ(kernel.gdmDistance({ 0.5, 0.5, 0.5 }, { 0., 0., 1. }), 0.);
}
