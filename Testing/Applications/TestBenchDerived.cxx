// What a bench's report derives from rows, on rows whose answers are known.

#include "BenchAnalysis.h"
#include "BenchDerived.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
using Json = BenchResults::Json;

Json Row(const std::string& technique, const std::string& quality, double milliseconds,
  double prepare, double depth, double texels, double silhouette, int triangles)
{
  const Json figures = { { "depth_p95", depth }, { "texcoord_p95", texels },
    { "silhouette_px_mean", silhouette } };
  return { { "technique", technique }, { "quality", quality }, { "status", "ok" },
    { "judged_by", "mesh" }, { "errors", { { "mesh", figures } } },
    { "gpu_ms", { { "median", milliseconds } } }, { "prepare_s", prepare },
    { "triangles", triangles } };
}

const Json Relief = Row("relief", "medium", 20., 0.1, 0.2, 2., 0.5, 100);

/// Errors fall to a quarter where facets double.
std::vector<Json> Dicings()
{
  return { Row("tessellated", "draft", 5., 0.2, 0.64, 6.4, 0.64, 1000),
    Row("tessellated", "low", 12., 0.3, 0.16, 1.6, 0.16, 4000),
    Row("tessellated", "medium", 40., 0.6, 0.04, 0.4, 0.04, 16000),
    Row("tessellated", "high", 150., 2., 0.01, 0.1, 0.01, 64000) };
}
}

TEST(BenchDerived, AlternativeIsTheCoarsestDicingThatIsNoWorse)
{
  std::vector<Json> rows = Dicings();
  ASSERT_NE(BenchAlternative(rows, Relief), nullptr);
  EXPECT_EQ((*BenchAlternative(rows, Relief))["quality"], "low");
  // One figure that is worse rules a dicing out; one that was refused does not count.
  rows[1]["errors"]["mesh"]["silhouette_px_mean"] = 0.6;
  EXPECT_EQ((*BenchAlternative(rows, Relief))["quality"], "medium");
  rows[2]["status"] = "refused";
  EXPECT_EQ((*BenchAlternative(rows, Relief))["quality"], "high");
  rows[3]["errors"]["mesh"]["depth_p95"] = 0.3;
  EXPECT_EQ(BenchAlternative(rows, Relief), nullptr);
}

TEST(BenchDerived, ErrorAtATimeIsTheLeastThatTheTimeAllows)
{
  const std::vector<Json> rows = Dicings();
  std::vector<const Json*> pointers;
  for (const Json& row : rows)
  {
    pointers.push_back(&row);
  }
  EXPECT_EQ(MostExact(pointers, 4.), nullptr);
  EXPECT_EQ((*MostExact(pointers, 12.))["quality"], "low");
  EXPECT_EQ((*MostExact(pointers, 100.))["quality"], "medium");
  EXPECT_EQ((*MostExact(pointers))["quality"], "high");
}

TEST(BenchDerived, OrderIsThePowerOfTheWork)
{
  const auto order = BenchOrder(Dicings(), "tessellated", "texcoord_p95", "mesh");
  ASSERT_TRUE(order);
  EXPECT_NEAR(*order, 2., 1e-12);
  EXPECT_FALSE(BenchOrder(Dicings(), "relief", "texcoord_p95", "mesh"));
  EXPECT_FALSE(BenchOrder(Dicings(), "tessellated", "texcoord_p95", "smooth"));
  std::vector<Json> rows = Dicings();
  rows[3]["errors"]["mesh"]["texcoord_p95"] = 0.;
  EXPECT_FALSE(BenchOrder(rows, "tessellated", "texcoord_p95", "mesh"));
}

TEST(BenchDerived, BreakEvenIsWhereTheSumsMeet)
{
  // 0.2 s more to prepare, 8 ms less a frame: 25 frames.
  const auto frames = BenchBreakEven(Dicings()[1], Relief);
  ASSERT_TRUE(frames);
  EXPECT_NEAR(*frames, 25., 1e-9);
  EXPECT_FALSE(BenchBreakEven(Dicings()[2], Relief)); // slower a frame as well
  EXPECT_FALSE(BenchBreakEven(Relief, Dicings()[1])); // ahead from the start
}
