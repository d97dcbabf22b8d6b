#ifndef MesoCornerNormals_h
#define MesoCornerNormals_h

/**
 * @file MesoCornerNormals.h
 * @brief Measures triangles, and makes the normal that each of their corners is to be lit with.
 *
 * A normal is the mean of the unit normals of the triangles around a merged vertex, weighted with
 * their angles there (Thuermer and Wuethrich 1998), which does not depend on how the surface is
 * cut into triangles. Triangles without area have no say.
 */

#include "MesoTriangleMesh.h"

/// A triangle's unit normal (right-handed) and its angles in radians; an area of 0 where it has no
/// direction: two corners fall together, or the three lie on a line but for rounding.
struct MesoTriangleMeasure
{
  MesoVector Normal = { 0., 0., 0. };
  MesoVector Angles = { 0., 0., 0. };
  double Area = 0.;
};

std::vector<MesoTriangleMeasure> MesoMeasureTriangles(const MesoTriangleMesh& mesh);

/// Which normal each corner (3 * triangle + 0, 1, 2) has.
struct MesoCornerNormals
{
  std::vector<std::int64_t> Group;
  std::vector<MesoVector> Normals; ///< by group, unit length
};

/**
 * One normal for each merged vertex. With `split`, one for each set of triangles around it that are
 * joined by edges bent by no more than `featureAngle` (degrees); an edge with other than two
 * triangles, or where one is turned over, joins nothing.
 *
 * Where normals cancel, as between the sides of a doubled sheet, each point takes the mean of its
 * own triangles, and if they cancel too, the normal of the first. A corner that has no triangle
 * with area around it takes (0, 0, 1).
 */
MesoCornerNormals MesoMakeCornerNormals(const MesoTriangleMesh& mesh,
  const std::vector<MesoTriangleMeasure>& measures, bool split, double featureAngle);

#endif
