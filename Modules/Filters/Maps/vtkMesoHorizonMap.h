/**
 * @class vtkMesoHorizonMap
 * @brief How high the relief of a height map stands around each of its texels (horizon mapping).
 *
 * For each of Azimuths directions over the map, (cos, sin)(2 pi k / Azimuths) in (u, v), the angle above
 * the plane at which the relief begins, as seen from the bilinear surface at the texel's centre: light
 * from below it is blocked. Angles are those over a square tile of side 1 with relief Scale deep; tan(angle) /
 * Scale is a slope in heights a tile, which holds for any chart and any depth.
 *
 * Exact to the sampling of MesoHorizonSweep.h, in a time that grows with texels x Azimuths alone.
 *
 * Output: the input's image with the point arrays
 * - `Horizon` (the scalars): Azimuths floats, radians in [0, pi/2);
 * - `AmbientOcclusion`: one float, the part of an evenly bright sky's light that comes down to a
 *   surface in the plane there, the mean of cos^2 of the horizon's angles: 1 where it sees all of it.
 *
 * Source: Max, "Horizon Mapping: Shadows for Bump-Mapped Surfaces", The Visual Computer 4(2), 1988.
 *
 * @sa vtkMesoBumpMapper
 */

#ifndef vtkMesoHorizonMap_h
#define vtkMesoHorizonMap_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoHeightMapAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoHorizonMap : public vtkMesoHeightMapAlgorithm
{
public:
  static vtkMesoHorizonMap* New();
  vtkTypeMacro(vtkMesoHorizonMap, vtkMesoHeightMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of directions, 4 to 360. Default 16.
  vtkSetClampMacro(Azimuths, int, 4, 360);
  vtkGetMacro(Azimuths, int);
  ///@}

  ///@{
  /// Depth of the relief in widths of a tile, above 0. Default 0.1.
  vtkSetClampMacro(Scale, double, 1e-6, 1e6);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /// How far is looked, in tiles, 0.1 to 16; what lies further off raises a horizon by at most the
  /// slope 1 / Reach, in heights a tile. Default 2.
  vtkSetClampMacro(Reach, double, 0.1, 16.);
  vtkGetMacro(Reach, double);
  ///@}

protected:
  vtkMesoHorizonMap() = default;
  ~vtkMesoHorizonMap() override = default;

  void Compute(const Map& map, vtkImageData* output) override;

private:
  vtkMesoHorizonMap(const vtkMesoHorizonMap&) = delete;
  void operator=(const vtkMesoHorizonMap&) = delete;

  int Azimuths = 16;
  double Scale = 0.1;
  double Reach = 2.;
};

#endif
