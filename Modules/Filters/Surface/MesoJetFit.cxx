#include "MesoJetFit.h"

#include "MesoLeastSquares.h"

#include <algorithm>

namespace
{
// Neighbours whose spread across is less than this part of that along lie on a line.
constexpr double LeastSpread = 1e-3;
// Elements of R relative to the first, below which a polynomial is not determined. Rings of a
// regular mesh give about 1e-2 in degree 4.
constexpr double RankTolerance = 2e-4;
// Of the precision that MesoJetFit.h defines: below, what is fitted is noise.
constexpr double LeastPrecision = 0.1;
// Curvatures that differ by less than this part of the larger are equal.
constexpr double UmbilicTolerance = 1e-9;

/// The neighbours in the frame of their second moments, in units of their spread.
struct Neighbourhood
{
  std::array<MesoVector, 2> Axes;
  MesoVector Normal;
  std::array<double, 2> Spread;   ///< root mean squares along the axes, the larger first
  std::vector<MesoVector> Places; ///< x / Spread[0], y / Spread[1], z / Spread[0]
  double Sidedness = 0.;
};

bool Place(const std::vector<MesoVector>& offsets, const MesoVector& normal, Neighbourhood& result)
{
  const std::array<MesoVector, 2> axes = MesoPerpendiculars(normal);
  const std::size_t size = std::min(offsets.size(), MesoMostJetNeighbours);
  double xx = 0.;
  double xy = 0.;
  double yy = 0.;
  result.Places.clear();
  for (std::size_t i = 0; i < size; ++i)
  {
    const MesoVector& q = offsets[i * offsets.size() / size];
    const MesoVector place = { MesoDot(q, axes[0]), MesoDot(q, axes[1]), MesoDot(q, normal) };
    xx += place[0] * place[0];
    xy += place[0] * place[1];
    yy += place[1] * place[1];
    result.Places.push_back(place);
  }
  const double angle = 0.5 * std::atan2(2. * xy, xx - yy);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  result.Normal = normal;
  result.Axes[0] = MesoSum(MesoScaled(axes[0], c), MesoScaled(axes[1], s));
  result.Axes[1] = MesoSum(MesoScaled(axes[1], c), MesoScaled(axes[0], -s));
  std::array<double, 2> square = { 0., 0. };
  std::array<double, 2> mean = { 0., 0. };
  for (MesoVector& place : result.Places)
  {
    place = { c * place[0] + s * place[1], c * place[1] - s * place[0], place[2] };
    for (std::size_t k = 0; k < 2; ++k)
    {
      square[k] += place[k] * place[k];
      mean[k] += place[k];
    }
  }
  for (std::size_t k = 0; k < 2; ++k)
  {
    result.Spread[k] = std::sqrt(square[k] / static_cast<double>(size));
  }
  if (!(result.Spread[1] > LeastSpread * result.Spread[0]) || !std::isfinite(result.Spread[0]))
  {
    return false;
  }
  const std::array<double, 2> inverse = { 1. / result.Spread[0], 1. / result.Spread[1] };
  for (MesoVector& place : result.Places)
  {
    place = { place[0] * inverse[0], place[1] * inverse[1], place[2] * inverse[0] };
  }
  const double x = mean[0] * inverse[0] / static_cast<double>(size);
  const double y = mean[1] * inverse[1] / static_cast<double>(size);
  result.Sidedness = std::max(0., 1. - 0.5 * (x * x + y * y));
  return true;
}

/// Derivatives of the height in the frame, in object units, and the deviation of the second ones.
struct Jet
{
  double X, Y, XX, XY, YY;
  double Deviation;
};

template <int Degree>
bool Fit(const Neighbourhood& hood, Jet& jet)
{
  constexpr std::size_t columns = (Degree + 1) * (Degree + 2) / 2 - 1;
  constexpr std::size_t least = Degree == 4 ? MesoQuarticNeighbours : (Degree == 3 ? 12 : 6);
  if (hood.Places.size() < least)
  {
    return false;
  }
  MesoLeastSquares<columns, MesoMostJetNeighbours> system;
  for (const MesoVector& place : hood.Places)
  {
    const double x = place[0];
    const double y = place[1];
    auto& row = system.AddRow();
    row[0] = x;
    row[1] = y;
    std::size_t column = 2;
    // Each degree is the one before times x, and its last term times y.
    for (int degree = 2; degree <= Degree; ++degree)
    {
      for (int k = 0; k < degree; ++k)
      {
        row[column] = x * row[column - degree];
        ++column;
      }
      row[column] = y * row[column - degree - 1];
      ++column;
    }
    row[columns] = place[2];
  }
  if (!system.Solve(RankTolerance))
  {
    return false;
  }
  const auto& a = system.GetSolution();
  const double along = 1. / hood.Spread[0];
  const double across = 1. / hood.Spread[1];
  const double ratio = hood.Spread[0] * across;
  jet.X = a[0];
  jet.Y = a[1] * ratio;
  jet.XX = 2. * a[2] * along;
  jet.XY = a[3] * across;
  jet.YY = 2. * a[4] * ratio * across;
  const double xx = 2. * along * system.Sensitivity(2);
  const double xy = across * system.Sensitivity(3);
  const double yy = 2. * ratio * across * system.Sensitivity(4);
  jet.Deviation = system.ResidualDeviation() * std::sqrt(xx * xx + 2. * xy * xy + yy * yy);
  return std::isfinite(jet.X + jet.Y + jet.XX + jet.XY + jet.YY + jet.Deviation);
}

bool FitDegree(int degree, const Neighbourhood& hood, Jet& jet)
{
  switch (degree)
  {
    case 4:
      return Fit<4>(hood, jet);
    case 3:
      return Fit<3>(hood, jet);
    default:
      return Fit<2>(hood, jet);
  }
}

/// Eigenvalues of the shape operator at the origin of the graph, with directions in object space.
void Diagonalize(const Neighbourhood& hood, const Jet& jet, MesoPrincipalCurvature& result)
{
  // L = [a, 0; b, c]; the columns of J L^-T are orthonormal tangents, J = [ru, rv].
  const double a = std::sqrt(1. + jet.X * jet.X);
  const double b = jet.X * jet.Y / a;
  const double root = std::sqrt(1. + jet.X * jet.X + jet.Y * jet.Y);
  const double c = root / a;
  const double m11 = jet.XX / (a * a) / root;
  const double m12 = (jet.XY - jet.XX * b / a) / (a * c) / root;
  const double m22 = (jet.YY - 2. * jet.XY * b / a + jet.XX * b * b / (a * a)) / (c * c) / root;
  const MesoVector ru = MesoSum(hood.Axes[0], MesoScaled(hood.Normal, jet.X));
  const MesoVector rv = MesoSum(hood.Axes[1], MesoScaled(hood.Normal, jet.Y));
  const MesoVector first = MesoScaled(ru, 1. / a);
  const MesoVector second = MesoScaled(MesoDifference(rv, MesoScaled(ru, b / a)), 1. / c);

  const double mean = -0.5 * (m11 + m22);
  const double half = 0.5 * (m22 - m11);
  const double radius = std::hypot(half, m12);
  result.Maximum = mean + radius;
  result.Minimum = mean - radius;
  if (radius > UmbilicTolerance * (std::abs(mean) + radius))
  {
    const double angle = 0.5 * std::atan2(-m12, half);
    result.MaximumDirection =
      MesoSum(MesoScaled(first, std::cos(angle)), MesoScaled(second, std::sin(angle)));
    result.MinimumDirection =
      MesoSum(MesoScaled(second, std::cos(angle)), MesoScaled(first, -std::sin(angle)));
  }
  else
  {
    const MesoVector normal = MesoCross(first, second);
    const std::array<MesoVector, 2> axes = MesoPerpendiculars(normal);
    result.MaximumDirection = axes[0];
    result.MinimumDirection = axes[1];
  }
}
}

