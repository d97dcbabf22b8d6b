// `meso render`: the same bytes each time, samples, options in place of the scene's, lights.

#include "SceneFolder.h"

#include <cmath>

namespace
{
using Rgb = std::array<int, 3>;

void ExpectColor(const Rgb& color, const Rgb& expected)
{
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(color[i], expected[i], 1) << "channel " << i;
  }
}
}

TEST(MesoRenderPicture, IsTheSameEachTime)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({ "--samples", "2", "--aov", "all" }, "x");
  scene.Render({ "--samples", "2", "--aov", "all" }, "y");
  ASSERT_FALSE(scene.Bytes("x.png").empty());
  EXPECT_EQ(scene.Bytes("x.png"), scene.Bytes("y.png"));
  ASSERT_FALSE(scene.Bytes("x.aov.exr").empty());
  EXPECT_EQ(scene.Bytes("x.aov.exr"), scene.Bytes("y.aov.exr"));
  // AOVs have one sample, whatever the picture has.
  scene.Render({ "--aov", "all" }, "one");
  EXPECT_NE(scene.Bytes("x.png"), scene.Bytes("one.png"));
  EXPECT_EQ(scene.Bytes("x.aov.exr"), scene.Bytes("one.aov.exr"));
}

TEST(MesoRenderPicture, SamplesSmoothIt)
{
  // A bright square turned by 20 degrees: its edge crosses pixels.
  SceneFolder scene(R"("lights": [], "nodes": [{"transform": {"rotate": [20, 0, 0, 1]},
    "mesh": {"shape": "plane"}}])");
  scene.Render({}, "one");
  scene.Render({ "--samples", "4" }, "four");
  const MesoImageDifference difference = scene.Compare("four", "one");
  EXPECT_GT(difference.SmallPixels, 20);
  EXPECT_LT(difference.SmallPixels, 150) << "more than the edge's pixels";
  int grey = 0;
  double sums[] = { 0., 0. };
  for (int row = 0; row < SceneFolder::Height; ++row)
  {
    for (int column = 0; column < SceneFolder::Width; ++column)
    {
      const int one = scene.Color(column, row, "one")[0];
      const int four = scene.Color(column, row, "four")[0];
      EXPECT_TRUE(one == 0 || one == 255) << one;
      EXPECT_NEAR(four, 63.75 * std::round(four / 63.75), 0.51) << "no quarter of 255";
      grey += four > 0 && four < 255 ? 1 : 0;
      sums[0] += one / 255.;
      sums[1] += four / 255.;
    }
  }
  EXPECT_GT(grey, 20);
  // The samples lie around the pixel's centre, so that the square is as large as before.
  EXPECT_NEAR(sums[0], 400., 8.);
  EXPECT_NEAR(sums[1], 400., 8.);
}

TEST(MesoRenderPicture, TechniqueTakesThePlaceOfTheScenes)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({}, "scene");
  scene.Render({ "--technique", "plain" }, "plain");
  EXPECT_GT(scene.Compare("plain", "scene").SmallPixels, 300);
  // A plane under a directional light has one color.
  EXPECT_EQ(scene.Color(15, 10, "plain"), scene.Color(40, 30, "plain"));
}

TEST(MesoRenderPicture, QualityTakesThePlaceOfTheScenes)
{
  SceneFolder scene(BrickPlane); // medium
  scene.Render({ "--aov", "iterations" }, "scene");
  scene.Render({ "--quality", "draft", "--aov", "iterations" }, "draft");
  const auto most = [&](const char* name)
  {
    const MesoExrImage image = scene.AOVs({ "iterations" }, name);
    return *std::max_element(image.Data.begin(), image.Data.end());
  };
  EXPECT_LE(most("draft"), 16.f + 5.f);
  EXPECT_GT(most("draft"), 10.f);
  EXPECT_LE(most("scene"), 64.f + 7.f);
  EXPECT_GT(most("scene"), 40.f);
}

TEST(MesoRenderPicture, EffectsTakeThePlaceOfTheScenes)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({}, "scene");
  scene.Render({ "--effects", "occlusion,depth,self_shadow,shading" }, "named");
  scene.Render({ "--effects", "none" }, "none");
  scene.Render({ "--effects", "shading" }, "shading");
  EXPECT_TRUE(scene.Compare("named", "scene").Within);
  EXPECT_EQ(scene.Color(15, 10, "none"), scene.Color(40, 30, "none"));
  EXPECT_GT(scene.Compare("shading", "none").SmallPixels, 300);
  EXPECT_GT(scene.Compare("shading", "scene").SmallPixels, 100) << "no shadows in the scene";
}

TEST(MesoRenderPicture, EachEffectAloneIsLit)
{
  // Pixel (22, 30) lies on the flat top of a stripe, out of all shadow.
  SceneFolder scene(R"("lights": [{"type": "directional", "direction": [1, -0.6, -0.6]}],
    "nodes": [{"mesh": {"shape": "plane", "size": [2, 2]},
      "mesostructure": {"technique": "relief", "scale": 0.1,
                        "height_map": {"pattern": "step", "size": [64, 64]}}}])");
  scene.Render({ "--technique", "plain" }, "plain");
  const std::array<int, 3> plain = scene.Color(22, 30, "plain");
  EXPECT_GT(plain[0], 50);
  for (const char* effect : { "shading", "occlusion", "self_shadow", "depth" })
  {
    scene.Render({ "--effects", effect }, effect);
    ExpectColor(scene.Color(22, 30, effect), plain);
  }
}

TEST(MesoRenderPicture, WithoutLightsIsAmbientAndDiffuseAtFull)
{
  SceneFolder scene(R"("lights": [], "background": [0.2, 0.4, 0.6],
    "nodes": [{"mesh": {"shape": "plane"},
               "material": {"color": [0.8, 0.5, 0.4], "ambient": 0.25, "diffuse": 0.5}}])");
  scene.Render();
  ExpectColor(scene.Color(32, 24), { 153, 96, 77 }); // 0.75 of the color
  ExpectColor(scene.Color(0, 0), { 51, 102, 153 });
}

TEST(MesoRenderPicture, WithoutLightsReliefIsFlatColor)
{
  SceneFolder scene(std::string(R"("lights": [], )") + BrickPlane);
  scene.Render();
  for (int column = 15; column < 50; ++column)
  {
    ExpectColor(scene.Color(column, 20), { 204, 128, 102 });
  }
}

TEST(MesoRenderPicture, WithoutALightsKeyHasAHeadlight)
{
  SceneFolder scene(R"("nodes": [{"mesh": {"shape": "plane"},
                                  "material": {"color": [0.8, 0.5, 0.4]}}])");
  scene.Render();
  ExpectColor(scene.Color(32, 24), { 204, 128, 102 }); // it shines along the normal
}
