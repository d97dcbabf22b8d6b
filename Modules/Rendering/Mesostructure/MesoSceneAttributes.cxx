#include "MesoSceneAttributes.h"

#include "MesoSceneBuilder.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <cmath>

namespace
{
void SetVector(MesoExrAttributes& attributes, const std::string& name, const double vector[3])
{
  attributes[name + ".x"] = vector[0];
  attributes[name + ".y"] = vector[1];
  attributes[name + ".z"] = vector[2];
}

void DescribeObjects(const MesoSceneBuilder& builder, MesoExrAttributes& attributes)
{
  for (const auto& object : builder.GetObjects())
  {
    const std::string prefix = "meso." + std::to_string(object.Number) + ".";
    attributes[prefix + "name"] = object.Name;
    attributes[prefix + "scale"] = object.Options.Scale;
    attributes[prefix + "world_units"] =
      std::cbrt(std::abs(object.Actor->GetMatrix()->Determinant()));
    // A volume's voxels count as texels of the tile.
    vtkImageData* map = object.Volume ? object.Volume : object.HeightMap;
    if (map)
    {
      const int* size = map->GetDimensions();
      attributes[prefix + "map_width"] = static_cast<double>(size[0]);
      attributes[prefix + "map_height"] = static_cast<double>(size[1]);
    }
  }
}

void DescribeLights(vtkRenderer* renderer, MesoExrAttributes& attributes)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  int number = 0;
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    const std::string prefix = "meso.light." + std::to_string(number++) + ".";
    double position[3];
    double towards[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(towards);
    if (light->GetPositional())
    {
      SetVector(attributes, prefix + "position", position);
      continue;
    }
    vtkMath::Subtract(position, towards, towards);
    vtkMath::Normalize(towards);
    SetVector(attributes, prefix + "towards", towards);
  }
}

void DescribeCamera(vtkCamera* camera, double aspect, MesoExrAttributes& attributes)
{
  double forward[3];
  double right[3];
  double up[3];
  camera->GetDirectionOfProjection(forward);
  vtkMath::Cross(forward, camera->GetViewUp(), right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, up);
  const bool parallel = camera->GetParallelProjection() != 0;
  const double halfHeight = parallel
    ? camera->GetParallelScale()
    : std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  vtkMath::MultiplyScalar(up, halfHeight);
  vtkMath::MultiplyScalar(right, halfHeight * aspect);
  SetVector(attributes, "meso.camera.position", camera->GetPosition());
  SetVector(attributes, "meso.camera.forward", forward);
  SetVector(attributes, "meso.camera.right", right);
  SetVector(attributes, "meso.camera.up", up);
  attributes["meso.camera.parallel"] = parallel ? 1. : 0.;
}
}

MesoExrAttributes MesoAttributesOfScene(
  const MesoSceneBuilder& builder, vtkRenderer* renderer, double aspect)
{
  MesoExrAttributes attributes;
  DescribeObjects(builder, attributes);
  DescribeLights(renderer, attributes);
  DescribeCamera(renderer->GetActiveCamera(), aspect, attributes);
  return attributes;
}
