/**
 * @class vtkMesoPolyDataMapper
 * @brief Draw a base mesh with one of Meso's techniques; by itself, the technique `plain`.
 *
 * The family's mappers derive from this class and give it a technique (MesoTechniqueShader). What
 * is common to all of them is here and in Shaders/Common: lighting, depth, colour textures read
 * where the ray hit, and every pixel's hit as numbers (vtkMesoAOVPass).
 *
 * A frame is drawn as by vtkOpenGLPolyDataMapper, with these steps added:
 *
 *     arrays of the input -> vertex attributes       RenderPieceStart
 *     technique's chunks spliced into the shaders    ReplaceShaderValues, before the superclass
 *     own lighting in place of VTK's                 ReplaceShaderLight
 *     textures and uniforms                          SetMapper-, SetCameraShaderParameters
 *
 * Without relief the picture is that of vtkPolyDataMapper, bit for bit, for any lights.
 *
 * A technique that needs the tangent frame asks for the point arrays MesoTangent (3), MesoBitangent
 * (3) and MesoTileScale (2), normals and texture coordinates (vtkMesoSurfaceFrames makes them).
 * Where they are missing the base mesh is drawn and one warning says what to add.
 *
 * Shadows between actors are vtkMesoShadowMapPass's. VTK's own shadow map passes see the displaced
 * surface as well. Seen from behind, where back faces are not culled, the base mesh is drawn. A
 * mirrored matrix turns front and back, as for any VTK actor. Physically based materials are lit by
 * VTK, without self-shadow. Clipping planes, at most six, cut the surface that is drawn, not the base
 * mesh.
 *
 * The environment variable MESO_DUMP_SHADERS names a folder to which each shader that is built is
 * written.
 *
 * @sa vtkMesoReliefMapper, vtkMesoAOVPass, vtkMesoShadowMapPass
 */

#ifndef vtkMesoPolyDataMapper_h
#define vtkMesoPolyDataMapper_h

#include "MesoContourLines.h"                 // for the lines drawn
#include "MesoNormalMap.h"                    // for MesoNormalMapMeaning
#include "MesoOptions.h"                      // for MesoMesostructureOptions
#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkOpenGLPolyDataMapper.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

