#include "MesoVolumeFields.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Pi = 3.141592653589793238462643;

/// From the middle of the nearest of `count` places that are evenly spaced over a tile; `number` of it.
double FromNearest(double x, int count, int& number)
{
  number = static_cast<int>(std::floor(x * count));
  return x - (number + 0.5) / count;
}

/**
 * Threads of elliptic cross-section whose centre lines are sines; where two cross they touch. The
 * ellipse's distance is that of its implicit function over the length of its gradient.
 */
class WeaveVolume : public MesoVolumePattern::Field
{
public:
  explicit WeaveVolume(const MesoPatternValues& values)
    : Threads(static_cast<int>(values.at("threads")))
    , HalfWidth(0.5 * values.at("width") / this->Threads)
    , HalfThickness(0.25 * values.at("thickness") * values.at("depth"))
    , Middle(0.5 * values.at("depth"))
  {
  }

  double At(double x, double y, double z) const override
  {
    return std::min(this->Thread(x, y, z, 1.), this->Thread(y, x, z, -1.));
  }

private:
  /// Of the threads of one way, at `along` and `across` them; `side` is that of their first crossing.
  double Thread(double along, double across, double z, double side) const
  {
    int number = 0;
    const double dy = FromNearest(across, this->Threads, number);
    const double phase = Pi * (along * this->Threads - 0.5 - number);
    const double dz = z - this->Middle - side * this->HalfThickness * std::cos(phase);
    const double slope = -side * this->HalfThickness * Pi * this->Threads * std::sin(phase);
    const double a = this->HalfWidth;
    const double b = this->HalfThickness;
    const double q = std::hypot(dy / a, dz / b);
    const double gradient = std::hypot(dy / (a * a), dz / (b * b) * std::hypot(1., slope));
    return gradient > 0. ? (q - 1.) * q / gradient : -std::min(a, b);
  }

  int Threads;
  double HalfWidth;
  double HalfThickness; ///< and how far the centre lines go up and down
  double Middle;
};

/**
 * Links are tubes around stadiums, each turned by a quarter against the next about the row's axis, by
 * an eighth against the ground. The next link's end touches this one's from inside.
 */
class ChainVolume : public MesoVolumePattern::Field
{
public:
  explicit ChainVolume(const MesoPatternValues& values)
    : Links(static_cast<int>(values.at("links")))
    , Rows(static_cast<int>(values.at("rows")))
    , Wire(values.at("wire") / this->Links)
    , HalfWidth(values.at("width") / this->Links)
    , HalfStraight(std::max(0., 0.5 / this->Links + this->Wire - this->HalfWidth))
    , Middle(0.5 * values.at("depth"))
  {
  }

  double At(double x, double y, double z) const override
  {
    const int link = static_cast<int>(std::floor(x * this->Links));
    const int row = static_cast<int>(std::floor(y * this->Rows));
    double distance = 1.;
    for (int j = row - 1; j <= row + 1; ++j)
    {
      for (int i = link - 1; i <= link + 1; ++i)
      {
        const double dx = x - (i + 0.5) / this->Links;
        const double dy = y - (j + 0.5) / this->Rows;
        const double dz = z - this->Middle;
        const double turn = (i & 1) ? -1. : 1.;
        const double across = std::sqrt(0.5) * (dy + turn * dz);
        const double off = std::sqrt(0.5) * (dz - turn * dy);
        const double beyond = std::max(0., std::abs(dx) - this->HalfStraight);
        const double inPlane = std::hypot(beyond, across) - this->HalfWidth;
        distance = std::min(distance, std::hypot(inPlane, off) - this->Wire);
      }
    }
    return distance;
  }

private:
  int Links;
  int Rows;
  double Wire;
  double HalfWidth;
  double HalfStraight;
  double Middle;
};

/// Bars of rounded rectangular cross-section.
class GridVolume : public MesoVolumePattern::Field
{
public:
  explicit GridVolume(const MesoPatternValues& values)
    : Bars(static_cast<int>(values.at("bars")))
    , HalfWidth(0.5 * values.at("width") / this->Bars)
    , HalfThickness(0.5 * values.at("thickness") * values.at("depth"))
    , Radius(values.at("rounding") * std::min(this->HalfWidth, this->HalfThickness))
    , Middle(0.5 * values.at("depth"))
  {
  }

  double At(double x, double y, double z) const override
  {
    return std::min(this->Bar(x, z - this->Middle), this->Bar(y, z - this->Middle));
  }

private:
  double Bar(double across, double dz) const
  {
    int number = 0;
    const double dy = FromNearest(across, this->Bars, number);
    const double qy = std::abs(dy) - this->HalfWidth + this->Radius;
    const double qz = std::abs(dz) - this->HalfThickness + this->Radius;
    return std::hypot(std::max(qy, 0.), std::max(qz, 0.)) + std::min(std::max(qy, qz), 0.) -
      this->Radius;
  }

  int Bars;
  double HalfWidth;
  double HalfThickness;
  double Radius;
  double Middle;
};
}

double MesoHalfHeightOfChain(const MesoPatternValues& values)
{
  return (std::sqrt(0.5) * values.at("width") + values.at("wire")) / values.at("links");
}

MesoVolumeFieldPointer MesoMakeWeaveVolume(const MesoPatternValues& values)
{
  return std::make_shared<WeaveVolume>(values);
}

MesoVolumeFieldPointer MesoMakeChainVolume(const MesoPatternValues& values)
{
  return std::make_shared<ChainVolume>(values);
}

MesoVolumeFieldPointer MesoMakeGridVolume(const MesoPatternValues& values)
{
  return std::make_shared<GridVolume>(values);
}
