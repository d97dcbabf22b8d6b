// Makes the program that it is in compute as some devices do: numbers next to zero count as zero, from its start on, and its
// own code may round products and sums together. What other files of it test holds with such numbers, too.

#include <gtest/gtest.h>
#include <limits>
#include <pmmintrin.h>

namespace
{
const bool IsFlushed = []
{
  _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
  _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  return true;
}();
}

TEST(FusedArithmetic, IsWhatThisProgramDoes)
{
  ASSERT_TRUE(IsFlushed);
  const volatile float least = std::numeric_limits<float>::min();
  EXPECT_EQ(least * 0.5f, 0.f);
  const volatile float denormal = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(denormal * 1e30f, 0.f);
  // The square of 1 + e is 1 + 2 e + e^2, whose last term a rounded product has lost.
  const float e = std::numeric_limits<float>::epsilon();
  const volatile float a = 1.f + e;
  const float factor = a;
  EXPECT_EQ(factor * factor - (1.f + 2.f * e), e * e);
}