class MesoHeightColors;
class MesoNormalMapTexture;
class MesoShaderAssembler;
class MesoTechniqueShader;
class MesoVertexAttributes;
struct MesoShaderBuild;
struct MesoShaderShape;
class vtkImageData;
class vtkLookupTable;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoPolyDataMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkMesoPolyDataMapper* New();
  vtkTypeMacro(vtkMesoPolyDataMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How the detail is drawn. Scale, tiles: a new value is a uniform and costs nothing; quality,
   * effects and wrap build the shader anew. The mapper's class is the technique; where it is a
   * family, the options name which of them.
   */
  void SetOptions(const MesoMesostructureOptions& options);
  const MesoMesostructureOptions& GetOptions() const { return this->Options; }
  ///@}

  ///@{
  /// D, the depth of the deepest point below the base mesh, in object units, >= 0. Default 0.
  void SetScale(double scale);
  double GetScale() const { return this->Options.Scale; }
  ///@}

  /// Map coordinate = texture coordinate x tiles; each > 0. Default 1, 1.
  void SetTiles(double u, double v);

  ///@{
  /**
   * Colours by the height where the ray hit, 1 - relief depth, in place of the material's colour and
   * of scalar colours: the table's colours over its range, the end colours beyond; its opacities are
   * not looked at. Where the base mesh is drawn the height is 1. Null (the default): off, and nothing
   * of it is in the shader. On and off build the shader anew.
   */
  void SetHeightColors(vtkLookupTable* table);
  vtkLookupTable* GetHeightColors() const;
  ///@}

  ///@{
  /**
   * Lines of equal height on the surface that is drawn, smooth and as wide on the screen everywhere;
   * over textures and unlit, as ink. Where the base mesh is drawn there are none. Numbers are
   * uniforms; lines where there were none, or another number of Heights, build the shader anew.
   */
  void SetContourLines(const MesoContourLines& lines);
  const MesoContourLines& GetContourLines() const { return this->ContourLines; }
  ///@}

  ///@{
  /**
   * What the numbers of the height map's file were at the heights 0 and 1, for those who read heights
   * off the picture (vtkMesoPicker). Changes nothing that is drawn. Default 0, 1.
   */
  void SetMapNumbers(double atZero, double atOne);
  const std::array<double, 2>& GetMapNumbers() const { return this->MapNumbers; }
  ///@}

  /// Draw as another mapper does: VTK's part, the options, the colours and the contour lines. The
  /// tables, maps and input are shared.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  ///@{
  /**
   * A normal map that gives the shading normal where the ray hit, in place of the technique's own, for
   * techniques that show the effect `shading`; what its numbers mean is said, never guessed. Null (the
   * default): none. Techniques that dice show the normals of the diced mesh.
   */
  void SetNormalMap(vtkImageData* map, const MesoNormalMapMeaning& meaning = {});
  vtkImageData* GetNormalMap() const;
  ///@}
  /// Whether its actors cast and take shadows in vtkMesoShadowMapPass: the effect `cast_shadow` is on.
  bool CastsShadow() const { return this->EffectsChosen().Has(MesoEffect::CastShadow); }
  /// When what the options and maps show last changed, where that does not build anything anew.
  virtual vtkMTimeType GetDetailMTime() { return this->OptionsTime; }

  /// The effects that the shader of the last frame had compiled in.
  MesoEffects GetEffectsDrawn() const { return this->EffectsDrawn; }

  /// Why the last frame shows the base mesh instead of the technique, or nothing of data that are no mesh; empty where
  /// the technique is drawn.
  const std::string& GetWhyPlain() const { return this->WhyPlain; }

  /// Triangles that the last frame was drawn with.
  virtual std::int64_t GetNumberOfTrianglesDrawn();

  /// Bytes of vertex data, indices and textures held on the GPU since the last frame.
  std::size_t GetGPUBytes();

  void RenderPieceStart(vtkRenderer* renderer, vtkActor* actor) override;
  void RenderPieceFinish(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkMesoPolyDataMapper();
  ~vtkMesoPolyDataMapper() override;

  /// Bounds of the mesh and of the detail, which lies at most D away from it.
  void ComputeBounds() override;

  using Shaders = std::map<vtkShader::Type, vtkShader*>;

  /// The technique of this class; the base class's is `plain`.
  virtual MesoTechniqueShader* GetTechnique();
  /// Called after the options have changed.
  virtual void OptionsChanged() {}
  ///@{
  /// For classes whose vertex stage places the vertices (MesoShaderShape::Diced): whether it does so in
  /// this frame, and making the program ready that does; it is LastBoundBO's. False where there is nothing
  /// to draw.
  bool PlacesVertices(vtkActor* actor);
  bool ReadyToPlaceVertices(vtkRenderer* renderer, vtkActor* actor);
  ///@}
  /// Bytes of the GPU that a class takes for geometry of its own.
  virtual std::size_t GetGeometryBytes() const { return 0; }
  /// The technique that this class draws with some options.
  virtual MesoTechnique TechniqueOf(const MesoMesostructureOptions& options) const;

  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderValues(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderLight(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderClip(Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderCoincidentOffset(
    Shaders shaders, vtkRenderer* renderer, vtkActor* actor) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void SetCameraShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;

private:
  vtkMesoPolyDataMapper(const vtkMesoPolyDataMapper&) = delete;
  void operator=(const vtkMesoPolyDataMapper&) = delete;

  /// The technique's, with the normal map's part.
  MesoShaderShape Shape();
  MesoEffects EffectsChosen() const;
  MesoShaderBuild DescribeBuild(vtkOpenGLHelper& cellBO, vtkActor* actor);
  /// Back faces of open meshes are drawn into shadow maps, where light comes in from behind.
  void SetCulling(vtkRenderer* renderer);

  /// Why the technique cannot be drawn on the input; empty when it can.
  std::string WhyNot(const MesoShaderShape& shape);
  bool DrawsContours(const MesoShaderShape& shape) const;
  void Report(const MesoShaderAssembler& assembler);
  void WarnOnce(const std::string& reason);

  MesoMesostructureOptions Options;
  vtkTimeStamp OptionsTime;
  vtkTimeStamp ClosedTime;
  vtkPolyData* ClosedMesh = nullptr; ///< the mesh that Closed tells of; never looked into
  bool Closed = false;
  std::unique_ptr<MesoTechniqueShader> Plain;
  std::string WhyPlain; ///< why the technique cannot be drawn in this frame
  std::string LastWarning;
  MesoEffects EffectsDrawn;
  MesoContourLines ContourLines;
  std::array<double, 2> MapNumbers = { 0., 1. };
  std::unique_ptr<MesoVertexAttributes> Attributes;
  std::unique_ptr<MesoNormalMapTexture> NormalMap;
  std::unique_ptr<MesoHeightColors> HeightColors;
  bool HeightColorsReady = false; ///< in this frame
  std::map<const vtkOpenGLHelper*, std::string> BuiltKeys;
};

#endif
