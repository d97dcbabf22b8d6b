#include "MesoVDMRays.h"

#include "MesoKernels.h"

#include <algorithm>
#include <cmath>

namespace
{
using Kernel = MesoKernels::Double::VDMTable;
const Kernel TheKernel;
const double RightAngle = std::acos(0.);

/// Depth of a ray over a point of the base.
double RayDepth(double curvature, double sine, double cosine, double offset)
{
  return TheKernel.vdmPointAtDistance(sine, cosine, curvature, offset / sine).Depth;
}

/// The first s in (0, length] at which the parabola through a positive number at 0 and two others in the
/// middle and at the end is 0; negative where there is none.
double FirstRoot(double start, double middle, double end, double length)
{
  const double bend = 2. * (start - 2. * middle + end) / (length * length);
  const double slope = (4. * middle - 3. * start - end) / length;
  const double discriminant = slope * slope - 4. * bend * start;
  if (discriminant < 0.)
  {
    return -1.;
  }
  const double root = std::sqrt(discriminant);
  const double first = slope < 0. ? 2. * start / (root - slope)
                                  : (bend < 0. ? -(slope + root) / (2. * bend) : -1.);
  return first <= length ? first : -1.;
}
}

MesoVDMRays::MesoVDMRays(const MesoVDMLayout& layout, MesoVDMCurved curved, double azimuth)
  : Layout(layout)
  , Curved(curved)
  , Range(layout.Range())
  , Line(layout.Width, layout.Height, azimuth, ReachOf(layout))
{
  for (int k = 0; k < layout.Curvatures; ++k)
  {
    this->Fans.push_back(this->MakeFan(layout.CurvatureAt(k)));
  }
  if (curved == MesoVDMCurved::Bent)
  {
    this->Flat.push_back(this->MakeFan(0.));
  }
}

MesoVDMRays::Ray MesoVDMRays::MakeRay(const MesoVDMLayout& layout, double curvature, int polar)
{
  const double angle = layout.RayPolarAt(polar);
  Ray ray = { std::sin(angle), std::cos(angle), 0., false };
  const double rest = (2. - curvature * layout.Depth) * layout.Depth;
  ray.ComesOut = ray.Cosine * ray.Cosine < curvature * rest;
  ray.End = ray.ComesOut
    ? 2. * (RightAngle - angle) / curvature
    : TheKernel.vdmPointAtDepth(ray.Sine, ray.Cosine, curvature, layout.Depth, false).Offset;
  return ray;
}

double MesoVDMRays::ReachOf(const MesoVDMLayout& layout)
{
  double reach = 0.;
  for (int k = -1; k < layout.Curvatures; ++k) // -1: the flat base
  {
    const double curvature = k < 0 ? 0. : layout.CurvatureAt(k);
    for (int i = 0; i < layout.Polars; ++i)
    {
      reach = std::max(reach, MakeRay(layout, curvature, i).End);
    }
    if (curvature > 0.)
    {
      // A ray that touches the bottom meets something; nothing further off is seen more flatly.
      reach = std::max(reach, 2. * std::acos(1. - curvature * layout.Depth) / curvature);
    }
  }
  return reach;
}

MesoVDMRays::Fan MesoVDMRays::MakeFan(double curvature) const
{
  Fan fan;
  fan.Curvature = curvature;
  const std::vector<double>& offsets = this->Line.GetOffsets();
  const std::size_t places = 2 * offsets.size() - 1;
  const auto offsetAt = [&](std::size_t place)
  {
    return place % 2 == 0 ? offsets[place / 2] : 0.5 * (offsets[place / 2] + offsets[place / 2 + 1]);
  };
  fan.Depths.resize(this->Layout.Polars * places);
  for (int i = 0; i < this->Layout.Polars; ++i)
  {
    fan.Rays.push_back(MakeRay(this->Layout, curvature, i));
    const Ray& ray = fan.Rays.back();
    for (std::size_t k = 0; ray.Sine > 0. && k < places; ++k)
    {
      fan.Depths[i * places + k] = RayDepth(curvature, ray.Sine, ray.Cosine, offsetAt(k));
      if (k % 2 == 0 && offsetAt(k) > ray.End)
      {
        break; // the rest is not looked at
      }
    }
  }
  for (std::size_t k = 0; curvature > 0. && k < places; ++k)
  {
    const double psi = curvature * offsetAt(k);
    fan.Arcs.push_back({ (1. - std::cos(psi)) / curvature, std::cos(psi), std::sin(psi) / curvature });
  }
  return fan;
}

