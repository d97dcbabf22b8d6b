// Hits that can be computed by hand, in double precision. What a map is between its texels is the
// bilinear height itself, so the closed forms are of that; how far it is from the function that the
// texels sample is a figure of its own (CylinderWithCosines).

#include "ReferenceWorld.h"

#include <cmath>

namespace
{
constexpr double Pi = 3.141592653589793238462643;
// Hits differ from the closed forms by rounding alone: some ten roundings of numbers below 10.
constexpr double Rounding = 1e-13;

/// The first t at which a ray meets a sphere about the origin, from outside.
double SphereT(const glm::dvec3& origin, const glm::dvec3& direction, double radius)
{
  const double a = glm::dot(direction, direction);
  const double b = glm::dot(origin, direction);
  const double c = glm::dot(origin, origin) - radius * radius;
  return (-b - std::sqrt(b * b - a * c)) / a;
}

const char* const SmoothSphere = R"([{"mesh": {"shape": "sphere", "rings": 8, "sides": 12},
  "mesostructure": {"technique": "relief", "scale": 0.2, "tiles": [3, 2],
                    "height_map": {"pattern": "step", "size": [16, 8], "position": 0, "low": 0.25}}}])";
}

TEST(ReferenceClosedForms, SmoothSphereMovedEvenly)
{
  ReferenceWorld world(SmoothSphere, true);
  RandomNumbers random(1);
  constexpr double Radius = 1. - 0.75 * 0.2;
  int hits = 0;
  for (int i = 0; i < 3000; ++i)
  {
    const glm::dvec3 target = 0.95 * Radius * random.Direction();
    const glm::dvec3 origin = 4. * random.Direction();
    const glm::dvec3 direction = target - origin;
    const double t = world.T(origin, direction);
    ASSERT_NEAR(t, SphereT(origin, direction, Radius), Rounding) << "ray " << i;
    const auto point = world.Surfaces[0]->Describe(world.Hit, direction);
    const glm::dvec3 outward = glm::normalize(origin + t * direction);
    ASSERT_NEAR(point.Relief, 0.75, 1e-12);
    ASSERT_GT(glm::dot(point.Geometric, outward), 1. - 1e-9);
    ASSERT_GT(glm::dot(point.Shading, outward), 1. - 1e-9);
    ++hits;
  }
  EXPECT_EQ(hits, 3000);
  EXPECT_EQ(world.Work.Solver.Unresolved, 0u);
  // Just inside and just outside of the outline.
  for (double off : { 1. - 1e-9, 1. + 1e-9 })
  {
    const double t = world.T({ Radius * off * 0.6, Radius * off * 0.8, 5. }, { 0., 0., -1. });
    EXPECT_EQ(std::isfinite(t), off < 1.);
  }
}

TEST(ReferenceClosedForms, SmoothSphereMovedOutward)
{
  // q = p + (h - r) D n with h = 0.25 everywhere: also its normal and its base, where h = 1 lies.
  for (double reference : { 0., 0.5, 0.75 })
  {
    std::string nodes = SmoothSphere;
    nodes.insert(nodes.find("\"scale\""), "\"reference\": " + std::to_string(reference) + ", ");
    ReferenceWorld world(nodes, true);
    const double radius = 1. + (0.25 - reference) * 0.2;
    const double drawn = 1. + (1. - reference) * 0.2;
    RandomNumbers random(1);
    for (int i = 0; i < 300; ++i)
    {
      const glm::dvec3 origin = 4. * random.Direction();
      const glm::dvec3 direction = 0.95 * radius * random.Direction() - origin;
      const double t = world.T(origin, direction);
      ASSERT_NEAR(t, SphereT(origin, direction, radius), Rounding) << "ray " << i;
      const auto point = world.Surfaces[0]->Describe(world.Hit, direction);
      const glm::dvec3 outward = glm::normalize(origin + t * direction);
      ASSERT_NEAR(point.Relief, 0.75, 1e-12);
      ASSERT_GT(glm::dot(point.Shading, outward), 1. - 1e-9);
    }
    for (double off : { 1. - 1e-9, 1. + 1e-9 })
    {
      MesoReferenceTracer::Ray ray;
      ray.Origin = { drawn * off * 0.6, drawn * off * 0.8, 5. };
      ray.Direction = { 0., 0., -1. };
      ray.TMax = 10.;
      EXPECT_EQ(world.Tracer->MeetsBase(ray, 0, world.Work), off < 1.) << reference;
    }
  }
}

TEST(ReferenceClosedForms, MeshOfASphereIsItsFacets)
{
  // The same even relief over the mesh: on a corner's own normal the hit is at the sphere's.
  ReferenceWorld world(SmoothSphere, false);
  const double t = world.T({ 0., 0., 5. }, { 0., 0., -1. });
  EXPECT_NEAR(t, 5. - (1. - 0.75 * 0.2), 1e-6); // the mesh's points are stored as floats
}

