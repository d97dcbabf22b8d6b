#include "MesoModelSurface.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double MostTiles = 1e5; // MESO_MAX_TILES of Shaders/Common/ReliefSurface.glsl

glm::dmat4 MatrixOf(vtkActor* actor)
{
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix[column][row] = actor->GetMatrix()->GetElement(row, column);
    }
  }
  return matrix;
}

MesoModelField FieldOf(vtkImageData* heights, MesoWrap wrap)
{
  const int* size = heights->GetDimensions();
  const auto* values = static_cast<const float*>(heights->GetScalarPointer());
  return MesoModelField(
    size[0], size[1], wrap, std::vector<float>(values, values + std::size_t(size[0]) * size[1]));
}

double SumOfParts(const glm::dvec2& v)
{
  return std::abs(v.x) + std::abs(v.y);
}
}

MesoModelSurface::MesoModelSurface(const MesoSceneBuilder::Object& object)
  : Options(object.Options)
  , Effects(MesoEffectsOn(object.Options))
  , Traces(
      MesoUsesHeightMap(object.Options.Technique) && object.HeightMap && !this->Effects.Empty())
  , Bends(object.Options.Technique == MesoTechnique::ReliefQuadric)
  , Culls(object.Actor->GetProperty()->GetBackfaceCulling() != 0)
{
  if (this->Traces)
  {
    this->Field.emplace(FieldOf(object.HeightMap, this->Options.Wrap));
  }
  this->Read(object.Mesh, MatrixOf(object.Actor));
}

void MesoModelSurface::Read(vtkPolyData* mesh, const glm::dmat4& matrix)
{
  this->Linear = glm::dmat3(matrix);
  vtkPointData* data = mesh->GetPointData();
  vtkDataArray* normals = data->GetNormals();
  vtkDataArray* coordinates = data->GetTCoords();
  vtkDataArray* tangents = this->Traces ? data->GetArray("MesoTangent") : nullptr;
  vtkDataArray* bitangents = this->Traces ? data->GetArray("MesoBitangent") : nullptr;
  vtkDataArray* scales = this->Traces ? data->GetArray("MesoTileScale") : nullptr;
  vtkDataArray* quadrics =
    this->Effects.Has(MesoEffect::Curvature) ? data->GetArray("MesoQuadric") : nullptr;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec4 point(0., 0., 0., 1.);
    mesh->GetPoint(i, &point.x);
    this->Points.emplace_back(matrix * point);
    glm::dvec3 normal(0.);
    glm::dvec2 coordinate(0.);
    glm::dvec3 tangent(0.);
    glm::dvec3 bitangent(0.);
    glm::dvec2 scale(0.);
    glm::dvec3 quadric(0.);
    const auto read = [i](vtkDataArray* array, double* values)
    {
      if (array)
      {
        array->GetTuple(i, values);
      }
    };
    read(normals, &normal.x);
    read(coordinates, &coordinate.x);
    read(tangents, &tangent.x);
    read(bitangents, &bitangent.x);
    read(scales, &scale.x);
    read(quadrics, &quadric.x);
    this->Normals.push_back(normal);
    this->Coordinates.push_back(coordinate);
    this->PerTCoordU.push_back(scale.x * tangent);
    this->PerTCoordV.push_back(scale.y * bitangent);
    this->QuadricsOverTexture.push_back(
      this->Quadrics.quadricOverTexture(quadric, tangent, bitangent, normal, scale));
    this->Metrics.emplace_back(
      scale.x * scale.x, scale.x * scale.y * glm::dot(tangent, bitangent), scale.y * scale.y);
  }
  auto cell = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType corners = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(corners, ids);
    for (vtkIdType k = 2; k < corners; ++k) // VTK draws polygons as fans
    {
      this->Triangles.push_back({ static_cast<std::uint32_t>(ids[0]),
        static_cast<std::uint32_t>(ids[k - 1]), static_cast<std::uint32_t>(ids[k]) });
    }
  }
}

