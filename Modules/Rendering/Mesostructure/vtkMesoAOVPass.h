/**
 * @class vtkMesoAOVPass
 * @brief Write every pixel's hit as numbers, in one rendering of the scene.
 *
 * Set it as a renderer's pass, render once, and take the numbers with GetValue, GetChannel or
 * GetInterleaved. One sample at each pixel's centre, whatever the window's multisampling; a pixel
 * that nothing covers is 0 in every channel. Rows run from the top.
 *
 * Channels: `coverage`; `depth` (distance from the camera along its axis, world units);
 * `texcoord.u`, `texcoord.v` (map coordinates, unwrapped); `relief` (depth in [0,1] at the hit);
 * `normal.x`, `.y`, `.z` (world, unit, for shading); `object` (as SetObjectNumber says, else 0);
 * `fetches`, `texel_reads`, `iterations`; `shadow.0` and on, one for each light that is on, in the
 * renderer's order: the fraction that the actor itself blocks, 1 where its facet faces away.
 * Mappers that are not Meso's give coverage, depth and object.
 *
 * At most 12 lights (the device's 8 targets); more are an error. The renderer's background, layers
 * and gradient play no part.
 */

#ifndef vtkMesoAOVPass_h
#define vtkMesoAOVPass_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkCameraPass;
class vtkMatrix4x4;
class vtkOpenGLFramebufferObject;
class vtkTextureObject;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoAOVPass : public vtkOpenGLRenderPass
{
public:
  static vtkMesoAOVPass* New();
  vtkTypeMacro(vtkMesoAOVPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Lights whose shadows the device's 8 targets hold.
  static constexpr int MostLights = 12;

  /// The number that `object` gives for a prop: 1-based, 0 for none.
  void SetObjectNumber(vtkProp* prop, int number);

  /// Width, height of what was rendered last, in pixels.
  int GetWidth() const { return this->Size[0]; }
  int GetHeight() const { return this->Size[1]; }

  /// The channels of what was rendered last.
  std::vector<std::string> GetChannelNames() const;

  /// A channel's value at a pixel; row 0 is the top. An unknown channel or pixel gives NaN.
  float GetValue(const std::string& channel, int column, int row) const;

  /// A whole channel, row 0 first; empty when there is no such channel.
  std::vector<float> GetChannel(const std::string& channel) const;

  /// The named channels, interleaved for each pixel, row 0 first.
  std::vector<float> GetInterleaved(const std::vector<std::string>& channels) const;

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;

protected:
  vtkMesoAOVPass();
  ~vtkMesoAOVPass() override;

private:
  vtkMesoAOVPass(const vtkMesoAOVPass&) = delete;
  void operator=(const vtkMesoAOVPass&) = delete;

  /// Where a channel lies: target and component; target -1 when there is no such channel.
  std::pair<int, int> Locate(const std::string& channel) const;
  /// The value at a place that Locate gave; NaN where there is none.
  float ValueAt(const std::pair<int, int>& place, int column, int row) const;
  void ReadBack();

  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
  std::vector<std::vector<float>> Targets; ///< RGBA of targets 1 and on, row 0 at the bottom
  std::map<vtkProp*, int> ObjectNumbers;
  int Size[2] = { 0, 0 };
  int LightCount = 0;
  vtkNew<vtkMatrix4x4> ViewToWorld;
  float DepthOfZ[4] = { 0.f, 0.f, 0.f, 0.f };
};

#endif
