#include "MesoHorizonSweep.h"

#include "MesoKernels.h"

#include <algorithm>
#include <cmath>

namespace
{
/// The map along a direction: `a` counts texels along the axis that the direction is nearer to, towards
/// where it points, `b` along the other.
class Turned
{
public:
  Turned(const std::vector<float>& heights, int width, int height, MesoWrap wrap, double texelsU,
    double texelsV)
    : Field(1, 1, wrap, { 0.f })
    , Heights(heights)
    , Width(width)
    , Sizes{ width, height }
    , Wrap(static_cast<int>(wrap))
    , AlongU(std::abs(texelsU) >= std::abs(texelsV))
    , Backwards((this->AlongU ? texelsU : texelsV) < 0.)
    , Slope((this->AlongU ? texelsV : texelsU) / std::abs(this->AlongU ? texelsU : texelsV))
    , TilesPerStep(1. / std::abs(this->AlongU ? texelsU : texelsV))
  {
  }

  int Along() const { return this->AlongU ? this->Sizes[0] : this->Sizes[1]; }
  int Across() const { return this->AlongU ? this->Sizes[1] : this->Sizes[0]; }

  /// Index of the texel, which may lie outside of the map.
  std::size_t IndexOf(int a, int b) const
  {
    const int forward = this->Backwards ? this->Along() - 1 - a : a;
    const int column =
      this->Field.wrapTexel(this->AlongU ? forward : b, this->Sizes[0], this->Wrap);
    const int row = this->Field.wrapTexel(this->AlongU ? b : forward, this->Sizes[1], this->Wrap);
    return std::size_t(row) * this->Width + column;
  }
  double HeightOf(int a, int b) const { return this->Heights[this->IndexOf(a, b)]; }

  double GetSlope() const { return this->Slope; } ///< of b, for a step of a
  double GetTilesPerStep() const { return this->TilesPerStep; }

private:
  MesoKernels::Double::HeightField Field; // for the kernel's way of wrapping
  const std::vector<float>& Heights;
  int Width;
  int Sizes[2];
  int Wrap;
  bool AlongU;
  bool Backwards;
  double Slope;
  double TilesPerStep;
};

/// The upper convex hull of points that come in order of falling x.
class Hull
{
public:
  /// Adds a point; gives the slope of its tangent to those before, or 0 where all of them fall off.
  double Add(double x, double height)
  {
    const auto slopeTo = [&](const Point& point)
    { return (point.Height - height) / (point.X - x); };
    while (this->Points.size() > 1 &&
      slopeTo(this->Points.back()) <= slopeTo(this->Points[this->Points.size() - 2]))
    {
      this->Points.pop_back();
    }
    const double slope = this->Points.empty() ? 0. : slopeTo(this->Points.back());
    this->Points.push_back({ x, height });
    return std::max(0., slope);
  }

  void Clear() { this->Points.clear(); }

private:
  struct Point
  {
    double X;
    double Height;
  };
  std::vector<Point> Points;
};

/// The line b = c + slope a, within what its texels can see.
class Line
{
public:
  Line(const Turned& map, int c)
    : Map(map)
    , C(c)
  {
  }

  /// Height at a column of texel centres. low: the row at or above it; above: how far above, [0,1).
  double At(int a, int& row, double& above) const
  {
    const double base = this->Map.GetSlope() * a;
    const double upper = std::ceil(base);
    above = upper - base;
    row = this->C + static_cast<int>(upper);
    const double high = this->Map.HeightOf(a, row);
    return above > 0. ? high + above * (this->Map.HeightOf(a, row - 1) - high) : high;
  }

