#include "MesoSplineCell.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Basis[4][4] = { { 1. / 6., 4. / 6., 1. / 6., 0. }, { -3. / 6., 0., 3. / 6., 0. },
  { 3. / 6., -6. / 6., 3. / 6., 0. },
  { -1. / 6., 3. / 6., -3. / 6., 1. / 6. } }; // of each power of a, for each control point

/// The two parts of an interval on both sides of a place in it, or the whole.
std::vector<std::array<double, 2>> Split(double low, double high, double least, double greatest)
{
  std::vector<std::array<double, 2>> parts;
  double from = low;
  for (const double cut : { least, greatest })
  {
    if (from < cut && cut < high)
    {
      parts.push_back({ from, cut });
      from = cut;
    }
  }
  parts.push_back({ from, high });
  return parts;
}
}

MesoSplineCell::MesoSplineCell(
  const MesoHeightPyramid& map, int column, int row, double x0, double y0)
{
  const auto side = [](const MesoHeightPyramid::Axis& axis, double start)
  {
    const double far = std::numeric_limits<double>::infinity();
    return axis.Clamped() ? Side{ start, -0.5, axis.Texels() - 0.5 } : Side{ start, -far, far };
  };
  this->X = side(map.X(), x0);
  this->Y = side(map.Y(), y0);
  const int x = map.X().FirstTexel(column);
  const int y = map.Y().FirstTexel(row);
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      this->Texels[j][i] = map.Height(x - 1 + i, y - 1 + j);
    }
  }
}

std::vector<MesoRect> MesoSplineCell::Parts(const MesoRect& rect) const
{
  std::vector<MesoRect> parts;
  if (rect.Empty())
  {
    return parts;
  }
  for (const auto& y : Split(rect.Y0, rect.Y1, this->Y.Least, this->Y.Greatest))
  {
    for (const auto& x : Split(rect.X0, rect.X1, this->X.Least, this->X.Greatest))
    {
      parts.push_back({ x[0], x[1], y[0], y[1] });
    }
  }
  return parts;
}

MesoSplineCell::Weights MesoSplineCell::WeightsOver(
  const Side& side, double low, double high, bool& level)
{
  const double middle = 0.5 * (low + high);
  level = middle < side.Least || middle > side.Greatest;
  const double a = std::min(std::max(middle, side.Least), side.Greatest) - side.Start;
  Weights weights = {};
  for (int k = 0; k < 4; ++k)
  {
    double power = 1.;
    for (int i = 0; i < 4; ++i)
    {
      weights[level ? 0 : i][k] += level ? Basis[i][k] * power : Basis[i][k];
      power *= a;
    }
  }
  return weights;
}

MesoHeightCell MesoSplineCell::Over(const MesoRect& part) const
{
  bool levelX = false;
  bool levelY = false;
  const Weights along = WeightsOver(this->X, part.X0, part.X1, levelX);
  const Weights across = WeightsOver(this->Y, part.Y0, part.Y1, levelY);
  MesoHeightCell cell = {};
  cell.X0 = this->X.Start;
  cell.Y0 = this->Y.Start;
  cell.Degree = 3;
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int texel = 0; texel < 16; ++texel)
      {
        cell.H[j][i] +=
          across[j][texel / 4] * along[i][texel % 4] * this->Texels[texel / 4][texel % 4];
      }
    }
  }
  // Derivatives of a B-spline are B-splines of the differences, and stay within their range.
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 2; ++i)
    {
      const auto& t = this->Texels;
      cell.MostXX = std::max(cell.MostXX, std::abs(t[j][i] - 2. * t[j][i + 1] + t[j][i + 2]));
      cell.MostYY = std::max(cell.MostYY, std::abs(t[i][j] - 2. * t[i + 1][j] + t[i + 2][j]));
    }
  }
  for (int j = 0; j < 3; ++j)
  {
    for (int i = 0; i < 3; ++i)
    {
      const auto& t = this->Texels;
      cell.MostXY =
        std::max(cell.MostXY, std::abs(t[j][i] - t[j][i + 1] - t[j + 1][i] + t[j + 1][i + 1]));
    }
  }
  cell.MostXX = levelX ? 0. : cell.MostXX;
  cell.MostXY = levelX || levelY ? 0. : cell.MostXY;
  cell.MostYY = levelY ? 0. : cell.MostYY;
  return cell;
}

glm::dvec3 MesoSplineCell::At(const MesoHeightPyramid& map, double x, double y)
{
  const auto along = [](const MesoHeightPyramid::Axis& axis, double place, std::int64_t& first,
                       std::array<double, 4>& weights, std::array<double, 4>& slopes)
  {
    const double inside =
      axis.Clamped() ? std::min(std::max(place, -0.5), axis.Texels() - 0.5) : place;
    const double cell = std::floor(inside);
    const double a = inside - cell;
    first = static_cast<std::int64_t>(cell) - 1;
    for (int k = 0; k < 4; ++k)
    {
      weights[k] = Basis[0][k] + a * (Basis[1][k] + a * (Basis[2][k] + a * Basis[3][k]));
      slopes[k] =
        inside == place ? Basis[1][k] + a * (2. * Basis[2][k] + a * 3. * Basis[3][k]) : 0.;
    }
  };
  std::int64_t column = 0;
  std::int64_t row = 0;
  std::array<double, 4> weightsX;
  std::array<double, 4> slopesX;
  std::array<double, 4> weightsY;
  std::array<double, 4> slopesY;
  along(map.X(), x, column, weightsX, slopesX);
  along(map.Y(), y, row, weightsY, slopesY);
  glm::dvec3 result(0.);
  for (int j = 0; j < 4; ++j)
  {
    for (int i = 0; i < 4; ++i)
    {
      result += map.Height(column + i, row + j) *
        glm::dvec3(weightsX[i] * weightsY[j], slopesX[i] * weightsY[j], weightsX[i] * slopesY[j]);
    }
  }
  return result;
}
