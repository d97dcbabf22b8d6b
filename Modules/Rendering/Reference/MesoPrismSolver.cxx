#include "MesoPrismSolver.h"

#include "vtkFloatArray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Margin = 1.25; ///< by which the speed in texture space may grow over a step

double Triple(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
  return glm::dot(glm::cross(a, b), c);
}

/// Roots of a + b z + c z^2, without cancellation.
int QuadraticRoots(double a, double b, double c, double roots[2])
{
  const double discriminant = b * b - 4. * a * c;
  if (discriminant < 0.)
  {
    return 0;
  }
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  int count = 0;
  if (c != 0.)
  {
    roots[count++] = q / c;
  }
  if (q != 0.)
  {
    roots[count++] = a / q;
  }
  return count;
}

/// Roots in [0, 1] of a cubic given by its coefficients, each between two places where it turns.
int CubicRoots(const std::array<double, 4>& k, double roots[3])
{
  const auto at = [&](double z) { return k[0] + z * (k[1] + z * (k[2] + z * k[3])); };
  double turns[2];
  const int turning = QuadraticRoots(k[1], 2. * k[2], 3. * k[3], turns);
  std::array<double, 4> ends = { 0., 1., 1., 1. };
  int count = 1;
  if (turning == 2 && turns[0] > turns[1])
  {
    std::swap(turns[0], turns[1]);
  }
  for (int i = 0; i < turning; ++i)
  {
    if (turns[i] > 0. && turns[i] < 1.)
    {
      ends[count++] = turns[i];
    }
  }
  ends[count] = 1.;
  int found = 0;
  for (int i = 0; i < count; ++i)
  {
    double low = ends[i];
    double high = ends[i + 1];
    const bool rises = at(low) < at(high);
    if ((at(low) > 0.) == (at(high) > 0.) && at(low) != 0. && at(high) != 0.)
    {
      continue;
    }
    for (int halving = 0; halving < 60; ++halving)
    {
      const double middle = 0.5 * (low + high);
      ((at(middle) < 0.) == rises ? low : high) = middle;
    }
    roots[found++] = 0.5 * (low + high);
  }
  return found;
}

/// Where a ray crosses one of the surfaces that bound a prism, wherever on it.
struct Crossing
{
  double T;
  int Face;
};

void CrossCap(const MesoTruePrism& prism, const glm::dvec3& origin, const glm::dvec3& direction,
  int face, std::vector<Crossing>& crossings)
{
  std::array<glm::dvec3, 3> corner = prism.Bottom;
  for (int k = 0; k < 3 && face == 1; ++k)
  {
    corner[k] += prism.Rise[k];
  }
  const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double rate = glm::dot(normal, direction);
  if (rate != 0.)
  {
    crossings.push_back({ glm::dot(normal, corner[0] - origin) / rate, face });
  }
}

void CrossFin(const MesoTruePrism& prism, const glm::dvec3& origin, const glm::dvec3& direction,
  int fin, std::vector<Crossing>& crossings)
{
  const int next = (fin + 1) % 3;
  const glm::dvec3 edge = prism.Bottom[next] - prism.Bottom[fin];
  const glm::dvec3 turn = prism.Rise[next] - prism.Rise[fin];
  const glm::dvec3 from = origin - prism.Bottom[fin];
  const glm::dvec3 edgeAcross = glm::cross(edge, direction);
  const glm::dvec3 turnAcross = glm::cross(turn, direction);
  double heights[2];
  const int count = QuadraticRoots(glm::dot(edgeAcross, from),
    glm::dot(turnAcross, from) - glm::dot(edgeAcross, prism.Rise[fin]),
    -glm::dot(turnAcross, prism.Rise[fin]), heights);
  for (int i = 0; i < count; ++i)
  {
    // At this height the ray meets the line between both sides of the fin.
    const glm::dvec3 line = edge + heights[i] * turn;
    const glm::dvec3 across = glm::cross(direction, line);
    const double square = glm::dot(across, across);
    if (square > 0.)
    {
      const glm::dvec3 start = heights[i] * prism.Rise[fin] - from;
      crossings.push_back({ glm::dot(glm::cross(start, line), across) / square, 2 + fin });
    }
  }
}