std::optional<MesoModelFragment> MesoModelSurface::FragmentAt(std::size_t triangle, bool front,
  const glm::dvec3& origin, const glm::dvec3& direction, double rounding) const
{
  const auto& corners = this->Triangles[triangle];
  const glm::dvec3& p0 = this->Points[corners[0]];
  const glm::dvec3 a = this->Points[corners[1]] - p0;
  const glm::dvec3 b = this->Points[corners[2]] - p0;
  glm::dvec3 found; // weights of the second and third corner, and t
  if (!this->Frame.solveFrame(a, b, -direction, origin - p0, found))
  {
    return {};
  }
  // The length as a weight: part of the triangle's least height, as seen along the ray.
  const double longest = std::max({ glm::length(a), glm::length(b), glm::length(b - a) });
  const double height = std::abs(glm::dot(glm::cross(a, b), direction)) / longest;
  const double beside = std::min(rounding / height, 0.5);
  if (found.x < -beside || found.y < -beside || found.x + found.y > 1. + beside)
  {
    return {};
  }
  const auto between = [&](const auto& values)
  {
    return (1. - found.x - found.y) * values[corners[0]] + found.x * values[corners[1]] +
      found.y * values[corners[2]];
  };
  MesoModelFragment fragment;
  fragment.T = found.z;
  fragment.View = direction;
  const glm::dvec3 normal = between(this->Normals);
  fragment.Normal = glm::normalize(glm::inverse(glm::transpose(this->Linear)) * normal);
  fragment.Normal = front ? fragment.Normal : -fragment.Normal;
  const glm::dvec2 tiles(this->Options.Tiles[0], this->Options.Tiles[1]);
  fragment.MapCoord = between(this->Coordinates) * tiles;
  fragment.PerMapU = this->Linear * between(this->PerTCoordU) / tiles.x;
  fragment.PerMapV = this->Linear * between(this->PerTCoordV) / tiles.y;
  const double depth = this->Options.Scale;
  fragment.PerDepth = this->Linear * (-depth * glm::normalize(normal));
  fragment.Quadric = glm::dvec3(0.);
  fragment.Metric = glm::dvec3(0.);
  if (this->Bends && depth > 0.)
  {
    const glm::dvec2 per = 1. / tiles;
    fragment.Quadric = between(this->QuadricsOverTexture) *
      glm::dvec3(per.x * per.x, per.y * per.y, per.x * per.y) / depth;
    fragment.Metric = between(this->Metrics) *
      glm::dvec3(per.x * per.x, per.x * per.y, per.y * per.y) / (depth * depth);
  }
  return fragment;
}

bool MesoModelSurface::SeenFromBehind(const MesoModelFragment& fragment) const
{
  return glm::dot(fragment.PerDepth, fragment.Normal) > 0.;
}

bool MesoModelSurface::ToTexture(
  const MesoModelFragment& fragment, const glm::dvec3& vector, glm::dvec3& rates) const
{
  return this->Frame.solveFrame(
    fragment.PerMapU, fragment.PerMapV, fragment.PerDepth, vector, rates);
}

glm::dvec3 MesoModelSurface::ReliefNormal(
  const MesoModelFragment& fragment, const MesoModelHit& hit, const glm::dvec2& gradient) const
{
  const glm::dvec3 cross = this->Bends
    ? this->Quadrics.displacedCross(
        fragment.Quadric, fragment.Metric, hit.MapCoord - fragment.MapCoord, hit.Relief, gradient)
    : glm::dvec3(gradient, 1.);
  return this->Frame.tiltedNormal(
    fragment.PerMapU, fragment.PerMapV, fragment.PerDepth, fragment.Normal, cross);
}

bool MesoModelSurface::FollowRay(
  const MesoModelFragment& fragment, MesoModelHit& hit, bool& misses) const
{
  glm::dvec3 rate;
  if (!this->ToTexture(fragment, fragment.View, rate))
  {
    return false;
  }
  const glm::dvec2 overMap(rate.x, rate.y);
  MesoModelPath path;
  double end = 0.;
  if (this->Bends)
  {
    const double bend = this->Quadrics.quadricDepth(fragment.Quadric, overMap);
    double depthEnd = 0.;
    end = this->Quadrics.leaveShell(0., rate.z, bend, depthEnd);
    path = this->Field->bentPath(fragment.MapCoord, overMap, 0., depthEnd, bend, end);
    if (!(SumOfParts(path.MapSpan) < MostTiles))
    {
      return false;
    }
  }
  else
  {
    if (!(rate.z * MostTiles > SumOfParts(overMap)))
    {
      return false;
    }
    end = 1. / rate.z;
    path = this->Field->straightPath(fragment.MapCoord, overMap / rate.z, 0., 1.);
  }
  const double part = MesoFirstMeeting(*this->Field, path);
  if (part > 1.)
  {
    misses = path.DepthEnd < 1. && this->Effects.Has(MesoEffect::Silhouette);
    return false;
  }
  hit.T = fragment.T + part * end;
  hit.MapCoord = path.MapStart + part * path.MapSpan;
  hit.Relief = glm::clamp(this->Field->pathDepth(path, part), 0., 1.);
  return true;
}

