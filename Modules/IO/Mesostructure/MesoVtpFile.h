#ifndef MesoVtpFile_h
#define MesoVtpFile_h

/**
 * @file MesoVtpFile.h
 * @brief Reads VTK's XML polygonal meshes (.vtp) through VTK's own reader, and checks what it gives.
 *
 * Polygons and triangle strips become faces. The active normals and the active texture coordinates
 * (else an array named `TextureCoordinates`, `TCoords` or `Texture Coordinates`) are taken; of three
 * texture coordinates the first two. All other point arrays are kept. Arrays of cells, points
 * (vertices) and lines are passed over with a note. VTK's reader checks neither the number of
 * points against the file nor the cells' indices, and tells what is wrong in several lines: all that
 * is done here.
 */

#include "MesoMeshFile.h"
#include "mesoIOMesostructureModule.h" // for export macro

/// Throws MesoInputError "file: reason". VTK reads the bytes, `fileName` serves the messages only.
MESOIOMESOSTRUCTURE_EXPORT MesoMeshFile MesoParseVtp(
  const std::string& bytes, const std::string& fileName);

#endif
