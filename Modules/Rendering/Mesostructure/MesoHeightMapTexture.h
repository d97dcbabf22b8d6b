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
  /// With a pyramid, tells its shader what each level lacks of the map's slopes.
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  void CompareLevels(const float* heights);

  bool Mipmaps = false;
  static constexpr int MostLevels = 16; ///< ComparedLevels of Shaders/Kernels/LevelChoice.glsl
  /// Mean square slopes along u and v: of the map, and how much of them each level of its pyramid lacks.
  float SlopesLost[MostLevels][2] = {};
  /// Of each level, the variance of the slopes of a rough surface (Shaders/Kernels/RoughRelief.glsl) that stands for what
  /// it lacks.
  float Roughness[MostLevels][2] = {};
  int LastLevel = 0;
};

#endif
