// Points that another is better than.

#include "MesoDominated.h"

#include <gtest/gtest.h>

TEST(Dominated, IsWhatAnotherIsBetterThan)
{
  // The second is as cheap as the first and worse; the fourth dearer and no better than the third.
  const std::vector<bool> expected = { false, true, false, true, false };
  EXPECT_EQ(
    MesoDominated({ { 1., 5. }, { 1., 6. }, { 2., 3. }, { 4., 3. }, { 8., 0. } }), expected);
}

TEST(Dominated, EqualPointsDoNotDominateEachOther)
{
  EXPECT_EQ(MesoDominated({ { 1., 1. }, { 1., 1. } }), (std::vector<bool>{ false, false }));
  EXPECT_TRUE(MesoDominated({}).empty());
}
