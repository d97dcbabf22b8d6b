#ifndef MesoReliefShader_h
#define MesoReliefShader_h

#include "MesoConeTexture.h"
#include "MesoHeightMapTexture.h"
#include "MesoOptions.h" // for MesoMesostructureOptions
#include "MesoTechniqueShader.h"

/**
 * @class MesoReliefShader
 * @brief The techniques `relief` and `relief-quadric`: a height field searched along the ray, in the
 * tangent plane or over the quadric.
 *
 * The options say which of the two it is. See Shaders/Techniques/Relief.glsl and ReliefQuadric.glsl.
 */
class MESORENDERINGMESOSTRUCTURE_EXPORT MesoReliefShader : public MesoTechniqueShader
{
public:
  /// One component of float heights in [0,1]; row 0 at t = 0.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap() const;
  void SetOptions(const MesoMesostructureOptions& options) { this->Options = options; }
  /// Steps in place of those that the quality stands for.
  void SetSteps(std::optional<MesoSearchSteps> steps) { this->Steps = steps; }

  /// Compute what the first frame would else wait for. Returns why that failed, or an empty text.
  std::string Prepare();

  MesoShaderShape GetShape() const override;
  std::string Activate(vtkOpenGLRenderWindow* window) override;
  void SetUniforms(vtkShaderProgram* program) override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetGPUBytes() const override;

private:
  bool UsesCones() const;

  MesoMesostructureOptions Options;
  std::optional<MesoSearchSteps> Steps;
  MesoHeightMapTexture Heights;
  MesoConeTexture Cones; ///< for the searches that need them
};

#endif
