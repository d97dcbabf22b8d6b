#ifndef MesoGeometryImageShader_h
#define MesoGeometryImageShader_h

#include "MesoBufferTexture.h"
#include "MesoOptions.h" // for MesoMesostructureOptions
#include "MesoTechniqueShader.h"
#include "vtkNew.h"          // for the indices
#include "vtkSmartPointer.h" // for the image

#include <array>
#include <vector>

class vtkImageData;
class vtkOpenGLBufferObject;
struct MesoGridView;

/**
 * @class MesoGeometryImageShader
 * @brief The technique `geometry-image`: levels of an image of positions, each drawn as a grid.
 *
 * See Shaders/Techniques/GeometryImage.glsl and vtkMesoGeometryImage.
 */
class MesoGeometryImageShader : public MesoTechniqueShader
{
public:
  MesoGeometryImageShader();
  ~MesoGeometryImageShader() override;

  void SetImage(vtkImageData* image);
  vtkImageData* GetImage() const { return this->Image; }
  void SetOptions(const MesoMesostructureOptions& options) { this->Options = options; }
  /// What positions become in the vertex buffer: (p - shift) x scale.
  void SetBufferPlace(const std::array<double, 3>& shift, const std::array<double, 3>& scale);

  /// Chooses the coarsest level whose triangles' sides are no longer than what the options ask for.
  void ChooseLevel(const MesoGridView& view);
  int GetLevel() const { return this->Level; }
  std::int64_t GetNumberOfTriangles() const;
  void Draw();

  MesoShaderShape GetShape() const override;
  std::string Activate(vtkOpenGLRenderWindow* window) override;
  void SetUniforms(vtkShaderProgram* program) override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetGPUBytes() const override;

private:
  struct Grid
  {
    std::size_t FirstIndex;
    std::size_t Indices;
    double Spacing; ///< mean side of its triangles, object units
  };

  std::string Upload(vtkOpenGLRenderWindow* window);

  MesoMesostructureOptions Options;
  vtkSmartPointer<vtkImageData> Image;
  std::array<double, 3> Shift = { 0., 0., 0. };
  std::array<double, 3> Scale = { 1., 1., 1. };
  std::vector<Grid> Levels;
  std::array<double, 6> Bounds = { 0., 0., 0., 0., 0., 0. };
  int Level = 0;
  MesoBufferTexture Vertices;
  vtkNew<vtkOpenGLBufferObject> Indices;
  std::size_t IndexBytes = 0;
  unsigned long long UploadedTime = 0;         ///< MTime of the image that the buffers hold
  vtkOpenGLRenderWindow* UploadedTo = nullptr; ///< never looked into
};

#endif
