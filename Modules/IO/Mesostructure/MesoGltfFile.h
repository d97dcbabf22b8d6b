#ifndef MesoGltfFile_h
#define MesoGltfFile_h

/**
 * @file MesoGltfFile.h
 * @brief Reads the geometry of glTF 2.0 files (.gltf with buffers beside it or within, .glb).
 *
 * All triangles of the default scene (the first where none is named, all root nodes where there is
 * none) become one mesh: lists, strips and fans of each primitive, once for each node that shows its
 * mesh, with the nodes' transforms applied in double. A node that mirrors turns the corners' order,
 * so that the outside stays outside. Read are POSITION, NORMAL, TEXCOORD_0 (t is turned: glTF's runs
 * down, ours up) and indices, of all types of numbers; buffers are files, base64 or the GLB's chunk.
 *
 * Passed over with a note: materials and images (which may be missing: they are never opened),
 * skins, morph targets, animations, further attributes, points and lines. Refused: sparse accessors,
 * compressed meshes, nodes that do not make trees, bytes beyond a buffer's end, extensions that the
 * file requires and that change its geometry.
 *
 * VTK's own reader is not used: it opens all images and fails where one is missing, reads beyond
 * what a damaged file holds, and applies transforms in float.
 *
 * Format: Khronos glTF 2.0 specification.
 */

#include "MesoMeshFile.h"
#include "mesoIOMesostructureModule.h" // for export macro

/// Throws MesoInputError "file: place: reason". Buffers are searched beside `fileName`.
MESOIOMESOSTRUCTURE_EXPORT MesoMeshFile MesoParseGltf(
  const std::string& bytes, const std::string& fileName);

#endif
