#ifndef MesoJetFit_h
#define MesoJetFit_h

/**
 * @file MesoJetFit.h
 * @brief Principal curvatures at a point of a sampled surface, from a polynomial fitted around it.
 *
 * In a frame (e1, e2, n) at the point p the neighbours q give heights
 *
 *     z(x, y) = sum a_ij x^i y^j,   1 <= i + j <= d,   x = (q - p) . e1,  y = (q - p) . e2
 *
 * by least squares (Cazals and Pouget 2005, "Estimating differential quantities using polynomial
 * fitting of osculating jets"); there is no constant, for the surface runs through p. With d = 4
 * the second derivatives' error falls with the third power of the neighbours' distance h (with h^4
 * where they lie symmetrically around p), with d = 3 and 2 with h^2 and h.
 *
 * e1, e2 are the axes of the neighbours' second moments in the tangent plane and x, y are taken in
 * units of their spread along them, so that what is fitted does not depend on the mesh's anisotropy
 * nor on its scale. n need not be the surface's normal: first derivatives are fitted and taken into
 * account. The curvatures are the eigenvalues of the shape operator of the graph at p,
 *
 *     I = [1 + zx^2, zx zy; zx zy, 1 + zy^2],   II = [zxx, zxy; zxy, zyy] / sqrt(1 + zx^2 + zy^2),
 *
 * of L^-1 II L^-T with I = L L^T, with the sign turned over: convex is positive where n is outward.
 */

#include "MesoVector.h"
#include "mesoFiltersSurfaceModule.h" // for export macro

#include <vector>

struct MesoPrincipalCurvature
{
  double Maximum = 0.; ///< 1 / object unit, positive where convex; at least Minimum
  double Minimum = 0.;
  MesoVector MaximumDirection = { 0., 0., 0. }; ///< unit
  MesoVector MinimumDirection = { 0., 0., 0. }; ///< unit, at right angles to the other
  double Confidence = 0.;                       ///< 0: there is no fit, and all else is 0
  int Degree = 0;                               ///< of the polynomial
};

/// Neighbours that MesoFitJet() looks at; more are thinned out evenly.
constexpr std::size_t MesoMostJetNeighbours = 128;
/// Neighbours that a polynomial of degree 4 is tried with.
constexpr std::size_t MesoQuarticNeighbours = 18;

/**
 * `offsets` are q - p, nearest first; `normal` is unit. Degrees `highest` (4, 3 or 2) down to
 * `lowest` are tried: 4 needs 18 neighbours, 3 needs 12, 2 needs 6, and each a matrix of full rank
 * and a precision of 1/10.
 *
 * Confidence = degree * sidedness * precision, each from 0 to 1:
 * - 1, 3/4 and 1/2 for degrees 4, 3 and 2;
 * - 1 - |m|^2 / 2 with m the mean of the neighbours' (x, y) in units of their spread: 1 in the
 *   middle, about .6 at a straight border, .3 at a corner;
 * - 1 / (1 + r e), e the standard error of the curvatures that the fit's residuals tell and r the
 *   radius of the neighbourhood.
 */
MESOFILTERSSURFACE_EXPORT MesoPrincipalCurvature MesoFitJet(const std::vector<MesoVector>& offsets,
  const MesoVector& normal, int highest = 4, int lowest = 2);

/// Two unit vectors at right angles to a unit vector and to each other, right-handed with it.
MESOFILTERSSURFACE_EXPORT std::array<MesoVector, 2> MesoPerpendiculars(const MesoVector& normal);

#endif
