#ifndef MesoGridBuffers_h
#define MesoGridBuffers_h

#include "MesoBufferTexture.h"
#include "vtkNew.h" // for the indices

#include <cstddef>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
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
  std::size_t GetGPUBytes() const;

private:
  MesoBufferTexture Corners;
  MesoBufferTexture Pieces;
  vtkNew<vtkOpenGLBufferObject> Indices;
};

#endif
