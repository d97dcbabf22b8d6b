#ifndef MesoSurfaceUniforms_h
#define MesoSurfaceUniforms_h

/**
 * @file MesoSurfaceUniforms.h
 * @brief Uniforms of what is drawn, or cut away, where the ray hits.
 */

class vtkPlaneCollection;
class vtkRenderer;
class vtkShaderProgram;
struct MesoContourLines;

/// Most clipping planes of a mapper; VTK's own limit.
constexpr int MesoMostClippingPlanes = 6;

/// Those of Shaders/Common/ContourDec.glsl, where the program has them.
void MesoSetContourUniforms(vtkShaderProgram* program, const MesoContourLines& lines);

/// Those of Shaders/Common/ClipDec.glsl, where the program has them: planes of the world, by the
/// renderer's camera.
void MesoSetClipUniforms(
  vtkShaderProgram* program, vtkPlaneCollection* planes, vtkRenderer* renderer);

#endif
