#include "MesoQuadric.h"

#include "MesoLeastSquares.h"

namespace
{
constexpr std::size_t MostNeighbours = 256;
constexpr double WorstCondition = 1e6;
// Of R's diagonal, far below what the worst condition allows.
constexpr double RankTolerance = 1e-9;

/// Singular values' ratio of the columns, which are orthogonalized in pairs (one-sided Jacobi); 0
/// where one vanishes.
template <std::size_t N>
double ConditionOf(std::array<std::array<double, N>, N> column)
{
  const auto dot = [&](std::size_t p, std::size_t q)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < N; ++i)
    {
      sum += column[p][i] * column[q][i];
    }
    return sum;
  };
  constexpr int sweeps = 12; // convergence is quadratic
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (std::size_t p = 0; p + 1 < N; ++p)
    {
      for (std::size_t q = p + 1; q < N; ++q)
      {
        const double angle = 0.5 * std::atan2(2. * dot(p, q), dot(p, p) - dot(q, q));
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        for (std::size_t i = 0; i < N; ++i)
        {
          const double a = column[p][i];
          const double b = column[q][i];
          column[p][i] = c * a + s * b;
          column[q][i] = c * b - s * a;
        }
      }
    }
  }
  double largest = 0.;
  double least = dot(0, 0);
  for (std::size_t p = 0; p < N; ++p)
  {
    largest = std::max(largest, dot(p, p));
    least = std::min(least, dot(p, p));
  }
  return least > 0. ? std::sqrt(largest / least) : 0.;
}

/// Solves A^T A x = A^T b by Cholesky's factorization, without pivots as a 2 x 2 inverse is.
template <std::size_t N, typename System>
bool SolveNormalEquations(const System& system, std::size_t rows, std::array<double, N>& solution)
{
  std::array<std::array<double, N + 1>, N> m{};
  for (std::size_t i = 0; i < rows; ++i)
  {
    for (std::size_t j = 0; j < N; ++j)
    {
      for (std::size_t k = 0; k <= N; ++k)
      {
        m[j][k] += system.GetRow(i)[j] * system.GetRow(i)[k];
      }
    }
  }
  for (std::size_t j = 0; j < N; ++j)
  {
    for (std::size_t k = 0; k < j; ++k)
    {
      const double factor = m[j][k] / m[k][k];
      for (std::size_t l = k; l <= N; ++l)
      {
        m[j][l] -= factor * m[k][l];
      }
    }
    if (!(m[j][j] > 0.))
    {
      return false;
    }
  }
  for (std::size_t j = N; j-- > 0;)
  {
    double value = m[j][N];
    for (std::size_t k = j + 1; k < N; ++k)
    {
      value -= m[j][k] * solution[k];
    }
    solution[j] = value / m[j][j];
  }
  return true;
}

/// N unknowns: a, b, then c where Full, then two slopes where there are two more.
template <std::size_t N, bool Full>
bool Fit(const std::vector<MesoVector>& places, MesoQuadricSolver solver, MesoQuadric& result)
{
  if (places.size() < N)
  {
    return false;
  }
  MesoLeastSquares<N, MostNeighbours> system;
  for (const MesoVector& place : places)
  {
    const double x = place[0];
    const double y = place[1];
    auto& row = system.AddRow();
    std::size_t column = 0;
    row[column++] = x * x;
    row[column++] = y * y;
    if (Full)
    {
      row[column++] = x * y;
    }
    if (column < N)
    {
      row[column++] = x;
      row[column++] = y;
    }
    row[N] = place[2];
  }
  std::array<double, N> solution{};
  const bool normal = solver == MesoQuadricSolver::NormalEquations;
  const bool solved = !normal || SolveNormalEquations<N>(system, places.size(), solution);
  if (!solved || !system.Solve(RankTolerance))
  {
    return false;
  }
  if (!normal)
  {
    solution = system.GetSolution();
  }
  std::array<std::array<double, N>, N> triangle;
  for (std::size_t j = 0; j < N; ++j)
  {
    for (std::size_t i = 0; i < N; ++i)
    {
      triangle[j][i] = system.Triangle(i, j);
    }
  }
  const double condition = ConditionOf<N>(triangle);
  const bool good = condition > 0. && condition <= WorstCondition;
  if (good)
  {
    result = { solution[0], solution[1], Full ? solution[2] : 0., condition };
  }
  return good;
}
}

MesoQuadric MesoFitQuadric(const std::vector<MesoVector>& offsets, const MesoVector& x,
  const MesoVector& y, const MesoVector& normal, const MesoQuadricOptions& options)
{
  const std::size_t size = std::min(offsets.size(), MostNeighbours);
  std::vector<MesoVector> places;
  places.reserve(size);
  double square = 0.;
  double deepest = 0.;
  for (std::size_t i = 0; i < size; ++i)
  {
    const MesoVector& q = offsets[i * offsets.size() / size];
    places.push_back({ MesoDot(q, x), MesoDot(q, y), -MesoDot(q, normal) });
    square += MesoDot(q, q);
    deepest = std::max(deepest, std::abs(places.back()[2]));
  }
  const double unit = std::sqrt(square / static_cast<double>(size));
  if (size == 0 || !(unit > 0.) || !std::isfinite(unit))
  {
    return {};
  }
  const bool flat = deepest <= options.Rounding;
  for (MesoVector& place : places)
  {
    place = { place[0] / unit, place[1] / unit, flat ? 0. : place[2] / unit };
  }
  MesoQuadric result;
  const bool done = options.Slopes &&
    (options.Full ? Fit<5, true>(places, options.Solver, result)
                  : Fit<4, false>(places, options.Solver, result));
  if (!done)
  {
    options.Full ? Fit<3, true>(places, options.Solver, result)
                 : Fit<2, false>(places, options.Solver, result);
  }
  result.A /= unit;
  result.B /= unit;
  result.C /= unit;
  return std::isfinite(result.A + result.B + result.C) ? result : MesoQuadric();
}
