#include "MesoGDMSweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Pi = 3.141592653589793238462643;
constexpr float Miss = std::numeric_limits<float>::infinity();
/// Of neighbouring lines' distances, in the distance of their planes, up to which their mean is taken.
constexpr float MostSpread = 2.f;

int Wrapped(int i, int period)
{
  const int rest = i % period;
  return rest < 0 ? rest + period : rest;
}

double Exact(double part)
{
  return std::abs(part) < 1e-12 ? 0. : part; // directions along an axis are meant exactly
}
}

MesoVolumeField::Vector MesoGDMDirections::At(int azimuth, int polar) const
{
  const double part = double(polar) / (this->Polars - 1);
  const double cosine = Exact(this->Even ? 1. - 2. * part : std::cos(Pi * part));
  const double sine = Exact(std::sqrt(std::max(0., 1. - cosine * cosine)));
  const double phi = 2. * Pi * azimuth / this->Azimuths;
  return { Exact(sine * std::cos(phi)), Exact(sine * std::sin(phi)), cosine };
}

/**
 * The lattice of lines. `a` counts planes in the way of travel, from that of the first points on;
 * line (b, c) is in plane a at (b + SlopeB a, c + SlopeC a), in points of the other two axes.
 */
class MesoGDMSweep::Lines
{
public:
  Lines(const MesoGDMSweep& sweep, const Vector& direction)
    : Sweep(sweep)
    , Direction(direction)
    , Size(sweep.Field.GetSize())
  {
    const double depth = sweep.Field.GetDepth();
    const double speed[3] = { direction[0] * this->Size[0], direction[1] * this->Size[1],
      direction[2] * (this->Size[2] - 1) / depth };
    this->A = std::abs(speed[1]) > std::abs(speed[0]) ? 1 : 0;
    this->A = std::abs(speed[2]) > std::abs(speed[this->A]) ? 2 : this->A;
    this->B = this->A == 0 ? 1 : 0;
    this->C = this->A == 2 ? 1 : 2;
    this->Backwards = speed[this->A] < 0.;
    this->Step = 1. / std::abs(speed[this->A]);
    this->SlopeB = speed[this->B] * this->Step;
    this->SlopeC = speed[this->C] * this->Step;
    this->Planes = this->Size[this->A];
    this->LastPlane = this->Planes - 1;
    this->FirstC = 0;
    this->LastC = this->Size[this->C] - 1;
    if (this->A != 2)
    {
      double ahead = sweep.Reach / this->Step;
      if (this->SlopeC != 0.)
      {
        ahead = std::min(ahead, (this->Size[2] - 1) / std::abs(this->SlopeC));
      }
      this->LastPlane += static_cast<int>(std::ceil(ahead)) + 1;
      const double shift = this->SlopeC * this->LastPlane;
      this->FirstC = static_cast<int>(std::floor(-std::max(0., shift))) - 1;
      this->LastC += static_cast<int>(std::ceil(-std::min(0., shift))) + 1;
    }
  }

  /// Distances of the points; how many rays were followed one by one.
  std::size_t Run(float* distances, std::size_t stride)
  {
    const int across = this->Size[this->B];
    const std::size_t count = std::size_t(this->LastC - this->FirstC + 1) * std::size_t(across);
    this->Distances.assign(count, Miss);
    this->Values.assign(count, 1.f);
    std::size_t followed = 0;
    for (int a = this->LastPlane; a >= 0; --a)
    {
      int first = 0;
      int last = 0;
      this->LinesWithin(a, first, last);
      this->LookAtPlane(a, first, last);
      for (int c = first; c <= last; ++c)
      {
        for (int b = 0; b < across; ++b)
        {
          this->Advance(a, b, c, this->ValueOn(b, c - first));
        }
      }
      if (a < this->Planes)
      {
        followed += this->Gather(a, distances, stride);
      }
    }
    return followed;
  }

private:
  /// Lines in the shell in plane a, and one beside it on each side, where points on its planes look too.
  void LinesWithin(int a, int& first, int& last) const
  {
    first = this->FirstC;
    last = this->LastC;
    if (this->A != 2)
    {
      first = std::max(first, static_cast<int>(std::floor(-this->SlopeC * a)));
      last = std::min(last, static_cast<int>(std::ceil(this->Size[2] - 1 - this->SlopeC * a)));
    }
  }

  std::size_t LineIndex(int b, int c) const
  {
    return std::size_t(c - this->FirstC) * this->Size[this->B] + std::size_t(b);
  }

  /// The point along the swept axis of a plane.
  int PointOfPlane(int a) const
  {
    const int inTile = a % this->Planes;
    return this->Backwards ? this->Planes - 1 - inTile : inTile;
  }

