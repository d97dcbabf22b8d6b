#include "MesoTableFactors.h"

#include "vtkSMPTools.h"

#include <Eigen/Dense>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

namespace
{
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Table = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Directions beside those asked for, so that the last of them is found as fast as the first.
constexpr int ExtraDirections = 8;
constexpr int MostIterations = 30;
/// Tables of so few columns take less time by one pass for their Gram matrix than by several.
constexpr Eigen::Index GramColumns = 256;
/// Change of a singular value, relative to the largest, at which the iteration ends.
constexpr double SettledChange = 1e-5;
constexpr std::size_t RowsPerBlock = 4096;

/// Sums over blocks of rows in an order that does not depend on threads.
class Blocks
{
public:
  Blocks(const float* table, std::size_t rows, std::size_t columns)
    : Numbers(table)
    , Rows(rows)
    , Columns(columns)
  {
  }

  /// The sum of f(A_block) over the blocks, each of the size of `sum`, which comes in as zeros.
  template <typename F>
  void Sum(Matrix& sum, const F& f) const
  {
    const std::size_t count = (this->Rows + RowsPerBlock - 1) / RowsPerBlock;
    std::vector<Matrix> parts(count);
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType block = begin; block < end; ++block)
        {
          parts[block] = f(this->Block(block));
        }
      });
    for (const Matrix& part : parts)
    {
      sum += part;
    }
  }

  /// A_block in double precision.
  Matrix Block(std::size_t block) const
  {
    const std::size_t first = block * RowsPerBlock;
    const std::size_t rows = std::min(RowsPerBlock, this->Rows - first);
    return Eigen::Map<const Table>(this->Numbers + first * this->Columns,
      static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(this->Columns))
      .cast<double>();
  }

private:
  const float* Numbers;
  std::size_t Rows;
  std::size_t Columns;
};

/// Orthonormal columns that span those of `matrix`, completed where they are dependent.
Matrix Orthonormal(const Matrix& matrix)
{
  const Eigen::HouseholderQR<Matrix> factors(matrix);
  return factors.householderQ() * Matrix::Identity(matrix.rows(), matrix.cols());
}

/// Directions to begin with: all of them, or as many as asked for at random, the same at each call.
Matrix FirstDirections(Eigen::Index columns, Eigen::Index count)
{
  if (count == columns)
  {
    return Matrix::Identity(columns, columns);
  }
  std::mt19937 random(1);
  Matrix directions(columns, count);
  for (Eigen::Index i = 0; i < directions.size(); ++i)
  {
    directions.data()[i] = double(random()) / double(std::mt19937::max()) - 0.5;
  }
  return Orthonormal(directions);
}
}

bool MesoTableFactors::Compute(
  const float* table, std::size_t rows, std::size_t columns, int rank, const Progress& progress)
{
  this->Rows = rows;
  this->Columns = columns;
  const auto width = static_cast<Eigen::Index>(columns);
  const Eigen::Index kept = std::min(static_cast<Eigen::Index>(rank), width);
  const Eigen::Index count = width <= GramColumns ? width : std::min(kept + ExtraDirections, width);
  const Blocks blocks(table, rows, columns);
  const auto goesOn = [&](double done) { return !progress || progress(done); };

  Matrix squares = Matrix::Zero(1, 1);
  blocks.Sum(squares,
    [](const Matrix& block) -> Matrix { return Matrix::Constant(1, 1, block.squaredNorm()); });
  this->SquareSum = squares(0, 0);

  Matrix directions = FirstDirections(width, count);
  Eigen::VectorXd last = Eigen::VectorXd::Zero(count);
  for (int iteration = 0; count < width && iteration < MostIterations; ++iteration)
  {
    if (!goesOn(0.8 * iteration / MostIterations))
    {
      return false;
    }
    Matrix image = Matrix::Zero(width, count); // A^T A Q
    blocks.Sum(image,
      [&](const Matrix& block) -> Matrix { return block.transpose() * (block * directions); });
    // Ritz values: the squares of singular values as far as they are known.
    const Matrix small = directions.transpose() * image;
    const Eigen::VectorXd squared =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(small, Eigen::EigenvaluesOnly).eigenvalues();
    const Eigen::VectorXd values = squared.cwiseMax(0.).cwiseSqrt().reverse();
    const double change = (values - last).head(kept).cwiseAbs().maxCoeff();
    last = values;
    directions = Orthonormal(image);
    if (change <= SettledChange * values(0))
    {
      break;
    }
  }
  if (!goesOn(0.8))
  {
    return false;
  }

  Matrix gram = Matrix::Zero(count, count); // (A Q)^T (A Q)
  blocks.Sum(gram,
    [&](const Matrix& block) -> Matrix
    {
      const Matrix projected = count < width ? Matrix(block * directions) : block;
      Matrix product = Matrix::Zero(count, count);
      product.selfadjointView<Eigen::Lower>().rankUpdate(projected.transpose());
      return product; // its lower half, which is all that is looked at
    });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(gram);
  // Eigen sorts upwards.
  Matrix functions = directions * solved.eigenvectors().rowwise().reverse().leftCols(kept);
  this->SingularValues.resize(kept);
  for (Eigen::Index i = 0; i < kept; ++i)
  {
    this->SingularValues[i] = std::sqrt(std::max(0., solved.eigenvalues()(count - 1 - i)));
    Eigen::Index largest = 0;
    functions.col(i).cwiseAbs().maxCoeff(&largest);
    if (functions(largest, i) < 0.)
    {
      functions.col(i) *= -1.;
    }
  }
  this->EigenFunctions.resize(columns * kept);
  Eigen::Map<Table>(this->EigenFunctions.data(), width, kept) = functions.cast<float>();

  this->Weights.resize(rows * kept);
  vtkSMPTools::For(0, static_cast<vtkIdType>((rows + RowsPerBlock - 1) / RowsPerBlock), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const Matrix weights = blocks.Block(block) * functions;
        std::transform(weights.data(), weights.data() + weights.size(),
          this->Weights.data() + block * RowsPerBlock * kept,
          [](double weight) { return static_cast<float>(weight); });
      }
    });
  return goesOn(1.);
}

double MesoTableFactors::GetError(int rank) const
{
  double left = this->SquareSum;
  for (int i = 0; i < std::min(rank, this->GetRank()); ++i)
  {
    left -= this->SingularValues[i] * this->SingularValues[i];
  }
  return std::sqrt(std::max(0., left) / (double(this->Rows) * double(this->Columns)));
}

float MesoTableFactors::GetValue(std::size_t row, std::size_t column, int rank) const
{
  const std::size_t stride = this->SingularValues.size();
  const float* weights = this->Weights.data() + row * stride;
  const float* functions = this->EigenFunctions.data() + column * stride;
  float sum = 0.f;
  for (int i = 0; i < std::min(rank, this->GetRank()); ++i)
  {
    sum += weights[i] * functions[i];
  }
  return sum;
}
