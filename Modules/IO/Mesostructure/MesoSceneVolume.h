#ifndef MesoSceneVolume_h
#define MesoSceneVolume_h

#include "MesoSceneValue.h"

/// The `volume` or `tile_mesh` of a mesostructure, if it has one.
std::optional<MesoSceneVolume> MesoReadSceneVolume(const MesoSceneValue& mesostructure);

#endif
