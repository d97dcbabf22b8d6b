#ifndef MesoQuadric_h
#define MesoQuadric_h

/**
 * @file MesoQuadric.h
 * @brief Fits the quadric that curved relief bends its height field over.
 *
 * In a frame (x, y, n) at the point p, x and y unit, at right angles to each other and to the unit
 * normal n, the neighbours q give depths below the tangent plane
 *
 *     z = -(q - p) . n,    z(x, y) = a x^2 + b y^2 + c x y
 *
 * (Oliveira2005, section 3, equations 1 and 2, with c = 0), so that a > 0 where the surface is
 * convex: at a point of a smooth surface with principal directions x, y the limit is a = c_max / 2,
 * b = c_min / 2, c = 0. Coordinates are taken in units of the neighbours' distance.
 */

#include "MesoVector.h"
#include "mesoFiltersSurfaceModule.h" // for export macro

#include <vector>

enum class MesoQuadricSolver
{
  QR,             ///< Householder QR of the equations
  NormalEquations ///< x = (A^T A)^-1 A^T b, as in Oliveira2005; squares the condition number
};

struct MesoQuadricOptions
{
  bool Full = true; ///< fit c; else c = 0
  /// Fit slopes of the tangent plane, d x + e y, beside, and leave them out of the result: where n
  /// is a mesh's estimate its error is of the size of the curvature's effect. Needs two more
  /// neighbours; where there are not as many, slopes are not fitted.
  bool Slopes = false;
  MesoQuadricSolver Solver = MesoQuadricSolver::QR;
  /// Depths up to this are rounding, in object units: where all are, the quadric is 0.
  double Rounding = 0.;
};

struct MesoQuadric
{
  double A = 0.; ///< 1 / object unit, as B and C
  double B = 0.;
  double C = 0.;
  /// Ratio of the largest to the least singular value of the equations' matrix with its columns
  /// scaled to unit length: 1 or more. 0 where there is no fit, and all else is 0: fewer neighbours
  /// than unknowns, neighbours on one line or on a pair of lines that quadrics do not differ on, or
  /// a condition above 1e6.
  double Condition = 0.;
};

/// `offsets` are q - p.
MESOFILTERSSURFACE_EXPORT MesoQuadric MesoFitQuadric(const std::vector<MesoVector>& offsets,
  const MesoVector& x, const MesoVector& y, const MesoVector& normal,
  const MesoQuadricOptions& options);

#endif
