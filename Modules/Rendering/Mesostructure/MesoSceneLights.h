#ifndef MesoSceneLights_h
#define MesoSceneLights_h

struct MesoSceneCamera;
struct MesoSceneLight;
class vtkRenderer;

/// The renderer's active camera becomes the scene's; without a clipping range it is fitted to what the
/// renderer holds.
void MesoSetSceneCamera(const MesoSceneCamera& camera, vtkRenderer* renderer);

/// Adds a light. Those in camera coordinates are brought to VTK's camera lights.
void MesoAddSceneLight(
  const MesoSceneLight& light, const MesoSceneCamera& camera, vtkRenderer* renderer);

#endif