std::vector<MesoVDMRays::Point> MesoVDMRays::Meet(
  MesoHeightLine::Profile& profile, const Fan& fan) const
{
  const std::vector<double>& offsets = this->Line.GetOffsets();
  std::vector<Point> points;
  points.reserve(fan.Rays.size());
  std::size_t cut = 0;
  profile.Reach(0);
  const double surface = profile.DepthAt(0);
  for (std::size_t i = 0; i < fan.Rays.size(); ++i)
  {
    const Ray& ray = fan.Rays[i];
    if (ray.Sine == 0. || surface <= 0.)
    {
      points.push_back({ 0., surface });
      continue;
    }
    const double* rayDepths = &fan.Depths[i * (2 * offsets.size() - 1)];
    Point point = { ray.End, this->Layout.Depth };
    bool meets = !ray.ComesOut; // the bottom at the latest
    double before = profile.DepthAt(cut) - rayDepths[2 * cut];
    for (; cut + 1 < offsets.size() && offsets[cut] <= ray.End; ++cut)
    {
      profile.Reach(cut + 1);
      const double after = profile.DepthAt(cut + 1) - rayDepths[2 * cut + 2];
      if (std::min(before, after) <= profile.SagAfter(cut) &&
        this->MeetBetween(profile, rayDepths + 2 * cut, cut, point))
      {
        meets = true;
        break;
      }
      before = after;
    }
    if (!meets)
    {
      break; // and no flatter one does
    }
    points.push_back(point);
    cut = std::min(cut, offsets.size() - 2);
    // Where a ray ended at the bottom the next goes on from the cut before.
    while (cut > 0 && offsets[cut] > point.Offset)
    {
      --cut;
    }
  }
  return points;
}

bool MesoVDMRays::MeetBetween(const MesoHeightLine::Profile& profile, const double* rayDepths,
  std::size_t cut, Point& point) const
{
  const double start = this->Line.GetOffsets()[cut];
  const double length = this->Line.GetOffsets()[cut + 1] - start;
  const double before = profile.DepthAt(cut) - rayDepths[0];
  const double after = profile.DepthAt(cut + 1) - rayDepths[2];
  double along = 0.;
  if (before > 0.)
  {
    along =
      FirstRoot(before, profile.DepthBetween(cut, 0.5 * length) - rayDepths[1], after, length);
    if (along < 0.)
    {
      if (after > 0.)
      {
        return false;
      }
      along = length;
    }
  }
  point.Offset = start + along;
  point.Depth = std::min(std::max(profile.DepthBetween(cut, along), 0.), this->Layout.Depth);
  return true;
}

double MesoVDMRays::Flattest(
  MesoHeightLine::Profile& profile, const Fan& fan, Point& point) const
{
  const std::vector<double>& offsets = this->Line.GetOffsets();
  const double c = fan.Curvature;
  profile.Reach(0);
  point = { 0., profile.DepthAt(0) };
  if (point.Depth <= 0. || !(c > 0.))
  {
    return 0.; // in the plane of the base; where that is not convex, every ray comes down
  }
  // Cotangent = rise / run of a point as seen from the entry.
  const auto riseOf = [](const Fan::Arc& arc, double depth)
  { return arc.Versine + depth * arc.Cosine; };
  const auto runOf = [c](const Fan::Arc& arc, double depth) { return (1. - c * depth) * arc.Sine; };
  double best = HUGE_VAL;
  const double reach = 2. * std::acos(1. - c * this->Layout.Depth) / c;
  std::size_t cut = 1;
  for (; cut < offsets.size() && offsets[cut] <= reach; ++cut)
  {
    const Fan::Arc& arc = fan.Arcs[2 * cut];
    // Even a point of the base itself is seen no more flatly from here on.
    if (arc.Versine >= best * arc.Sine)
    {
      break;
    }
    profile.Reach(cut);
    const double end = profile.DepthAt(cut);
    // Within the stretch up to this cut the surface lies no higher than this.
    const double least = std::min(profile.DepthAt(cut - 1), end) - profile.SagAfter(cut - 1);
    const Fan::Arc& near = fan.Arcs[2 * cut - 2];
    if (cut > 1 && arc.Cosine > 0. &&
      std::min(riseOf(near, least), riseOf(arc, least)) >=
        best * std::max(runOf(near, least), runOf(arc, least)))
    {
      continue;
    }
    const double length = offsets[cut] - offsets[cut - 1];
    const double value = riseOf(arc, end) / runOf(arc, end);
    if (value < best)
    {
      best = value;
      point = { offsets[cut], end };
    }
    if (cut == 1)
    {
      continue; // the first stretch begins at the entry, where the cotangent has no bound
    }
    // Between the cuts: the vertex of the parabola through both ends and the middle.
    const double before = riseOf(near, profile.DepthAt(cut - 1)) / runOf(near, profile.DepthAt(cut - 1));
    const double depthMiddle = profile.DepthBetween(cut - 1, 0.5 * length);
    const Fan::Arc& between = fan.Arcs[2 * cut - 1];
    const double middle = riseOf(between, depthMiddle) / runOf(between, depthMiddle);
    const double bend = before - 2. * middle + value;
    const double shift = bend > 0. ? 0.25 * (before - value) / bend : 0.; // in lengths, from the middle
    if (bend > 0. && std::abs(shift) < 0.5)
    {
      const double vertex = middle - 0.125 * (before - value) * (before - value) / bend;
      if (vertex < best)
      {
        const double along = (0.5 + shift) * length;
        best = vertex;
        point = { offsets[cut - 1] + along, profile.DepthBetween(cut - 1, along) };
      }
    }
  }
  return best;
}

