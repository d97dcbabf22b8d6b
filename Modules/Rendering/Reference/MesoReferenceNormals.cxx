#include "MesoReferenceNormals.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{
/// The texel of [0, size) that stands for any other.
std::size_t TexelFor(double i, int size, MesoWrap wrap)
{
  const double n = size;
  double texel = i;
  if (wrap == MesoWrap::Clamp)
  {
    texel = std::min(std::max(i, 0.), n - 1.);
  }
  else if (wrap == MesoWrap::Repeat)
  {
    texel = i - n * std::floor(i / n);
  }
  else
  {
    texel = i - 2. * n * std::floor(i / (2. * n));
    texel = texel < n ? texel : 2. * n - 1. - texel;
  }
  return static_cast<std::size_t>(texel);
}
}

MesoReferenceNormals::MesoReferenceNormals(
  vtkImageData* map, const MesoNormalMapMeaning& meaning, MesoWrap wrap)
  : Width(map->GetDimensions()[0])
  , Height(map->GetDimensions()[1])
  , Wrap(wrap)
  , OfObject(meaning.Space == MesoNormalSpace::Object)
{
  vtkDataArray* stored = map->GetPointData()->GetScalars();
  const int type = stored->GetDataType();
  const double white = type == VTK_UNSIGNED_CHAR ? 255. : 65535.;
  for (vtkIdType i = 0; i < stored->GetNumberOfTuples(); ++i)
  {
    glm::dvec3 direction;
    stored->GetTuple(i, &direction.x);
    if (type != VTK_FLOAT)
    {
      direction = 2. * direction / white - 1.;
    }
    direction.y = meaning.Down ? -direction.y : direction.y;
    this->Texels.push_back(direction);
  }
}

glm::dvec3 MesoReferenceNormals::Stored(const glm::dvec2& place) const
{
  const double x = place.x * this->Width - 0.5;
  const double y = place.y * this->Height - 0.5;
  const double i = std::floor(x);
  const double j = std::floor(y);
  const auto at = [&](double column, double row)
  {
    return this->Texels[TexelFor(row, this->Height, this->Wrap) * this->Width +
      TexelFor(column, this->Width, this->Wrap)];
  };
  return (1. - (y - j)) * ((1. - (x - i)) * at(i, j) + (x - i) * at(i + 1., j)) +
    (y - j) * ((1. - (x - i)) * at(i, j + 1.) + (x - i) * at(i + 1., j + 1.));
}

std::optional<glm::dvec3> MesoReferenceNormals::NormalAt(const glm::dvec2& mapCoord,
  const glm::dvec2& tiles, const glm::dvec3& perU, const glm::dvec3& perV,
  const glm::dvec3& normal) const
{
  if (!std::isfinite(mapCoord.x + mapCoord.y))
  {
    return {};
  }
  const glm::dvec3 stored = this->Stored(this->OfObject ? mapCoord / tiles : mapCoord);
  glm::dvec3 direction = stored;
  if (!this->OfObject)
  {
    // The direction whose parts along dp/du, dp/dv and n are the stored ones.
    const glm::dvec3 t = glm::normalize(perU);
    const glm::dvec3 b = glm::normalize(perV);
    const double volume = glm::dot(t, glm::cross(b, normal));
    direction = (stored.x * glm::cross(b, normal) + stored.y * glm::cross(normal, t)) / volume +
      stored.z * normal;
  }
  const double length = glm::length(direction);
  if (!(length > 0.) || !std::isfinite(length))
  {
    return {};
  }
  return direction / length;
}
