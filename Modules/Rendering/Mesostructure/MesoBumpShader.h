#ifndef MesoBumpShader_h
#define MesoBumpShader_h

#include "MesoHeightMapTexture.h"
#include "MesoHorizonTexture.h"
#include "MesoOptions.h" // for MesoMesostructureOptions
#include "MesoTechniqueShader.h"

/**
 * @class MesoBumpShader
 * @brief The techniques that leave the base mesh where it is: `bump`, `normal`, `normal-object`,
 * `parallax`, `horizon`.
 *
 * The options say which of them it is. The normals of `normal` and `normal-object` come from the mapper's
 * normal map; the height map, where there is one, then serves numbers alone. See
 * Shaders/Techniques/Bump.glsl, Parallax.glsl and Horizon.glsl.
 */
class MesoBumpShader : public MesoTechniqueShader
{
public:
  MesoBumpShader();
  ~MesoBumpShader() override;

  /// One component of float heights in [0,1]; row 0 at t = 0.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap() const;
  MesoHorizonTexture& GetHorizon() { return this->Horizon; }
  void SetOptions(const MesoMesostructureOptions& options) { this->Options = options; }

  MesoShaderShape GetShape() const override;
  std::string Activate(vtkOpenGLRenderWindow* window) override;
  void SetUniforms(vtkShaderProgram* program) override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetGPUBytes() const override;

private:
  MesoMesostructureOptions Options;
  MesoHeightMapTexture Heights;
  MesoHorizonTexture Horizon;
};

#endif
