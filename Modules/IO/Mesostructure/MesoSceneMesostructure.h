#ifndef MesoSceneMesostructure_h
#define MesoSceneMesostructure_h

/**
 * @file MesoSceneMesostructure.h
 * @brief The part of a scene file that says what relief is on a surface and how it is drawn.
 */

#include "MesoSceneValue.h"

/// Reads the value of the key "mesostructure": sets the node's Mesostructure, Map, Volume, Baked,
/// VolumeColors and the space of its Material's normal map. Throws MesoInputError on what is wrong with it.
void MesoReadSceneMesostructure(const MesoSceneValue& value, MesoSceneNode& node);

#endif
