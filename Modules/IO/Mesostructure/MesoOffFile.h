#ifndef MesoOffFile_h
#define MesoOffFile_h

/**
 * @file MesoOffFile.h
 * @brief Reads OFF meshes: the text form, with normals and texture coordinates.
 *
 * The first word is `OFF` with prefixes in this order, or is left out: `ST` (two texture coordinates
 * a vertex), `C` (a colour a vertex, passed over with a note), `N` (a normal a vertex). Three counts
 * follow (vertices, faces, edges; the last is not used), a line for each vertex (position, normal,
 * colour, texture coordinates) and a line for each face (number of corners, vertices from 0, and a
 * colour that is passed over). `#` begins a comment. Binary files and those of another dimension
 * (`4OFF`, `nOFF`) are refused. Format: Geomview's manual, section 4.2.5.
 */

#include "MesoMeshFile.h"
#include "mesoIOMesostructureModule.h" // for export macro

/// Throws MesoInputError "file: line N: reason".
MESOIOMESOSTRUCTURE_EXPORT MesoMeshFile MesoParseOff(
  const std::string& text, const std::string& fileName);

#endif
