#include "MesoVolumeRay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace
{
/// A cubic by its coefficients, lowest first.
struct Cubic
{
  double Coefficient[4];

  double At(double t) const
  {
    return this->Coefficient[0] +
      t * (this->Coefficient[1] + t * (this->Coefficient[2] + t * this->Coefficient[3]));
  }

  /// The first t in [0, 1] where it is below 0, its value at 0 being none; more than 1 where there is none.
  double FirstBelow() const
  {
    double stops[4] = { 0., 1., 1., 1. };
    int count = 1;
    const double a = 3. * this->Coefficient[3];
    const double b = this->Coefficient[2];
    const double c = this->Coefficient[1];
    const double discriminant = b * b - a * c;
    if (discriminant > 0.)
    {
      const double q = -(b + std::copysign(std::sqrt(discriminant), b));
      double roots[2] = { a != 0. ? q / a : 2., q != 0. ? c / q : 2. };
      if (roots[0] > roots[1])
      {
        std::swap(roots[0], roots[1]);
      }
      for (const double root : roots)
      {
        if (root > stops[count - 1] && root < 1.)
        {
          stops[count++] = root;
        }
      }
    }
    stops[count] = 1.;
    for (int i = 0; i < count; ++i)
    {
      if (this->At(stops[i + 1]) < 0.)
      {
        return this->Bisect(stops[i], stops[i + 1]);
      }
    }
    return 2.;
  }

private:
  double Bisect(double above, double below) const
  {
    constexpr int Halvings = 52;
    for (int i = 0; i < Halvings; ++i)
    {
      const double middle = 0.5 * (above + below);
      (this->At(middle) < 0. ? below : above) = middle;
    }
    return below;
  }
};

/// A number along the ray within a cell: value + t * change.
struct Linear
{
  double Value;
  double Change;
};

/// The trilinear interpolant of a cell's corners (by z, y, x) along a ray, over [0, 1].
Cubic AlongRay(const double (&corner)[2][2][2], const Linear (&weight)[3])
{
  // Products of the three weights, one after another, each a polynomial.
  double sum[4] = { 0., 0., 0., 0. };
  for (int c = 0; c < 8; ++c)
  {
    double product[4] = { corner[c >> 2][(c >> 1) & 1][c & 1], 0., 0., 0. };
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isUpper = ((c >> axis) & 1) != 0;
      const double value = isUpper ? weight[axis].Value : 1. - weight[axis].Value;
      const double change = isUpper ? weight[axis].Change : -weight[axis].Change;
      for (int power = axis + 1; power > 0; --power)
      {
        product[power] = product[power] * value + product[power - 1] * change;
      }
      product[0] *= value;
    }
    for (int power = 0; power < 4; ++power)
    {
      sum[power] += product[power];
    }
  }
  return { { sum[0], sum[1], sum[2], sum[3] } };
}
}

MesoVolumeRay::MesoVolumeRay(const MesoVolumeField& field)
  : Field(field)
{
  this->FindFreeCells();
}

std::size_t MesoVolumeRay::NumberOf(const int (&cell)[3]) const
{
  const auto& size = this->Field.GetSize();
  const auto wrapped = [](int i, int period)
  { return i >= 0 && i < period ? i : (i % period + period) % period; };
  const int slice = std::clamp(cell[2] + 1, 0, size[2]);
  return (std::size_t(slice) * size[1] + wrapped(cell[1], size[1])) * size[0] +
    wrapped(cell[0], size[0]);
}

