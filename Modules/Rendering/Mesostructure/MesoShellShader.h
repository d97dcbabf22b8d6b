#ifndef MesoShellShader_h
#define MesoShellShader_h

#include "MesoGDMTexture.h"
#include "MesoOptions.h" // for MesoMesostructureOptions
#include "MesoPrismTexture.h"
#include "MesoTechniqueShader.h"
#include "MesoVolumeMap.h"

/**
 * @class MesoShellShader
 * @brief The techniques that draw a volume of mesostructure in a shell of prisms.
 *
 * The options say which. See Shaders/Common/PrismShell.glsl and Shaders/Techniques.
 */
class MESORENDERINGMESOSTRUCTURE_EXPORT MesoShellShader : public MesoTechniqueShader
{
public:
  /// A canonical volume (MesoVolumeMap). Null: none, and the shell's faces are drawn.
  void SetVolume(vtkImageData* volume);
  vtkImageData* GetVolume() const { return this->Volume.GetVolume(); }
  /// The table of the volume, for the technique GDM. Null: none.
  void SetTable(vtkImageData* table) { this->TableProblem = this->Table.SetTable(table); }
  vtkImageData* GetTable() const { return this->Table.GetTable(); }
  void SetOptions(const MesoMesostructureOptions& options) { this->Options = options; }
  /// The shell that is drawn (vtkMesoPrismShell).
  void SetShell(vtkPolyData* shell) { this->ShellProblem = this->Prisms.SetShell(shell); }

  MesoShaderShape GetShape() const override;
  std::string Activate(vtkOpenGLRenderWindow* window) override;
  void SetUniforms(vtkShaderProgram* program) override;
  const double* GetCentre() const override { return this->Prisms.GetCentre().data(); }
  void Deactivate() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  std::size_t GetGPUBytes() const override;

private:
  std::vector<MesoMapTexture*> Textures();
  bool UsesTable() const { return this->Options.Technique == MesoTechnique::GDM; }

  MesoMesostructureOptions Options;
  std::string ShellProblem; ///< why the input is no shell
  std::string TableProblem; ///< why the table is none
  MesoPrismTexture Prisms;
  MesoVolumeMap Volume;
  MesoVolumeColorMap Colors;
  MesoGDMTexture Table;
};

/// Slices across the shell's thickness: 1/4, 1/2, 1 or 2 for each of the volume's, as the quality says.
int MesoSlicesOf(vtkImageData& volume, MesoQuality quality);

#endif
