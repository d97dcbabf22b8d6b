// The exact surface and the diced one, which share the evaluation of single points alone: they agree
// to what facets of a given size can be off by, and that falls as dicing says it must.

#include "ReferenceWorld.h"

namespace
{
const char* const NoisyTorus = R"([{"transform": {"rotate": [30, 1, 1, 0]},
  "mesh": {"shape": "torus", "rings": 12, "sides": 8},
  "mesostructure": {"technique": "relief", "scale": 0.1, "tiles": [4, 2],
                    "height_map": {"pattern": "smooth", "size": [16, 16]}}}])";
constexpr double D = 0.1;

struct Agreement
{
  std::vector<double> Distances; ///< of t, where both hit
  int OneAlone = 0;
  int Elsewhere = 0; ///< hits further apart than D: another part of the surface
  int Rays = 0;
};

Agreement Compare(const std::string& nodes, double facetsPerTexel)
{
  ReferenceWorld exact(nodes);
  ReferenceWorld diced(nodes, false, facetsPerTexel);
  RandomNumbers random(8);
  Agreement agreement;
  for (int i = 0; i < 4000; ++i)
  {
    const glm::dvec3 origin = 4. * random.Direction();
    const glm::dvec3 direction = glm::normalize(1.3 * random.Direction() - origin);
    const double a = exact.T(origin, direction);
    const double b = diced.T(origin, direction);
    ++agreement.Rays;
    if (std::isnan(a) != std::isnan(b))
    {
      ++agreement.OneAlone;
    }
    else if (!std::isnan(a))
    {
      agreement.Distances.push_back(std::abs(a - b));
      agreement.Elsewhere += std::abs(a - b) >= D ? 1 : 0;
    }
  }
  return agreement;
}
}

TEST(ReferenceDiced, AgreesWithTheExactSurface)
{
  double median = 1.;
  Agreement fine;
  for (double facets : { 2., 4., 8. })
  {
    fine = Compare(NoisyTorus, facets);
    ASSERT_GT(fine.Distances.size(), 1500u);
    const double finer = Percentile(fine.Distances, 0.5);
    std::cout << facets << " facets a texel: p50 " << finer / D << " p95 "
              << Percentile(fine.Distances, 0.95) / D << " of D; alone " << fine.OneAlone
              << ", elsewhere " << fine.Elsewhere << " of " << fine.Rays << "\n";
    // Quadratic within texels, linear at the creases between them.
    EXPECT_LT(finer, 0.5 * median);
    median = finer;
  }
  // A facet of 1/8 texel leaves a bilinear patch by at most its twist / 4 / 64, and cuts a crease
  // between texels by slope / 4 / 8: a thousandth of D on the whole, on this map.
  EXPECT_LT(Percentile(fine.Distances, 0.95), 2e-3 * D);
  // At outlines one surface is hit and the other not.
  EXPECT_LE(fine.OneAlone + fine.Elsewhere, fine.Rays / 200);
}

TEST(ReferenceDiced, IsTheMeshItselfWithoutAMap)
{
  const char* const nodes = R"([{"mesh": {"shape": "sphere", "rings": 6, "sides": 9}}])";
  const Agreement agreement = Compare(nodes, 4.);
  ASSERT_GT(agreement.Distances.size(), 1000u);
  EXPECT_LE(agreement.OneAlone, 1); // Embree's own triangles are of float
  EXPECT_LT(Percentile(agreement.Distances, 1.), 1e-9);
}

TEST(ReferenceDiced, RefusesWhatCannotBeDiced)
{
  EXPECT_THROW(ReferenceWorld(R"([{"mesh": {"shape": "sphere"}}])", true, 2.), MesoInputError);
  EXPECT_THROW(ReferenceWorld(NoisyTorus, false, 5000.), MesoInputError);
}
