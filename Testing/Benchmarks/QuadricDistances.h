#ifndef QuadricDistances_h
#define QuadricDistances_h

/**
 * @file QuadricDistances.h
 * @brief The distances of Oliveira2005, section 3.1 (its Figure 10), below a cylinder of radius 1.
 */

#include "MesoKernels.h"

#include <algorithm>
#include <cmath>

/// Of a ray that enters at an angle to the normal, where it is truly 0.05 deep or half as deep as it gets.
struct QuadricDistances
{
  double Degrees;
  double Depth;
  double Across; ///< equation 6 over the true depth
  double Along;  ///< equation 7, along the fragment's normal
  double Normal; ///< along the quadric's own normals
};

/// Distance from (x, z) to the parabola z = x^2 / 2, z down, by Newton's method on the foot's x.
inline double DistanceToParabola(double x, double z)
{
  double foot = x;
  for (int i = 0; i < 60; ++i)
  {
    const double value = foot - x + foot * (0.5 * foot * foot - z);
    const double slope = 1. + 1.5 * foot * foot - z;
    foot -= value / slope;
  }
  return std::hypot(x - foot, z - 0.5 * foot * foot);
}

inline QuadricDistances DistancesAt(double degrees)
{
  const MesoKernels::Double::QuadricExact kernel;
  const glm::dvec3 quadric(0.5, 0., 0.);
  const double angle = degrees * 3.14159265358979323846 / 180.;
  const glm::dvec3 view(std::sin(angle), 0., std::cos(angle));
  const double depth = std::min(0.05, 0.5 * (1. - view.x));
  // (1 - depth)^2 = x^2 + (1 - z)^2
  const double rest = depth * (2. - depth);
  const double time = rest / (view.z + std::sqrt(view.z * view.z - rest));
  const glm::dvec3 point = time * view;
  const glm::dvec3 across = kernel.acrossView({ 0., 0., -1. }, view);
  return { degrees, depth, kernel.distanceAcross(quadric, across, point) / depth,
    kernel.distanceToQuadric(quadric, point) / depth,
    DistanceToParabola(point.x, point.z) / depth };
}

#endif