TEST(ReferenceClosedForms, PlaneWithAStep)
{
  // 64 texels over [-1, 1]: 1 left of the middle, 0 right of it, a ramp one texel wide about it.
  ReferenceWorld world(R"([{"mesh": {"shape": "plane", "size": [2, 2]},
    "mesostructure": {"technique": "relief", "scale": 0.3, "wrap": "clamp",
                      "height_map": {"pattern": "step", "size": [64, 4]}}}])");
  constexpr double D = 0.3;
  constexpr double HalfTexel = 1. / 64.;
  RandomNumbers random(2);
  int onRamp = 0;
  int behind = 0;
  for (int i = 0; i < 4000; ++i)
  {
    // In a plane y = const, seen from the right, above: floor at z = -D, ramp, top at z = 0.
    const double x = random.In(-0.9, 0.9);
    const double slope = random.In(-1.2, 1.2); // dx per unit of depth
    const double y = random.In(-0.9, 0.9);
    const glm::dvec3 direction(slope, 0., -1.);
    const glm::dvec3 origin = glm::dvec3(x, y, 0.) - 2. * direction;
    // By hand: s(t) on the three pieces, the first that lies within its piece.
    double expected = std::numeric_limits<double>::quiet_NaN();
    const auto offer = [&](double t, double low, double high)
    {
      const double at = origin.x + t * slope;
      if (at >= low && at <= high && !(expected <= t))
      {
        expected = t;
      }
    };
    offer(2., -1., -HalfTexel);
    offer(2. + D, HalfTexel, 1.);
    // z = -D (x + HalfTexel) / (2 HalfTexel), which must be met from the right and above.
    const double fall = D / (2. * HalfTexel);
    const double approach = -1. + fall * slope;
    if (approach < 0.)
    {
      const double t = (-2. - fall * (origin.x + HalfTexel)) / approach;
      offer(t, -HalfTexel, HalfTexel);
      onRamp += expected == t ? 1 : 0;
    }
    const double t = world.T(origin, direction);
    behind += std::isnan(expected) ? 1 : 0;
    if (std::isnan(expected))
    {
      ASSERT_TRUE(std::isnan(t)) << "ray " << i << ": " << t;
      continue;
    }
    ASSERT_NEAR(t, expected, 1e-12) << "ray " << i;
  }
  EXPECT_GT(onRamp, 100);
  EXPECT_GT(behind, 10) << "rays that pass through the ramp's back and out";
}

TEST(ReferenceClosedForms, CylinderWithCosines)
{
  // h = (1 + cos(2 pi 6 u)) / 2 sampled at 96 texels around; the ray lies at right angles to the axis,
  // so that the hit is a root of one equation in t, with h linear between texels.
  constexpr int Waves = 6;
  constexpr int Texels = 96;
  constexpr double Radius = 0.5;
  constexpr double D = 0.08;
  const auto cosine = [](double u) { return 0.5 + 0.5 * std::cos(2. * Pi * Waves * u); };
  const auto heights =
    HeightsOf(Texels, 1, [&](int column, int) { return cosine((column + 0.5) / Texels); });
  ReferenceWorld world(R"([{"mesh": {"shape": "cylinder", "sides": 10},
    "mesostructure": {"technique": "relief", "scale": 0.08, "height_map": {"pattern": "noise"}}}])",
    true, 0., heights);
  const auto* values = static_cast<const float*>(heights->GetScalarPointer());
  double largestFromCosine = 0.;
  const auto linear = [&](double u)
  {
    const double x = u * Texels - 0.5;
    const double low = std::floor(x);
    const auto texel = [&](double i)
    { return double(values[(static_cast<int>(i) + Texels) % Texels]); };
    return texel(low) + (x - low) * (texel(low + 1.) - texel(low));
  };
  RandomNumbers random(4);
  for (int i = 0; i < 300; ++i)
  {
    const double turn = random.In(0., 2. * Pi);
    const glm::dvec3 origin(2. * std::sin(turn), random.In(-0.4, 0.4), 2. * std::cos(turn));
    const double off = random.In(-0.38, 0.38);
    const glm::dvec3 side(std::cos(turn), 0., -std::sin(turn));
    const glm::dvec3 direction = glm::normalize(off * side - glm::dvec3(origin.x, 0., origin.z));
    const auto above = [&](double t)
    {
      const double x = origin.x + t * direction.x;
      const double z = origin.z + t * direction.z;
      // u = 0 at -z, eastward: u = 1/2 + (angle from +z towards +x) / 2 pi.
      const double u = 0.5 + std::atan2(x, z) / (2. * Pi);
      largestFromCosine = std::max(largestFromCosine, std::abs(linear(u) - cosine(u)));
      return std::sqrt(x * x + z * z) - (Radius + (linear(u) - 1.) * D);
    };
    double t = 1.4;
    constexpr double Step =
      1e-4; // a texel is 0.03 wide: what rises and falls within a step is less
            // than can be seen from outside the cosines
    while (above(t + Step) > 0. && t < 2.2)
    {
      t += Step;
    }
    double far = t + Step;
    for (int k = 0; k < 60; ++k)
    {
      const double middle = 0.5 * (t + far);
      (above(middle) > 0. ? t : far) = middle;
    }
    ASSERT_NEAR(world.T(origin, direction), t, 1e-12) << "ray " << i; // 1e-5 D is 8e-7
  }
  // The truth is what lies between the texels: |h''| / 8 per texel squared from the cosine itself.
  const double bound = 0.5 * std::pow(2. * Pi * Waves / Texels, 2) / 8.;
  EXPECT_LT(largestFromCosine, 1.001 * bound + 1e-6);
  EXPECT_GT(largestFromCosine, 0.9 * bound);
}

