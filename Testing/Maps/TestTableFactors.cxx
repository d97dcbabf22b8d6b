// Tables as sums of products: exact at full rank, the best there is below it, at ease with tables
// that have less to say than they have columns.
#include "MesoTableFactors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
constexpr std::size_t Rows = 9000; // more than two of the blocks that sums are made of
constexpr std::size_t Columns = 40;

/// Products of smooth functions, the i-th 2^-i as large, with noise of a given size.
std::vector<float> MakeTable(int products, double noise)
{
  std::mt19937 random(7);
  std::vector<float> table(Rows * Columns);
  for (std::size_t row = 0; row < Rows; ++row)
  {
    for (std::size_t column = 0; column < Columns; ++column)
    {
      double sum = noise * (double(random()) / double(std::mt19937::max()) - 0.5);
      for (int i = 0; i < products; ++i)
      {
        sum += std::pow(2., -i) * std::cos(0.001 * double((i + 1) * row)) *
          std::cos(M_PI * (i + 1) * (double(column) + 0.5) / Columns);
      }
      table[row * Columns + column] = static_cast<float>(sum);
    }
  }
  return table;
}

double MeasuredError(const std::vector<float>& table, const MesoTableFactors& factors, int rank)
{
  double sum = 0.;
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double off = double(factors.GetValue(i / Columns, i % Columns, rank)) - table[i];
    sum += off * off;
  }
  return std::sqrt(sum / double(table.size()));
}
}

TEST(TableFactors, AreTheTableAtFullRank)
{
  const std::vector<float> table = MakeTable(5, 1.);
  MesoTableFactors factors;
  ASSERT_TRUE(factors.Compute(table.data(), Rows, Columns, 1000));
  EXPECT_EQ(factors.GetRank(), int(Columns));
  EXPECT_LT(MeasuredError(table, factors, Columns), 1e-6);
  EXPECT_LT(factors.GetError(Columns), 1e-6);
}

TEST(TableFactors, FindAsManyProductsAsThereAre)
{
  const std::vector<float> table = MakeTable(4, 0.);
  MesoTableFactors factors;
  ASSERT_TRUE(factors.Compute(table.data(), Rows, Columns, 6));
  EXPECT_GT(MeasuredError(table, factors, 3), 1e-2);
  EXPECT_LT(MeasuredError(table, factors, 4), 1e-6);
  EXPECT_LT(factors.GetSingularValues()[4], 1e-6 * factors.GetSingularValues()[0]);
}

TEST(TableFactors, KnowTheErrorOfEachRank)
{
  const std::vector<float> table = MakeTable(6, 0.1);
  MesoTableFactors factors;
  ASSERT_TRUE(factors.Compute(table.data(), Rows, Columns, 8));
  double last = factors.GetError(0);
  for (int rank = 1; rank <= 8; ++rank)
  {
    EXPECT_NEAR(MeasuredError(table, factors, rank), factors.GetError(rank), 1e-5) << rank;
    EXPECT_LT(factors.GetError(rank), last) << rank;
    last = factors.GetError(rank);
  }
}

// What the iteration finds in a part of the columns' space is what all of it holds.
TEST(TableFactors, AreNoWorseThanTheWholeDecomposition)
{
  const std::vector<float> table = MakeTable(12, 0.3);
  MesoTableFactors part;
  MesoTableFactors whole;
  ASSERT_TRUE(part.Compute(table.data(), Rows, Columns, 5));
  ASSERT_TRUE(whole.Compute(table.data(), Rows, Columns, int(Columns)));
  for (int rank = 1; rank <= 5; ++rank)
  {
    EXPECT_NEAR(part.GetError(rank), whole.GetError(rank), 1e-5 * whole.GetError(0)) << rank;
  }
}

TEST(TableFactors, HaveNothingToSayOfAnEmptyTable)
{
  for (const float value : { 0.f, 3.f })
  {
    const std::vector<float> table(Rows * Columns, value);
    MesoTableFactors factors;
    ASSERT_TRUE(factors.Compute(table.data(), Rows, Columns, 3));
    for (int rank = 1; rank <= 3; ++rank)
    {
      EXPECT_LT(MeasuredError(table, factors, rank), 1e-6) << value << " " << rank;
    }
    EXPECT_LT(factors.GetSingularValues()[1], 1e-4) << value;
  }
}

TEST(TableFactors, TakeTablesOfOneRowOrColumn)
{
  const std::vector<float> table = { 3.f, 4.f, 0.f };
  MesoTableFactors row;
  ASSERT_TRUE(row.Compute(table.data(), 1, 3, 2));
  EXPECT_NEAR(row.GetSingularValues()[0], 5., 1e-12);
  EXPECT_NEAR(row.GetValue(0, 1, 2), 4.f, 1e-6f);
  MesoTableFactors column;
  ASSERT_TRUE(column.Compute(table.data(), 3, 1, 2));
  EXPECT_EQ(column.GetRank(), 1);
  EXPECT_NEAR(column.GetValue(1, 0, 1), 4.f, 1e-6f);
}

TEST(TableFactors, StopWhenTold)
{
  const std::vector<float> table = MakeTable(5, 1.);
  MesoTableFactors factors;
  EXPECT_FALSE(
    factors.Compute(table.data(), Rows, Columns, 3, [](double done) { return done < 0.1; }));
}

TEST(TableFactors, AreTheSameEachTime)
{
  const std::vector<float> table = MakeTable(5, 1.);
  MesoTableFactors first;
  MesoTableFactors second;
  ASSERT_TRUE(first.Compute(table.data(), Rows, Columns, 3));
  ASSERT_TRUE(second.Compute(table.data(), Rows, Columns, 3));
  EXPECT_EQ(first.GetWeights(), second.GetWeights());
  EXPECT_EQ(first.GetEigenFunctions(), second.GetEigenFunctions());
}
