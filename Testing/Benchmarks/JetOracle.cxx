#define CGAL_EIGEN3_ENABLED 1
#define CGAL_DISABLE_GMP 1
#define CGAL_DISABLE_MPFR 1
#include "JetOracle.h"

#include <CGAL/Monge_via_jet_fitting.h>
#include <CGAL/Simple_cartesian.h>

JetOracleResult JetOracle(
  const std::vector<MesoVector>& offsets, const MesoVector& normal, int degree)
{
  using Kernel = CGAL::Simple_cartesian<double>;
  std::vector<Kernel::Point_3> points = { Kernel::Point_3(0., 0., 0.) };
  for (const MesoVector& q : offsets)
  {
    points.emplace_back(q[0], q[1], q[2]);
  }
  CGAL::Monge_via_jet_fitting<Kernel> fit;
  auto form = fit(points.begin(), points.end(), static_cast<std::size_t>(degree), 2);
  // Curvatures of CGAL are negative where the surface bends away from the normal.
  form.comply_wrt_given_normal(Kernel::Vector_3(-normal[0], -normal[1], -normal[2]));
  const auto direction = form.maximal_principal_direction();
  return { form.principal_curvatures(0), { direction.x(), direction.y(), direction.z() } };
}