double MesoVDMRays::NumberOf(
  double curvature, double sine, double cosine, const Point& point) const
{
  if (this->Layout.Stores == MesoVDMStores::Depth && !(curvature > 0.))
  {
    return point.Depth; // no ray rises
  }
  Kernel::VDMLayout table = {};
  table.Stores = static_cast<int>(this->Layout.Stores);
  Kernel::VDMPoint full = {};
  full.Offset = point.Offset;
  full.Depth = point.Depth;
  // By the law of sines, or straight down.
  full.RayLength = sine > 1e-6 ? (1. - curvature * point.Depth) *
      TheKernel.vdmSinc(curvature * point.Offset) * point.Offset / sine
                               : point.Depth;
  return TheKernel.vdmNumber(table, sine, cosine, curvature, full);
}

std::vector<double> MesoVDMRays::Bend(
  const std::vector<Point>& flat, const Fan& fan, double surfaceDepth) const
{
  const double c = fan.Curvature;
  std::vector<double> angles = { 0. };
  std::vector<double> numbers = { this->NumberOf(c, 0., 1., { 0., surfaceDepth }) };
  for (const Point& point : flat)
  {
    const double psi = c * point.Offset;
    const double half = TheKernel.vdmSinc(0.5 * psi);
    const double rise =
      point.Depth * std::cos(psi) + 0.5 * c * point.Offset * point.Offset * half * half;
    const double run = (1. - c * point.Depth) * TheKernel.vdmSinc(psi) * point.Offset;
    const double angle = std::atan2(run, rise);
    if (psi < 2. * RightAngle && angle > angles.back()) // else it is occluded by what is nearer
    {
      angles.push_back(angle);
      numbers.push_back(this->NumberOf(c, std::sin(angle), std::cos(angle), point));
    }
  }
  std::vector<double> resampled;
  std::size_t next = 1;
  for (int i = 0; i < this->Layout.Polars; ++i)
  {
    const double polar = this->Layout.RayPolarAt(i);
    while (next < angles.size() && angles[next] < polar)
    {
      ++next;
    }
    if (next == angles.size())
    {
      if (c > 0.)
      {
        break; // flatter than all that is known
      }
      resampled.push_back(numbers.back());
      continue;
    }
    const double part = (polar - angles[next - 1]) / (angles[next] - angles[next - 1]);
    resampled.push_back(numbers[next - 1] + part * (numbers[next] - numbers[next - 1]));
  }
  return resampled;
}

void MesoVDMRays::Trace(
  MesoHeightLine::Profile& profile, int column, int row, float* numbers) const
{
  profile.Start(column, row);
  std::vector<Point> flat;
  if (!this->Flat.empty())
  {
    flat = this->Meet(profile, this->Flat.front());
  }
  float* distance = numbers;
  float* angle = numbers + this->Layout.DistanceColumns();
  for (const Fan& fan : this->Fans)
  {
    std::vector<double> met;
    if (this->Flat.empty() || fan.Curvature == 0.)
    {
      const std::vector<Point> points = this->Meet(profile, fan);
      for (std::size_t i = 0; i < points.size(); ++i)
      {
        met.push_back(
          this->NumberOf(fan.Curvature, fan.Rays[i].Sine, fan.Rays[i].Cosine, points[i]));
      }
    }
    else
    {
      met = this->Bend(flat, fan, profile.DepthAt(0));
    }
    Point flattest = {};
    const double largest = std::atan2(1., this->Flattest(profile, fan, flattest));
    if (met.size() < fan.Rays.size())
    {
      met.resize(fan.Rays.size(),
        this->NumberOf(fan.Curvature, std::sin(largest), std::cos(largest), flattest));
    }
    for (const double number : met)
    {
      *distance++ = static_cast<float>(std::min(std::max(number / this->Range, 0.), 1.));
    }
    *angle++ = static_cast<float>(largest / RightAngle);
  }
}
