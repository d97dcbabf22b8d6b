#ifndef MesoLeastSquares_h
#define MesoLeastSquares_h

/**
 * @file MesoLeastSquares.h
 * @brief Least squares with few unknowns: Householder QR with column pivoting, without allocation.
 *
 * Columns are scaled to unit length first, so that the rank does not depend on their units. Rows
 * are contiguous, so that both halves of a reflection run along them.
 */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

template <std::size_t Columns, std::size_t MaximumRows>
class MesoLeastSquares
{
public:
  static constexpr std::size_t Width = Columns + 1; ///< the right-hand side is the last
  using RowType = std::array<double, Width>;

  /// The next row to fill; at most MaximumRows may be added.
  RowType& AddRow() { return this->Row[this->Rows++]; }
  const RowType& GetRow(std::size_t i) const { return this->Row[i]; }
  std::size_t NumberOfRows() const { return this->Rows; }

  /// Whether there is one solution: the diagonal of R does not fall below `tolerance` times its
  /// first element. The rows are consumed.
  bool Solve(double tolerance)
  {
    if (this->Rows < Columns || !this->ScaleColumns())
    {
      return false;
    }
    for (std::size_t k = 0; k < Columns; ++k)
    {
      this->Pivot(k);
      if (!this->Reflect(k) || !(std::abs(this->Row[k][k]) > tolerance * std::abs(this->Row[0][0])))
      {
        return false;
      }
    }
    this->Substitute();
    return true;
  }

  /// By column, after Solve().
  const std::array<double, Columns>& GetSolution() const { return this->Solution; }

  /// Root of the mean square of what is left, over the rows that are more than the unknowns; 0
  /// where there are none.
  double ResidualDeviation() const
  {
    double sum = 0.;
    for (std::size_t i = Columns; i < this->Rows; ++i)
    {
      sum += this->Row[i][Columns] * this->Row[i][Columns];
    }
    return this->Rows > Columns ? std::sqrt(sum / static_cast<double>(this->Rows - Columns)) : 0.;
  }

  /// By how much errors of standard deviation 1 in the right-hand sides change a column's solution:
  /// the root of the diagonal of (A^T A)^-1.
  double Sensitivity(std::size_t column) const
  {
    const auto place = static_cast<std::size_t>(
      std::find(this->Column.begin(), this->Column.end(), column) - this->Column.begin());
    std::array<double, Columns> y{};
    double sum = 0.;
    for (std::size_t i = place; i < Columns; ++i)
    {
      double value = i == place ? 1. : 0.;
      for (std::size_t j = place; j < i; ++j)
      {
        value -= this->Row[j][i] * y[j];
      }
      y[i] = value / this->Row[i][i];
      sum += y[i] * y[i];
    }
    return std::sqrt(sum) * this->Scale[column];
  }

  /// Element of R, whose columns are pivoted and of unit length before the factorization.
  double Triangle(std::size_t row, std::size_t column) const
  {
    return row <= column ? this->Row[row][column] : 0.;
  }

private:
  bool ScaleColumns()
  {
    std::array<double, Columns> square{};
    for (std::size_t i = 0; i < this->Rows; ++i)
    {
      for (std::size_t j = 0; j < Columns; ++j)
      {
        square[j] += this->Row[i][j] * this->Row[i][j];
      }
    }
    for (std::size_t j = 0; j < Columns; ++j)
    {
      if (!(square[j] > 0.) || !std::isfinite(square[j]))
      {
        return false;
      }
      this->Column[j] = j;
      this->Scale[j] = 1. / std::sqrt(square[j]);
      this->Left[j] = 1.;
    }
    for (std::size_t i = 0; i < this->Rows; ++i)
    {
      for (std::size_t j = 0; j < Columns; ++j)
      {
        this->Row[i][j] *= this->Scale[j];
      }
    }
    return true;
  }

  /// Moves the column with most left to it to place k.
  void Pivot(std::size_t k)
  {
    const auto best = static_cast<std::size_t>(
      std::max_element(this->Left.begin() + k, this->Left.end()) - this->Left.begin());
    if (best != k)
    {
      std::swap(this->Left[k], this->Left[best]);
      std::swap(this->Column[k], this->Column[best]);
      for (std::size_t i = 0; i < this->Rows; ++i)
      {
        std::swap(this->Row[i][k], this->Row[i][best]);
      }
    }
  }

  bool Reflect(std::size_t k)
  {
    double square = 0.;
    for (std::size_t i = k; i < this->Rows; ++i)
    {
      square += this->Row[i][k] * this->Row[i][k];
    }
    const double length = std::copysign(std::sqrt(square), this->Row[k][k]);
    const double first = this->Row[k][k] + length; // no cancellation
    if (!(square > 0.))
    {
      return false;
    }
    const double factor = 1. / (length * first);
    std::array<double, Width> sum{};
    for (std::size_t i = k; i < this->Rows; ++i)
    {
      const double v = i == k ? first : this->Row[i][k];
      for (std::size_t j = k + 1; j < Width; ++j)
      {
        sum[j] += v * this->Row[i][j];
      }
    }
    for (std::size_t i = k; i < this->Rows; ++i)
    {
      const double v = factor * (i == k ? first : this->Row[i][k]);
      for (std::size_t j = k + 1; j < Width; ++j)
      {
        this->Row[i][j] -= v * sum[j];
      }
    }
    this->Row[k][k] = -length;
    for (std::size_t j = k + 1; j < Columns; ++j)
    {
      this->Left[j] = std::max(0., this->Left[j] - this->Row[k][j] * this->Row[k][j]);
    }
    return true;
  }

  void Substitute()
  {
    for (std::size_t i = Columns; i-- > 0;)
    {
      double value = this->Row[i][Columns];
      for (std::size_t j = i + 1; j < Columns; ++j)
      {
        value -= this->Row[i][j] * this->Solution[this->Column[j]];
      }
      this->Solution[this->Column[i]] = value / this->Row[i][i];
    }
    for (std::size_t j = 0; j < Columns; ++j)
    {
      this->Solution[j] *= this->Scale[j];
    }
  }

  std::size_t Rows = 0;
  std::array<RowType, MaximumRows> Row;
  std::array<std::size_t, Columns> Column;
  std::array<double, Columns> Scale;
  std::array<double, Columns> Left; ///< squared lengths of what is not reflected yet
  std::array<double, Columns> Solution;
};

#endif
