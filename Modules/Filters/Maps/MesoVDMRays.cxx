#include "MesoVDMRays.h"

#include "MesoKernels.h"

#include <algorithm>
#include <cmath>

namespace
{
using Kernel = MesoKernels::Double::VDMTable;
const Kernel TheKernel;
const double RightAngle = std::acos(0.);

/// Of the polar angle at which a point is seen from the entry, over a convex base.
double Cotangent(double curvature, double offset, double depth)
{
  const double psi = curvature * offset;
  const double left = 1. - curvature * depth;
  return (1. - left * std::cos(psi)) / (left * std::sin(psi));
}

/// Angles at the centre, of a stretch between two cuts, above which a parabola is not the way.
constexpr double CoarseAngle = 0.03;

/// Where between two cuts the cotangent is least, from a guess of a parabola on.
double FlattestBetween(const MesoHeightLine::Profile& profile, double curvature, std::size_t cut,
  double start, double length, double guess)
{
  const auto at = [&](double along)
  { return Cotangent(curvature, start + along, profile.DepthBetween(cut, along)); };
  if (curvature * length > CoarseAngle)
  {
    double low = 0.;
    double high = length;
    for (int step = 0; step < 40; ++step)
    {
      const double third = (high - low) / 3.;
      if (at(low + third) < at(high - third))
      {
        high -= third;
      }
      else
      {
        low += third;
      }
    }
    return 0.5 * (low + high);
  }
  const double apart = 0.02 * length;
  const double along = std::min(std::max(guess, apart), length - apart);
  const double before = at(along - apart);
  const double after = at(along + apart);
  const double bend = before - 2. * at(along) + after;
  const double shift = bend > 0. ? 0.5 * apart * (before - after) / bend : 0.;
  return std::min(std::max(along + shift, 0.), length);
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
  const double first =
    slope < 0. ? 2. * start / (root - slope) : (bend < 0. ? -(slope + root) / (2. * bend) : -1.);
  return first <= length ? first : -1.;
}
}

MesoVDMRays::MesoVDMRays(const MesoVDMLayout& layout, MesoVDMCurved curved, double azimuth)
  : Layout(layout)
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
  Ray ray = { std::sin(angle), std::cos(angle), 0., 0., false };
  ray.Cotangent = ray.Sine > 0. ? ray.Cosine / ray.Sine : 0.;
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

MesoVDMRays::Fan::Arc MesoVDMRays::ArcOf(double curvature, double offset)
{
  const double psi = curvature * offset;
  const double half = TheKernel.vdmSinc(0.5 * psi);
  return { 0.5 * psi * offset * half * half, std::cos(psi), offset * TheKernel.vdmSinc(psi) };
}

