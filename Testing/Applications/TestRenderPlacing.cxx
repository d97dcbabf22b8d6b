// Where nodes lie in the picture, and which of two objects is in front.

#include "SceneFolder.h"

#include <cmath>

namespace
{
/// Calls check(column, row, x, y) for each pixel.
template <typename Check>
void ForPixels(Check check)
{
  for (int row = 0; row < SceneFolder::Height; ++row)
  {
    for (int column = 0; column < SceneFolder::Width; ++column)
    {
      check(column, row, SceneFolder::X(column), SceneFolder::Y(row));
    }
  }
}

// A wall with one step, 0.4 deep where x is between 0 and 1, and a plain one 0.2 behind its front.
const char* const StepBeforePlane = R"("lights": [], "nodes": [
  {"name": "step", "mesh": {"shape": "plane", "size": [2, 2]},
   "material": {"color": [1, 0, 0]},
   "mesostructure": {"technique": "relief", "scale": 0.4,
                     "height_map": {"pattern": "step", "size": [128, 1]}}},
  {"name": "plain", "mesh": {"shape": "plane", "size": [2, 2]},
   "transform": {"translate": [0, 0, -0.2]},
   "material": {"color": [0, 1, 0]}}])";

// Where the step's ramps, each a texel wide, are not.
bool AwayFromRamps(double x)
{
  return std::abs(x) < 0.96 && std::abs(x) > 0.04;
}
}

TEST(MesoRenderPlacing, ChildrenMoveWithTheirParent)
{
  // The child's x goes to 2 x + 0.3 and its z to z + 1; then the parent turns x to y and moves.
  SceneFolder scene(R"("lights": [], "nodes": [
    {"name": "parent", "transform": {"translate": [0.5, 0.25, 0], "rotate": [90, 0, 0, 1]},
     "children": [
       {"name": "child", "mesh": {"shape": "plane", "size": [0.4, 0.2]},
        "transform": {"matrix": [2, 0, 0, 0.3,  0, 1, 0, 0,  0, 0, 1, 1,  0, 0, 0, 1]}}]}])");
  scene.Render({ "--aov", "coverage,depth,texcoord" });
  const MesoExrImage image = scene.AOVs({ "coverage", "depth", "texcoord.u", "texcoord.v" });
  int covered = 0;
  ForPixels(
    [&](int column, int row, double x, double y)
    {
      const bool inside = x > 0.4 && x < 0.6 && y > 0.15 && y < 0.95;
      ASSERT_EQ(image.At(column, row, 0), inside ? 1.f : 0.f) << x << ", " << y;
      EXPECT_EQ(scene.Color(column, row)[0], inside ? 255 : 0);
      if (inside)
      {
        ++covered;
        EXPECT_NEAR(image.At(column, row, 1), 4., 1e-5);
        EXPECT_NEAR(image.At(column, row, 2), (y - 0.15) / 0.8, 1e-5);
        EXPECT_NEAR(image.At(column, row, 3), (0.6 - x) / 0.2, 1e-5);
      }
    });
  EXPECT_EQ(covered, 64);
}

TEST(MesoRenderPlacing, ReliefScalesWithItsNode)
{
  SceneFolder scene(R"("nodes": [{"transform": {"scale": 2}, "children": [
    {"transform": {"scale": [1, 1, 3]}, "mesh": {"shape": "plane"},
     "mesostructure": {"technique": "relief", "scale": 0.1,
                       "height_map": {"pattern": "step", "size": [128, 1]}}}]}])");
  scene.Render({ "--aov", "coverage,depth" });
  const MesoExrImage image = scene.AOVs({ "coverage", "depth" });
  ForPixels(
    [&](int column, int row, double x, double y)
    {
      const bool inside = std::abs(x) < 1. && std::abs(y) < 1.;
      ASSERT_EQ(image.At(column, row, 0), inside ? 1.f : 0.f);
      if (inside && AwayFromRamps(x))
      {
        EXPECT_NEAR(image.At(column, row, 1), x < 0. ? 5. : 5.6, 1e-4);
      }
    });
}

TEST(MesoRenderPlacing, ObjectBehindReliefShowsWhereItIsDeep)
{
  SceneFolder scene(StepBeforePlane);
  scene.Render({ "--aov", "object,depth" });
  const MesoExrImage image = scene.AOVs({ "object", "depth" });
  ForPixels(
    [&](int column, int row, double x, double y)
    {
      if (std::abs(x) > 1. || std::abs(y) > 1.)
      {
        EXPECT_EQ(image.At(column, row, 0), 0.f);
      }
      else if (AwayFromRamps(x))
      {
        EXPECT_EQ(image.At(column, row, 0), x < 0. ? 1.f : 2.f);
        EXPECT_NEAR(image.At(column, row, 1), x < 0. ? 5. : 5.2, 1e-4);
        const std::array<int, 3> color = scene.Color(column, row);
        EXPECT_EQ(
          color, (x < 0. ? std::array<int, 3>{ 255, 0, 0 } : std::array<int, 3>{ 0, 255, 0 }));
      }
    });
}

TEST(MesoRenderPlacing, WithoutTheDepthEffectTheBaseHidesWhatIsBehind)
{
  SceneFolder scene(StepBeforePlane);
  scene.Render({ "--aov", "object", "--effects", "occlusion,shading" });
  const MesoExrImage image = scene.AOVs({ "object" });
  ForPixels(
    [&](int column, int row, double x, double y)
    {
      if (std::abs(x) < 1. && std::abs(y) < 1.)
      {
        EXPECT_EQ(image.At(column, row, 0), 1.f);
      }
    });
}
