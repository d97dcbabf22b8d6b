#ifndef MesoBaseTexture_h
#define MesoBaseTexture_h

#include "MesoMapTexture.h"

#include <array>

/**
 * @class MesoBaseTexture
 * @brief The image of a base mesh (vtkMesoBaseImage) as two textures, positions and normals.
 *
 * See Shaders/Common/BaseAccess.glsl.
 */
class MesoBaseTexture : public MesoMapTexture
{
public:
  MesoBaseTexture();

  /// Null: no image.
  void SetBaseImage(vtkImageData* image);
  /// The point that positions are counted from, object space; (0, 0, 0) without an image.
  const std::array<double, 3>& GetCentre() const { return this->Centre; }

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  std::array<double, 3> Centre = { 0., 0., 0. };
};

#endif
