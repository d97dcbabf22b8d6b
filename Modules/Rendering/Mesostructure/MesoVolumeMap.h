#ifndef MesoVolumeMap_h
#define MesoVolumeMap_h

#include "MesoMapTexture.h"

/**
 * @class MesoVolumeMap
 * @brief A volume of signed distances as a texture; see Shaders/Common/VolumeAccess.glsl.
 *
 * The point array MesoSignedDistance (1, float) over the whole of one tile: tile widths, negative inside.
 * The field array MesoVolumeDepth (1): the volume's depth in tile widths.
 */
class MesoVolumeMap : public MesoMapTexture
{
public:
  MesoVolumeMap();

  /// Null: no volume.
  void SetVolume(vtkImageData* volume) { this->SetImage(volume); }
  vtkImageData* GetVolume() const { return this->GetImage(); }

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;
};

#endif
