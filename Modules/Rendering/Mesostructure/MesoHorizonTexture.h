#ifndef MesoHorizonTexture_h
#define MesoHorizonTexture_h

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

/**
 * @class MesoHorizonTexture
 * @brief A horizon map (vtkMesoHorizonMap) as a texture of three dimensions, a slice an azimuth.
 *
 * See Shaders/Techniques/Horizon.glsl.
 */
class MesoHorizonTexture
{
public:
  MesoHorizonTexture();
  ~MesoHorizonTexture();
  MesoHorizonTexture(const MesoHorizonTexture&) = delete;
  void operator=(const MesoHorizonTexture&) = delete;

  /// A float component an azimuth, radians; `scale` is that of the filter. Null: no map.
  void SetHorizonMap(vtkImageData* map, double scale);
  vtkImageData* GetHorizonMap() const;

  /// Upload what has changed and bind the texture. Returns why that failed, or an empty text; without
  /// a map there is nothing to do.
  std::string Activate(vtkOpenGLRenderWindow* window, MesoWrap wrap);
  void SetUniforms(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  std::size_t GetGPUBytes() const;

private:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap);

  vtkSmartPointer<vtkImageData> HorizonMap;
  double Scale = 1.0;
  vtkNew<vtkTextureObject> Texture;
  unsigned long long UploadedTime = 0; ///< MTime of the map that the texture holds
  MesoWrap UploadedWrap = MesoWrap::Repeat;
};

#endif
