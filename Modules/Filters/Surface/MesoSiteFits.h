#ifndef MesoSiteFits_h
#define MesoSiteFits_h

/**
 * @file MesoSiteFits.h
 * @brief Fits at the sites of a mesh: which neighbours are taken.
 */

#include "MesoJetFit.h"
#include "MesoSmoothPatches.h"

/// What one thread needs again and again.
struct MesoFitSpace
{
  MesoSmoothPatches::Walk Walk;
  std::vector<MesoVector> Offsets;
};

/// Fills space.Offsets with the neighbours of `rings` rings, or of as many more, up to `mostRings`,
/// as give `enough`. Sites whose normal is turned by more than 80 degrees are left out: the surface
/// may not be a graph over the tangent plane there.
MESOFILTERSSURFACE_EXPORT void MesoGatherNeighbours(const MesoSmoothPatches& patches,
  std::int64_t site, std::size_t rings, std::size_t enough, std::size_t mostRings,
  MesoFitSpace& space);

/**
 * The principal curvatures at a site, from two rings or as many as give 18 neighbours, at most
 * five; from one more where a polynomial of degree 4 is not determined, then with a lower degree.
 * Fewer than six neighbours, or neighbours on a line, give zeros.
 */
MESOFILTERSSURFACE_EXPORT MesoPrincipalCurvature MesoFitSiteCurvature(
  const MesoSmoothPatches& patches, std::int64_t site, MesoFitSpace& space);

#endif
