/**
 * @class vtkMesoShellMapper
 * @brief Draw a volume of mesostructure - overhangs, weaves, chains - in a shell of prisms over a mesh.
 *
 * The input is the shell that vtkMesoPrismShell makes of the mesh. Its outside, as far as it looks to the eye,
 * is rasterised; a fragment is where the eye's ray comes into the shell, from where it is followed from prism to
 * prism. The ray's way through a prism is a straight line in texture space (or several, the options'
 * Segments), along which the volume is searched; a fragment that meets nothing is not drawn, and the
 * depth buffer decides between fragments, in any order of drawing (Wang2004, section 3.2). With the eye or
 * the near plane in the shell rays begin there.
 *
 * The options' Exits: with Interpolated each prism is drawn by itself (the shell with InnerFins), and where a
 * ray leaves it comes out of distances at its vertices (section 4.2); for comparison.
 *
 * The options' Technique says how the volume is searched:
 *
 * - ShellSDF: along its signed distance, by steps as long as that is (sphere tracing). The quality says how
 *   short the shortest steps are: 1, 1/2, 1/4, 1/8 voxel.
 *
 * - Slices: not at all; with the options' Stack Prism the input is a stack of slices of each prism
 *   (vtkMesoPrismShell's Slices), and what of them lies in matter is drawn, from both sides (Meyer1998). With
 *   Screen slices are parallel to the projection plane, at the same depths before the eye in all prisms,
 *   counted from the shell's middle, the Scale apart divided by 1/4, 1/2, 1 or 2 (the quality) for each of the
 *   volume's slices; the input is the shell, and the first slice in matter on a ray's way is drawn.
 * - GDM: by one look-up of the distance to matter in a Table of it (vtkMesoGDMTable) for each piece of a
 *   ray's way, and one for each light. The quality Full is a whole table.
 *
 * Volume: a canonical volume, one tile of the mesostructure in x and y, whole in z: the point array
 * MesoSignedDistance (1, float; tile widths, negative inside; row 0 at t = 0, z from the shell's bottom to
 * its top) and the field array MesoVolumeDepth (1; z counts that many tile widths). Matter ends at the
 * shell's bottom, top and open fins, where its cut is seen. The point array MesoColor (3, float; red,
 * green, blue in [0, 1]), where there is one, multiplies the actor's ambient and diffuse color where matter is met.
 *
 * The options' Scale is the shell's thickness, which the input has already; Effects other than shading,
 * self-shadow and those of shadow maps are shown together or not at all.
 *
 * Sources: Wang et al., "Generalized Displacement Maps", EGSR 2004; for sphere tracing Hart1996 of Documentation/Techniques/References.md.
 *
 * @sa vtkMesoPrismShell, vtkMesoPolyDataMapper
 */

#ifndef vtkMesoShellMapper_h
#define vtkMesoShellMapper_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkMesoPolyDataMapper.h"

#include <memory>

class MesoShellShader;
class vtkImageData;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoShellMapper : public vtkMesoPolyDataMapper
{
public:
  static vtkMesoShellMapper* New();
  vtkTypeMacro(vtkMesoShellMapper, vtkMesoPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The volume; without one the shell's faces are drawn.
  void SetVolume(vtkImageData* volume);
  vtkImageData* GetVolume();
  vtkMTimeType GetDetailMTime() override;
  ///@}

  ///@{
  /// The volume's table of distances, for the technique GDM, which draws the shell's faces without one.
  void SetTable(vtkImageData* table);
  vtkImageData* GetTable();
  ///@}

  /// Draw as another mapper does; volume and table are shared.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;

protected:
  vtkMesoShellMapper();
  ~vtkMesoShellMapper() override;

  MesoTechniqueShader* GetTechnique() override;
  MesoTechnique TechniqueOf(const MesoMesostructureOptions& options) const override;
  void OptionsChanged() override;
  void SetCameraShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkMesoShellMapper(const vtkMesoShellMapper&) = delete;
  void operator=(const vtkMesoShellMapper&) = delete;

  std::unique_ptr<MesoShellShader> Shell;
};

#endif
