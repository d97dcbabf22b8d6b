#ifndef MesoSceneSurface_h
#define MesoSceneSurface_h

/**
 * @file MesoSceneSurface.h
 * @brief The parts of a scene file that say what a surface is: mesh, part, material, mesostructure.
 *
 * Each reads the value of the key of its name and throws MesoInputError on what is wrong with it.
 */

#include "MesoSceneValue.h"

MesoSceneMesh MesoReadSceneMesh(const MesoSceneValue& value);
MesoScenePart MesoReadScenePart(const MesoSceneValue& value);
MesoSceneMaterial MesoReadSceneMaterial(const MesoSceneValue& value);

/// Sets the node's Mesostructure and Map.
void MesoReadSceneMesostructure(const MesoSceneValue& value, MesoSceneNode& node);

#endif
