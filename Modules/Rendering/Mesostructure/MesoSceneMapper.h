#ifndef MesoSceneMapper_h
#define MesoSceneMapper_h

/**
 * @file MesoSceneMapper.h
 * @brief The mapper that draws a node's technique, with all that it needs beside the node's mesh.
 */

#include "MesoSceneBuilder.h"

struct MesoNormals;

/**
 * Sets the object's Mapper, with its maps, tables and options, and its Mesh where that is another than
 * the base: moved, with quadrics, or a shell. The mapper has its input.
 *
 * @param node of the scene, with all that the file says of it
 * @param object its base mesh, maps and volume are there
 * @param normals of the material's map, or none
 * @param inScene the node's place, for messages
 * @param warnings gains what is odd
 * Throws MesoInputError where something cannot be used.
 */
void MesoMakeSceneMapper(const MesoSceneNode& node, MesoSceneBuilder::Object& object,
  const MesoNormals& normals, const std::string& inScene, std::vector<std::string>& warnings);

#endif