/// A ray's way through a prism and the volume in it.
class Way
{
public:
  Way(const MesoTruePrism& prism, const MesoVolumeTruth& volume, const glm::dvec3& origin,
    const glm::dvec3& direction, MesoSolverWork& work)
    : Prism(prism)
    , Volume(volume)
    , Origin(origin)
    , Direction(direction)
    , Metric(1., 1., volume.Field().GetDepth())
    , Work(work)
  {
  }

  /// Follows a stretch that lies inside.
  bool Follow(double from, double to, const glm::dvec3& middle, MesoPrismHit& hit)
  {
    glm::dvec3 place = this->PlaceAt(from, middle);
    double t = from;
    double distance = this->DistanceAt(place);
    if (distance <= 0.)
    {
      hit.T = from;
      hit.Place = place;
      return true;
    }
    double speed = this->SpeedAt(place);
    const double least = 1e-3 * this->Volume.VoxelSide();
    while (t < to)
    {
      ++this->Work.Pieces;
      double step = std::max(distance / this->Volume.MostChange() / Margin, least) / speed;
      double next = std::min(t + step, to);
      glm::dvec3 there = this->PlaceAt(next, place);
      double speedThere = this->SpeedAt(there);
      for (int halving = 0; speedThere > Margin * speed && halving < 20; ++halving)
      {
        next = 0.5 * (t + next);
        there = this->PlaceAt(next, place);
        speedThere = this->SpeedAt(there);
      }
      const double distanceThere = this->DistanceAt(there);
      if (distanceThere <= 0.)
      {
        this->Refine(t, next, place, hit);
        return true;
      }
      if (!(next > t))
      {
        return false; // so short a step is none in double
      }
      t = next;
      place = there;
      distance = distanceThere;
      speed = speedThere;
    }
    return false;
  }

private:
  glm::dvec3 PlaceAt(double t, glm::dvec3 place) const
  {
    const glm::dvec3 point = this->Origin + t * this->Direction;
    for (int i = 0; i < 20; ++i)
    {
      const glm::dmat3 jacobian = this->Prism.Jacobian(place);
      if (glm::determinant(jacobian) == 0.)
      {
        break;
      }
      const glm::dvec3 move = glm::inverse(jacobian) * (point - this->Prism.PointAt(place));
      place = glm::clamp(place + move, glm::dvec3(-1.), glm::dvec3(2.));
      if (glm::dot(move, move) < 1e-26)
      {
        break;
      }
    }
    return place;
  }

  double DistanceAt(const glm::dvec3& place) const
  {
    return this->Volume.At(this->Prism.ChartAt(place));
  }

  /// Tile widths along the way in texture space, per t.
  double SpeedAt(const glm::dvec3& place) const
  {
    const glm::dmat3 jacobian = this->Prism.Jacobian(place);
    if (glm::determinant(jacobian) == 0.)
    {
      return std::numeric_limits<double>::min();
    }
    return std::max(glm::length(this->Metric *
                      (this->Prism.ChartJacobian() * (glm::inverse(jacobian) * this->Direction))),
      std::numeric_limits<double>::min());
  }

  void Refine(double outside, double inside, glm::dvec3 place, MesoPrismHit& hit) const
  {
    for (int halving = 0; halving < 60 && 0.5 * (outside + inside) != outside; ++halving)
    {
      const double middle = 0.5 * (outside + inside);
      place = this->PlaceAt(middle, place);
      (this->DistanceAt(place) > 0. ? outside : inside) = middle;
    }
    hit.T = 0.5 * (outside + inside);
    hit.Place = this->PlaceAt(hit.T, place);
    hit.Cut = -1;
  }

