#ifndef MesoHeightLevelsTexture_h
#define MesoHeightLevelsTexture_h

#include "MesoMapTexture.h"

/**
 * @class MesoHeightLevelsTexture
 * @brief A height map and the levels of its pyramid, as a texture to be read texel by texel.
 *
 * One float channel; the levels (MesoMakeHeightPyramid) lie side by side above the map itself, for a choice between
 * two textures reads both on some devices. A device's own pyramid is not asked for: its texels are the device's, and
 * quads of pixels share a level. See Shaders/Common/ConeAccess.glsl.
 */
class MesoHeightLevelsTexture : public MesoMapTexture
{
public:
  MesoHeightLevelsTexture();

  /// Make the levels of a height map of one float component, unless they are those of it as it is now.
  void Prepare(vtkImageData* heights);

  /// One image a level, from the map itself on.
  const std::vector<vtkSmartPointer<vtkImageData>>& GetLevels() const { return this->Levels; }

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  std::vector<vtkSmartPointer<vtkImageData>> Levels;
  unsigned long long PreparedTime = 0; ///< MTime of the map that they are of
};

#endif
