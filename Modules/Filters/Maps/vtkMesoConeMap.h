/**
 * @class vtkMesoConeMap
 * @brief A height map becomes cones of free space, by which searches of the map take long steps.
 *
 * For each texel and each of four ways of travel (du, dv >= 0; du < 0; dv < 0; both) the cone that
 * MesoHeightCones.h defines: a ray above it meets no relief. That holds for the bilinear surface, not
 * only for its texels, for rays straight and bent, and with Wrap for the endless map; numbers are
 * rounded so that cones shrink, up to 1.6e-7 of the depth.
 *
 * Output: the input's image with the point scalars `ConeSteepness` and the point array `ConeApex`, four
 * unsigned chars each: depth of the apex, 255 a; steepness, 255 sqrt(2 m), of a cone whose depth drops
 * by m for each texel of |du| + |dv|.
 *
 * The cones of Dummer and of Policarpo2007 are free at the texels only and around an apex on the
 * relief; see Documentation/Techniques/Relief.md.
 *
 * @sa vtkMesoMaximumMip
 */

#ifndef vtkMesoConeMap_h
#define vtkMesoConeMap_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoHeightMapAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoConeMap : public vtkMesoHeightMapAlgorithm
{
public:
  static vtkMesoConeMap* New();
  vtkTypeMacro(vtkMesoConeMap, vtkMesoHeightMapAlgorithm);

protected:
  vtkMesoConeMap() = default;
  ~vtkMesoConeMap() override = default;

  void Compute(const Map& map, vtkImageData* output) override;

private:
  vtkMesoConeMap(const vtkMesoConeMap&) = delete;
  void operator=(const vtkMesoConeMap&) = delete;
};

#endif
