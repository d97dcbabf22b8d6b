#include "MesoSceneLights.h"

#include "MesoScene.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkRenderer.h"

#include <cmath>

void MesoSetSceneCamera(const MesoSceneCamera& camera, vtkRenderer* renderer)
{
  vtkCamera* target = renderer->GetActiveCamera();
  target->SetPosition(camera.Position.data());
  target->SetFocalPoint(camera.FocalPoint.data());
  target->SetViewUp(camera.ViewUp.data());
  target->SetViewAngle(camera.ViewAngle);
  target->SetParallelProjection(camera.ParallelScale.has_value());
  if (camera.ParallelScale)
  {
    target->SetParallelScale(*camera.ParallelScale);
  }
  if (camera.ClippingRange)
  {
    target->SetClippingRange(camera.ClippingRange->data());
  }
  else
  {
    renderer->ResetCameraClippingRange();
  }
}

void MesoAddSceneLight(
  const MesoSceneLight& light, const MesoSceneCamera& camera, vtkRenderer* renderer)
{
  using Kind = MesoSceneLight::Kind;
  vtkNew<vtkLight> target;
  target->SetColor(light.Color.data());
  target->SetIntensity(light.Intensity);
  target->SetShadowAttenuation(light.Shadow ? 1.f : 0.f); // read by vtkMesoShadowMapPass
  if (light.Type == Kind::Headlight)
  {
    target->SetLightTypeToHeadlight();
    renderer->AddLight(target);
    return;
  }
  MesoVector3 position = light.Position;
  MesoVector3 focalPoint = light.FocalPoint;
  if (light.Type == Kind::Directional)
  {
    position = { -light.Direction[0], -light.Direction[1], -light.Direction[2] };
    focalPoint = { 0., 0., 0. };
  }
  target->SetLightTypeToSceneLight();
  if (light.InCameraCoordinates)
  {
    // VTK's camera lights live in a space with the camera at (0,0,1) and the focal point at 0.
    target->SetLightTypeToCameraLight();
    if (light.Type != Kind::Directional)
    {
      double distance = 0.;
      for (int i = 0; i < 3; ++i)
      {
        distance += std::pow(camera.FocalPoint[i] - camera.Position[i], 2);
      }
      distance = std::sqrt(distance);
      for (MesoVector3* point : { &position, &focalPoint })
      {
        *point = { (*point)[0] / distance, (*point)[1] / distance, (*point)[2] / distance + 1. };
      }
    }
  }
  target->SetPosition(position.data());
  target->SetFocalPoint(focalPoint.data());
  if (light.Type != Kind::Directional)
  {
    target->PositionalOn();
    target->SetConeAngle(light.Type == Kind::Spot ? light.ConeAngle : 90.);
    target->SetExponent(light.Exponent);
    target->SetAttenuationValues(light.Attenuation.data());
  }
  renderer->AddLight(target);
}
