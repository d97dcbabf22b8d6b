#ifndef MesoReliefShader_h
#define MesoReliefShader_h

#include "MesoOptions.h" // for MesoMesostructureOptions
#include "MesoTechniqueShader.h"
#include "vtkNew.h"          // for the texture
#include "vtkSmartPointer.h" // for the height map

class vtkImageData;
class vtkTextureObject;

/**
 * @class MesoReliefShader
 * @brief The techniques `relief` and `relief-quadric`: a height field searched along the ray, in the
 * tangent plane or over the quadric.
 *
 * Holds the height map as a single-channel float texture, which keeps 16-bit and float heights
 * exactly. The options say which of the two it is. See Shaders/Techniques/Relief.glsl and
 * ReliefQuadric.glsl.
 */
class MESORENDERINGMESOSTRUCTURE_EXPORT MesoReliefShader : public MesoTechniqueShader
{
public:
  MesoReliefShader();
  ~MesoReliefShader() override;

  /// One component of float heights in [0,1]; row 0 at t = 0.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap() const { return this->HeightMap; }
  void SetOptions(const MesoMesostructureOptions& options) { this->Options = options; }

  MesoShaderShape GetShape() const override;
  std::string Activate(vtkOpenGLRenderWindow* window) override;
  void SetUniforms(vtkShaderProgram* program) override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetGPUBytes() const override;

private:
  std::string Upload(vtkOpenGLRenderWindow* window);

  MesoMesostructureOptions Options;
  vtkSmartPointer<vtkImageData> HeightMap;
  vtkNew<vtkTextureObject> HeightTexture;
  unsigned long long UploadedTime = 0; ///< MTime of the map that the texture holds
  MesoWrap UploadedWrap = MesoWrap::Repeat;
};

#endif