  const MesoTruePrism& Prism;
  const MesoVolumeTruth& Volume;
  const glm::dvec3& Origin;
  const glm::dvec3& Direction;
  glm::dvec3 Metric;
  MesoSolverWork& Work;
};
}

MesoVolumeTruth::MesoVolumeTruth(vtkImageData* volume)
  : Samples(volume)
{
  // Within a cell the change along an axis lies between those of its four edges.
  const std::array<int, 3>& size = this->Samples.GetSize();
  glm::dvec3 most(0.);
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const double here = this->Samples.Sample(i, j, k);
        most = glm::max(most,
          glm::abs(glm::dvec3(this->Samples.Sample(i + 1, j, k) - here,
            this->Samples.Sample(i, j + 1, k) - here, this->Samples.Sample(i, j, k + 1) - here)));
      }
    }
  }
  const glm::dvec3 perWidth(size[0], size[1], size[2] / this->Samples.GetDepth());
  this->Most = std::max(glm::length(most * perWidth), 1e-9);
  if (vtkFloatArray* colors = MesoVolumeColors(volume))
  {
    for (vtkIdType i = 0; i < colors->GetNumberOfTuples(); ++i)
    {
      const double* color = colors->GetTuple3(i);
      this->Colors.emplace_back(color[0], color[1], color[2]);
    }
  }
}

glm::dvec3 MesoVolumeTruth::ColorAt(const glm::dvec3& place) const
{
  if (this->Colors.empty())
  {
    return glm::dvec3(1.);
  }
  const std::array<int, 3>& size = this->Samples.GetSize();
  const glm::dvec3 at = place * glm::dvec3(size[0], size[1], size[2]) - 0.5;
  const glm::dvec3 low = glm::floor(at);
  const glm::dvec3 weight = at - low;
  glm::dvec3 sum(0.);
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<int, 3> sample{};
    double share = 1.;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool next = ((corner >> axis) & 1) != 0;
      const double number = low[axis] + (next ? 1. : 0.);
      share *= next ? weight[axis] : 1. - weight[axis];
      // Tiles repeat; above and below goes on what is there.
      sample[axis] = axis < 2
        ? static_cast<int>(number - std::floor(number / size[axis]) * size[axis])
        : static_cast<int>(glm::clamp(number, 0., size[axis] - 1.));
    }
    sum += share *
      this
        ->Colors[sample[0] + std::size_t(size[0]) * (sample[1] + std::size_t(size[1]) * sample[2])];
  }
  return sum;
}

glm::dvec3 MesoVolumeTruth::Gradient(const glm::dvec3& place) const
{
  const MesoVolumeField::Vector gradient = this->Samples.Gradient({ place.x, place.y, place.z });
  // The field's is per tile width.
  return { gradient[0], gradient[1], gradient[2] * this->Samples.GetDepth() };
}

glm::dvec3 MesoVolumeTruth::SmoothGradient(const glm::dvec3& place) const
{
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int size = this->Samples.GetSize()[axis];
    glm::dvec3 voxel(0.);
    voxel[axis] = 1. / size;
    gradient[axis] = 0.5 * size * (this->At(place + voxel) - this->At(place - voxel));
  }
  return gradient;
}

double MesoVolumeTruth::VoxelSide() const
{
  const std::array<int, 3>& size = this->Samples.GetSize();
  return std::min({ 1. / size[0], 1. / size[1], this->Samples.GetDepth() / size[2] });
}

glm::dmat3 MesoTruePrism::Jacobian(const glm::dvec3& place) const
{
  const glm::dvec3 turn1 = this->Rise[1] - this->Rise[0];
  const glm::dvec3 turn2 = this->Rise[2] - this->Rise[0];
  return { this->Bottom[1] - this->Bottom[0] + place.z * turn1,
    this->Bottom[2] - this->Bottom[0] + place.z * turn2,
    this->Rise[0] + place.x * turn1 + place.y * turn2 };
}

