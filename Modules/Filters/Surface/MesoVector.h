#ifndef MesoVector_h
#define MesoVector_h

/**
 * @file MesoVector.h
 * @brief The few operations on triples of doubles that the surface filters need.
 */

#include <array>
#include <cmath>

using MesoVector = std::array<double, 3>;

inline MesoVector MesoSum(const MesoVector& a, const MesoVector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline MesoVector MesoDifference(const MesoVector& a, const MesoVector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

inline MesoVector MesoScaled(const MesoVector& a, double factor)
{
  return { a[0] * factor, a[1] * factor, a[2] * factor };
}

inline double MesoDot(const MesoVector& a, const MesoVector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline MesoVector MesoCross(const MesoVector& a, const MesoVector& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

inline double MesoLength(const MesoVector& a)
{
  return std::sqrt(MesoDot(a, a));
}

#endif
