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
  using Frame = MesoKernels::Float::Frame;
  using HeightField = MesoKernels::Float::HeightField;
};

struct DoubleKernels
{
  using Real = double;
  using Frame = MesoKernels::Double::Frame;
  using HeightField = MesoKernels::Double::HeightField;
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

template <typename Kernels>
class KernelTest : public ::testing::Test
{
public:
  using Real = typename Kernels::Real;
  using Vec2 = glm::vec<2, Real>;
  using Vec3 = glm::vec<3, Real>;
  using Frame = typename Kernels::Frame;
  using HeightField = typename Kernels::HeightField;
  static constexpr Real Epsilon = std::numeric_limits<Real>::epsilon();

  /// Uniform in [low, high].
  Real Random(double low, double high)
  {
    return Real(std::uniform_real_distribution<double>(low, high)(this->Generator));
  }
  std::vector<float> RandomHeights(int count)
  {
    std::vector<float> heights;
    for (int i = 0; i < count; ++i)
    {
      heights.push_back(float(this->Random(0., 1.)));
    }
    return heights;
  }

  std::mt19937 Generator{ 20051 };
};

constexpr MesoWrap AllWraps[] = { MesoWrap::Repeat, MesoWrap::Clamp, MesoWrap::Mirror };
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

#endif
