#ifndef MesoHeightMapTexture_h
#define MesoHeightMapTexture_h

#include "MesoOptions.h"     // for MesoWrap
#include "vtkNew.h"          // for the texture
#include "vtkSmartPointer.h" // for the height map

#include <cstddef>
#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

/**
 * @class MesoHeightMapTexture
 * @brief A height map as a texture of one float channel, which keeps 16-bit and float heights exactly.
 *
 * For every technique that reads heights; see Shaders/Common/HeightAccess.glsl.
 */
class MesoHeightMapTexture
{
public:
  MesoHeightMapTexture();
  ~MesoHeightMapTexture();
  MesoHeightMapTexture(const MesoHeightMapTexture&) = delete;
  void operator=(const MesoHeightMapTexture&) = delete;

  /// One component of float heights in [0,1]; row 0 at t = 0. Null: no map.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap() const;

  /// Whether a pyramid of filtered heights is held as well, for techniques that read it. Default: no.
  void SetMipmaps(bool mipmaps);

  /// Upload what has changed and bind the texture. Returns why that failed, or an empty text; without
  /// a map there is nothing to do.
  std::string Activate(vtkOpenGLRenderWindow* window, MesoWrap wrap);
  void SetUniforms(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  std::size_t GetGPUBytes() const;

private:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap);

  vtkSmartPointer<vtkImageData> HeightMap;
  vtkNew<vtkTextureObject> Texture;
  bool Mipmaps = false;
  unsigned long long UploadedTime = 0; ///< MTime of the map that the texture holds
  MesoWrap UploadedWrap = MesoWrap::Repeat;
};

#endif