TEST(ReferenceClosedForms, SmoothTorusMovedEvenly)
{
  // Along the axis direction: the tube's circle of radius r - d about the main circle.
  ReferenceWorld world(R"([{"mesh": {"shape": "torus", "rings": 9, "sides": 7},
    "mesostructure": {"technique": "relief", "scale": 0.1,
                      "height_map": {"pattern": "step", "position": 0, "low": 0.5}}}])",
    true);
  constexpr double Tube = 0.4 - 0.05;
  RandomNumbers random(5);
  for (int i = 0; i < 1000; ++i)
  {
    const double turn = random.In(0., 2. * Pi);
    const double off = random.In(-0.99 * Tube, 0.99 * Tube);
    const glm::dvec3 origin((1. + off) * std::sin(turn), 3., (1. + off) * std::cos(turn));
    ASSERT_NEAR(world.T(origin, { 0., -1., 0. }), 3. - std::sqrt(Tube * Tube - off * off), 1e-12);
  }
}

TEST(ReferenceClosedForms, FarFromTheOriginAndInOtherUnits)
{
  // The same sphere 1e6 away, and 1e-4 and 1e4 times the size: as exact as the numbers allow.
  for (double scale : { 1e-4, 1., 1e4 })
  {
    for (double offset : { 0., 1e6 })
    {
      const double move = offset * scale;
      const std::string nodes = R"([{"transform": {"translate": [)" + std::to_string(move) +
        R"(, 0, 0], "scale": )" + std::to_string(scale) + R"(}, "mesh": {"shape": "sphere"},
        "mesostructure": {"technique": "relief", "scale": 0.2, "height_map":
          {"pattern": "step", "position": 0, "low": 0.25}}}])";
      ReferenceWorld world(nodes, true);
      RandomNumbers random(6);
      for (int i = 0; i < 100; ++i)
      {
        const glm::dvec3 from = 4. * scale * random.Direction();
        const glm::dvec3 direction = 0.8 * scale * random.Direction() - from;
        const glm::dvec3 origin = from + glm::dvec3(move, 0., 0.);
        const double expected = SphereT(origin - glm::dvec3(move, 0., 0.), direction, 0.85 * scale);
        ASSERT_NEAR(world.T(origin, direction), expected, offset > 0. ? 1e-8 : 1e-12)
          << scale << " at " << move;
      }
    }
  }
}

TEST(ReferenceClosedForms, ManyTiles)
{
  // 10^4 tiles of 64 texels: straight down, the relief at a place is the map's own there.
  ReferenceWorld world(R"([{"mesh": {"shape": "plane", "size": [2, 2]},
    "mesostructure": {"technique": "relief", "scale": 0.3, "tiles": [10000, 10000],
                      "height_map": {"pattern": "smooth", "size": [64, 64]}}}])");
  const MesoHeightPyramid& map = *world.Surfaces[0]->GetMap();
  RandomNumbers random(7);
  for (int i = 0; i < 500; ++i)
  {
    const double x = random.In(-0.99, 0.99);
    const double y = random.In(-0.99, 0.99);
    const double height = map.HeightAt(5000. * (x + 1.), 5000. * (y + 1.));
    ASSERT_NEAR(world.T({ x, y, 2. }, { 0., 0., -1. }), 2. + (1. - height) * 0.3, 1e-9);
  }
}