glm::dvec3 MesoTruePrism::PointAt(const glm::dvec3& place) const
{
  const double weights[3] = { 1. - place.x - place.y, place.x, place.y };
  glm::dvec3 point(0.);
  for (int k = 0; k < 3; ++k)
  {
    point += weights[k] * (this->Bottom[k] + place.z * this->Rise[k]);
  }
  return point;
}

glm::dvec3 MesoTruePrism::ChartAt(const glm::dvec3& place) const
{
  const glm::dvec2 map = this->Map[0] + place.x * (this->Map[1] - this->Map[0]) +
    place.y * (this->Map[2] - this->Map[0]);
  return { map.x, map.y, place.z };
}

glm::dmat3 MesoTruePrism::ChartJacobian() const
{
  return { glm::dvec3(this->Map[1] - this->Map[0], 0.), glm::dvec3(this->Map[2] - this->Map[0], 0.),
    glm::dvec3(0., 0., 1.) };
}

bool MesoTruePrism::Find(const glm::dvec3& point, glm::dvec3& place) const
{
  // At height z the point lies in the plane of the prism's section there.
  const glm::dvec3 e1 = this->Bottom[1] - this->Bottom[0];
  const glm::dvec3 e2 = this->Bottom[2] - this->Bottom[0];
  const glm::dvec3 g1 = this->Rise[1] - this->Rise[0];
  const glm::dvec3 g2 = this->Rise[2] - this->Rise[0];
  const glm::dvec3 from = point - this->Bottom[0];
  const glm::dvec3& rise = this->Rise[0];
  double heights[3];
  const int count = CubicRoots(
    { Triple(e1, e2, from), Triple(g1, e2, from) + Triple(e1, g2, from) - Triple(e1, e2, rise),
      Triple(g1, g2, from) - Triple(g1, e2, rise) - Triple(e1, g2, rise), -Triple(g1, g2, rise) },
    heights);
  for (int i = 0; i < count; ++i)
  {
    const double z = heights[i];
    const glm::dvec3 side1 = e1 + z * g1;
    const glm::dvec3 side2 = e2 + z * g2;
    const glm::dvec3 normal = glm::cross(side1, side2);
    const double square = glm::dot(normal, normal);
    if (square > 0.)
    {
      const glm::dvec3 away = from - z * rise;
      place = { Triple(away, side2, normal) / square, Triple(side1, away, normal) / square, z };
      if (place.x >= 0. && place.y >= 0. && place.x + place.y <= 1.)
      {
        return true;
      }
    }
  }
  return false;
}

bool MesoFirstInPrism(const MesoTruePrism& prism, const MesoVolumeTruth& volume,
  const glm::dvec3& origin, const glm::dvec3& direction, double tMin, double tMax,
  MesoPrismHit& hit, MesoSolverWork& work)
{
  ++work.Blocks;
  std::vector<Crossing> crossings;
  CrossCap(prism, origin, direction, 0, crossings);
  CrossCap(prism, origin, direction, 1, crossings);
  for (int fin = 0; fin < 3; ++fin)
  {
    CrossFin(prism, origin, direction, fin, crossings);
  }
  std::sort(crossings.begin(), crossings.end(),
    [](const Crossing& a, const Crossing& b) { return a.T < b.T; });
  Way way(prism, volume, origin, direction, work);
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i)
  {
    const double from = std::max(crossings[i].T, tMin);
    const double to = std::min(crossings[i + 1].T, tMax);
    glm::dvec3 place;
    if (!(from < to) || !prism.Find(origin + 0.5 * (from + to) * direction, place))
    {
      continue;
    }
    hit.Cut = crossings[i].T < tMin ? -2 : crossings[i].Face;
    if (way.Follow(from, to, place, hit))
    {
      return true;
    }
  }
  return false;
}
