#ifndef MesoHitTextures_h
#define MesoHitTextures_h

/**
 * @file MesoHitTextures.h
 * @brief An actor's colour textures and scalar colours, read where the ray hit instead of at the base
 * mesh.
 */

#include <string>
#include <utility>
#include <vector>

class MesoShaderAssembler;
class vtkTexture;

/// VTK's list of an actor's textures and their uniforms' names.
using MesoActorTextures = std::vector<std::pair<vtkTexture*, std::string>>;

/// Whether there are textures that are laid over the surface; scalar colours are none.
bool MesoHasColorTextures(const MesoActorTextures& textures);

/// Make the fragment shader, once VTK has written its part, read them by Common/TextureDec.glsl.
void MesoReadTexturesAtHit(MesoShaderAssembler& fragment, const MesoActorTextures& textures);

/// The same for colours by a point array, by Common/ScalarDec.glsl: VTK reads them in a texture of the
/// lookup table, or has them at the vertices.
void MesoReadScalarsAtHit(MesoShaderAssembler& fragment, bool texture);

#endif
