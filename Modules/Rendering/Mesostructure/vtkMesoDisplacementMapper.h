/**
 * @class vtkMesoDisplacementMapper
 * @brief Displace a mesh in the vertex stage, over grids that are held nowhere.
 *
 * The surface is q = p + (h - r) D n, with D the Scale and r the Reference of the options and h the height
 * map. Each triangle of the input is drawn as a barycentric lattice whose points the vertex stage places:
 * it reads the corners and the height and moves the point. On the GPU there are 96 bytes a triangle of
 * the input, 32 bytes a piece of 64 rows, the map, and a list of indices that all triangles share, however
 * fine they are cut.
 *
 * Edges are cut by the picture and by the map: segments are as long as FacetPixels of the options on the
 * screen (default: the quality's), but not more than MesoFacetsPerTexel of the quality a texel. An edge's
 * number of segments is decided by that edge alone, so that a closed mesh without seams stays closed
 * whatever its triangles are cut into (MesoGridBase). What lies outside of the picture is not drawn. With
 * FacetPixels 0 the map alone decides; then the picture is that of vtkMesoDisplacedMesh, to rounding,
 * where a triangle's edges have equal numbers of segments.
 *
 * Shading normals are q_s x q_t, at the points of the grid and interpolated between them
 * (Shaders/Kernels/DisplacedNormal.glsl); without the effect `curvature` the term of the base's curvature
 * is left out of them. With `self_shadow` and a horizon map (SetHorizonMap) the relief shades itself.
 *
 * Input: normals and texture coordinates. The input is looked at anew in each frame in which it has
 * changed, so it may deform. Heights: one component of float in [0,1], row 0 at t = 0, bilinear between
 * texel centres.
 *
 * Depth, outlines, clipping, translucency, shadow maps, edges and picking of cells are VTK's own on what is
 * drawn. Points and wireframe, and picking of points, show the base mesh. Cell normals are not read.
 *
 * Sources: Cook, "Shade Trees", SIGGRAPH 1984; Marschner, "Representing geometric details with textures",
 * 2008; with horizons Max, "Horizon Mapping: Shadows for Bump-Mapped Surfaces", The Visual Computer 4(2),
 * 1988.
 *
 * @sa vtkMesoDisplacedMesh, vtkMesoTessellatedMapper, vtkMesoHorizonMap
 */

#ifndef vtkMesoDisplacementMapper_h
#define vtkMesoDisplacementMapper_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkMesoPolyDataMapper.h"

#include <memory>

class MesoDisplacementShader;
class vtkImageData;
class vtkOpenGLRenderWindow;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoDisplacementMapper : public vtkMesoPolyDataMapper
{
public:
  static vtkMesoDisplacementMapper* New();
  vtkTypeMacro(vtkMesoDisplacementMapper, vtkMesoPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The height map; without one the base mesh is drawn.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap();
  ///@}

  ///@{
  /// The horizons of the height map, and the Scale, > 0, that vtkMesoHorizonMap had; without them the
  /// relief does not shade itself.
  void SetHorizonMap(vtkImageData* horizons, double scale);
  vtkImageData* GetHorizonMap();
  ///@}

  std::int64_t GetNumberOfTrianglesDrawn() override;

  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkMesoDisplacementMapper();
  ~vtkMesoDisplacementMapper() override;

  MesoTechniqueShader* GetTechnique() override;
  MesoTechnique TechniqueOf(const MesoMesostructureOptions& options) const override;
  void OptionsChanged() override;
  std::size_t GetGeometryBytes() const override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkMesoDisplacementMapper(const vtkMesoDisplacementMapper&) = delete;
  void operator=(const vtkMesoDisplacementMapper&) = delete;

  struct Grids;

  /// Follows the input; returns why that failed, or an empty text.
  std::string UpdateBase();
  std::string UpdateCorners(vtkOpenGLRenderWindow* window);
  std::string UpdatePieces(vtkRenderer* renderer, vtkActor* actor);

  std::unique_ptr<MesoDisplacementShader> Displacement;
  std::unique_ptr<Grids> Inside;
};

#endif