void MesoVolumeRay::FindFreeCells()
{
  constexpr unsigned char unknown = 255;
  const auto& size = this->Field.GetSize();
  this->Free.assign(std::size_t(size[0]) * size[1] * (size[2] + 1), unknown);
  // From the cells with solid outwards, shell by shell.
  std::vector<std::array<int, 3>> reached;
  for (int z = -1; z < size[2]; ++z)
  {
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        double corner[2][2][2];
        this->Field.Corners(x, y, z, corner);
        if (*std::min_element(&corner[0][0][0], &corner[0][0][0] + 8) < 0.)
        {
          this->Free[this->NumberOf({ x, y, z })] = 0;
          reached.push_back({ x, y, z });
        }
      }
    }
  }
  for (unsigned char steps = 1; steps < unknown && !reached.empty(); ++steps)
  {
    std::vector<std::array<int, 3>> next;
    for (const auto& [x, y, z] : reached)
    {
      for (int beside = 0; beside < 27; ++beside)
      {
        const int cell[3] = { x + beside % 3 - 1, y + beside / 3 % 3 - 1, z + beside / 9 - 1 };
        const bool isInShell = cell[2] >= -1 && cell[2] < size[2];
        if (isInShell && this->Free[this->NumberOf(cell)] == unknown)
        {
          this->Free[this->NumberOf(cell)] = steps;
          next.push_back({ (cell[0] + size[0]) % size[0], (cell[1] + size[1]) % size[1], cell[2] });
        }
      }
    }
    reached = std::move(next);
  }
}

double MesoVolumeRay::ToPlane(double z, double directionZ, double depth)
{
  return directionZ > 0. ? (1. - z) * depth / directionZ
    : directionZ < 0.    ? z * depth / -directionZ
                         : std::numeric_limits<double>::infinity();
}

MesoVolumeRay::Hit MesoVolumeRay::Cast(
  const Vector& origin, const Vector& direction, double reach) const
{
  if (this->Field.At(origin) < 0.)
  {
    return { true, 0. };
  }
  const auto& size = this->Field.GetSize();
  const double end =
    std::min(reach, MesoVolumeRay::ToPlane(origin[2], direction[2], this->Field.GetDepth()));
  // In samples, and how many of them a tile width along the ray is.
  double place[3];
  double speed[3];
  int cell[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    place[axis] = origin[axis] * size[axis] - 0.5;
    speed[axis] = direction[axis] * size[axis] / (axis == 2 ? this->Field.GetDepth() : 1.);
    cell[axis] = static_cast<int>(std::floor(place[axis]));
    if (speed[axis] < 0. && place[axis] == cell[axis])
    {
      --cell[axis];
    }
  }
  const auto toBorder = [&](int axis)
  {
    return speed[axis] == 0.
      ? std::numeric_limits<double>::infinity()
      : (cell[axis] + (speed[axis] > 0. ? 1 : 0) - place[axis]) / speed[axis];
  };
  const double fastest = std::max({ std::abs(speed[0]), std::abs(speed[1]), std::abs(speed[2]) });
  double start = 0.;
  while (start < end)
  {
    const int isFree = this->Free[this->NumberOf(cell)];
    if (isFree > 1)
    {
      // So far along the ray no axis has more than isFree - 1 borders, and beyond these there is a free cell still.
      start += (isFree - 1) / fastest;
      for (int axis = 0; axis < 3; ++axis)
      {
        cell[axis] = static_cast<int>(std::floor(place[axis] + start * speed[axis]));
      }
      continue;
    }
    int next = 0;
    for (int axis = 1; axis < 3; ++axis)
    {
      next = toBorder(axis) < toBorder(next) ? axis : next;
    }
    const double stop = std::min(end, std::max(start, toBorder(next)));
    if (isFree == 0)
    {
      double corner[2][2][2];
      this->Field.Corners(cell[0], cell[1], cell[2], corner);
      Linear weight[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        weight[axis] = { place[axis] + start * speed[axis] - cell[axis],
          (stop - start) * speed[axis] };
      }
      const double part = AlongRay(corner, weight).FirstBelow();
      if (part <= 1.)
      {
        return { true, start + part * (stop - start) };
      }
    }
    start = stop;
    cell[next] += speed[next] > 0. ? 1 : -1;
  }
  return { false, end };
}
