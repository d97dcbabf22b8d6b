#include "MesoVolumeFields.h"

#include <algorithm>
#include <cmath>

namespace
{
int Wrapped(int i, int period)
{
  const int rest = i % period;
  return rest < 0 ? rest + period : rest;
}

/// Plates are flat ellipsoids in staggered rows, tilted so that they lie on those of the next row.
class ScalesVolume : public MesoVolumePattern::Field
{
public:
  ScalesVolume(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , Rows(static_cast<int>(values.at("rows")))
    , Columns(static_cast<int>(values.at("columns")))
    , HalfWidth(0.55 / this->Columns)
    , HalfLength(0.5 * (1. + values.at("overlap")) / this->Rows)
    , HalfThickness(0.5 * values.at("thickness") * values.at("depth"))
    , Ground(values.at("ground") * values.at("depth"))
    , Variation(values.at("variation"))
  {
    const double room = 0.95 * values.at("depth") - this->Ground - this->HalfThickness;
    this->SineOfTilt = std::clamp(room / ((1. + Sunk) * this->HalfLength), 0., MostSine);
  }

  double At(double x, double y, double z) const override
  {
    double distance = z - this->Ground;
    const int row = static_cast<int>(std::floor(y * this->Rows));
    for (int j = row - 2; j <= row + 2; ++j)
    {
      const double shift = (j & 1) ? 0.5 : 0.;
      const int column = static_cast<int>(std::floor(x * this->Columns - shift));
      for (int i = column - 1; i <= column + 1; ++i)
      {
        const double random =
          MesoSeededRandom(this->Seed, 5000, Wrapped(i, this->Columns), Wrapped(j, this->Rows));
        distance = std::min(distance,
          this->Plate(x - (i + 0.5 + shift) / this->Columns, y - (j + 0.5) / this->Rows, z,
            this->SineOfTilt * (1. - this->Variation * random)));
      }
    }
    return distance;
  }

private:
  static constexpr double Sunk = 0.8;     ///< of a plate's lower half, that is above the ground
  static constexpr double MostSine = 0.8; ///< of the tilt

  /// An ellipsoid's implicit function over the length of its gradient.
  double Plate(double dx, double dy, double z, double sine) const
  {
    const double cosine = std::sqrt(1. - sine * sine);
    const double dz = z - this->Ground - Sunk * this->HalfLength * sine;
    const double along = cosine * dy - sine * dz;
    const double off = sine * dy + cosine * dz;
    const double a = dx / this->HalfWidth;
    const double b = along / this->HalfLength;
    const double c = off / this->HalfThickness;
    const double q = std::sqrt(a * a + b * b + c * c);
    const double gradient = std::sqrt(std::pow(a / this->HalfWidth, 2.) +
      std::pow(b / this->HalfLength, 2.) + std::pow(c / this->HalfThickness, 2.));
    return gradient > 0. ? (q - 1.) * q / gradient : -this->HalfThickness;
  }

  std::uint32_t Seed;
  int Rows;
  int Columns;
  double HalfWidth;
  double HalfLength;
  double HalfThickness;
  double Ground;
  double Variation;
  double SineOfTilt = 0.;
};

/// Plates are cells around shifted points; how far a point is from the nearest crack decides.
class BarkVolume : public MesoVolumePattern::Field
{
public:
  BarkVolume(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , Columns(static_cast<int>(values.at("columns")))
    , Rows(static_cast<int>(values.at("rows")))
    , Crack(values.at("crack") / this->Columns)
    , Undercut(values.at("undercut"))
    , Roughness(values.at("roughness"))
    , Depth(values.at("depth"))
  {
  }

  double At(double x, double y, double z) const override
  {
    const double fine = this->Noise(x, y, 4, 1);
    const double bent = x + 0.25 * this->Roughness * this->Noise(x, y, 1, 2) / this->Columns;
    const double top = this->Depth * (0.95 - 0.12 * this->Roughness * (1. + fine));
    const double ground = this->Depth * (0.12 + 0.1 * this->Roughness * (1. + fine));
    const double below = std::clamp(1. - z / this->Depth, 0., 1.);
    const double halfWidth =
      this->Crack * (1. + this->Undercut * below + 0.6 * this->Roughness * fine);
    const double wall = halfWidth - this->FromCrack(bent, y);
    return std::min(z - ground, std::max(z - top, wall));
  }

private:
  double Noise(double x, double y, int finer, int key) const
  {
    const std::array<int, 2> period = { this->Columns * finer, this->Rows * 2 * finer };
    return MesoGradientNoise(x * period[0], y * period[1], period, this->Seed, 6000 + key);
  }

  /// Distance to the line halfway between the two nearest points, tile widths.
  double FromCrack(double x, double y) const
  {
    constexpr double Shift = 0.7; // of a point within its cell
    struct Near
    {
      double Square = 1e9;
      double X = 0.;
      double Y = 0.;
    };
    Near first;
    const int column = static_cast<int>(std::floor(x * this->Columns));
    const int row = static_cast<int>(std::floor(y * this->Rows));
    const auto place = [&](int i, int j)
    {
      const int a = Wrapped(i, this->Columns);
      const int b = Wrapped(j, this->Rows);
      Near near;
      near.X =
        (i + 0.5 + Shift * (MesoSeededRandom(this->Seed, 6100, a, b) - 0.5)) / this->Columns - x;
      near.Y =
        (j + 0.5 + Shift * (MesoSeededRandom(this->Seed, 6200, a, b) - 0.5)) / this->Rows - y;
      // Cells are long: what is near is told in cells.
      near.Square = std::pow(near.X * this->Columns, 2.) + std::pow(near.Y * this->Rows, 2.);
      return near;
    };
    for (int j = row - 2; j <= row + 2; ++j)
    {
      for (int i = column - 2; i <= column + 2; ++i)
      {
        const Near near = place(i, j);
        first = near.Square < first.Square ? near : first;
      }
    }
    double distance = 1.;
    for (int j = row - 2; j <= row + 2; ++j)
    {
      for (int i = column - 2; i <= column + 2; ++i)
      {
        const Near near = place(i, j);
        if (near.Square > first.Square)
        {
          // Over the gradient's length, of which the cell's shape is a part.
          const double gradient = std::hypot((near.X - first.X) * std::pow(this->Columns, 2.),
            (near.Y - first.Y) * std::pow(this->Rows, 2.));
          distance = std::min(distance, 0.5 * (near.Square - first.Square) / gradient);
        }
      }
    }
    return distance;
  }

  std::uint32_t Seed;
  int Columns;
  int Rows;
  double Crack;
  double Undercut;
  double Roughness;
  double Depth;
};

/// A block without the spheres around shifted points of a lattice.
class FoamVolume : public MesoVolumePattern::Field
{
public:
  FoamVolume(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , Bubbles(static_cast<int>(values.at("bubbles")))
    , Radius(values.at("radius") / this->Bubbles)
    , Jitter(values.at("jitter"))
    , Variation(values.at("variation"))
    , Top(0.97 * values.at("depth"))
  {
  }

  double At(double x, double y, double z) const override
  {
    const auto cell = [&](double c) { return static_cast<int>(std::floor(c * this->Bubbles)); };
    double toBubble = 1.;
    for (int k = cell(z) - 1; k <= cell(z) + 1; ++k)
    {
      for (int j = cell(y) - 1; j <= cell(y) + 1; ++j)
      {
        for (int i = cell(x) - 1; i <= cell(x) + 1; ++i)
        {
          const int column = Wrapped(i, this->Bubbles) + Wrapped(j, this->Bubbles) * this->Bubbles;
          const auto shifted = [&](int number, int key)
          {
            const double random = MesoSeededRandom(this->Seed, 7000 + key, column, k);
            return (number + 0.5 + this->Jitter * (random - 0.5)) / this->Bubbles;
          };
          const double radius =
            this->Radius * (1. - this->Variation * MesoSeededRandom(this->Seed, 7003, column, k));
          const double distance =
            std::sqrt(std::pow(x - shifted(i, 0), 2.) + std::pow(y - shifted(j, 1), 2.) +
              std::pow(z - shifted(k, 2), 2.)) -
            radius;
          toBubble = std::min(toBubble, distance);
        }
      }
    }
    return std::max(z - this->Top, -toBubble);
  }

private:
  std::uint32_t Seed;
  int Bubbles;
  double Radius;
  double Jitter;
  double Variation;
  double Top;
};
}

MesoVolumeFieldPointer MesoMakeScalesVolume(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<ScalesVolume>(seed, values);
}

MesoVolumeFieldPointer MesoMakeBarkVolume(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<BarkVolume>(seed, values);
}

MesoVolumeFieldPointer MesoMakeFoamVolume(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<FoamVolume>(seed, values);
}
