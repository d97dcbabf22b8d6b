#ifndef MesoStlFile_h
#define MesoStlFile_h

/**
 * @file MesoStlFile.h
 * @brief Reads STL meshes, text and binary.
 *
 * A file is binary where its size is that of its count of facets (84 + 50 n bytes), or where it does
 * not begin with the word `solid`; bytes after the last facet get a note. Facets have no common
 * vertices: equal positions are merged later (MesoMeshSurface.h). Their normals are not used, since
 * they say no more than the corners do; where they contradict the corners' order, a note says so.
 * Binary numbers are little-endian. Format: 3D Systems, StereoLithography interface specification.
 */

#include "MesoMeshFile.h"
#include "mesoIOMesostructureModule.h" // for export macro

/// Throws MesoInputError "file: line N: reason" or "file: byte N: facet K: reason".
MESOIOMESOSTRUCTURE_EXPORT MesoMeshFile MesoParseStl(
  const std::string& bytes, const std::string& fileName);

#endif
