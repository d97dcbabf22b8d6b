// `meso render --aov`: every pixel's numbers in a file beside the picture.

#include "SceneFolder.h"

#include <cmath>

namespace
{
const std::vector<std::string> AllOfOneLight = { "coverage", "depth", "fetches", "iterations",
  "normal.x", "normal.y", "normal.z", "object", "relief", "shadow.0", "texcoord.u", "texcoord.v",
  "texel_reads" };

std::vector<std::string> Sorted(std::vector<std::string> names)
{
  std::sort(names.begin(), names.end());
  return names;
}
}

TEST(MesoRenderAOVs, AreWrittenOnlyWhereAsked)
{
  SceneFolder scene(BrickPlane);
  scene.Render();
  EXPECT_EQ(scene.Names(), (std::vector<std::string>{ "scene.json", "x.png" }));
}

TEST(MesoRenderAOVs, HaveAShadowForEachLight)
{
  SceneFolder scene(std::string(R"("lights": [{"type": "headlight"},
    {"type": "directional", "direction": [1, 0, -1]}, {"type": "point", "position": [0, 1, 1]}], )") +
    BrickPlane);
  scene.Render({ "--aov", "shadow" });
  EXPECT_EQ(Sorted(scene.AOVs().ChannelNames),
    (std::vector<std::string>{ "shadow.0", "shadow.1", "shadow.2" }));
}

TEST(MesoRenderAOVs, GroupsGiveJustTheirChannels)
{
  SceneFolder scene(BrickPlane);
  scene.Render({ "--aov", "depth,texcoord" });
  EXPECT_EQ(Sorted(scene.AOVs().ChannelNames),
    (std::vector<std::string>{ "depth", "texcoord.u", "texcoord.v" }));
  scene.Render({ "--aov", "fetches" });
  EXPECT_EQ(
    Sorted(scene.AOVs().ChannelNames), (std::vector<std::string>{ "fetches", "texel_reads" }));
}

TEST(MesoRenderAOVs, AttributesDescribeTheObject)
{
  SceneFolder scene(BrickPlane);
  scene.Render({ "--aov", "coverage" });
  const auto attributes = scene.AOVs().Attributes;
  for (const char* name :
    { "meso.1.name", "meso.1.scale", "meso.1.map_width", "meso.1.map_height" })
  {
    ASSERT_EQ(attributes.count(name), 1u) << name;
  }
  EXPECT_EQ(attributes.at("meso.1.name"), MesoImageAttribute(std::string("wall")));
  EXPECT_NEAR(std::get<double>(attributes.at("meso.1.scale")), 0.1, 1e-7);
  EXPECT_EQ(std::get<double>(attributes.at("meso.1.map_width")), 128.);
  EXPECT_EQ(std::get<double>(attributes.at("meso.1.map_height")), 64.);
}

TEST(MesoRenderAOVs, OfReliefSeenFromTheFront)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({ "--aov", "all" });
  EXPECT_EQ(scene.Names(), (std::vector<std::string>{ "scene.json", "x.aov.exr", "x.png" }));
  ASSERT_EQ(Sorted(scene.AOVs().ChannelNames), AllOfOneLight);
  const MesoExrImage image = scene.AOVs(AllOfOneLight);
  ASSERT_EQ(image.Width, SceneFolder::Width);
  ASSERT_EQ(image.Height, SceneFolder::Height);
  int deep = 0;
  int shadowed = 0;
  for (int row = 0; row < image.Height; ++row)
  {
    for (int column = 0; column < image.Width; ++column)
    {
      const auto value = [&](const char* channel)
      {
        const auto at = std::find(AllOfOneLight.begin(), AllOfOneLight.end(), channel);
        return double(image.At(column, row, at - AllOfOneLight.begin()));
      };
      const double x = SceneFolder::X(column);
      const double y = SceneFolder::Y(row);
      if (std::abs(x) > 1. || std::abs(y) > 1.)
      {
        for (const std::string& channel : AllOfOneLight)
        {
          ASSERT_EQ(value(channel.c_str()), 0.) << channel << " at " << column << ", " << row;
        }
        continue;
      }
      ASSERT_EQ(value("coverage"), 1.) << column << ", " << row;
      EXPECT_EQ(value("object"), 1.);
      EXPECT_NEAR(value("texcoord.u"), x + 1., 1e-5);
      EXPECT_NEAR(value("texcoord.v"), y + 1., 1e-5);
      EXPECT_NEAR(value("depth"), 5. + 0.1 * value("relief"), 1e-4);
      EXPECT_NEAR(std::hypot(value("normal.x"), value("normal.y"), value("normal.z")), 1., 1e-5);
      EXPECT_GT(value("fetches"), 0.);
      EXPECT_GE(value("texel_reads"), value("fetches"));
      deep += value("relief") > 0.7 ? 1 : 0;
      shadowed += value("shadow.0") > 0.5 ? 1 : 0;
    }
  }
  EXPECT_GT(deep, 50) << "no joints between the bricks";
  EXPECT_GT(shadowed, 50) << "nothing in shadow";
  EXPECT_LT(shadowed, 1000) << "nothing lit";
}