  /// Where the points around the lines of plane a are among all, once for the whole plane.
  void LookAtPlane(int a, int first, int last)
  {
    const std::size_t strides[3] = { 1, std::size_t(this->Size[0]),
      std::size_t(this->Size[0]) * std::size_t(this->Size[1]) };
    const double shiftB = this->SlopeB * a;
    const double shiftC = this->SlopeC * a;
    const double lowB = std::floor(shiftB);
    const double lowC = std::floor(shiftC);
    this->WeightB = static_cast<float>(shiftB - lowB);
    this->WeightC = static_cast<float>(shiftC - lowC);
    const std::size_t base = std::size_t(this->PointOfPlane(a)) * strides[this->A];
    this->PointsB.resize(std::size_t(this->Size[this->B]) + 1);
    for (int b = 0; b <= this->Size[this->B]; ++b)
    {
      const int place = Wrapped(static_cast<int>(lowB) + b, this->Size[this->B]);
      this->PointsB[b] = base + std::size_t(place) * strides[this->B];
    }
    this->PointsC.resize(std::size_t(last - first) + 2);
    for (int c = first; c <= last + 1; ++c)
    {
      const int place = static_cast<int>(lowC) + c;
      const int inTile = this->A == 2 ? Wrapped(place, this->Size[this->C])
                                      : std::clamp(place, 0, this->Size[this->C] - 1);
      this->PointsC[c - first] = std::size_t(inTile) * strides[this->C];
    }
  }

  /// The field where line b of the plane's row c, counted from the first, meets it.
  float ValueOn(int b, int row) const
  {
    const float* low = this->Sweep.Nodes.data() + this->PointsC[row];
    const float* high = this->Sweep.Nodes.data() + this->PointsC[row + 1];
    const std::size_t left = this->PointsB[b];
    const std::size_t right = this->PointsB[b + 1];
    const float below = low[left] + this->WeightB * (low[right] - low[left]);
    const float above = high[left] + this->WeightB * (high[right] - high[left]);
    return below + this->WeightC * (above - below);
  }

  /// In texture space, `part` of a step behind plane a.
  Vector PositionOn(double a, int b, int c) const
  {
    double place[3];
    place[this->A] = this->Backwards ? this->Planes - 1 - a : a;
    place[this->B] = b + this->SlopeB * a;
    place[this->C] = c + this->SlopeC * a;
    return { (place[0] + 0.5) / this->Size[0], (place[1] + 0.5) / this->Size[1],
      place[2] / (this->Size[2] - 1) };
  }

  /// The part of a step from plane a at which the field falls below 0: false position, on the field itself.
  double PartOfStep(int a, int b, int c, double value, double end, double next) const
  {
    double low = 0.;
    double high = end;
    constexpr int Refinements = 2;
    for (int i = 0; i <= Refinements; ++i)
    {
      const double part = low + (high - low) * value / (value - next);
      if (i == Refinements)
      {
        return part;
      }
      const double there = this->Sweep.Field.At(this->PositionOn(a + part, b, c));
      (there < 0. ? high : low) = part;
      (there < 0. ? next : value) = there;
      if (value == next)
      {
        return part;
      }
    }
    return end;
  }

  /// A line from the next plane to plane a, where the field is `value`.
  void Advance(int a, int b, int c, float value)
  {
    const std::size_t line = this->LineIndex(b, c);
    const float next = this->Values[line];
    float distance = this->Distances[line];
    if (value < 0.f)
    {
      distance = 0.f;
    }
    else if (this->LeavesBeforeNext(a, c))
    {
      const double end = this->PartToPlane(a, c);
      const double out = end > 0. ? this->Sweep.Field.At(this->PositionOn(a + end, b, c)) : 1.;
      distance = out < 0.
        ? static_cast<float>(this->PartOfStep(a, b, c, value, end, out) * this->Step)
        : Miss;
    }
    else if (next < 0.f)
    {
      distance = static_cast<float>(this->PartOfStep(a, b, c, value, 1., next) * this->Step);
    }
    else
    {
      distance += static_cast<float>(this->Step);
    }
    this->Distances[line] = distance;
    this->Values[line] = value;
  }

  bool LeavesBeforeNext(int a, int c) const
  {
    if (this->A == 2)
    {
      return a == this->LastPlane;
    }
    const double z = c + this->SlopeC * (a + 1);
    return this->SlopeC > 0. ? z > this->Size[2] - 1 : this->SlopeC < 0. && z < 0.;
  }

  double PartToPlane(int a, int c) const
  {
    if (this->A == 2)
    {
      return 0.;
    }
    const double z = c + this->SlopeC * a;
    return this->SlopeC > 0. ? (this->Size[2] - 1 - z) / this->SlopeC : z / -this->SlopeC;
  }

