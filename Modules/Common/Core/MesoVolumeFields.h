#ifndef MesoVolumeFields_h
#define MesoVolumeFields_h

/**
 * @file MesoVolumeFields.h
 * @brief The functions behind MesoVolumePattern. Not installed.
 */

#include "MesoPatternFields.h" // for seeded noise
#include "MesoVolumePattern.h"

class MesoVolumePattern::Field
{
public:
  virtual ~Field() = default;
  /// x and y in [0,1), z from 0 to the pattern's depth, all in tile widths.
  virtual double At(double x, double y, double z) const = 0;
};

using MesoVolumeFieldPointer = std::shared_ptr<const MesoVolumePattern::Field>;

///@{
/// `values` holds every key of the pattern.
MesoVolumeFieldPointer MesoMakeWeaveVolume(const MesoPatternValues& values);
MesoVolumeFieldPointer MesoMakeChainVolume(const MesoPatternValues& values);
MesoVolumeFieldPointer MesoMakeGridVolume(const MesoPatternValues& values);
MesoVolumeFieldPointer MesoMakeScalesVolume(std::uint32_t seed, const MesoPatternValues& values);
MesoVolumeFieldPointer MesoMakeBarkVolume(std::uint32_t seed, const MesoPatternValues& values);
MesoVolumeFieldPointer MesoMakeFoamVolume(std::uint32_t seed, const MesoPatternValues& values);
///@}

/// Half the height of a chain's links, in tile widths: what its depth must be twice of.
double MesoHalfHeightOfChain(const MesoPatternValues& values);

#endif
