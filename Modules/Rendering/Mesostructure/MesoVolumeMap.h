#ifndef MesoVolumeMap_h
#define MesoVolumeMap_h

#include "MesoMapTexture.h"

class vtkDataArray;

/// An array of a canonical volume as a texture: one tile, repeated in x and y.
class MesoVolumeTexture : public MesoMapTexture
{
protected:
  MesoVolumeTexture()
    : MesoMapTexture(1)
  {
  }

  /// An array of floats of the image's points. Returns why that failed, or an empty text.
  std::string UploadArray(vtkOpenGLRenderWindow* window, vtkDataArray* values);
};

/**
 * @class MesoVolumeMap
 * @brief A volume of signed distances as a texture; see Shaders/Common/VolumeAccess.glsl.
 *
 * The point array MesoSignedDistance (1, float) over the whole of one tile: tile widths, negative inside.
 * The field array MesoVolumeDepth (1): the volume's depth in tile widths.
 */
class MesoVolumeMap : public MesoVolumeTexture
{
public:
  /// Null: no volume.
  void SetVolume(vtkImageData* volume) { this->SetImage(volume); }
  vtkImageData* GetVolume() const { return this->GetImage(); }

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;
};

/**
 * @class MesoVolumeColorMap
 * @brief The colours of a volume (MesoVolumeColors) as a texture, where it has some; see
 * Shaders/Common/VolumeColorDec.glsl.
 */
class MesoVolumeColorMap : public MesoVolumeTexture
{
public:
  void SetVolume(vtkImageData* volume);
  bool HasColors() const { return this->GetImage() != nullptr; }

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;
};

#endif
