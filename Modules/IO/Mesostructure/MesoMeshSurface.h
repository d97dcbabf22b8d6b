#ifndef MesoMeshSurface_h
#define MesoMeshSurface_h

/**
 * @file MesoMeshSurface.h
 * @brief Turns the faces of a mesh file into triangles over points, one for each different corner.
 *
 * ~~~
 * file -> merge equal positions -> drop corners that fall together -> topology (sheets)
 *      -> triangles in the file's order -> points: position x texture coordinate x normal
 * ~~~
 *
 * Nothing is left out or put in without a line in Notes.
 */

#include "MesoMeshFile.h"
#include "mesoIOMesostructureModule.h" // for export macro

/// `n` points and `m` triangles. Points lie in the order of their first use.
struct MesoMeshSurface
{
  std::vector<std::array<double, 3>> Positions; ///< n
  /// n, or empty where the file has none; (0, 0) at corners without.
  std::vector<std::array<double, 2>> TextureCoordinates;
  /// n of unit length, or empty where a corner has none.
  std::vector<std::array<double, 3>> Normals;
  /// n: the point's vertex, from 0 without a gap. Points of equal position share a vertex, except
  /// that each sheet (MesoMeshTopology) has vertices of its own.
  std::vector<std::int32_t> Vertex;
  /// n: the position's number in the file, of equal ones that of the point's first corner.
  std::vector<std::int32_t> FilePosition;
  std::vector<std::array<std::int32_t, 3>> Triangles; ///< m, point numbers
  std::size_t NumberOfVertices = 0;
  std::size_t NumberOfSheets = 1;
  std::size_t NumberOfOpenEdges = 0; ///< edges of the file's polygons that have one face
  std::vector<std::string> Notes;    ///< what is odd about the file, a line each
};

/// Throws MesoInputError where no face is left. `fileName` serves the message only.
MESOIOMESOSTRUCTURE_EXPORT MesoMeshSurface MesoMakeSurface(
  const MesoMeshFile& file, const std::string& fileName);

#endif
