#ifndef MesoHeightMapTexture_h
#define MesoHeightMapTexture_h

#include "MesoMapTexture.h"

/**
 * @class MesoHeightMapTexture
 * @brief A height map as a texture of one float channel, which keeps 16-bit and float heights exactly.
 *
 * For every technique that reads heights; see Shaders/Common/HeightAccess.glsl.
 */
class MesoHeightMapTexture : public MesoMapTexture
{
public:
  MesoHeightMapTexture();

  /// One component of float heights in [0,1]; row 0 at t = 0. Null: no map.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap() const { return this->GetImage(); }

  /// Whether a pyramid of filtered heights is held as well, for techniques that read it. Default: no.
  void SetMipmaps(bool mipmaps);

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  bool Mipmaps = false;
  float Slope[2] = { 0.f, 0.f }; ///< root mean square along u and v, height per map coordinate
};

#endif
