// `meso compare`: two files in, figures of error out.

#include "MesoAOVs.h"
#include "SceneFolder.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace
{
MesoRun Compare(const SceneFolder& scene, const std::string& truth, const std::string& test,
  const std::vector<std::string>& more = {})
{
  std::vector<std::string> arguments = { "compare", scene.PathOf(truth), scene.PathOf(test) };
  arguments.insert(arguments.end(), more.begin(), more.end());
  return RunMeso(arguments);
}

nlohmann::json Figures(const SceneFolder& scene, const std::string& truth, const std::string& test)
{
  const MesoRun run = Compare(scene, truth, test, { "--json" });
  EXPECT_EQ(run.ExitCode, 0) << run.Messages;
  EXPECT_EQ(run.Messages, "");
  return nlohmann::json::parse(run.Output, nullptr, false);
}

/// Refused by one line with these parts, by this exit code, and nothing is printed or written.
void ExpectRefusal(const SceneFolder& scene, const MesoRun& run, int exitCode,
  const std::vector<std::string>& parts, const std::vector<std::string>& filesBefore)
{
  EXPECT_EQ(run.ExitCode, exitCode);
  EXPECT_EQ(run.Output, "");
  EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
  for (const std::string& part : parts)
  {
    EXPECT_NE(run.Messages.find(part), std::string::npos) << part << "\nis not in\n"
                                                          << run.Messages;
  }
  EXPECT_EQ(scene.Names(), filesBefore);
}
}

TEST(MesoCompare, OfARenderingWithItself)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({ "--aov", "all" });
  const auto figures = Figures(scene, "x.png", "x.png");
  for (const char* zero :
    { "silhouette_px_mean", "silhouette_px_max", "depth_rms", "depth_p95", "depth_max",
      "texcoord_p50", "texcoord_p95", "texcoord_p99", "texcoord_max", "normal_mean", "normal_p95",
      "shadow_attached", "shadow_cast", "nan_pixels", "void_pixels", "extra_pixels", "hole_pixels",
      "boundary_pixels", "other_object_pixels", "flip_mean", "rmse" })
  {
    EXPECT_EQ(figures[zero], 0.) << zero;
  }
  EXPECT_EQ(figures["coverage_iou"], 1.);
  EXPECT_NEAR(figures["ssim"].get<double>(), 1., 1e-6);
  EXPECT_EQ(figures["depth_unit"], "D");
  EXPECT_EQ(figures["both_pixels"], 1600); // the plane is 40 x 40 pixels
}

TEST(MesoCompare, OfPlainWithReliefSeesWhatPlainLacks)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({ "--aov", "all" });
  scene.Render({ "--aov", "all", "--technique", "plain" }, "plain");
  const auto figures = Figures(scene, "x.png", "plain.png");
  EXPECT_EQ(figures["coverage_iou"], 1.);
  // Seen from the front the texture coordinates agree, and plain is too near by the relief.
  EXPECT_NEAR(figures["texcoord_max"].get<double>(), 0., 1e-3);
  const MesoExrImage relief = scene.AOVs({ "relief", "shadow.0" });
  double squares = 0.;
  double shadows = 0.;
  for (std::size_t i = 0; i < relief.Data.size(); i += 2)
  {
    squares += std::pow(relief.Data[i], 2);
    shadows += relief.Data[i + 1] >= 0.5f ? 1. : 0.;
  }
  EXPECT_NEAR(figures["depth_rms"].get<double>(), std::sqrt(squares / 1600.), 1e-4);
  EXPECT_GT(figures["normal_mean"], 1.);
  EXPECT_GT(figures["flip_mean"], 0.01);
  EXPECT_LT(figures["ssim"], 0.99);
  EXPECT_GT(figures["rmse"], 0.01);
  // Plain has no shadow where its facet faces the light, so all of relief's are wrong.
  const double attached = figures["shadow_attached"];
  const double cast = figures["shadow_cast"];
  EXPECT_GT(std::max(attached, cast), 0.);
  EXPECT_LE(std::min(attached, cast), shadows / 1600.);
  ASSERT_EQ(figures["objects"].size(), 1u);
  EXPECT_EQ(figures["objects"][0]["name"], "wall");
}