MesoPrincipalCurvature MesoFitJet(
  const std::vector<MesoVector>& offsets, const MesoVector& normal, int highest, int lowest)
{
  MesoPrincipalCurvature result;
  Neighbourhood hood;
  Jet jet;
  if (offsets.empty() || !Place(offsets, normal, hood))
  {
    return result;
  }
  const double radius = std::hypot(hood.Spread[0], hood.Spread[1]);
  double precision = 0.;
  int degree = highest + 1;
  while (precision < LeastPrecision && --degree >= lowest)
  {
    precision = FitDegree(degree, hood, jet) ? 1. / (1. + radius * jet.Deviation) : 0.;
  }
  if (degree < lowest)
  {
    return result;
  }
  Diagonalize(hood, jet, result);
  result.Degree = degree;
  result.Confidence = 0.25 * degree * hood.Sidedness * precision;
  return result;
}

std::array<MesoVector, 2> MesoPerpendiculars(const MesoVector& normal)
{
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    least = std::abs(normal[k]) < std::abs(normal[least]) ? k : least;
  }
  MesoVector axis = { 0., 0., 0. };
  axis[least] = 1.;
  MesoVector first = MesoDifference(axis, MesoScaled(normal, MesoDot(axis, normal)));
  first = MesoScaled(first, 1. / MesoLength(first));
  return { first, MesoCross(normal, first) };
}
