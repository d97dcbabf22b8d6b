#ifndef MesoNormalMapTexture_h
#define MesoNormalMapTexture_h

#include "MesoNormalMap.h"
#include "MesoOptions.h"     // for MesoWrap
#include "vtkNew.h"          // for the texture
#include "vtkSmartPointer.h" // for the map

#include <cstddef>
#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;
struct MesoShaderShape;

/**
 * @class MesoNormalMapTexture
 * @brief A normal map as a texture with a pyramid, and what it adds to any technique's shader.
 *
 * See Shaders/Common/NormalMap.glsl.
 */
class MesoNormalMapTexture
{
public:
  MesoNormalMapTexture();
  ~MesoNormalMapTexture();
  MesoNormalMapTexture(const MesoNormalMapTexture&) = delete;
  void operator=(const MesoNormalMapTexture&) = delete;

  /// Null: no map.
  void SetNormalMap(vtkImageData* map, const MesoNormalMapMeaning& meaning);
  vtkImageData* GetNormalMap() const;
  const MesoNormalMapMeaning& GetMeaning() const { return this->Meaning; }

  /// Makes a technique's shape that of the technique with this map's normals.
  void AddTo(MesoShaderShape& shape) const;

  /// Upload what has changed and bind the texture. Returns why that failed, or an empty text; without
  /// a map there is nothing to do.
  std::string Activate(vtkOpenGLRenderWindow* window, MesoWrap wrap);
  void SetUniforms(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  std::size_t GetGPUBytes() const;

private:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap);

  vtkSmartPointer<vtkImageData> NormalMap;
  MesoNormalMapMeaning Meaning;
  vtkNew<vtkTextureObject> Texture;
  unsigned long long UploadedTime = 0; ///< MTime of the map that the texture holds
  MesoWrap UploadedWrap = MesoWrap::Repeat;
  std::size_t Bytes = 0;
};

#endif
