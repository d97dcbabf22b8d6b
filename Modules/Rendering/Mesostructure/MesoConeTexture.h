#ifndef MesoConeTexture_h
#define MesoConeTexture_h

#include "MesoOptions.h"     // for MesoWrap
#include "vtkNew.h"          // for the filter
#include "vtkSmartPointer.h" // for the map

#include <cstddef>
#include <string>

class vtkImageData;
class vtkMesoConeMap;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

/**
 * @class MesoConeTexture
 * @brief The cones of free space over a height map (vtkMesoConeMap) as a texture.
 *
 * Two channels of 8 bits, apex and steepness; the four ways of travel lie in the quarters of a texture of
 * twice the map's width and height, so that one fetch gives a ray's cone. See
 * Shaders/Common/ConeAccess.glsl.
 */
class MesoConeTexture
{
public:
  MesoConeTexture();
  ~MesoConeTexture();
  MesoConeTexture(const MesoConeTexture&) = delete;
  void operator=(const MesoConeTexture&) = delete;

  /// Compute the cones of a height map, unless they are those of it as it is now. Returns why that
  /// failed, or an empty text.
  std::string Prepare(vtkImageData* heights, MesoWrap wrap);

  /// Prepare, upload what has changed and bind the texture. Returns why that failed, or an empty text.
  std::string Activate(vtkOpenGLRenderWindow* window, vtkImageData* heights, MesoWrap wrap);
  void SetUniforms(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  std::size_t GetGPUBytes() const;

private:
  std::string Upload(vtkOpenGLRenderWindow* window);

  vtkNew<vtkMesoConeMap> Cones;
  vtkNew<vtkTextureObject> Texture;
  unsigned long long UploadedTime = 0; ///< MTime of the cones that the texture holds
};

#endif