TEST(MesoCompare, FilesSayWhichPointAPixelShows)
{
  SceneFolder scene(BrickPlane);
  for (const bool parallel : { true, false })
  {
    const std::string name = parallel ? "parallel" : "perspective";
    if (!parallel)
    {
      std::ofstream(scene.PathOf("scene.json"))
        << R"({"meso": 1, "camera": {"position": [1, -2, 4], "focal_point": [0.2, 0.1, 0],
             "view_up": [0.3, 1, 0.1], "view_angle": 25}, )"
        << BrickPlane << "}";
    }
    scene.Render({ "--aov", "all", "--technique", "plain" }, name);
    const MesoAOVs aovs = MesoAOVsOfImage(MesoReadExr(scene.PathOf(name + ".aov.exr")));
    ASSERT_TRUE(aovs.Camera);
    int shown = 0;
    for (std::size_t pixel = 0; pixel < aovs.NumberOfPixels(); ++pixel)
    {
      if (aovs.Coverage[pixel] > 0.f)
      {
        // The plane is 2 x 2 around 0 at z = 0, with two tiles along each side.
        const auto point = aovs.PointAt(pixel);
        EXPECT_NEAR(point[0], aovs.Texcoord[0][pixel] - 1., 1e-4) << name << " " << pixel;
        EXPECT_NEAR(point[1], aovs.Texcoord[1][pixel] - 1., 1e-4) << name << " " << pixel;
        EXPECT_NEAR(point[2], 0., 1e-4) << name << " " << pixel;
        ++shown;
      }
    }
    EXPECT_GT(shown, 500);
  }
}

TEST(MesoCompare, FilesSayWhereLightsAre)
{
  SceneFolder scene(std::string(R"("lights": [{"type": "headlight"},
    {"type": "directional", "direction": [0, -3, -4]},
    {"type": "point", "position": [1, 2, 3]},
    {"type": "directional", "direction": [0, 0, -1], "coordinates": "camera"}], )") +
    BrickPlane);
  scene.Render({ "--aov", "coverage,shadow" });
  const MesoAOVs aovs = MesoAOVsOfImage(scene.AOVs());
  ASSERT_EQ(aovs.Lights.size(), 4u);
  const std::array<double, 3> expected[] = { { 0., 0., 1. }, { 0., 0.6, 0.8 }, { 1., 2., 3. },
    { 0., 0., 1. } };
  for (int light = 0; light < 4; ++light)
  {
    EXPECT_EQ(aovs.Lights[light].Positional, light == 2) << light;
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(aovs.Lights[light].Place[i], expected[light][i], 1e-9) << light;
    }
  }
}

TEST(MesoCompare, AnObjectsUnitIsThatOfItsMatrix)
{
  SceneFolder scene(R"("nodes": [{"transform": {"scale": [0.5, 2, 0.125]},
    "mesh": {"shape": "plane", "size": [2, 2]}}])");
  scene.Render({ "--aov", "coverage" });
  EXPECT_NEAR(
    std::get<double>(scene.AOVs().Attributes.at("meso.1.world_units")), std::cbrt(0.125), 1e-9);
}

TEST(MesoCompare, PrintsNamesNumbersAndUnits)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({ "--aov", "all" });
  const MesoRun geometry = Compare(scene, "x.aov.exr", "x.aov.exr");
  EXPECT_EQ(geometry.ExitCode, 0) << geometry.Messages;
  EXPECT_NE(geometry.Output.find("texcoord_p95         0            texel\n"), std::string::npos)
    << geometry.Output;
  EXPECT_EQ(geometry.Output.find("flip_mean"), std::string::npos) << "not known, so not printed";
  EXPECT_TRUE(Figures(scene, "x.aov.exr", "x.aov.exr")["flip_mean"].is_null());
}

TEST(MesoCompare, OfPicturesAlone)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render();
  scene.Render({ "--technique", "plain" }, "plain");
  const auto figures = Figures(scene, "x.png", "plain.png");
  EXPECT_GT(figures["flip_mean"], 0.01);
  EXPECT_TRUE(figures["coverage_iou"].is_null());
  EXPECT_TRUE(figures["hole_pixels"].is_null());
  EXPECT_EQ(figures.count("objects"), 0u);
}

