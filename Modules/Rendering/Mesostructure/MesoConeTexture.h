#ifndef MesoConeTexture_h
#define MesoConeTexture_h

#include "MesoMapTexture.h"
#include "vtkNew.h" // for the filter

class vtkMesoConeMap;

/**
 * @class MesoConeTexture
 * @brief The cones of free space over a height map (vtkMesoConeMap) as a texture.
 *
 * Two channels of 8 bits, apex and steepness; the four ways of travel lie in the quarters of a texture of
 * twice the map's width and height, so that one fetch gives a ray's cone. See
 * Shaders/Common/ConeAccess.glsl.
 */
class MesoConeTexture : public MesoMapTexture
{
public:
  MesoConeTexture();
  ~MesoConeTexture() override;

  /// Compute the cones of a height map, unless they are those of it as it is now. Returns why that
  /// failed, or an empty text.
  std::string Prepare(vtkImageData* heights, MesoWrap wrap);

  /// Prepare, upload what has changed and bind the texture. Returns why that failed, or an empty text.
  std::string Activate(vtkOpenGLRenderWindow* window, vtkImageData* heights, MesoWrap wrap);
  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  vtkNew<vtkMesoConeMap> Cones;
};

#endif
