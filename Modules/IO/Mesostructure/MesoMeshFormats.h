#ifndef MesoMeshFormats_h
#define MesoMeshFormats_h

/**
 * @file MesoMeshFormats.h
 * @brief The formats of meshes, by the ends of their files' names.
 */

#include "MesoMeshFile.h"
#include "mesoIOMesostructureModule.h" // for export macro

/// The ends of file names that are meshes, in small letters: ".obj", ".ply", ...
MESOIOMESOSTRUCTURE_EXPORT const std::vector<std::string>& MesoMeshExtensions();

/// The end of a file's name from its last dot, in small letters; empty without one.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoExtensionOf(const std::string& fileName);

/// Reads a mesh file of any of the formats, told by its name. Throws MesoInputError.
MESOIOMESOSTRUCTURE_EXPORT MesoMeshFile MesoReadMeshFile(const std::string& fileName);

#endif