std::optional<MesoModelHit> MesoModelSurface::Solve(const MesoModelFragment& fragment) const
{
  MesoModelHit hit = { fragment.T, fragment.MapCoord, 0., fragment.Normal, fragment.Normal };
  if (!this->Traces || this->SeenFromBehind(fragment))
  {
    return hit;
  }
  if (this->Effects.Has(MesoEffect::Occlusion))
  {
    bool misses = false;
    if (!this->FollowRay(fragment, hit, misses))
    {
      return misses ? std::nullopt : std::optional<MesoModelHit>(hit);
    }
  }
  else
  {
    hit.Relief = 1. - this->Field->bilinearHeight(fragment.MapCoord);
  }
  hit.FacetNormal = this->ReliefNormal(fragment, hit, this->Field->patchGradient(hit.MapCoord));
  if (this->Effects.Has(MesoEffect::Shading))
  {
    hit.Normal = this->ReliefNormal(fragment, hit, this->Field->heightGradient(hit.MapCoord));
  }
  return hit;
}

bool MesoModelSurface::Blocks(const MesoModelFragment& fragment, const MesoModelHit& hit,
  const glm::dvec3& towardsLight, double distance) const
{
  if (!(glm::dot(hit.FacetNormal, towardsLight) > 0.))
  {
    return true;
  }
  if (!this->Traces || this->SeenFromBehind(fragment) || !this->Effects.Has(MesoEffect::SelfShadow))
  {
    return false;
  }
  const glm::dvec2 texel =
    glm::dvec2(glm::length(fragment.PerMapU), glm::length(fragment.PerMapV)) /
    glm::dvec2(this->Field->mapSize());
  glm::dvec3 rate;
  glm::dvec3 lift;
  if (!this->ToTexture(fragment, towardsLight, rate) ||
    !this->ToTexture(fragment, 1e-3 * std::min(texel.x, texel.y) * hit.FacetNormal, lift))
  {
    return false;
  }
  const glm::dvec2 overMap(rate.x, rate.y);
  const glm::dvec2 start = hit.MapCoord + glm::dvec2(lift.x, lift.y);
  if (!this->Bends)
  {
    const double depthStart = hit.Relief + lift.z;
    if (!(depthStart > 0.) || !(-rate.z * MostTiles > SumOfParts(overMap)))
    {
      return depthStart > 0.;
    }
    const double depthEnd = std::min(depthStart, std::max(0., hit.Relief + rate.z * distance));
    return MesoIsBlocked(
      *this->Field, this->Field->straightPath(start, overMap / rate.z, depthStart, depthEnd));
  }
  const glm::dvec2 gradient =
    this->Quadrics.quadricGradient(fragment.Quadric, hit.MapCoord - fragment.MapCoord);
  const double depthStart = hit.Relief + lift.z - glm::dot(gradient, glm::dvec2(lift.x, lift.y));
  if (!(depthStart > 0.))
  {
    return false;
  }
  const double slope = rate.z - glm::dot(gradient, overMap);
  const double bend = this->Quadrics.quadricDepth(fragment.Quadric, overMap);
  double depthEnd = 0.;
  double end = this->Quadrics.leaveShell(depthStart, slope, bend, depthEnd);
  if (distance < end)
  {
    end = distance;
    depthEnd = depthStart + end * (slope - end * bend);
  }
  else if (depthEnd > 0.)
  {
    return true;
  }
  const MesoModelPath path = this->Field->bentPath(start, overMap, depthStart, depthEnd, bend, end);
  return !(SumOfParts(path.MapSpan) < MostTiles) || MesoIsBlocked(*this->Field, path);
}
