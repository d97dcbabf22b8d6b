#ifndef MesoBufferTexture_h
#define MesoBufferTexture_h

#include "vtkNew.h" // for the buffer

#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

/**
 * @class MesoBufferTexture
 * @brief A list of floats that the vertex stage reads by number, four a texel: a samplerBuffer.
 */
class MesoBufferTexture
{
public:
  MesoBufferTexture();
  ~MesoBufferTexture();
  MesoBufferTexture(const MesoBufferTexture&) = delete;
  void operator=(const MesoBufferTexture&) = delete;

  /// At least one texel. Returns why that failed, with `what` as its subject (plural), or an empty text.
  std::string Upload(
    vtkOpenGLRenderWindow* window, const std::vector<float>& numbers, const char* what);
  void Activate();
  void SetUniform(vtkShaderProgram* program, const char* name);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  std::size_t GetGPUBytes() const { return this->Bytes; }

private:
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
  std::size_t Bytes = 0;
};

#endif
