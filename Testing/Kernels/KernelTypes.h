#ifndef KernelTypes_h
#define KernelTypes_h

// The two copies of the kernels, for typed tests.

#include "MesoKernels.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

struct FloatKernels
{
  using Real = float;
  using Contour = MesoKernels::Float::Contour;
  using Frame = MesoKernels::Float::Frame;
  using Grid = MesoKernels::Float::Grid;
  using HeightField = MesoKernels::Float::HeightField;
  using LevelChoice = MesoKernels::Float::LevelChoice;
  using Quadric = MesoKernels::Float::Quadric;
  using QuadricExact = MesoKernels::Float::QuadricExact;
  using PrismGeometry = MesoKernels::Float::PrismGeometry;
  using RoughRelief = MesoKernels::Float::RoughRelief;
  using Volume = MesoKernels::Float::Volume;
};

struct DoubleKernels
{
  using Real = double;
  using Contour = MesoKernels::Double::Contour;
  using Frame = MesoKernels::Double::Frame;
  using Grid = MesoKernels::Double::Grid;
  using HeightField = MesoKernels::Double::HeightField;
  using LevelChoice = MesoKernels::Double::LevelChoice;
  using Quadric = MesoKernels::Double::Quadric;
  using QuadricExact = MesoKernels::Double::QuadricExact;
  using PrismGeometry = MesoKernels::Double::PrismGeometry;
  using RoughRelief = MesoKernels::Double::RoughRelief;
  using Volume = MesoKernels::Double::Volume;
};

struct KernelNames
{
  template <typename Kernels>
  static std::string GetName(int)
  {
    return sizeof(typename Kernels::Real) == sizeof(float) ? "Float" : "Double";
  }
};

using BothKernels = ::testing::Types<FloatKernels, DoubleKernels>;

/// Heights of a map from a function of column and row.
template <typename Function>
std::vector<float> MakeHeights(int columns, int rows, const Function& height)
{
  std::vector<float> heights(std::size_t(columns) * std::size_t(rows));
  std::size_t i = 0;
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      heights[i++] = float(height(column, row));
    }
  }
  return heights;
}

template <typename Kernels>
class KernelTest : public ::testing::Test
{
public:
  using Real = typename Kernels::Real;
  using Vec2 = glm::vec<2, Real>;
  using Vec3 = glm::vec<3, Real>;
  using Frame = typename Kernels::Frame;
  using HeightField = typename Kernels::HeightField;
  using Quadric = typename Kernels::Quadric;
  static constexpr Real Epsilon = std::numeric_limits<Real>::epsilon();

  /// Uniform in [low, high].
  Real Random(double low, double high)
  {
    return Real(std::uniform_real_distribution<double>(low, high)(this->Generator));
  }
  std::vector<float> RandomHeights(int count)
  {
    return MakeHeights(count, 1, [this](int, int) { return this->Random(0., 1.); });
  }

  std::mt19937 Generator{ 20051 };
};

constexpr MesoWrap AllWraps[] = { MesoWrap::Repeat, MesoWrap::Clamp, MesoWrap::Mirror };
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

#endif
