#ifndef MesoVolumeRay_h
#define MesoVolumeRay_h

#include "MesoVolume.h"

#include <cstddef>
#include <vector>

/**
 * @class MesoVolumeRay
 * @brief Where a straight ray first meets a volume's surface, exactly.
 *
 * The ray is followed from cell to cell of eight samples. Within one the trilinear interpolant along the
 * ray is a cubic, whose first change of sign is isolated by its extremes and bisected to the last bits:
 * what the tables of a volume are measured against. Cells without a sample in the solid hold none of it: each
 * cell knows how many of them lie around it, and rays leap over these.
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
  /// The cell's number in Free, wrapped; z from -1, between which and 0 samples go on as at 0.
  std::size_t NumberOf(const int (&cell)[3]) const;
  void FindFreeCells();

  const MesoVolumeField& Field;
  /// Of each cell how many cells away, along the axis along which it is the most, the next is that has a sample in
  /// the solid: 0 where it has one itself.
  std::vector<unsigned char> Free;
};

#endif
