#ifndef MesoPlyFile_h
#define MesoPlyFile_h

/**
 * @file MesoPlyFile.h
 * @brief Reads PLY meshes: text and binary of both byte orders.
 *
 * | element | what is read |
 * | --- | --- |
 * | `vertex` | `x`, `y`, `z`, in the file's precision; `nx`, `ny`, `nz`; texture coordinates: the first of the pairs `s t`, `u v`, `texture_u texture_v`, `texture_s texture_t` |
 * | `face` | the list `vertex_indices` or `vertex_index`; the list `texcoord` (two numbers a corner, before those of the vertices) |
 * | `tristrips` | the list `vertex_indices`, a strip ended by -1 |
 *
 * Other elements and properties are passed over with a note. In a text file an element has a line
 * of its own. Format: Turk, The PLY Polygon File Format, 1994.
 */

#include "MesoMeshFile.h"
#include "mesoIOMesostructureModule.h" // for export macro

/// Throws MesoInputError "file: line N: element K: reason", "file: byte N: ..." in a binary file.
MESOIOMESOSTRUCTURE_EXPORT MesoMeshFile MesoParsePly(
  const std::string& bytes, const std::string& fileName);

#endif