  /// Adds what lies between columns a and a + 1, the further end first: the crossing with a row, where
  /// there is one, and the middles. Gives the slope of the surface itself, from column a onwards.
  double AddBetween(int a, Hull& hull) const
  {
    const double slope = this->Map.GetSlope();
    int row = 0;
    double above = 0.;
    const double start = this->At(a, row, above);
    double end = a + 1.;
    double height = this->At(a + 1, row, above);
    if (slope == 0.)
    {
      return height - start; // straight between the columns
    }
    const double here = slope * a;
    const double crossed = slope > 0. ? std::floor(here) + 1. : std::ceil(here) - 1.;
    const double part = (crossed - here) / slope;
    // At a column's own centre there is a sample already; two that differ by rounding have no slope.
    constexpr double apart = 1e-6;
    if (part > apart && part < 1. - apart)
    {
      hull.Add(a + 0.5 * (part + 1.), this->Within(a + 0.5 * (part + 1.)));
      end = a + part;
      height = this->Within(end);
      hull.Add(end, height);
    }
    const double middle = this->Within(0.5 * (a + end));
    hull.Add(0.5 * (a + end), middle);
    return (4. * middle - 3. * start - height) / (end - a); // of the parabola through the three
  }

private:
  /// The bilinear height anywhere on the line.
  double Within(double along) const
  {
    const double across = this->Map.GetSlope() * along;
    const double a = std::floor(along);
    const double b = std::floor(across);
    const auto at = [&](int i, int j)
    { return this->Map.HeightOf(static_cast<int>(a) + i, this->C + static_cast<int>(b) + j); };
    const double low = at(0, 0) + (along - a) * (at(1, 0) - at(0, 0));
    const double high = at(0, 1) + (along - a) * (at(1, 1) - at(0, 1));
    return low + (across - b) * (high - low);
  }

  const Turned& Map;
  int C;
};
}

MesoHorizonSweep::MesoHorizonSweep(int width, int height, MesoWrap wrap,
  const std::vector<float>& heights, double reach, double scale)
  : Width(width)
  , Height(height)
  , Wrap(wrap)
  , Heights(heights)
  , Reach(reach)
  , Scale(scale)
{
}

std::vector<float> MesoHorizonSweep::Sweep(double azimuth) const
{
  // Directions along an axis are meant exactly.
  const auto exact = [](double part) { return std::abs(part) < 1e-12 ? 0. : part; };
  const Turned map(this->Heights, this->Width, this->Height, this->Wrap,
    exact(std::cos(azimuth)) * this->Width, exact(std::sin(azimuth)) * this->Height);
  std::vector<float> angles(this->Heights.size(), 0.f);
  const int along = map.Along();
  const int across = map.Across();
  const int ahead = static_cast<int>(std::ceil(this->Reach / map.GetTilesPerStep()));
  const double slope = map.GetSlope();
  const auto lowest = static_cast<int>(std::floor(-std::max(0., slope * (along - 1)))) - 1;
  const auto highest = across + static_cast<int>(std::ceil(-std::min(0., slope * (along - 1))));
  Hull hull;
  for (int c = lowest; c <= highest; ++c)
  {
    const Line line(map, c);
    // Where it has a texel of the map on it or beside it.
    int first = along;
    int last = -1;
    for (const int end : { 0, along - 1 })
    {
      const double b = c + slope * end;
      if (b > -1. && b < across)
      {
        first = std::min(first, end);
        last = std::max(last, end);
      }
    }
    if (slope != 0.)
    {
      for (const double side : { -1., double(across) })
      {
        const double a = (side - c) / slope;
        if (a >= 0. && a <= along - 1)
        {
          first = std::min(first, static_cast<int>(std::floor(a)));
          last = std::max(last, static_cast<int>(std::ceil(a)));
        }
      }
    }
    hull.Clear();
    int row = 0;
    double above = 0.;
    for (int a = last + ahead; a > last; --a)
    {
      line.AddBetween(a, hull);
      hull.Add(a, line.At(a, row, above));
    }
    for (int a = std::min(last, along - 1); a >= first; --a)
    {
      const double own = line.AddBetween(a, hull);
      const double rise =
        std::max(own, hull.Add(a, line.At(a, row, above))) / map.GetTilesPerStep();
      const double angle = std::atan(this->Scale * rise);
      if (row >= 0 && row < across)
      {
        angles[map.IndexOf(a, row)] += static_cast<float>((1. - above) * angle);
      }
      if (above > 0. && row - 1 >= 0 && row - 1 < across)
      {
        angles[map.IndexOf(a, row - 1)] += static_cast<float>(above * angle);
      }
    }
  }
  return angles;
}
