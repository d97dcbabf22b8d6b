/**
 * @class vtkMesoVDMMapper
 * @brief View-dependent displacement mapping: where rays meet the relief is looked up in a table.
 *
 * Draws `q = p + (h - 1) D n` as seen from the eye, with D the Scale of the options and h the height
 * map, by a few look-ups a pixel and no search: near detail hides far detail, detail shades itself for
 * each light, the outline and the depth buffer are those of the detail. Around each fragment the base is a
 * circle in the plane of ray and normal, of the curvature along the ray (point array MesoQuadric,
 * vtkMesoQuadricFit).
 *
 * The table is vtkMesoVDM's, of the map or of its factors. How deep the relief is in it does not matter to
 * what is drawn, as long as it is deep enough to look like: rays are taken to the table's space and back,
 * exactly where the base is flat. Directions beyond the first and last polar angle, and curvatures beyond
 * the first and last, are taken for those.
 *
 * The options' Rank and Quality say how many of the table's factors are summed, as far as it has them: 2,
 * 4, 8, 12 for distances at Draft, Low, Medium, High; Full asks for a table without factors. The mesh
 * that is drawn is where height 1 lies. The table is of a tile that repeats.
 *
 * Heights: one component of float in [0,1], row 0 at t = 0, bilinear between texel centres; the normals
 * are theirs, whatever the table's resolution.
 *
 * Source: Wang et al., "View-Dependent Displacement Mapping", SIGGRAPH 2003.
 *
 * @sa vtkMesoPolyDataMapper, vtkMesoVDM, vtkMesoSurfaceFrames, vtkMesoQuadricFit
 */

#ifndef vtkMesoVDMMapper_h
#define vtkMesoVDMMapper_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkMesoPolyDataMapper.h"

#include <memory>

class MesoVDMShader;
class vtkImageData;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoVDMMapper : public vtkMesoPolyDataMapper
{
public:
  static vtkMesoVDMMapper* New();
  vtkTypeMacro(vtkMesoVDMMapper, vtkMesoPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The height map; without one the base mesh is drawn.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap();
  ///@}

  ///@{
  /// The table, an output of vtkMesoVDM; without one the base mesh is drawn. One that is none is an error,
  /// and there is no table then.
  void SetTable(vtkImageData* table);
  vtkImageData* GetTable();
  ///@}

  ///@{
  /// Two shortcuts of the paper, to be measured. FlatShadows: light leaves the relief as if the base were
  /// flat. NearestOutlines: the outline is that of the table's nearest texel. Default off.
  void SetFlatShadows(bool flat);
  vtkGetMacro(FlatShadows, bool);
  void SetNearestOutlines(bool nearest);
  vtkGetMacro(NearestOutlines, bool);
  ///@}

  /// Draw as another mapper does; the height map and the table are shared.
  void ShallowCopy(vtkAbstractMapper* mapper) override;
  vtkMTimeType GetDetailMTime() override;

  /// Factors of distances and of largest angles that options ask for; 0, 0 for a table without factors.
  static std::array<int, 2> GetRanks(const MesoMesostructureOptions& options);

protected:
  vtkMesoVDMMapper();
  ~vtkMesoVDMMapper() override;

  MesoTechniqueShader* GetTechnique() override;
  MesoTechnique TechniqueOf(const MesoMesostructureOptions& options) const override;
  void OptionsChanged() override;

private:
  vtkMesoVDMMapper(const vtkMesoVDMMapper&) = delete;
  void operator=(const vtkMesoVDMMapper&) = delete;

  std::unique_ptr<MesoVDMShader> VDM;
  bool FlatShadows = false;
  bool NearestOutlines = false;
};

#endif
