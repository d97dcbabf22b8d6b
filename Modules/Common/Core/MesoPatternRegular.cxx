#include "MesoPatternFields.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Pi = 3.141592653589793238462643;

/// The cell of a periodic row of `count` that x (in cells) lies in, and the place from its middle.
struct Cell
{
  int Number;
  double FromMiddle; ///< -1/2 to 1/2

  Cell(double x, int count)
    : Number(std::min(static_cast<int>(x), count - 1))
    , FromMiddle(x - this->Number - 0.5)
  {
  }
};

/**
 * A thread lies on a centre line that waves up and down by one crossing each; over it the height falls to
 * the ground at the thread's edges. Where two threads cross the higher one is seen.
 */
class WeaveField : public MesoPattern::Field
{
public:
  WeaveField(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , Threads(static_cast<int>(values.at("threads")))
    , Width(values.at("width"))
    , Strands(values.at("strands"))
    , Variation(values.at("variation"))
  {
  }

  double At(double s, double t) const override
  {
    const double x = s * this->Threads;
    const double y = t * this->Threads;
    return std::max(this->Thread(x, y, 0), this->Thread(y, x, 1));
  }

private:
  static constexpr double Sway = 0.4;   ///< of the centre line, to each side of the middle
  static constexpr double Radius = 0.2; ///< of a thread's upper side; 2 Sway + Radius is 1

  /// A thread's height at `across` and `along` it; `family` 0: along t, 1: along s.
  double Thread(double across, double along, int family) const
  {
    const Cell cell(across, this->Threads);
    const auto random = [&](int what)
    { return MesoSeededRandom(this->Seed, 2000 + 2 * what + family, cell.Number); };
    const double width = this->Width * (1. - 0.5 * this->Variation * random(0));
    const double d = 2. * cell.FromMiddle / width;
    if (std::abs(d) >= 1.)
    {
      return 0.;
    }
    // Up where the sum of both cells' numbers is even for one family, odd for the other.
    const double centre = Sway * (1. + std::cos(Pi * (along - 0.5 - cell.Number + family)));
    const double grooves =
      0.5 - 0.5 * std::cos(2. * Pi * (2. * along + 1.5 * d + std::floor(8. * random(1)) / 8.));
    return (centre + Radius) * (1. - std::pow(d, 4.)) * (1. - 0.15 * this->Strands * grooves);
  }

  std::uint32_t Seed;
  int Threads;
  double Width;
  double Strands;
  double Variation;
};

/// Cones, or what a power makes of them, in the middles of square cells.
class SpikesField : public MesoPattern::Field
{
public:
  SpikesField(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , Count(static_cast<int>(values.at("count")))
    , Radius(values.at("radius"))
    , Power(values.at("power"))
    , Variation(values.at("variation"))
  {
  }

  double At(double s, double t) const override
  {
    const Cell x(s * this->Count, this->Count);
    const Cell y(t * this->Count, this->Count);
    const double inside = 1. - std::hypot(x.FromMiddle, y.FromMiddle) / this->Radius;
    if (inside <= 0.)
    {
      return 0.;
    }
    const double tip =
      1. - this->Variation * MesoSeededRandom(this->Seed, 3000, x.Number, y.Number);
    return tip * std::pow(inside, this->Power);
  }

private:
  std::uint32_t Seed;
  int Count;
  double Radius;
  double Power;
  double Variation;
};

class CheckerboardField : public MesoPattern::Field
{
public:
  CheckerboardField(int squares, double low)
    : Squares(squares)
    , Low(low)
  {
  }

  double At(double s, double t) const override
  {
    const Cell x(s * this->Squares, this->Squares);
    const Cell y(t * this->Squares, this->Squares);
    return (x.Number + y.Number) % 2 == 0 ? 1. : this->Low;
  }

private:
  int Squares;
  double Low;
};

/// Hollows like the lower half of an ellipsoid, one in each square cell and inside of it.
class PitsField : public MesoPattern::Field
{
public:
  PitsField(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , Count(static_cast<int>(values.at("count")))
    , Radius(values.at("radius"))
    , Variation(values.at("variation"))
  {
  }

  double At(double s, double t) const override
  {
    const Cell x(s * this->Count, this->Count);
    const Cell y(t * this->Count, this->Count);
    const auto random = [&](int what)
    { return MesoSeededRandom(this->Seed, 4000 + what, x.Number, y.Number); };
    const double size = 1. - 0.6 * this->Variation * random(0);
    const double radius = this->Radius * size;
    const double play = this->Variation * (0.5 - radius);
    const double distance = std::hypot(
      x.FromMiddle - play * (2. * random(1) - 1.), y.FromMiddle - play * (2. * random(2) - 1.));
    const double q = distance / radius;
    return q >= 1. ? 1. : 1. - size * std::sqrt(1. - q * q);
  }

private:
  std::uint32_t Seed;
  int Count;
  double Radius;
  double Variation;
};
}

MesoFieldPointer MesoMakeWeaveField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<WeaveField>(seed, values);
}

MesoFieldPointer MesoMakeSpikesField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<SpikesField>(seed, values);
}

MesoFieldPointer MesoMakeCheckerboardField(const MesoPatternValues& values)
{
  return std::make_shared<CheckerboardField>(
    static_cast<int>(values.at("squares")), values.at("low"));
}

MesoFieldPointer MesoMakePitsField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<PitsField>(seed, values);
}
