#ifndef MesoVDMShader_h
#define MesoVDMShader_h

#include "MesoHeightMapTexture.h"
#include "MesoOptions.h" // for MesoMesostructureOptions
#include "MesoTechniqueShader.h"
#include "MesoVDMPart.h"

#include <memory>

/**
 * @class MesoVDMShader
 * @brief The technique `vdm`: the view ray's and the lights' meetings with the relief, looked up.
 *
 * See Shaders/Techniques/VDM.glsl.
 */
class MesoVDMShader : public MesoTechniqueShader
{
public:
  MesoVDMShader();

  /// One component of float heights in [0,1]; row 0 at t = 0. They give the normals.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap() const;
  /// Of vtkMesoVDM. Returns why it is none, or an empty text.
  std::string SetTable(vtkImageData* table);
  vtkImageData* GetTable() const { return this->Table; }
  void SetOptions(const MesoMesostructureOptions& options);
  /// See vtkMesoVDMMapper.
  void SetFlatShadows(bool flat) { this->FlatShadows = flat; }
  void SetNearestOutlines(bool nearest) { this->NearestOutlines = nearest; }

  /// The factors that options ask for, for distances and angles; 0, 0: the table itself.
  static std::array<int, 2> RanksOf(const MesoMesostructureOptions& options);

  MesoShaderShape GetShape() const override;
  std::string Activate(vtkOpenGLRenderWindow* window) override;
  void SetUniforms(vtkShaderProgram* program) override;
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetGPUBytes() const override;

private:
  void SetParts();

  MesoMesostructureOptions Options;
  bool FlatShadows = false;
  bool NearestOutlines = false;
  MesoHeightMapTexture Heights;
  vtkSmartPointer<vtkImageData> Table;
  MesoVDMLayout Layout;
  std::array<int, 2> Ranks = { 0, 0 }; ///< that are used; 0: the table itself
  double Error = 0.;                   ///< root mean square of what is stored, of 1
  std::vector<std::unique_ptr<MesoVDMPart>> Parts;
};

#endif
