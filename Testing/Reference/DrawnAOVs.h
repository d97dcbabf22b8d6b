#ifndef DrawnAOVs_h
#define DrawnAOVs_h

// A scene as its mappers draw it: what its pixels know, as the reference gives it.

#include "MesoAOVs.h"
#include "MesoSceneAttributes.h"
#include "MesoSceneBuilder.h"
#include "vtkMesoAOVPass.h"
#include "vtkMesoEGLRenderWindow.h"
#include "vtkMesoShadowMapPass.h"

#include "vtkNew.h"
#include "vtkRenderer.h"

#include <functional>

/// change: called with the scene's objects before they are drawn.
inline MesoExrImage DrawnImage(const MesoScene& scene, int width, int height,
  const std::function<void(const MesoSceneBuilder&)>& change = {})
{
  vtkNew<vtkMesoEGLRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  MesoSceneBuilder builder;
  builder.Build(scene, renderer);
  if (change)
  {
    change(builder);
  }
  vtkNew<vtkMesoAOVPass> pass;
  for (const auto& object : builder.GetObjects())
  {
    pass->SetObjectNumber(object.Actor, object.Number);
  }
  vtkMesoShadowMapPass::RenderThrough(renderer, pass);
  MesoExrImage image;
  image.Width = width;
  image.Height = height;
  image.ChannelNames = pass->GetChannelNames();
  image.Data = pass->GetInterleaved(image.ChannelNames);
  image.Attributes = MesoAttributesOfScene(builder, renderer, double(width) / height);
  pass->ReleaseGraphicsResources(window);
  return image;
}

inline MesoAOVs DrawnAOVs(const MesoScene& scene, int width, int height,
  const std::function<void(const MesoSceneBuilder&)>& change = {})
{
  return MesoAOVsOfImage(DrawnImage(scene, width, height, change));
}

#endif
