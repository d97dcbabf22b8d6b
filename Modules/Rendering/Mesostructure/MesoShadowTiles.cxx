#include "MesoShadowTiles.h"

#include "vtkLight.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Vector = std::array<double, 3>;

constexpr double BorderTexels = 2.;
/// Beyond this a cone's map would be mostly rim: tan of 85 degrees.
constexpr double WidestCone = 85.;
/// Nearest to farthest, so that the depth buffer still tells surfaces apart.
constexpr double NearToFar = 1e-3;

/// What corners of bounds span in a tile's frame: across (x, y; those of the perspective at distance
/// 1) and along the view.
struct Span
{
  std::array<double, 3> Low;
  std::array<double, 3> High;
  bool Behind = false; ///< a corner lies at or behind the eye

  Span()
  {
    this->Low.fill(std::numeric_limits<double>::infinity());
    this->High.fill(-std::numeric_limits<double>::infinity());
  }
  void Add(const Span& other)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Low[i] = std::min(this->Low[i], other.Low[i]);
      this->High[i] = std::max(this->High[i], other.High[i]);
    }
    this->Behind = this->Behind || other.Behind;
  }
  bool Empty() const { return !(this->Low[0] < this->High[0] && this->Low[1] < this->High[1]); }
};

Vector Cross(const Vector& a, const Vector& b)
{
  Vector result;
  vtkMath::Cross(a.data(), b.data(), result.data());
  return result;
}

Span SpanOf(const MesoShadowTile& tile, const MesoShadowCaster& caster)
{
  const Vector right = Cross(tile.Direction, tile.Up);
  Span span;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector from;
    for (int i = 0; i < 3; ++i)
    {
      from[i] = caster.Bounds[2 * i + ((corner >> i) & 1)] - tile.Position[i];
    }
    const double along = vtkMath::Dot(from.data(), tile.Direction.data());
    const double by = tile.Perspective && along > 0. ? along : 1.;
    Span point;
    point.Low = point.High = { vtkMath::Dot(from.data(), right.data()) / by,
      vtkMath::Dot(from.data(), tile.Up.data()) / by, along };
    point.Behind = !(along > 0.);
    span.Add(point);
  }
  return span;
}

/// Where shadows can begin, and the depths of all that casts.
Span SpanOf(const MesoShadowTile& tile, const std::vector<MesoShadowCaster>& casters)
{
  std::vector<Span> spans;
  Span all;
  for (const MesoShadowCaster& caster : casters)
  {
    spans.push_back(SpanOf(tile, caster));
    all.Add(spans.back());
  }
  Span result;
  for (std::size_t i = 0; i < spans.size(); ++i)
  {
    Span span = spans[i];
    if (casters[i].Flat && !(tile.Perspective && all.Behind))
    {
      Span others;
      for (std::size_t k = 0; k < spans.size(); ++k)
      {
        if (k != i)
        {
          others.Add(spans[k]);
        }
      }
      for (int axis = 0; axis < 2; ++axis)
      {
        span.Low[axis] = std::max(span.Low[axis], others.Low[axis]);
        span.High[axis] = std::min(span.High[axis], others.High[axis]);
      }
    }
    if (!span.Empty())
    {
      result.Add(span);
    }
  }
  result.Low[2] = all.Low[2];
  result.High[2] = all.High[2];
  result.Behind = all.Behind;
  return result;
}

/// Widen what is seen by a border.
void AddBorder(MesoShadowTile& tile, int resolution)
{
  const double part = BorderTexels / std::max(1., resolution - 2. * BorderTexels);
  const double across = std::max(part * (tile.Right - tile.Left), 1e-12);
  const double upwards = std::max(part * (tile.Top - tile.Bottom), 1e-12);
  tile.Left -= across;
  tile.Right += across;
  tile.Bottom -= upwards;
  tile.Top += upwards;
}

