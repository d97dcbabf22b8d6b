#ifndef MesoMeshTopology_h
#define MesoMeshTopology_h

/**
 * @file MesoMeshTopology.h
 * @brief Makes a manifold mesh of any faces, by giving those that do not fit vertices of their own.
 *
 * Faces are added one by one to an OpenMesh half-edge mesh. Those that it refuses, because an edge
 * would have three faces or two of the same direction, make further sheets: a sheet has its own
 * copy of each vertex, and is built in the same way of the faces that all sheets before refused.
 * After eight sheets, faces that are still left stand alone.
 */

#include <cstddef>
#include <cstdint>
#include <vector>

struct MesoMeshTopology
{
  /// For each corner of `Build`'s faces the vertex it has now.
  std::vector<std::int32_t> VertexOfCorner;
  /// For each vertex the one that was given; the first ones are those given, in their order.
  std::vector<std::int32_t> Original;
  std::vector<std::size_t> RefusedFaces; ///< by the first sheet, in rising order
  std::size_t NumberOfSheets = 1;        ///< 1 where all faces fit; a face alone is not counted
  std::size_t NumberOfOpenEdges = 0;     ///< edges with one face, in all sheets
};

/**
 * @param numberOfVertices vertices are numbered from 0 to this
 * @param firstCorner face i has corners firstCorner[i] to firstCorner[i + 1] - 1
 * @param corners a vertex each; at least 3 a face, all different in a face
 */
MesoMeshTopology MesoBuildTopology(std::size_t numberOfVertices,
  const std::vector<std::size_t>& firstCorner, const std::vector<std::int32_t>& corners);

#endif
