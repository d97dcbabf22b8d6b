// Volumes in the reference: prisms crossed where closed forms and a dense march say, hits that no step
// passes over, matter cut at bottom, top and open fins only, and no gap between prisms.

#include "MesoTestVolume.h"
#include "ReferenceWorld.h"

#include "MesoPrismSolver.h"

#include <cmath>

namespace
{
/// A prism over (0, 0), (1, 0), (0, 1), one high, its corners and rises moved by up to `amount`.
MesoTruePrism BentPrism(RandomNumbers& random, double amount)
{
  MesoTruePrism prism;
  prism.Bottom = { glm::dvec3(0.), glm::dvec3(1., 0., 0.), glm::dvec3(0., 1., 0.) };
  for (int k = 0; k < 3; ++k)
  {
    prism.Rise[k] = glm::dvec3(0., 0., 1.) + amount * random.Direction();
    prism.Bottom[k] += amount * random.Direction();
    prism.Map[k] = glm::dvec2(prism.Bottom[k]);
  }
  return prism;
}

/// A built-in volume's text in a scene.
std::string Node(const std::string& shape, const std::string& volume, const std::string& more)
{
  return R"([{"mesh": )" + shape + R"(, "mesostructure": {"technique": "shell-sdf", "volume": )" +
    volume + ", " + more + "}}]";
}
}

TEST(VolumeReference, PlacesInPrismsAreFoundAgain)
{
  RandomNumbers random(1);
  for (int i = 0; i < 2000; ++i)
  {
    const MesoTruePrism prism = BentPrism(random, 0.2);
    glm::dvec3 place(random.In(0., 1.), random.In(0., 1.), random.In(0., 1.));
    if (place.x + place.y > 1.)
    {
      place = { 1. - place.x, 1. - place.y, place.z };
    }
    glm::dvec3 found;
    ASSERT_TRUE(prism.Find(prism.PointAt(place), found)) << i;
    EXPECT_LT(glm::length(found - place), 1e-11) << i;
  }
}

TEST(VolumeReference, FindsWhatADenseMarchFinds)
{
  const auto image = MesoTestBars();
  const MesoVolumeTruth volume(image);
  RandomNumbers random(2);
  int hits = 0;
  int cuts = 0;
  for (int i = 0; i < 400; ++i)
  {
    const MesoTruePrism prism = BentPrism(random, 0.15);
    const glm::dvec3 through =
      prism.PointAt({ random.In(0., 0.5), random.In(0., 0.5), random.In(0., 1.) });
    const glm::dvec3 direction = random.Direction();
    const glm::dvec3 origin = through - 3. * direction;
    MesoPrismHit hit;
    MesoSolverWork work;
    const bool found = MesoFirstInPrism(prism, volume, origin, direction, 0., 6., hit, work);
    // Places are found by the cubic anew at each step.
    double first = -1.;
    constexpr int steps = 6000;
    for (int step = 0; step <= steps && first < 0.; ++step)
    {
      const double t = 6. * step / steps;
      glm::dvec3 place;
      if (prism.Find(origin + t * direction, place) && volume.At(prism.ChartAt(place)) <= 0.)
      {
        first = t;
      }
    }
    if (first < 0.)
    {
      // A stretch shorter than the march's step may be found by the solver alone.
      EXPECT_TRUE(!found || std::abs(volume.At(prism.ChartAt(hit.Place))) < 1e-3) << i;
      continue;
    }
    ASSERT_TRUE(found) << i;
    ASSERT_LE(hit.T, first + 1e-9) << i;
    ++hits;
    const double there = volume.At(prism.ChartAt(hit.Place));
    EXPECT_LT(glm::length(prism.PointAt(hit.Place) - (origin + hit.T * direction)), 1e-10);
    if (hit.Cut >= 0)
    {
      ++cuts;
      EXPECT_LE(there, 0.);
      const glm::dvec3& p = hit.Place;
      const double onFace[] = { p.z, 1. - p.z, p.y, 1. - p.x - p.y, p.x };
      EXPECT_NEAR(onFace[hit.Cut], 0., 1e-9) << i;
    }
    else
    {
      EXPECT_NEAR(there, 0., 1e-10) << i;
    }
    EXPECT_GT(hit.T, first - 6. / steps - 1e-3) << i;
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(cuts, 5);
}

TEST(VolumeReference, TheBoundOfChangeHolds)
{
  const auto image = MesoTestBars();
  const MesoVolumeTruth volume(image);
  const glm::dvec3 metric(1., 1., volume.Field().GetDepth());
  RandomNumbers random(3);
  double most = 0.;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 place(random.In(0., 1.), random.In(0., 1.), random.In(0., 1.));
    most = std::max(most, glm::length(volume.Gradient(place) / metric));
  }
  EXPECT_LE(most, volume.MostChange());
  EXPECT_GT(most, 0.5 * volume.MostChange());
}

