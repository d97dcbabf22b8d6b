/**
 * @class vtkMesoShadowMapPass
 * @brief Shadows that objects cast on each other, relief included, by shadow maps.
 *
 *     vtkNew<vtkMesoShadowMapPass> shadows;
 *     renderer->SetPass(shadows);
 *
 * Of each light that casts shadows the scene is drawn from the light into a map of depths (Williams
 * 1978; Oliveira2005, section 3.5), relief traced along the light's own rays, and then by the
 * delegate pass, where every fragment looks up what lies between it and the light.
 *
 * - Directional lights, spot lights and point lights (six views) cast; headlights do not. A light
 *   whose vtkLight::SetShadowAttenuation is 0 casts none, in between a part of its light is taken.
 * - Every visible, opaque vtkActor of the renderer casts. With Meso's mappers the effect
 *   `cast_shadow` must be on, which also lets them take shadows; other mappers of triangles take
 *   them as well. With fewer than two such actors nothing is added to any shader, unless one of them is drawn
 *   as a volume in a shell (vtkMesoShellMapper), which shades itself from afar.
 * - An object's own relief blocks light by the technique's search; of the object itself the map
 *   counts only what lies beyond its shell, so that nothing is counted twice. Documentation/Shadows.md
 *   says how far that is, and what it misses.
 * - A map is a square of Resolution texels, fitted to what casts, whatever the window's shape.
 * - Maps are drawn anew only where an actor, its mapper, its mesh or a light has changed; a camera
 *   that moves costs none.
 *
 * In place of vtkShadowMapPass, whose maps of exponentials are skewed by windows that are not
 * square.
 *
 * @sa vtkMesoPolyDataMapper, vtkMesoAOVPass
 */

#ifndef vtkMesoShadowMapPass_h
#define vtkMesoShadowMapPass_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <string>
#include <vector>

class vtkActor;
class vtkMesoShadowCasterPass;
class vtkOpenGLCamera;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;
class vtkTextureObject;
struct MesoShadowTile;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoShadowMapPass : public vtkOpenGLRenderPass
{
public:
  static vtkMesoShadowMapPass* New();
  vtkTypeMacro(vtkMesoShadowMapPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// What draws the picture, its camera and lights included (vtkMesoAOVPass, say). Null (the
  /// default): what a renderer without a pass draws.
  void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass() { return this->DelegatePass; }
  ///@}

  /// Render a renderer's window once by a pass: below the renderer's own pass where that is of this
  /// class, so that shadows are there as well, else in its place.
  static void RenderThrough(vtkRenderer* renderer, vtkRenderPass* pass);

  ///@{
  /// Texels across a light's map, at least 16. Default 1024; less where the device's largest texture
  /// does not hold as many for all lights.
  vtkSetClampMacro(Resolution, int, 16, 16384);
  vtkGetMacro(Resolution, int);
  ///@}

  /// Number of maps that the last frame was drawn with; 0: no shadows, and nothing in the shaders.
  int GetNumberOfMaps() const { return this->NumberOfMaps; }
  /// How often the maps have been drawn.
  int GetNumberOfBakes() const { return this->NumberOfBakes; }
  /// Bytes of the maps on the GPU.
  std::size_t GetGPUBytes() const;

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;
  vtkMTimeType GetShaderStageMTime() override { return this->ShaderTime; }

protected:
  vtkMesoShadowMapPass();
  ~vtkMesoShadowMapPass() override;

private:
  vtkMesoShadowMapPass(const vtkMesoShadowMapPass&) = delete;
  void operator=(const vtkMesoShadowMapPass&) = delete;

  /// Views of one light among the tiles.
  struct Views
  {
    int First = -1;
    int Count = 0;
    bool Near = false; ///< the light has a place
    float Part = 0.f;
  };

  void FindCasters(vtkRenderer* renderer);
  void PlaceTiles(vtkRenderer* renderer, int resolution);
  /// What the maps depend on; equal values, equal maps.
  std::vector<double> StateOfMaps(vtkRenderer* renderer) const;
  bool Bake(vtkRenderer* renderer);
  void UpdateUniforms(vtkRenderer* renderer);
  bool Takes(vtkAbstractMapper* mapper) const;

  vtkSmartPointer<vtkRenderPass> DelegatePass;
  vtkSmartPointer<vtkRenderPass> DefaultPass;
  int Resolution = 1024;
  int NumberOfMaps = 0;
  int NumberOfBakes = 0;

  std::vector<vtkActor*> Casters;
  std::vector<Views> Lights; ///< those that are on, in the renderer's order
  std::vector<MesoShadowTile> Tiles;
  std::vector<vtkSmartPointer<vtkOpenGLCamera>> Cameras; ///< one a tile
  int TileSize = 0;                                      ///< texels
  std::vector<double> Baked;                             ///< StateOfMaps of the maps

  vtkNew<vtkMesoShadowCasterPass> CasterPass;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Maps;

  std::string Definitions; ///< of the shaders
  vtkTimeStamp ShaderTime;
  std::vector<float> ViewUniform;
  std::vector<float> FrameUniform;
  std::vector<float> TileUniform;
};

#endif