  std::size_t Gather(int a, float* distances, std::size_t stride)
  {
    std::size_t followed = 0;
    const double shiftB = -this->SlopeB * a;
    const double shiftC = -this->SlopeC * a;
    int point[3];
    point[this->A] = this->PointOfPlane(a);
    for (point[this->C] = 0; point[this->C] < this->Size[this->C]; ++point[this->C])
    {
      for (point[this->B] = 0; point[this->B] < this->Size[this->B]; ++point[this->B])
      {
        float* target =
          distances + (std::size_t(point[1]) * this->Size[0] + point[0]) * stride + point[2];
        const std::size_t node =
          (std::size_t(point[2]) * this->Size[1] + point[1]) * this->Size[0] + point[0];
        if (this->Sweep.Nodes[node] < 0.f)
        {
          *target = 0.f;
          continue;
        }
        if (!this->Mean(point[this->B] + shiftB, point[this->C] + shiftC, *target))
        {
          *target = this->Sweep.CastFrom(point[0], point[1], point[2], this->Direction);
          ++followed;
          continue;
        }
        const double toPlane = MesoVolumeRay::ToPlane(
          double(point[2]) / (this->Size[2] - 1), this->Direction[2], this->Sweep.Field.GetDepth());
        *target = std::min(*target, static_cast<float>(std::min(toPlane, this->Sweep.Reach)));
      }
    }
    return followed;
  }

  /// Of the four lines around a place; false where they do not agree.
  bool Mean(double placeB, double placeC, float& mean) const
  {
    const int lowB = static_cast<int>(std::floor(placeB));
    const int lowC = static_cast<int>(std::floor(placeC));
    const auto weightB = static_cast<float>(placeB - lowB);
    const auto weightC = static_cast<float>(placeC - lowC);
    const int highC = weightC > 0.f ? lowC + 1 : lowC;
    float four[4];
    for (int i = 0; i < 4; ++i)
    {
      const int b = Wrapped(lowB + (weightB > 0.f ? i & 1 : 0), this->Size[this->B]);
      int c = i & 2 ? highC : lowC;
      if (this->A == 2)
      {
        c = Wrapped(c, this->Size[this->C]);
      }
      four[i] = this->Distances[this->LineIndex(b, c)];
    }
    const auto [least, most] = std::minmax({ four[0], four[1], four[2], four[3] });
    if (least == Miss)
    {
      mean = Miss;
      return true;
    }
    if (!(most - least <= MostSpread * static_cast<float>(this->Step)))
    {
      return false;
    }
    const float low = four[0] + weightB * (four[1] - four[0]);
    const float high = four[2] + weightB * (four[3] - four[2]);
    mean = low + weightC * (high - low);
    return true;
  }

  const MesoGDMSweep& Sweep;
  const Vector Direction;
  const std::array<int, 3>& Size;
  int A = 0; ///< the axis that is swept along, and the others
  int B = 0;
  int C = 0;
  bool Backwards = false;
  double Step = 0.; ///< from plane to plane, tile widths
  double SlopeB = 0.;
  double SlopeC = 0.;
  int Planes = 0;    ///< in a tile
  int LastPlane = 0; ///< the furthest that is looked at
  int FirstC = 0;
  int LastC = 0;
  std::vector<float> Distances; ///< of each line from the last plane; Miss where it meets nothing
  std::vector<float> Values;    ///< the field there
  float WeightB = 0.f; ///< of the points after those of PointsB, PointsC, in the plane looked at
  float WeightC = 0.f;
  std::vector<std::size_t> PointsB;
  std::vector<std::size_t> PointsC;
};

MesoGDMSweep::MesoGDMSweep(const MesoVolumeField& field, double reach)
  : Field(field)
  , Ray(field)
  , Reach(reach)
{
  const auto& size = field.GetSize();
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        this->Nodes.push_back(static_cast<float>(field.At(this->PointAt(i, j, k))));
      }
    }
  }
}

MesoGDMSweep::Vector MesoGDMSweep::PointAt(int i, int j, int k) const
{
  const auto& size = this->Field.GetSize();
  return { (i + 0.5) / size[0], (j + 0.5) / size[1], double(k) / std::max(1, size[2] - 1) };
}

float MesoGDMSweep::CastFrom(int i, int j, int k, const Vector& direction) const
{
  return static_cast<float>(
    this->Ray.Cast(this->PointAt(i, j, k), direction, this->Reach).Distance);
}

std::size_t MesoGDMSweep::Sweep(const Vector& direction, float* distances, std::size_t stride) const
{
  return Lines(*this, direction).Run(distances, stride);
}

void MesoGDMSweep::Cast(const Vector& direction, float* distances, std::size_t stride) const
{
  const auto& size = this->Field.GetSize();
  for (int j = 0; j < size[1]; ++j)
  {
    for (int i = 0; i < size[0]; ++i)
    {
      for (int k = 0; k < size[2]; ++k)
      {
        distances[(std::size_t(j) * size[0] + i) * stride + k] = this->CastFrom(i, j, k, direction);
      }
    }
  }
}
