// What the step makes of Accepted.glsl: its types, and that it computes.

#include "MesoKernels.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace MesoKernels
{
struct AcceptedFloat
{
#include "MesoAcceptedNeededFloat.h"
// after those that it needs
#include "MesoAcceptedFloat.h"
};

struct AcceptedDouble
{
#include "MesoAcceptedNeededDouble.h"
// after those that it needs
#include "MesoAcceptedDouble.h"
};
}

template <typename Copy>
class KernelCopy : public ::testing::Test
{
public:
  using Real = std::remove_const_t<decltype(Copy::AcceptedHalf)>;
  Copy Kernel;
};
using Copies = ::testing::Types<MesoKernels::AcceptedFloat, MesoKernels::AcceptedDouble>;
TYPED_TEST_SUITE(KernelCopy, Copies);

static_assert(std::is_same_v<decltype(MesoKernels::AcceptedFloat::AcceptedThird), const float>);
static_assert(std::is_same_v<decltype(MesoKernels::AcceptedDouble::AcceptedThird), const double>);

TYPED_TEST(KernelCopy, Computes)
{
  using Real = typename TestFixture::Real;
  using Vec2 = glm::vec<2, Real>;
  using Vec3 = glm::vec<3, Real>;
  EXPECT_EQ(this->Kernel.acceptedSwizzle(Vec3(1, 2, 3)), Vec3(3 + 2 + 1, 2 + 2, 1 + 3));
  const Real values[3] = { 1, 2, 3 };
  const Real weights[3] = { 4, 5, 6 };
  EXPECT_EQ(this->Kernel.acceptedSum(values, weights), Real(32));
  Real filled[3] = { 0, 0, 0 };
  Vec2 last(5, 7);
  this->Kernel.acceptedFill(filled, last, 10);
  EXPECT_EQ(filled[0], Real(2));
  EXPECT_EQ(filled[2], Real(21));
  EXPECT_EQ(last, Vec2(10, 42));
  EXPECT_EQ(this->Kernel.acceptedInts(-3, { 1, 9 }), 0 - 1 + 7);
  // 0.5 * (2 + 100 * 3 - 0.015) + 2 + 1 / 3
  EXPECT_NEAR(this->Kernel.acceptedFloats(2, 3), 153.3258333, 1e-4);
}
