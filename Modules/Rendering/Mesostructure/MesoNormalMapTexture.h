#ifndef MesoNormalMapTexture_h
#define MesoNormalMapTexture_h

#include "MesoMapTexture.h"
#include "MesoNormalMap.h" // for MesoNormalMapMeaning

struct MesoShaderShape;

/**
 * @class MesoNormalMapTexture
 * @brief A normal map as a texture with a pyramid, and what it adds to any technique's shader.
 *
 * See Shaders/Common/NormalMap.glsl.
 */
class MesoNormalMapTexture : public MesoMapTexture
{
public:
  MesoNormalMapTexture();

  /// Null: no map.
  void SetNormalMap(vtkImageData* map, const MesoNormalMapMeaning& meaning);
  vtkImageData* GetNormalMap() const { return this->GetImage(); }
  const MesoNormalMapMeaning& GetMeaning() const { return this->Meaning; }

  /// Makes a technique's shape that of the technique with this map's normals.
  void AddTo(MesoShaderShape& shape) const;

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  MesoNormalMapMeaning Meaning;
};

#endif
