#ifndef MesoConeTexture_h
#define MesoConeTexture_h

#include "MesoMapTexture.h"

class vtkMesoConeMap;

/**
 * @class MesoConeTexture
 * @brief The cones of free space over a height map (vtkMesoConeMap), or over levels of its pyramid, as a
 * texture.
 *
 * Four channels of 8 bits, apex and steepness of two ways of travel; the other two lie in the right half of a
 * texture of twice the map's width, so that one fetch gives a ray's cone. Those of levels above the map lie side
 * by side above the map's, in the same texture, for a choice between two textures reads both on some devices. See
 * Shaders/Common/ConeAccess.glsl.
 */
class MesoConeTexture : public MesoMapTexture
{
public:
  MesoConeTexture();
  ~MesoConeTexture() override;

  /// Compute the cones of a height map and of its levels, each half as large as the one before, unless they
  /// are those of them as they are now. Returns why that failed, or an empty text.
  std::string Prepare(const std::vector<vtkSmartPointer<vtkImageData>>& levels, MesoWrap wrap);

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  std::vector<vtkSmartPointer<vtkMesoConeMap>> Cones; ///< of each level
};

#endif
