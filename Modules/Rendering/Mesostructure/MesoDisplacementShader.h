#ifndef MesoDisplacementShader_h
#define MesoDisplacementShader_h

#include "MesoHeightMapTexture.h"
#include "MesoHorizonTexture.h"
#include "MesoOptions.h" // for MesoMesostructureOptions
#include "MesoTechniqueShader.h"

#include <array>
#include <string>

/**
 * @class MesoDisplacementShader
 * @brief The technique `displacement`: a vertex stage that places grids, and the fragments of a mesh that
 * is the detail. See Shaders/Techniques/Displacement.glsl.
 */
class MesoDisplacementShader : public MesoTechniqueShader
{
public:
  /// What corners have beside position, normal and the mesh's coordinate.
  enum class Extra
  {
    Nothing,
    Colors,     ///< three texels a triangle
    Coordinates ///< for VTK's textures: two
  };

  MesoDisplacementShader();
  ~MesoDisplacementShader() override;

  MesoHeightMapTexture& GetHeights() { return this->Heights; }
  MesoHorizonTexture& GetHorizon() { return this->Horizon; }
  void SetOptions(const MesoMesostructureOptions& options) { this->Options = options; }
  /// Why the mesh cannot be diced; empty where it can.
  void SetFailure(const std::string& failure) { this->Failure = failure; }
  void SetExtra(Extra extra) { this->Extras = extra; }
  Extra GetExtra() const { return this->Extras; }
  /// Positions in the vertex buffer over object units.
  void SetBufferScale(const std::array<double, 3>& scale) { this->BufferScale = scale; }
  /// Texels of the corners' buffer that a triangle has.
  int GetCornerTexels() const;

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
  std::string Failure;
  Extra Extras = Extra::Nothing;
  std::array<double, 3> BufferScale = { 1., 1., 1. };
};

#endif
