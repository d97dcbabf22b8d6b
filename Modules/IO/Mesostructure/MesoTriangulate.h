#ifndef MesoTriangulate_h
#define MesoTriangulate_h

/**
 * @file MesoTriangulate.h
 * @brief Cuts one polygon, convex or not, into triangles.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <array>
#include <cstddef>
#include <vector>

/**
 * Triangles of the polygon with these corners, as triples of corner numbers from 0 in the
 * polygon's winding, appended to `triangles`: always corners.size() - 2 of them.
 *
 * A quad is cut along its shorter diagonal, or the one that lies inside where only one does; ties
 * go to the one from corner 0. Longer polygons are cut by clipping ears in the plane of their mean
 * (Newell's) normal. Areas below 1e-12 of the squared size count as none. Corners may lie out of
 * the plane; time grows with the square of their number (ear clipping: Meisters 1975).
 *
 * @return whether the polygon could be cut without a triangle that is turned over or has no area;
 * it cannot where it crosses itself or has no area.
 */
MESOIOMESOSTRUCTURE_EXPORT bool MesoTriangulate(
  const std::vector<std::array<double, 3>>& corners, std::vector<int>& triangles);

#endif
