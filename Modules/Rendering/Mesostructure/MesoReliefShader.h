#ifndef MesoReliefShader_h
#define MesoReliefShader_h

#include "MesoBaseTexture.h"
#include "MesoConeTexture.h"
#include "MesoHeightLevelsTexture.h"
#include "MesoHeightMapTexture.h"
#include "MesoOptions.h" // for MesoMesostructureOptions
#include "MesoTechniqueShader.h"

/**
 * @class MesoReliefShader
 * @brief The techniques `relief`, `relief-quadric` and `relief-quadric-exact`: a height field searched
 * along the ray, in the tangent plane or over a curved base.
 *
 * The options say which technique and which base it is. See Shaders/Techniques/Relief*.glsl.
 */
class MESORENDERINGMESOSTRUCTURE_EXPORT MesoReliefShader : public MesoTechniqueShader
{
public:
  /// One component of float heights in [0,1]; row 0 at t = 0.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap() const;
  /// The mesh's image (vtkMesoBaseImage), for the bases that need one (MesoNeedsBaseImage).
  void SetBaseImage(vtkImageData* image);
  vtkImageData* GetBaseImage() const;
  void SetOptions(const MesoMesostructureOptions& options);
  /// Steps in place of those that the quality stands for.
  void SetSteps(std::optional<MesoSearchSteps> steps) { this->Steps = steps; }

  /// Compute what the first frame would else wait for. Returns why that failed, or an empty text.
  std::string Prepare();

  MesoShaderShape GetShape() const override;
  std::string Activate(vtkOpenGLRenderWindow* window) override;
  void SetUniforms(vtkShaderProgram* program) override;
  const double* GetCentre() const override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetGPUBytes() const override;

private:
  bool UsesCones() const;
  bool UsesLevels() const; ///< those of the pyramid have cones, too
  std::string PrepareCones();

  MesoMesostructureOptions Options;
  std::optional<MesoSearchSteps> Steps;
  MesoHeightMapTexture Heights;
  MesoHeightLevelsTexture Levels; ///< for the search that needs them
  MesoConeTexture Cones;          ///< for the searches that need them
  MesoBaseTexture Base;           ///< for the bases that need it
};

#endif
