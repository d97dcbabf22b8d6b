#ifndef MesoVolumeRay_h
#define MesoVolumeRay_h

#include "MesoVolume.h"

/**
 * @class MesoVolumeRay
 * @brief Where a straight ray first meets a volume's surface, exactly.
 *
 * The ray is followed from cell to cell of eight samples. Within one the trilinear interpolant along the
 * ray is a cubic, whose first change of sign is isolated by its extremes and bisected to the last bits:
 * what the tables of a volume are measured against.
 */
class MESOFILTERSMAPS_EXPORT MesoVolumeRay
{
public:
  using Vector = MesoVolumeField::Vector;

  explicit MesoVolumeRay(const MesoVolumeField& field);

  struct Hit
  {
    bool IsHit;      ///< else the ray left the shell, or went as far as it was to go
    double Distance; ///< tile widths, in (x, y, F z); 0 where it begins inside the solid
  };

  /**
   * @param origin texture space, z in [0,1]
   * @param direction unit, in (x, y, F z)
   * @param reach tile widths that are looked at
   */
  Hit Cast(const Vector& origin, const Vector& direction, double reach) const;

  /// Tile widths to the plane z = 0 or z = 1, along the ray; infinite where it is level.
  static double ToPlane(double z, double directionZ, double depth);

private:
  const MesoVolumeField& Field;
};

#endif
