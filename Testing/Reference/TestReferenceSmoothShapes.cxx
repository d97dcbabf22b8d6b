// The surface `smooth` of the built-in shapes: the mesh's surface comes to it as the mesh is refined, and
// with no relief hits lie on the closed form itself.

#include "ReferenceWorld.h"

#include "MesoShape.h"

namespace
{
std::string NodeOf(const std::string& shape, const std::string& counts, double scale)
{
  return R"([{"mesh": {"shape": ")" + shape + "\"" + counts +
    R"(}, "mesostructure": {"technique": "relief", "reference": 0.5, "scale": )" +
    std::to_string(scale) + R"(, "tiles": [3, 2],
      "height_map": {"pattern": "smooth", "size": [16, 16]}}}])";
}

/// Differences of t between the smooth surface and the mesh's, where both are hit.
std::vector<double> Differences(const std::string& shape, const std::string& counts)
{
  ReferenceWorld smooth(NodeOf(shape, counts, 0.05), true);
  ReferenceWorld mesh(NodeOf(shape, counts, 0.05));
  EXPECT_TRUE(smooth.Surfaces[0]->IsSmooth());
  RandomNumbers random(5);
  std::vector<double> differences;
  for (int i = 0; i < 1500; ++i)
  {
    const glm::dvec3 origin = 4. * random.Direction();
    const glm::dvec3 direction = glm::normalize(0.6 * random.Direction() - origin);
    const double a = smooth.T(origin, direction);
    const double b = mesh.T(origin, direction);
    if (!std::isnan(a) && !std::isnan(b))
    {
      differences.push_back(std::abs(a - b));
    }
  }
  EXPECT_EQ(smooth.Work.Solver.Unresolved, 0u);
  return differences;
}

struct Counts
{
  const char* Shape;
  const char* Coarse;
  const char* Fine;
};

// GoogleTest puts it into the test's name, which must not change from run to run.
void PrintTo(const Counts& counts, std::ostream* stream)
{
  *stream << counts.Shape;
}

class SmoothShape : public testing::TestWithParam<Counts>
{
};
}

TEST_P(SmoothShape, IsWhatMeshesComeTo)
{
  const auto coarse = Differences(GetParam().Shape, GetParam().Coarse);
  const auto fine = Differences(GetParam().Shape, GetParam().Fine);
  ASSERT_GT(fine.size(), 400u);
  std::cout << GetParam().Shape << ": p50 " << Percentile(coarse, 0.5) << ", of twice the quads "
            << Percentile(fine, 0.5) << "\n";
  EXPECT_LT(Percentile(fine, 0.5), 2e-3);
  // Chords leave a curve by the square of their length.
  EXPECT_LT(Percentile(fine, 0.5), Percentile(coarse, 0.5) / 3.);
}

INSTANTIATE_TEST_SUITE_P(All, SmoothShape,
  testing::Values(Counts{ "cone", R"(, "sides": 24, "rings": 8)", R"(, "sides": 48, "rings": 16)" },
    Counts{ "vase", R"(, "sides": 24, "rings": 20)", R"(, "sides": 48, "rings": 40)" },
    Counts{ "undulating", R"(, "segments": [16, 16])", R"(, "segments": [32, 32])" }));

TEST(SmoothShapes, WithoutReliefAreTheClosedForm)
{
  for (const char* shape : { "cone", "vase", "undulating" })
  {
    const MesoShape form(shape);
    ReferenceWorld world(NodeOf(shape, "", 0.), true);
    RandomNumbers random(6);
    for (int i = 0; i < 200; ++i)
    {
      // From outside along the normal, but for slopes that hide a point from afar.
      const MesoShapePoint point = form.At(random.In(0.01, 0.99), random.In(0.01, 0.99));
      const glm::dvec3 place(point.Position[0], point.Position[1], point.Position[2]);
      const glm::dvec3 normal(point.Normal[0], point.Normal[1], point.Normal[2]);
      ASSERT_NEAR(world.T(place + 0.01 * normal, -normal), 0.01, 1e-13) << shape;
      const auto hit = world.Surfaces[0]->Describe(world.Hit, -normal);
      ASSERT_GT(glm::dot(hit.Shading, normal), 1. - 1e-12) << shape;
    }
  }
}

TEST(SmoothShapes, FlatOnesAreTheirMeshes)
{
  for (const char* shape : { "plane", "cube" })
  {
    ReferenceWorld world(NodeOf(shape, "", 0.05), true);
    EXPECT_FALSE(world.Surfaces[0]->IsSmooth()) << shape;
    EXPECT_FALSE(std::isnan(world.T({ 0.1, 0.2, 3. }, { 0., 0., -1. }))) << shape;
  }
  for (const char* shape : { "teapot", "branch" })
  {
    EXPECT_THROW(ReferenceWorld(NodeOf(shape, "", 0.05), true), MesoInputError) << shape;
  }
}
