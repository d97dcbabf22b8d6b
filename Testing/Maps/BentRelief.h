#ifndef BentRelief_h
#define BentRelief_h

// Rays through a bent relief by small steps: what tables of view-dependent displacements are to hold.

#include "MesoVDMTable.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

/// The relief in the plane of a ray, bent about the centre of curvature, as a place knows it: written with
/// points of the plane, without the kernel's formulas.
class BentRelief
{
public:
  BentRelief(vtkImageData* map, const MesoVDMLayout& layout, int column, int row, double azimuth,
    double curvature)
    : Map(map)
    , Layout(layout)
    , Column(column)
    , Row(row)
    , Azimuth(azimuth)
    , Curvature(curvature)
  {
  }

  /// Depth of the relief below a place of the base.
  double ReliefAt(double offset) const
  {
    const double x = this->Column + offset * std::cos(this->Azimuth) * this->Layout.Width;
    const double y = this->Row + offset * std::sin(this->Azimuth) * this->Layout.Height;
    const double i = std::floor(x);
    const double j = std::floor(y);
    const auto at = [&](double column, double row)
    {
      const int c =
        static_cast<int>(column - this->Layout.Width * std::floor(column / this->Layout.Width));
      const int r =
        static_cast<int>(row - this->Layout.Height * std::floor(row / this->Layout.Height));
      return this->Map->GetScalarComponentAsDouble(c, r, 0, 0);
    };
    const double height = (1. - (y - j)) * ((1. - (x - i)) * at(i, j) + (x - i) * at(i + 1., j)) +
      (y - j) * ((1. - (x - i)) * at(i, j + 1.) + (x - i) * at(i + 1., j + 1.));
    return this->Layout.Depth * (1. - height);
  }

  struct Place
  {
    double Offset;
    double Depth;
  };

  /// Of a point of the plane: along the tangent at the entry, and inwards.
  Place PlaceOf(double along, double inwards) const
  {
    if (this->Curvature == 0.)
    {
      return { along, inwards };
    }
    const double radius = 1. / this->Curvature;
    const double side = this->Curvature > 0. ? 1. : -1.;
    const double angle = std::atan2(along, side * (radius - inwards)); // at the centre
    return { std::abs(radius) * angle, radius - side * std::hypot(along, radius - inwards) };
  }

  /// The first point of a ray in the relief by small steps and halving; false where it comes out.
  bool March(double polar, Place& place, double& length) const
  {
    const double step = StepInTexels / std::max(this->Layout.Width, this->Layout.Height);
    double before = 0.;
    for (double t = 0.;; t += step)
    {
      const Place here = this->PlaceOf(t * std::sin(polar), t * std::cos(polar));
      if (t > 0. && here.Depth < 0.)
      {
        return false;
      }
      if (here.Depth >= this->ReliefAt(here.Offset))
      {
        double low = before;
        double high = t;
        for (int i = 0; i < 50; ++i)
        {
          const double middle = 0.5 * (low + high);
          const Place there = this->PlaceOf(middle * std::sin(polar), middle * std::cos(polar));
          (there.Depth >= this->ReliefAt(there.Offset) ? high : low) = middle;
        }
        length = high;
        place = this->PlaceOf(high * std::sin(polar), high * std::cos(polar));
        return true;
      }
      before = t;
    }
  }

  /// The largest polar angle at which a point of the relief is seen over a convex base, by small steps and
  /// thirds of the best of them.
  double Flattest() const
  {
    constexpr int Steps = 20000;
    const double radius = 1. / this->Curvature;
    const auto at = [&](double step)
    {
      const double angle = std::acos(-1.) * step / Steps; // at the centre
      const double left = radius - this->ReliefAt(radius * angle);
      return std::atan2(left * std::sin(angle), radius - left * std::cos(angle));
    };
    int best = 1;
    for (int i = 2; i < Steps; ++i)
    {
      best = at(i) > at(best) ? i : best;
    }
    double low = best - 1;
    double high = best + 1;
    for (int i = 0; i < 60; ++i)
    {
      const double third = (high - low) / 3.;
      (at(low + third) > at(high - third) ? high : low) +=
        at(low + third) > at(high - third) ? -third : third;
    }
    return at(0.5 * (low + high));
  }

private:
  static constexpr double StepInTexels = 0.02;

  vtkImageData* Map;
  const MesoVDMLayout& Layout;
  int Column;
  int Row;
  double Azimuth;
  double Curvature;
};

#endif
