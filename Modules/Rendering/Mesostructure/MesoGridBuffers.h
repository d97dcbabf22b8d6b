#ifndef MesoGridBuffers_h
#define MesoGridBuffers_h

#include "vtkNew.h" // for the buffers

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;
struct MesoGridPieces;

/**
 * @class MesoGridBuffers
 * @brief What the vertex stage places grids with, on the GPU: corners, pieces, and one list of indices.
 *
 * See Shaders/Techniques/Displacement.glsl and MesoGridBase.
 */
class MesoGridBuffers
{
public:
  MesoGridBuffers();
  ~MesoGridBuffers();
  MesoGridBuffers(const MesoGridBuffers&) = delete;
  void operator=(const MesoGridBuffers&) = delete;

  ///@{
  /// Uploads numbers, four a texel. Returns why that failed, or an empty text.
  std::string SetCorners(vtkOpenGLRenderWindow* window, const std::vector<float>& numbers);
  std::string SetPieces(vtkOpenGLRenderWindow* window, const MesoGridPieces& pieces);
  ///@}
  void Activate();
  void SetUniforms(vtkShaderProgram* program);
  void Deactivate();
  /// Draws the pieces with the program and the vertex array that are bound.
  void Draw(vtkShaderProgram* program, const MesoGridPieces& pieces);
  void ReleaseGraphicsResources(vtkWindow* window);
  std::size_t GetGPUBytes() const { return this->Bytes[0] + this->Bytes[1] + this->Bytes[2]; }

private:
  std::string Upload(
    int which, vtkOpenGLRenderWindow* window, const std::vector<float>& numbers, const char* what);

  vtkNew<vtkOpenGLBufferObject> Buffers[2]; ///< corners, pieces
  vtkNew<vtkTextureObject> Textures[2];
  vtkNew<vtkOpenGLBufferObject> Indices;
  std::size_t Bytes[3] = { 0, 0, 0 };
};

#endif
