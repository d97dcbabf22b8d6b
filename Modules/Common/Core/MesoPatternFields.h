#ifndef MesoPatternFields_h
#define MesoPatternFields_h

/**
 * @file MesoPatternFields.h
 * @brief The functions behind MesoPattern, and the seeded noise they are made of. Not installed.
 */

#include "MesoPattern.h"

class MesoPattern::Field
{
public:
  virtual ~Field() = default;
  /// Height at (s, t) in [0,1) x [0,1); MesoPattern clamps it to [0,1].
  virtual double At(double s, double t) const = 0;
};

using MesoFieldPointer = std::shared_ptr<const MesoPattern::Field>;

///@{
/// `values` holds every key of the pattern.
MesoFieldPointer MesoMakeBrickField(std::uint32_t seed, const MesoPatternValues& values);
MesoFieldPointer MesoMakeSmoothField(std::uint32_t seed, const MesoPatternValues& values);
MesoFieldPointer MesoMakeNoiseField(std::uint32_t seed, const MesoPatternValues& values);
MesoFieldPointer MesoMakeStepField(const MesoPatternValues& values);
MesoFieldPointer MesoMakeWeaveField(std::uint32_t seed, const MesoPatternValues& values);
MesoFieldPointer MesoMakeStoneField(std::uint32_t seed, const MesoPatternValues& values);
MesoFieldPointer MesoMakeSpikesField(std::uint32_t seed, const MesoPatternValues& values);
MesoFieldPointer MesoMakeCheckerboardField(const MesoPatternValues& values);
MesoFieldPointer MesoMakePitsField(std::uint32_t seed, const MesoPatternValues& values);
MesoFieldPointer MesoMakeTerrainField(std::uint32_t seed, const MesoPatternValues& values);
MesoFieldPointer MesoMakeWavesField(std::uint32_t seed, const MesoPatternValues& values);
///@}

/// A number in [0,1) for a seed and up to three whole numbers (SplitMix64's mixer: Steele, Lea,
/// Flood 2014, "Fast splittable pseudorandom number generators").
double MesoSeededRandom(std::uint32_t seed, int a, int b = 0, int c = 0);

/// Gradient noise in [-1,1] (Perlin 2002, "Improving noise": quintic fade) on a lattice of unit
/// cells that repeats every period[0] by period[1] cells; `key` chooses one of many such noises.
double MesoGradientNoise(
  double x, double y, std::array<int, 2> period, std::uint32_t seed, int key);

/// Least and greatest value at the texel centres of an n x n map.
std::array<double, 2> MesoRangeOfField(const MesoPattern::Field& field, int n);

#endif
