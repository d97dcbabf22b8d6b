#ifndef MesoActorPasses_h
#define MesoActorPasses_h

/**
 * @file MesoActorPasses.h
 * @brief Which render passes an actor is being drawn by.
 */

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkLightingMapPass.h"
#include "vtkOpenGLRenderPass.h"

/// Whether the actor is being drawn by a pass of class T.
template <typename T>
bool MesoInPass(vtkActor* actor)
{
  vtkInformation* info = actor->GetPropertyKeys();
  if (!info || !info->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    return false;
  }
  for (int i = 0; i < info->Length(vtkOpenGLRenderPass::RenderPasses()); ++i)
  {
    if (T::SafeDownCast(info->Get(vtkOpenGLRenderPass::RenderPasses(), i)))
    {
      return true;
    }
  }
  return false;
}

/// Whether vtkLightingMapPass asks for normals or luminance instead of colours.
inline bool MesoInLightingMap(vtkActor* actor)
{
  vtkInformation* info = actor->GetPropertyKeys();
  return info &&
    (info->Has(vtkLightingMapPass::RENDER_NORMALS()) ||
      info->Has(vtkLightingMapPass::RENDER_LUMINANCE()));
}

#endif
