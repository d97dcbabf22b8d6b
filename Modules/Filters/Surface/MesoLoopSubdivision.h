#ifndef MesoLoopSubdivision_h
#define MesoLoopSubdivision_h

/**
 * @file MesoLoopSubdivision.h
 * @brief Loop's subdivision of triangles over merged vertices, so that seams of a texture are no edges.
 *
 * Loop, "Smooth Subdivision Surfaces Based on Triangles", University of Utah, 1987; boundaries as cubic
 * B-splines and limits as in Hoppe et al., "Piecewise Smooth Surface Reconstruction", SIGGRAPH 1994.
 */

#include "MesoTriangleMesh.h"

/// A mesh with a texture coordinate a point, or none.
struct MesoSubdividedMesh
{
  MesoTriangleMesh Mesh;
  std::vector<std::array<double, 2>> Coordinates;
};

/// Cuts each triangle into four and moves the vertices; coordinates are interpolated. Edges with other
/// than two triangles are boundaries, and vertices where other than two of those meet stay in place.
MesoSubdividedMesh MesoSubdivide(const MesoSubdividedMesh& mesh);

/// Moves the points of a mesh to where they come to lie when it is subdivided for ever.
void MesoMoveToLimit(MesoTriangleMesh& mesh);

#endif
