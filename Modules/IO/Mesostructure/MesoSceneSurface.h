#ifndef MesoSceneSurface_h
#define MesoSceneSurface_h

/**
 * @file MesoSceneSurface.h
 * @brief The parts of a scene file that say what a base is: mesh, part, material.
 *
 * Each reads the value of the key of its name and throws MesoInputError on what is wrong with it.
 */

#include "MesoSceneValue.h"

MesoSceneMesh MesoReadSceneMesh(const MesoSceneValue& value);
MesoScenePart MesoReadScenePart(const MesoSceneValue& value);
MesoSceneMaterial MesoReadSceneMaterial(const MesoSceneValue& value);

#endif
