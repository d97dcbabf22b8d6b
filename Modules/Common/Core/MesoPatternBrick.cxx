#include "MesoPatternFields.h"

#include <algorithm>
#include <cmath>

namespace
{
double SmoothStep(double low, double high, double x)
{
  const double t = std::clamp((x - low) / (high - low), 0., 1.);
  return t * t * (3. - 2. * t);
}

/**
 * Lengths below are in heights of a row. A point belongs to one cell: a brick and half of the joint
 * around it. Inside the brick's outline (a rounded rectangle, its edge made uneven by noise) the
 * height rises from the joint's to the face's along a parabola of the bevel's width.
 */
class BrickField : public MesoPattern::Field
{
public:
  BrickField(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , NumberOfRows(static_cast<int>(values.at("rows")))
    , NumberOfColumns(static_cast<int>(values.at("columns")))
    , Mortar(values.at("mortar"))
    , Bevel(values.at("bevel"))
    , Offset(values.at("offset"))
    , Variation(values.at("variation"))
    , Roughness(values.at("roughness"))
  {
  }

  double At(double s, double t) const override
  {
    const double y = t * this->NumberOfRows;
    const double x = s * this->NumberOfRows;
    const int row = std::min(static_cast<int>(y), this->NumberOfRows - 1);
    const double length = static_cast<double>(this->NumberOfRows) / this->NumberOfColumns;
    const double along = s * this->NumberOfColumns + (row % 2) * this->Offset;
    const int cell = static_cast<int>(std::floor(along));
    const int brick = row * this->NumberOfColumns + cell % this->NumberOfColumns;

    // Position from the brick's middle, with a slight error of the bricklayer's hand. In all the
    // brick comes no nearer to its cell's border than a quarter of a joint.
    const double error = this->Mortar * this->Variation;
    const double px = (along - cell - 0.5) * length + 0.15 * error * this->Signed(brick, 0);
    const double py = y - row - 0.5 + 0.15 * error * this->Signed(brick, 1);
    const double turn = 0.2 * error * this->Signed(brick, 2) / std::max(length, 1.);
    const double qx = px - turn * py;
    const double qy = py + turn * px;

    const double joint = this->JointHeight(x, y);
    const double halfX = 0.5 * (length - this->Mortar) - 0.3 * error * this->Positive(brick, 3);
    const double halfY = 0.5 * (1. - this->Mortar) - 0.3 * error * this->Positive(brick, 4);
    const double inside = this->Inside(qx, qy, halfX, halfY) - this->Chipping(x, y, brick);
    if (inside <= 0.)
    {
      // The hollow is even before the border, so that cells meet without a step.
      return joint * (1. - 0.75 * SmoothStep(0., 0.2 * this->Mortar + 1e-9, -inside));
    }
    const double rise = std::min(inside / this->Bevel, 1.);
    const double face = this->FaceHeight(x, y, qx / halfX, qy / halfY, brick);
    return joint + (face - joint) * rise * (2. - rise);
  }

private:
  double Positive(int brick, int what) const
  {
    return MesoSeededRandom(this->Seed, 1000 + what, brick);
  }
  double Signed(int brick, int what) const { return 2. * this->Positive(brick, what) - 1.; }

  // Noise with `cells` cells a row's height.
  double Noise(double x, double y, int cells, int key) const
  {
    const int period = this->NumberOfRows * cells;
    return MesoGradientNoise(x * cells, y * cells, { period, period }, this->Seed, key);
  }

  // Distance to the outline, positive inside.
  double Inside(double qx, double qy, double halfX, double halfY) const
  {
    const double corner = std::min({ 1.2 * this->Bevel, 0.9 * halfX, 0.9 * halfY });
    const double dx = std::abs(qx) - halfX + corner;
    const double dy = std::abs(qy) - halfY + corner;
    const double outside = std::hypot(std::max(dx, 0.), std::max(dy, 0.));
    return corner - outside - std::min(std::max(dx, dy), 0.);
  }

  // How far the edge is worn back: a waviness, and here and there a chip.
  double Chipping(double x, double y, int brick) const
  {
    const double wave = 0.5 + 0.5 * this->Noise(x, y, 4, 10 + 8 * brick);
    const double chip = SmoothStep(0.25, 0.7, this->Noise(x, y, 2, 11 + 8 * brick));
    return this->Roughness * this->Bevel * (0.5 * wave + 1.2 * chip);
  }

  double JointHeight(double x, double y) const
  {
    const double sand = 0.6 * this->Noise(x, y, 7, 1) + 0.4 * this->Noise(x, y, 14, 2);
    return 0.2 + 0.2 * this->Roughness * sand;
  }

  // (ex, ey) run from -1 to 1 over the face.
  double FaceHeight(double x, double y, double ex, double ey, int brick) const
  {
    const double level = 0.6 * this->Positive(brick, 5);
    const double tilt = 0.2 * (1. + ex * this->Signed(brick, 6) + ey * this->Signed(brick, 7));
    const double wave = 0.5 + 0.5 * this->Noise(x, y, 1, 12 + 8 * brick);
    const double grain = 0.5 + 0.3 * this->Noise(x, y, 5, 13 + 8 * brick) +
      0.2 * this->Noise(x, y, 11, 14 + 8 * brick);
    const double pit = SmoothStep(0.5, 0.85, this->Noise(x, y, 4, 15 + 8 * brick));
    return 1. - this->Variation * (level + tilt) -
      this->Roughness * (0.25 * wave + 0.22 * grain + 0.3 * pit);
  }

  std::uint32_t Seed;
  int NumberOfRows;
  int NumberOfColumns;
  double Mortar;
  double Bevel;
  double Offset;
  double Variation;
  double Roughness;
};
}

MesoFieldPointer MesoMakeBrickField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<BrickField>(seed, values);
}