TEST(VolumeReference, TheTopOfASphereIsAScaledSphere)
{
  // Where foam reaches the top of the shell its cut is seen, and the top is the facets of a sphere scaled by
  // 1 + H: a prism map that made normals unit between the corners would miss it.
  ReferenceWorld shell(Node(
    R"({"shape": "sphere"})", R"({"pattern": "foam", "size": [16, 16, 8]})", R"("scale": 0.2)"));
  ReferenceWorld plain(R"([{"mesh": {"shape": "sphere", "radius": 1.2}}])");
  RandomNumbers random(4);
  int same = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 origin = 5. * random.Direction();
    const glm::dvec3 direction = glm::normalize(0.8 * random.Direction() - origin);
    const double t = shell.T(origin, direction);
    const double top = plain.T(origin, direction);
    if (std::isnan(top) || std::isnan(t))
    {
      continue; // past the sphere, or through the foam
    }
    ASSERT_GE(t, top - 1e-6) << i; // nothing is before the shell
    if (std::abs(t - top) < 1e-6)  // the meshes are rounded to floats
    {
      ++same;
      EXPECT_EQ(shell.Hit.Cut, 1);
      const auto point = shell.Surfaces[0]->Describe(shell.Hit, direction);
      EXPECT_GT(glm::dot(point.Geometric, glm::normalize(origin + t * direction)), 0.99);
      EXPECT_NEAR(point.Relief, 0., 1e-9);
    }
  }
  EXPECT_GT(same, 20); // where the foam reaches the top
}

TEST(VolumeReference, NoRaySlipsBetweenPrisms)
{
  // The ground of the scales fills the lower tenth of the shell without a gap: rays from outside that meet
  // the base's facets meet matter before. Half of the rays run through corners and edges of the base.
  ReferenceWorld shell(Node(R"({"shape": "torus", "rings": 12, "sides": 8})",
    R"({"pattern": "scales", "size": [32, 32, 16]})", R"("scale": 0.1, "tiles": [6, 3])"));
  ReferenceWorld plain(R"([{"mesh": {"shape": "torus", "rings": 12, "sides": 8}}])");
  RandomNumbers random(5);
  int met = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 origin = 6. * random.Direction();
    glm::dvec3 target = random.Direction();
    if (i % 2 == 0)
    {
      const auto triangle =
        static_cast<std::size_t>(random.In(0., plain.Surfaces[0]->NumberOfPatches() - 1.));
      target = plain.Surfaces[0]->PositionAt(triangle, i % 4 == 0 ? 0. : random.In(0., 1.), 0.);
    }
    const glm::dvec3 direction = glm::normalize(target - origin);
    const double base = plain.T(origin, direction);
    if (std::isnan(base) || base > glm::length(origin))
    {
      continue; // a far side, over which rays may come from the inside
    }
    ++met;
    const double t = shell.T(origin, direction);
    ASSERT_FALSE(std::isnan(t)) << i;
    EXPECT_LT(t, base) << i;
  }
  EXPECT_GT(met, 500);
}

TEST(VolumeReference, OpenEdgesShowTheirCut)
{
  ReferenceWorld world(Node(R"({"shape": "plane", "size": [2, 2], "segments": [3, 3]})",
    R"({"pattern": "scales", "size": [32, 32, 16]})", R"("scale": 0.5)"));
  // Along y at a height within the ground.
  const double t = world.T({ 0.1, -5., 0.02 }, { 0., 1., 0. });
  EXPECT_NEAR(t, 4., 1e-12);
  EXPECT_GE(world.Hit.Cut, 2);
  const auto point = world.Surfaces[0]->Describe(world.Hit, { 0., 1., 0. });
  EXPECT_NEAR(point.Geometric.y, -1., 1e-12);
  // From below: the ground's cut at the bottom.
  EXPECT_NEAR(world.T({ 0.1, 0.2, -3. }, { 0., 0., 1. }), 3., 1e-12);
  EXPECT_EQ(world.Hit.Cut, 0);
  // Fins between prisms are none: matter behind one is reached through its own surface.
  const double inner = world.T({ 0.1, 0.2, 3. }, { 0.01, 0., -1. });
  EXPECT_GT(inner, 2.4);
  EXPECT_TRUE(world.Hit.Cut == -1 || world.Hit.Cut == 1);
}

TEST(VolumeReference, WhatItDoesNotShowIsRefused)
{
  const auto of = [](bool smooth, double facets)
  {
    try
    {
      ReferenceWorld world(Node(R"({"shape": "sphere"})",
                             R"({"pattern": "weave", "size": [8, 8, 4]})", R"("scale": 0.2)"),
        smooth, facets);
    }
    catch (const MesoInputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(of(true, 0.), "node 1 '': the surface 'smooth' is not known for volumes");
  EXPECT_EQ(of(false, 1.), "a volume cannot be diced");
}
