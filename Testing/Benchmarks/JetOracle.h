#ifndef JetOracle_h
#define JetOracle_h

#include "MesoVector.h"

#include <vector>

struct JetOracleResult
{
  double Maximum = 0.; ///< positive where convex
  MesoVector Direction = { 0., 0., 0. };
};

/// CGAL's Monge_via_jet_fitting on the point 0 and its neighbours. Only where CGAL was found.
JetOracleResult JetOracle(
  const std::vector<MesoVector>& offsets, const MesoVector& normal, int degree);

#endif
