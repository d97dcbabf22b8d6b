#ifndef MesoBaseTexture_h
#define MesoBaseTexture_h

#include "vtkNew.h"          // for the textures
#include "vtkSmartPointer.h" // for the image

#include <array>
#include <cstddef>
#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

/**
 * @class MesoBaseTexture
 * @brief The image of a base mesh (vtkMesoBaseImage) as two textures, positions and normals.
 *
 * See Shaders/Common/BaseAccess.glsl.
 */
class MesoBaseTexture
{
public:
  MesoBaseTexture();
  ~MesoBaseTexture();
  MesoBaseTexture(const MesoBaseTexture&) = delete;
  void operator=(const MesoBaseTexture&) = delete;

  /// Null: no image.
  void SetImage(vtkImageData* image);
  vtkImageData* GetImage() const;
  /// The point that positions are counted from, object space; (0, 0, 0) without an image.
  const std::array<double, 3>& GetCentre() const { return this->Centre; }

  /// Upload what has changed and bind the textures. Returns why that failed, or an empty text.
  std::string Activate(vtkOpenGLRenderWindow* window);
  void SetUniforms(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  std::size_t GetGPUBytes() const;

private:
  std::string Upload(vtkOpenGLRenderWindow* window);

  vtkSmartPointer<vtkImageData> Image;
  vtkNew<vtkTextureObject> Positions;
  vtkNew<vtkTextureObject> Normals;
  unsigned long long UploadedTime = 0; ///< MTime of the image that the textures hold
  std::array<double, 3> Centre = { 0., 0., 0. };
};

#endif
