#ifndef MesoMapTexture_h
#define MesoMapTexture_h

#include "MesoOptions.h"     // for MesoWrap
#include "vtkSmartPointer.h" // for the image

#include <cstddef>
#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

/**
 * @class MesoMapTexture
 * @brief An image as one or more textures, uploaded when they are not yet those of it.
 *
 * A subclass names the image and knows how it becomes textures; when it does so is known here: where
 * the image, its contents, the wrap or the window's context is another than last time.
 */
class MesoMapTexture
{
public:
  virtual ~MesoMapTexture();
  MesoMapTexture(const MesoMapTexture&) = delete;
  void operator=(const MesoMapTexture&) = delete;

  /// Null where there is none.
  vtkImageData* GetImage() const;

  /// Upload what has changed and bind the textures. Returns why that failed, or an empty text; without
  /// an image there is nothing to do.
  std::string Activate(vtkOpenGLRenderWindow* window, MesoWrap wrap);

  /// The samplers and what else the shader is to know, where it uses them.
  virtual void SetUniforms(vtkShaderProgram* program) = 0;

  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  /// Bytes held on the GPU.
  std::size_t GetGPUBytes() const;

protected:
  /// @param count of textures
  explicit MesoMapTexture(std::size_t count);

  /// Null: none.
  void SetImage(vtkImageData* image);
  /// The textures are to be made anew, though the image is as it was.
  void SetStale() { this->UploadedTime = 0; }

  /// Makes the textures of the image. Returns why that failed, or an empty text.
  virtual std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) = 0;

  vtkTextureObject* Texture(std::size_t index = 0) const;

  /// Tells the shader where a texture is bound; false where it does not use the sampler.
  bool SetSampler(vtkShaderProgram* program, const char* name, std::size_t index = 0) const;

  std::size_t Bytes = 0; ///< of the textures, set by Upload

private:
  bool IsUploaded(vtkOpenGLRenderWindow* window, MesoWrap wrap) const;

  vtkSmartPointer<vtkImageData> Image;
  std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
  unsigned long long UploadedTime = 0; ///< MTime of the image that the textures hold
  MesoWrap UploadedWrap = MesoWrap::Repeat;
};

#endif
