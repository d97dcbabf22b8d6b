#include "MesoReferenceLighting.h"

#include "MesoHeightPyramid.h" // for the wrapped texels of an axis
#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
glm::dvec3 ToVector(const MesoVector3& values)
{
  return { values[0], values[1], values[2] };
}

glm::dvec3 Color(const double* color, double factor)
{
  return glm::dvec3(color[0], color[1], color[2]) * factor;
}

/// A stored number as OpenGL reads it from a normalised texture.
double StoredToUnit(int type)
{
  return type == VTK_UNSIGNED_CHAR ? 1. / 255. : type == VTK_UNSIGNED_SHORT ? 1. / 65535. : 1.;
}
}

MesoReferenceCamera::MesoReferenceCamera(const MesoSceneCamera& camera)
  : Position(ToVector(camera.Position))
  , Forward(glm::normalize(ToVector(camera.FocalPoint) - ToVector(camera.Position)))
  , Right(glm::normalize(glm::cross(this->Forward, ToVector(camera.ViewUp))))
  , Up(glm::cross(this->Right, this->Forward))
  , Parallel(camera.ParallelScale.has_value())
  , HalfHeight(camera.ParallelScale.value_or(std::tan(glm::radians(0.5 * camera.ViewAngle))))
  , Near(0.)
  , Far(std::numeric_limits<double>::infinity())
{
  if (camera.ClippingRange)
  {
    this->Near = (*camera.ClippingRange)[0];
    this->Far = (*camera.ClippingRange)[1];
  }
}

void MesoReferenceCamera::RayAt(
  double x, double y, double aspect, glm::dvec3& origin, glm::dvec3& direction) const
{
  const glm::dvec3 across =
    x * aspect * this->HalfHeight * this->Right + y * this->HalfHeight * this->Up;
  origin = this->Parallel ? this->Position + across : this->Position;
  direction = this->Parallel ? this->Forward : this->Forward + across;
}

MesoReferenceLight::MesoReferenceLight(
  const MesoSceneLight& light, const MesoReferenceCamera& camera)
  : Headlight(light.Type == MesoSceneLight::Kind::Headlight)
  , Positional(
      light.Type == MesoSceneLight::Kind::Point || light.Type == MesoSceneLight::Kind::Spot)
  , CastsBetweenObjects(light.Shadow && light.Type != MesoSceneLight::Kind::Headlight)
  , Position(ToVector(light.Position))
  , Attenuation(ToVector(light.Attenuation))
  , ConeAngle(light.Type == MesoSceneLight::Kind::Spot ? light.ConeAngle : 90.)
  , Exponent(light.Exponent)
  , Radiance(ToVector(light.Color) * light.Intensity)
{
  glm::dvec3 focalPoint = ToVector(light.FocalPoint);
  glm::dvec3 direction = ToVector(light.Direction);
  if (light.InCameraCoordinates && !this->Headlight)
  {
    // x right, y up, z towards the viewer, from the camera's position.
    const auto toWorld = [&](const glm::dvec3& v)
    { return v.x * camera.Right + v.y * camera.Up - v.z * camera.Forward; };
    this->Position = camera.Position + toWorld(this->Position);
    focalPoint = camera.Position + toWorld(focalPoint);
    direction = toWorld(direction);
  }
  this->Travel = this->Headlight
    ? camera.Forward
    : glm::normalize(this->Positional ? focalPoint - this->Position : direction);
}

glm::dvec3 MesoReferenceLight::Towards(const glm::dvec3& point, double& distance) const
{
  if (!this->Positional)
  {
    distance = std::numeric_limits<double>::infinity();
    return -this->Travel;
  }
  const glm::dvec3 to = this->Position - point;
  distance = glm::length(to);
  return distance > 0. ? to / distance : -this->Travel;
}

double MesoReferenceLight::AttenuationAt(const glm::dvec3& point) const
{
  if (!this->Positional)
  {
    return 1.;
  }
  double distance = 0.;
  const glm::dvec3 travel = -this->Towards(point, distance);
  double attenuation = 1. /
    (this->Attenuation.x + this->Attenuation.y * distance +
      this->Attenuation.z * distance * distance);
  if (this->ConeAngle < 90.)
  {
    const double cosine = glm::dot(travel, this->Travel);
    attenuation *=
      cosine >= std::cos(glm::radians(this->ConeAngle)) ? std::pow(cosine, this->Exponent) : 0.;
  }
  return attenuation;
}

