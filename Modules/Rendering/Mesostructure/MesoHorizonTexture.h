#ifndef MesoHorizonTexture_h
#define MesoHorizonTexture_h

#include "MesoMapTexture.h"

/**
 * @class MesoHorizonTexture
 * @brief A horizon map (vtkMesoHorizonMap) as a texture of three dimensions, a slice an azimuth.
 *
 * See Shaders/Techniques/Horizon.glsl.
 */
class MesoHorizonTexture : public MesoMapTexture
{
public:
  MesoHorizonTexture();

  /// A float component an azimuth, radians; `scale` is that of the filter. Null: no map.
  void SetHorizonMap(vtkImageData* map, double scale);
  vtkImageData* GetHorizonMap() const { return this->GetImage(); }

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  double Scale = 1.0;
};

#endif