TEST(MesoCompare, SaysWhereAOVsAreBesideOneOnly)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render();
  scene.Render({ "--aov", "all" }, "y");
  const MesoRun run = Compare(scene, "x.png", "y.png");
  EXPECT_EQ(run.ExitCode, 0);
  EXPECT_NE(run.Messages.find("x.aov.exr"), std::string::npos) << run.Messages;
  EXPECT_EQ(run.Output.find("coverage_iou"), std::string::npos);
}

TEST(MesoCompare, WritesPicturesOfErrors)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({ "--aov", "all" });
  scene.Render({ "--aov", "all", "--technique", "plain" }, "plain");
  const MesoRun run = Compare(scene, "x.png", "plain.png",
    { "--difference", scene.PathOf("d.png"), "--classes", scene.PathOf("c.png") });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  // Outside the plane nothing is covered and nothing differs.
  EXPECT_EQ(scene.Color(1, 1, "d"), (std::array<int, 3>{ 0, 0, 4 }));
  EXPECT_EQ(scene.Color(1, 1, "c"), (std::array<int, 3>{ 0, 0, 0 }));
  // In a joint plain is nearer.
  const MesoExrImage relief = scene.AOVs({ "relief" });
  const auto deepest = std::max_element(relief.Data.begin(), relief.Data.end());
  const int pixel = static_cast<int>(deepest - relief.Data.begin());
  const std::array<int, 3> nearer = { 90, 200, 255 };
  EXPECT_EQ(scene.Color(pixel % SceneFolder::Width, pixel / SceneFolder::Width, "c"), nearer);
}

TEST(MesoCompare, RefusesWithOneLine)
{
  SceneFolder scene(LitBrickPlane());
  scene.Render({ "--aov", "all" });
  ASSERT_EQ(RunMeso({ "render", scene.PathOf("scene.json"), "-o", scene.PathOf("small.png"),
                      "--size", "32x24" })
              .ExitCode,
    0);
  scene.Render({ "--aov", "coverage" }, "few");
  std::ofstream(scene.PathOf("bad.png")) << "no picture";
  const auto files = scene.Names();
  const std::string out = scene.PathOf("out.png");
  ExpectRefusal(
    scene, Compare(scene, "x.png", "none.png"), 1, { "none.png", "no such file" }, files);
  ExpectRefusal(scene, Compare(scene, "x.png", "bad.png"), 1, { "bad.png" }, files);
  ExpectRefusal(scene, Compare(scene, "x.png", "small.png", { "--difference", out }), 1,
    { "small.png", "32x24", "64x48" }, files);
  ExpectRefusal(scene, Compare(scene, "x.aov.exr", "few.aov.exr", { "--classes", out }), 1,
    { "few.aov.exr", "depth", "missing" }, files);
  ExpectRefusal(scene, Compare(scene, "x.png", "x.aov.exr"), 2, { "EXR" }, files);
  ExpectRefusal(scene, Compare(scene, "x.aov.exr", "x.aov.exr", { "--difference", out }), 2,
    { "--difference" }, files);
  ExpectRefusal(scene,
    Compare(scene, "x.png", "x.png", { "--difference", scene.PathOf("no/d.png") }), 1,
    { "no/d.png", "no folder" }, files);
  ExpectRefusal(
    scene, Compare(scene, "x.png", "x.png", { "--difference", "d.txt" }), 2, { ".png" }, files);
  ExpectRefusal(scene, Compare(scene, "x.png", "x.png", { "--difference", out, "--classes", out }),
    1, { "out.png", "two results" }, files);
  const std::string before = scene.Bytes("x.png");
  ExpectRefusal(scene, Compare(scene, "x.png", "few.png", { "--classes", scene.PathOf("x.png") }),
    1, { "x.png", "is read" }, files);
  EXPECT_EQ(scene.Bytes("x.png"), before);
  std::filesystem::remove(scene.PathOf("few.aov.exr"));
  const auto fewer = scene.Names();
  ExpectRefusal(scene, Compare(scene, "few.png", "few.png", { "--classes", out }), 1,
    { "classes need", "few.aov.exr" }, fewer);
}