MesoVDMRays::Fan MesoVDMRays::MakeFan(double curvature) const
{
  Fan fan;
  fan.Curvature = curvature;
  for (int i = 0; i < this->Layout.Polars; ++i)
  {
    fan.Rays.push_back(MakeRay(this->Layout, curvature, i));
  }
  const std::vector<double>& offsets = this->Line.GetOffsets();
  for (std::size_t k = 0; k + 1 < offsets.size(); ++k)
  {
    fan.Arcs.push_back(ArcOf(curvature, offsets[k]));
    fan.Arcs.push_back(ArcOf(curvature, 0.5 * (offsets[k] + offsets[k + 1])));
  }
  fan.Arcs.push_back(ArcOf(curvature, offsets.back()));
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
  for (const Ray& ray : fan.Rays)
  {
    if (ray.Sine == 0. || surface <= 0.)
    {
      points.push_back({ 0., surface });
      continue;
    }
    const double bending = 0.25 * std::abs(fan.Curvature);
    Point point = { ray.End, this->Layout.Depth };
    bool meets = !ray.ComesOut; // the bottom at the latest
    double before = fan.Above(fan.Arcs[2 * cut], profile.DepthAt(cut), ray.Cotangent);
    for (; cut + 1 < offsets.size() && offsets[cut] <= ray.End; ++cut)
    {
      profile.Reach(cut + 1);
      const Fan::Arc& arc = fan.Arcs[2 * cut + 2];
      const double depth = profile.DepthAt(cut + 1);
      const double after = fan.Above(arc, depth, ray.Cotangent);
      // Between the cuts it may lie below its chord by the relief's sag, and by what the bend adds to it.
      const double length = offsets[cut + 1] - offsets[cut];
      const double sag = profile.SagAfter(cut) +
        bending *
          (length * length +
            ray.Cotangent *
              (length * std::abs(depth - profile.DepthAt(cut)) +
                4. * arc.Sine * profile.SagAfter(cut)));
      if (std::min(before, after) <= sag &&
        this->MeetBetween(profile, fan, ray, cut, before, after, point))
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

bool MesoVDMRays::MeetBetween(const MesoHeightLine::Profile& profile, const Fan& fan,
  const Ray& ray, std::size_t cut, double before, double after, Point& point) const
{
  constexpr int MostSteps = 8;
  const double start = this->Line.GetOffsets()[cut];
  const double length = this->Line.GetOffsets()[cut + 1] - start;
  double along = 0.;
  if (before > 0.)
  {
    const double middle =
      fan.Above(fan.Arcs[2 * cut + 1], profile.DepthBetween(cut, 0.5 * length), ray.Cotangent);
    along = FirstRoot(before, middle, after, length);
    if (along < 0.)
    {
      if (after > 0.)
      {
        return false;
      }
      along = length;
    }
    const auto above = [&](double place)
    {
      return fan.Above(
        ArcOf(fan.Curvature, start + place), profile.DepthBetween(cut, place), ray.Cotangent);
    };
    const double apart = 1e-5 * length;
    for (int step = 0; std::abs(fan.Curvature) * length > CoarseAngle && step < MostSteps; ++step)
    {
      const double value = above(along);
      const double slope = (above(along + apart) - value) / apart;
      const double next =
        slope < 0. ? std::min(std::max(along - value / slope, 0.), length) : along;
      if (std::abs(next - along) < apart)
      {
        break;
      }
      along = next;
    }
  }
  point.Offset = start + along;
  point.Depth = std::min(std::max(profile.DepthBetween(cut, along), 0.), this->Layout.Depth);
  return true;
}

double MesoVDMRays::Flattest(MesoHeightLine::Profile& profile, const Fan& fan, Point& point) const
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
  constexpr double Margin = 1e-4; // that the parabola may be off
  // Angles at the centre up to which stretches begin, and are looked at: what is behind it is seen steeply.
  constexpr double LastArc = 3.;
  constexpr double LargestArc = 3.1;
  double best = HUGE_VAL;
  const double reach = std::min(2. * std::acos(1. - c * this->Layout.Depth), LastArc) / c;
  std::size_t cut = 1;
  for (; cut < offsets.size() && offsets[cut - 1] <= reach; ++cut)
  {
    const Fan::Arc& near = fan.Arcs[2 * cut - 2];
    const Fan::Arc& arc = fan.Arcs[2 * cut];
    // Even a point of the base itself is seen no more flatly from the stretch's beginning on.
    if (near.Versine >= best * near.Sine)
    {
      break;
    }
    profile.Reach(cut);
    const double end = profile.DepthAt(cut);
    // Within the stretch up to this cut the surface lies no higher than this.
    const double least = std::min(profile.DepthAt(cut - 1), end) - profile.SagAfter(cut - 1);
    if (cut > 1 && arc.Cosine > 0. &&
      std::min(riseOf(near, least), riseOf(arc, least)) >=
        best * std::max(runOf(near, least), runOf(arc, least)))
    {
      continue;
    }
    const double length = offsets[cut] - offsets[cut - 1];
    const double value = arc.Sine > 0. ? riseOf(arc, end) / runOf(arc, end) : HUGE_VAL;
    if (value < best)
    {
      best = value;
      point = { offsets[cut], end };
    }
    // Between the cuts: near the vertex of the parabola through both ends and the middle. At the entry itself
    // the cotangent has no bound.
    double along = 0.5 * length;
    if (cut > 1 && c * length <= CoarseAngle)
    {
      const double before =
        riseOf(near, profile.DepthAt(cut - 1)) / runOf(near, profile.DepthAt(cut - 1));
      const double depthMiddle = profile.DepthBetween(cut - 1, along);
      const Fan::Arc& between = fan.Arcs[2 * cut - 1];
      const double middle = riseOf(between, depthMiddle) / runOf(between, depthMiddle);
      const double bend = before - 2. * middle + value;
      const double shift =
        bend > 0. ? 0.25 * (before - value) / bend : 1.; // lengths from the middle
      const double vertex = middle - 0.125 * (before - value) * (before - value) / bend;
      if (!(std::abs(shift) < 0.5) || vertex >= best + Margin)
      {
        continue;
      }
      along += shift * length;
    }
    const double searched = std::min(length, LargestArc / c - offsets[cut - 1]);
    along =
      FlattestBetween(profile, c, cut - 1, offsets[cut - 1], searched, std::min(along, searched));
    const Point found = { offsets[cut - 1] + along, profile.DepthBetween(cut - 1, along) };
    const double exact = Cotangent(c, found.Offset, found.Depth);
    if (exact < best)
    {
      best = exact;
      point = found;
    }
  }
  return best;
}

double MesoVDMRays::NumberOf(double curvature, double sine, double cosine, const Point& point) const
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

void MesoVDMRays::Trace(MesoHeightLine::Profile& profile, int column, int row, float* numbers) const
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