TEST(ReferenceClosedForms, NoRaySlipsBetweenPatches)
{
  // Rays through the inside of closed surfaces, aimed at corners, edges and texels' borders.
  for (bool smooth : { false, true })
  {
    ReferenceWorld world(R"([{"mesh": {"shape": "sphere", "rings": 6, "sides": 8},
      "mesostructure": {"technique": "relief", "scale": 0.1, "tiles": [4, 2],
                        "height_map": {"pattern": "smooth", "size": [8, 8]}}}])",
      smooth);
    const MesoShape sphere("sphere");
    for (int i = 0; i <= 64; ++i)
    {
      for (int j = 1; j < 24; ++j)
      {
        // Multiples of a quarter of an edge: 2 or 4 texels.
        const auto at = sphere.At(i / 32., j / 24.).Position;
        const glm::dvec3 p(at[0], at[1], at[2]);
        for (const glm::dvec3& from : { 4. * p, glm::dvec3(4. * p.y, 4. * p.z, 4. * p.x) })
        {
          ASSERT_TRUE(std::isfinite(world.T(from, 0.3 * p - from)))
            << (smooth ? "smooth " : "mesh ") << i << ", " << j;
        }
      }
    }
  }
}

TEST(ReferenceClosedForms, AtThePolesOfASphere)
{
  // All columns of the map meet at a pole, in a crown of different heights: a ray down the axis meets
  // it somewhere on the crown, one beside it where its own column says; both end soon.
  for (double off : { 0., 1e-12, 1e-9, 1e-6, 1e-3 })
  {
    ReferenceWorld world(R"([{"mesh": {"shape": "sphere", "rings": 6, "sides": 8},
      "mesostructure": {"technique": "relief", "scale": 0.1, "tiles": [4, 2],
                        "height_map": {"pattern": "noise", "size": [32, 32]}}}])",
      true);
    const double t = world.T({ off, 4., 0.3 * off }, { 0., -1., 0. });
    EXPECT_GE(t, 3.) << off;
    EXPECT_LE(t, 3.1) << off;
    EXPECT_LT(world.Work.Solver.Pieces, 100000u) << off;
    EXPECT_EQ(world.Work.Solver.Unresolved, 0u) << off;
  }
}

namespace
{
/// The height above a noisy sphere of radius 1 or a torus of 1 and 0.4, of which (u, v) of any point is
/// known in closed form.
double AboveNoise(const glm::dvec3& point, bool torus, const MesoHeightPyramid& map, double scale)
{
  const double around = std::hypot(point.x, point.z);
  const double out = torus ? around - 1. : around;
  const double radius = std::hypot(out, point.y);
  const double u = 0.5 + std::atan2(point.x, point.z) / (2. * Pi);
  const double v = 0.5 + std::atan2(point.y, out) / (torus ? 2. * Pi : Pi);
  const double height = map.HeightAt(4. * u, 2. * v);
  return radius - ((torus ? 0.4 : 1.) + (height - 1.) * scale);
}
}

TEST(ReferenceClosedForms, NoHitIsMissedOnSmoothShapesWithNoise)
{
  // Beside a march in steps of a fiftieth of a texel: what it finds must be found, or an earlier hit,
  // which lies on the surface.
  constexpr double Scale = 0.15;
  for (bool torus : { false, true })
  {
    ReferenceWorld world(std::string(R"([{"mesh": {"shape": )") +
        (torus ? R"("torus", "rings": 9, "sides": 6)" : R"("sphere", "rings": 5, "sides": 7)") +
        R"(}, "mesostructure": {"technique": "relief", "scale": 0.15, "tiles": [4, 2],
          "height_map": {"pattern": "noise", "size": [16, 16]}}}])",
      true);
    const MesoHeightPyramid& map = *world.Surfaces[0]->GetMap();
    RandomNumbers random(12);
    int marched = 0;
    int earlier = 0;
    for (int i = 0; i < 600; ++i)
    {
      const glm::dvec3 origin = 3. * random.Direction();
      const glm::dvec3 direction = glm::normalize((torus ? 1.4 : 1.) * random.Direction() - origin);
      const auto above = [&](double t)
      { return AboveNoise(origin + t * direction, torus, map, Scale); };
      const double t = world.T(origin, direction);
      if (std::isfinite(t))
      {
        ASSERT_NEAR(above(t), 0., 1e-12) << "ray " << i;
        ASSERT_GT(above(t - 1e-8), 0.) << "ray " << i << " meets a back";
      }
      constexpr double Step = 1e-3;
      double near = 1.4;
      while (near < 4.6 && above(near + Step) > 0.)
      {
        near += Step;
      }
      if (near < 4.6)
      {
        ++marched;
        ASSERT_LE(t, near + Step) << "ray " << i;
        earlier += t < near ? 1 : 0;
      }
    }
    EXPECT_GT(marched, 200);
    EXPECT_LT(earlier, 5) << "corners that the march cuts";
  }
}