/// Whether anything is left to see.
bool LookAlong(MesoShadowTile& tile, const std::vector<MesoShadowCaster>& casters)
{
  const Span span = SpanOf(tile, casters);
  if (span.Empty())
  {
    return false;
  }
  const double depth = std::max(span.High[2] - span.Low[2], 1e-12);
  // The eye goes before everything that casts.
  const double back = span.Low[2] - 0.1 * depth;
  for (int i = 0; i < 3; ++i)
  {
    tile.Position[i] += back * tile.Direction[i];
  }
  tile.Left = span.Low[0];
  tile.Right = span.High[0];
  tile.Bottom = span.Low[1];
  tile.Top = span.High[1];
  tile.Near = 0.05 * depth;
  tile.Far = 1.15 * depth;
  return true;
}

/// Whether anything is left to see.
bool LookFrom(MesoShadowTile& tile, const std::vector<MesoShadowCaster>& casters, double halfWidth)
{
  const Span span = SpanOf(tile, casters);
  if (!(span.High[2] > 0.))
  {
    return false;
  }
  tile.Far = 1.01 * span.High[2];
  tile.Near = std::max(0.99 * span.Low[2], NearToFar * tile.Far);
  tile.Left = tile.Bottom = -halfWidth;
  tile.Right = tile.Top = halfWidth;
  if (!span.Behind)
  {
    tile.Left = std::max(tile.Left, span.Low[0]);
    tile.Right = std::min(tile.Right, span.High[0]);
    tile.Bottom = std::max(tile.Bottom, span.Low[1]);
    tile.Top = std::min(tile.Top, span.High[1]);
  }
  return tile.Left < tile.Right && tile.Bottom < tile.Top;
}
}

std::vector<MesoShadowTile> MesoShadowTilesOf(
  vtkLight* light, const std::vector<MesoShadowCaster>& casters, int resolution)
{
  if (light->LightTypeIsHeadlight() || !light->GetSwitch() ||
    !(light->GetShadowAttenuation() > 0.f) || casters.empty())
  {
    return {};
  }
  MesoShadowTile tile;
  light->GetTransformedPosition(tile.Position.data());
  Vector focalPoint;
  light->GetTransformedFocalPoint(focalPoint.data());
  for (int i = 0; i < 3; ++i)
  {
    tile.Direction[i] = focalPoint[i] - tile.Position[i];
  }
  if (vtkMath::Normalize(tile.Direction.data()) == 0.)
  {
    tile.Direction = { 0., 0., -1. }; // of a point light, whose axis plays no part
  }
  Vector across;
  vtkMath::Perpendiculars(tile.Direction.data(), across.data(), tile.Up.data(), 0.);
  if (!light->GetPositional())
  {
    if (!LookAlong(tile, casters))
    {
      return {};
    }
    AddBorder(tile, resolution);
    return { tile };
  }
  tile.Perspective = true;
  if (light->GetConeAngle() < 90.)
  {
    const double cone = std::min(light->GetConeAngle(), WidestCone);
    if (!LookFrom(tile, casters, std::tan(vtkMath::RadiansFromDegrees(cone))))
    {
      return {};
    }
    AddBorder(tile, resolution);
    return { tile };
  }
  const Vector ahead = tile.Direction;
  const Vector up = tile.Up;
  const Vector right = Cross(ahead, up);
  const auto opposite = [](const Vector& v) { return Vector{ -v[0], -v[1], -v[2] }; };
  const Vector directions[6] = { ahead, opposite(ahead), up, opposite(up), right, opposite(right) };
  std::vector<MesoShadowTile> tiles;
  double reach = 0.;
  for (const Vector& direction : directions)
  {
    tile.Direction = direction;
    reach = std::max(reach, SpanOf(tile, casters).High[2]);
  }
  for (int i = 0; i < 6; ++i)
  {
    tile.Direction = directions[i];
    tile.Up = i == 2 || i == 3 ? right : up;
    // All sides, seen in full: a point is looked up in the side that faces it.
    tile.Left = tile.Bottom = -1.;
    tile.Right = tile.Top = 1.;
    tile.Far = std::max(1.01 * reach, 1e-12);
    tile.Near = NearToFar * tile.Far;
    tiles.push_back(tile);
    AddBorder(tiles.back(), resolution);
  }
  return tiles;
}
