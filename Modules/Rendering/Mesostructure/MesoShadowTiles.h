#ifndef MesoShadowTiles_h
#define MesoShadowTiles_h

/**
 * @file MesoShadowTiles.h
 * @brief Where a light looks from and how far, so that its shadow map holds what casts shadows.
 */

#include "mesoRenderingMesostructureModule.h" // for export macro

#include <array>
#include <vector>

class vtkLight;

/// What casts shadows.
struct MesoShadowCaster
{
  std::array<double, 6> Bounds; ///< world space
  bool Flat = false;            ///< it cannot cast a shadow on itself
};

/// One square of a shadow map: a view from a light, world space.
struct MesoShadowTile
{
  bool Perspective = false;
  std::array<double, 3> Position;  ///< of the eye
  std::array<double, 3> Direction; ///< unit, along the view
  std::array<double, 3> Up;        ///< unit, across it
  ///@{
  /// What is seen: world units, for Perspective those at distance 1.
  double Left = 0.;
  double Right = 0.;
  double Bottom = 0.;
  double Top = 0.;
  ///@}
  double Near = 0.; ///< along the view, 0 < Near < Far
  double Far = 0.;
};

/**
 * The views that a light's shadows need: none for headlights, for lights whose shadow attenuation is
 * 0 and where nothing casts a shadow before the light; one for a directional light and for a spot
 * light (cone angle below 90 degrees), fitted to where shadows can begin: what casts, of flat things
 * only what lies before or behind others; six for a point light, along -z, +z, +y, -y, +x and -x of
 * the first one's view.
 *
 * @param resolution texels across a tile: each view reaches at least a texel beyond what casts
 */
MESORENDERINGMESOSTRUCTURE_EXPORT std::vector<MesoShadowTile> MesoShadowTilesOf(
  vtkLight* light, const std::vector<MesoShadowCaster>& casters, int resolution);

#endif
