#ifndef MesoObjFile_h
#define MesoObjFile_h

/**
 * @file MesoObjFile.h
 * @brief Scans a Wavefront OBJ file and checks all that it says.
 *
 * Reads `v`, `vt`, `vn` and `f`; a vertex' fourth number and colours are passed over, a missing
 * second texture coordinate is 0. Groups, smoothing groups and materials are passed over in
 * silence, lines, points, curves and unknown keywords with a note. Numbers are read as double.
 *
 * Refused with the line number, beside what MesoMeshFile.h says: indices that are 0, before the
 * first or after the last element of the file (negative ones count back from the line that they
 * stand in); lines that do not begin with a word.
 */

#include "MesoMeshFile.h"
#include "mesoIOMesostructureModule.h" // for export macro

/// Throws MesoInputError "file: line N: reason"; `fileName` serves the messages only.
MESOIOMESOSTRUCTURE_EXPORT MesoMeshFile MesoParseObj(
  const std::string& text, const std::string& fileName);

#endif
