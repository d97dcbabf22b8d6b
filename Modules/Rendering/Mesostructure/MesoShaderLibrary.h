#ifndef MesoShaderLibrary_h
#define MesoShaderLibrary_h

#include "mesoRenderingMesostructureModule.h" // for export macro

#include <string>
#include <vector>

/**
 * @file MesoShaderLibrary.h
 * @brief The texts of the folder Shaders/, built into the library.
 *
 * In debug builds the environment variable MESO_SHADER_DIR names a folder that is read instead, at
 * every use, so that a shader can be edited and seen without a build.
 */

/// The text of a file of Shaders/, named as there ("Common/Lighting.glsl"); empty when there is
/// none.
MESORENDERINGMESOSTRUCTURE_EXPORT std::string MesoShaderText(const std::string& name);

/// Write an assembled shader to the folder that the environment variable MESO_DUMP_SHADERS names, as
/// shader<n>.<stage>.glsl with n counted over the process. Without the variable, or a text, nothing.
void MesoDumpShader(const char* stage, const std::string& text);

/// The names of all texts.
MESORENDERINGMESOSTRUCTURE_EXPORT std::vector<std::string> MesoShaderNames();

#endif