MesoReferenceMaterial::MesoReferenceMaterial(vtkActor* actor, MesoWrap wrap)
  : Wrap(wrap)
{
  vtkProperty* property = actor->GetProperty();
  this->Ambient = Color(property->GetAmbientColor(), property->GetAmbient());
  this->Diffuse = Color(property->GetDiffuseColor(), property->GetDiffuse());
  this->Specular = Color(property->GetSpecularColor(), property->GetSpecular());
  this->SpecularPower = property->GetSpecularPower();
  vtkImageData* image = actor->GetTexture() ? actor->GetTexture()->GetInput() : nullptr;
  if (!image)
  {
    return;
  }
  const int* size = image->GetDimensions();
  this->Width = size[0];
  this->Height = size[1];
  vtkDataArray* values = image->GetPointData()->GetScalars();
  const bool grey = values->GetNumberOfComponents() < 3;
  const double unit = StoredToUnit(values->GetDataType());
  this->Texels.reserve(values->GetNumberOfTuples());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    this->Texels.push_back(unit *
      glm::dvec3(values->GetComponent(i, 0), values->GetComponent(i, grey ? 0 : 1),
        values->GetComponent(i, grey ? 0 : 2)));
  }
}

glm::dvec3 MesoReferenceMaterial::TextureAt(const glm::dvec2& mapCoord) const
{
  const MesoHeightPyramid::Axis columns(this->Width, this->Wrap);
  const MesoHeightPyramid::Axis rows(this->Height, this->Wrap);
  glm::dvec2 at = mapCoord * glm::dvec2(this->Width, this->Height) - 0.5;
  constexpr double Farthest = 1e15; // beyond, a double no longer knows where in a texel it is
  at = glm::clamp(at, -Farthest, Farthest);
  const glm::dvec2 low = glm::floor(at);
  const glm::dvec2 weight = at - low;
  const auto texel = [&](double x, double y)
  {
    return this->Texels[std::size_t(rows.Wrapped(static_cast<std::int64_t>(y))) * this->Width +
      columns.Wrapped(static_cast<std::int64_t>(x))];
  };
  return glm::mix(glm::mix(texel(low.x, low.y), texel(low.x + 1., low.y), weight.x),
    glm::mix(texel(low.x, low.y + 1.), texel(low.x + 1., low.y + 1.), weight.x), weight.y);
}

glm::dvec3 MesoReferenceMaterial::Shade(const std::vector<MesoReferenceLight>& lights,
  const std::vector<double>& blocked, const glm::dvec3& point, const glm::dvec3& shading,
  const glm::dvec3& eye, const glm::dvec2& mapCoord, const glm::dvec3& own) const
{
  glm::dvec3 diffuse(0.);
  glm::dvec3 specular(0.);
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    const MesoReferenceLight& light = lights[i];
    const glm::dvec3 radiance = light.Radiance * (1. - blocked[i]);
    double distance = 0.;
    const glm::dvec3 towards = light.Towards(point, distance);
    const double attenuation = light.AttenuationAt(point);
    const double lambert = std::max(0., attenuation * glm::dot(shading, towards));
    diffuse += lambert * radiance;
    if (light.Headlight && lights.size() == 1)
    {
      specular += std::pow(lambert, this->SpecularPower) * radiance; // VTK's own: by n.z alone
    }
    else if (lambert > 0.)
    {
      const glm::dvec3 reflected = glm::reflect(-towards, shading);
      specular += attenuation *
        std::pow(std::max(0., glm::dot(reflected, eye)), this->SpecularPower) * radiance;
    }
  }
  if (lights.empty())
  {
    diffuse = glm::dvec3(1.); // VTK without lights: ambient and diffuse at full
  }
  glm::dvec3 color = own * (this->Ambient + this->Diffuse * diffuse) + this->Specular * specular;
  if (this->Width > 0)
  {
    color *= this->TextureAt(mapCoord);
  }
  return color;
}

glm::dvec3 MesoReferenceMaterial::Albedo(const glm::dvec2& mapCoord, const glm::dvec3& own) const
{
  return own * (this->Width > 0 ? this->Diffuse * this->TextureAt(mapCoord) : this->Diffuse);
}

glm::dvec3 MesoReferenceMaterial::ShadeDiffuse(const std::vector<MesoReferenceLight>& lights,
  const std::vector<double>& blocked, const glm::dvec3& point, const glm::dvec3& shading,
  const glm::dvec2& mapCoord, const glm::dvec3& own) const
{
  glm::dvec3 light(lights.empty() ? 1. : 0.); // VTK without lights: all at full
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    double distance = 0.;
    const glm::dvec3 towards = lights[i].Towards(point, distance);
    light += std::max(0., lights[i].AttenuationAt(point) * glm::dot(shading, towards)) *
      (1. - blocked[i]) * lights[i].Radiance;
  }
  return this->Albedo(mapCoord, own) * light;
}
