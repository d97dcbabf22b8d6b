// `meso bench`: a tiny sweep, what it leaves, and how it goes on after an interruption.

#include "SceneFolder.h"

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace
{
using Json = nlohmann::json;

MesoRun Bench(const SceneFolder& scene, const std::vector<std::string>& more = {},
  const std::string& file = "scene.json")
{
  std::vector<std::string> arguments = { "bench", scene.PathOf(file), "-o", scene.PathOf("out"),
    "--quick", "--size", "64x48", "--techniques", "plain,relief", "--qualities", "draft,high" };
  arguments.insert(arguments.end(), more.begin(), more.end());
  return RunMeso(arguments);
}

Json Results(const SceneFolder& scene)
{
  return Json::parse(scene.Bytes("out/results.json"), nullptr, false);
}

/// The row of a technique in a quality; null where there is none.
Json Row(const Json& results, const std::string& technique, const std::string& quality)
{
  for (const Json& row : results["rows"])
  {
    if (row["technique"] == technique && row["quality"] == quality)
    {
      return row;
    }
  }
  return {};
}

std::vector<std::string> Lines(const std::string& text)
{
  std::vector<std::string> lines(1);
  for (const char letter : text)
  {
    if (letter == '\n')
    {
      lines.emplace_back();
      continue;
    }
    lines.back() += letter;
  }
  lines.pop_back();
  return lines;
}

/// A sphere: its smooth shape is another surface than its mesh.
const char* const BrickSphere =
  R"("lights": [{"type": "directional", "direction": [1, -0.6, -0.6]}],
  "nodes": [{"mesh": {"shape": "sphere", "radius": 1, "rings": 12, "sides": 24},
  "mesostructure": {"technique": "plain", "scale": 0.05, "tiles": [8, 4],
                    "height_map": {"pattern": "brick", "size": [64, 64]}}}])";
}

TEST(MesoBench, LeavesTablesPlotsAndAReport)
{
  const SceneFolder scene(BrickSphere);
  const MesoRun run = Bench(scene);
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  EXPECT_EQ(run.Messages, "");
  EXPECT_EQ(run.Output, "");

  const Json results = Results(scene);
  ASSERT_EQ(results["scenes"].size(), 1u);
  EXPECT_EQ(results["scenes"][0]["scene"], "scene");
  EXPECT_EQ(results["scenes"][0]["truths"], (Json{ "mesh", "smooth" }));
  EXPECT_GT(results["scenes"][0]["surfaces"]["depth_p95"], 0.);
  EXPECT_FALSE(results["device"].get<std::string>().empty());
  ASSERT_EQ(results["rows"].size(), 3u);
  for (const Json& row : results["rows"])
  {
    EXPECT_EQ(row["status"], "ok");
    EXPECT_EQ(row["size"], (Json{ 64, 48 }));
    EXPECT_EQ(row["judged_by"], "mesh");
    EXPECT_GE(row["gpu_ms"]["max"], row["gpu_ms"]["median"]);
    EXPECT_GE(row["gpu_ms"]["median"], row["gpu_ms"]["min"]);
    EXPECT_GT(row["frame_ms"]["min"], 0.);
    EXPECT_EQ(row["runs"], 7);
    EXPECT_GT(row["gpu_bytes"], 0);
    EXPECT_EQ(row["triangles"], 2 * 24 * 11); // quads but at the poles
    for (const char* surface : { "mesh", "smooth" })
    {
      EXPECT_GT(row["errors"][surface]["both_pixels"], 500) << surface;
      EXPECT_GT(row["errors"][surface]["flip_mean"], 0.) << surface;
      EXPECT_EQ(row["errors"][surface]["nan_pixels"], 0) << surface;
    }
  }
  const Json plain = Row(results, "plain", "");
  const Json draft = Row(results, "relief", "draft");
  const Json high = Row(results, "relief", "high");
  EXPECT_EQ(plain["fetches_mean"], 0.);
  EXPECT_GT(draft["fetches_mean"], 1.);
  EXPECT_GT(high["fetches_mean"], draft["fetches_mean"]);
  // What plain draws is its model; relief has one that is solved apart from it.
  EXPECT_EQ(plain["errors"].count("solver"), 0u);
  EXPECT_LT(
    high["errors"]["solver"]["texcoord_p95"], 0.1 * double(high["errors"]["mesh"]["texcoord_p95"]));
  EXPECT_GE(draft["errors"]["solver"]["texcoord_p99"], high["errors"]["solver"]["texcoord_p99"]);
  EXPECT_TRUE(high["errors"]["solver"]["flip_mean"].is_null());
  const auto texels = [](const Json& row) -> double
  { return row["errors"]["mesh"]["texcoord_p95"]; };
  EXPECT_GT(texels(plain), 2. * texels(high));
  EXPECT_GT(plain["errors"]["mesh"]["flip_mean"], 2. * double(high["errors"]["mesh"]["flip_mean"]));
  // The mesh hides the truth of the shape: relief on the mesh is nearer to the mesh's truth.
  EXPECT_GT(high["errors"]["smooth"]["depth_rms"], high["errors"]["mesh"]["depth_rms"]);
}

TEST(MesoBench, TablesAreWholeAndTheReportStandsByItself)
{
  const SceneFolder scene(BrickSphere);
  ASSERT_EQ(Bench(scene).ExitCode, 0);
  const std::vector<std::string> lines = Lines(scene.Bytes("out/results.csv"));
  ASSERT_EQ(lines.size(), 1u + 3 * 2 + 2) << "a head, each row by two truths, relief by its model";
  for (const std::string& line : lines)
  {
    // No text of this table holds a comma but the clock's, which is quoted.
    const std::string unquoted = std::regex_replace(line, std::regex("\"[^\"]*\""), "");
    EXPECT_EQ(std::count(unquoted.begin(), unquoted.end(), ','),
      std::count(lines[0].begin(), lines[0].end(), ','))
      << line;
  }
  EXPECT_EQ(
    lines[0].rfind("scene,technique,quality,search,status,reason,width,height,surface,", 0), 0u);

  const std::string page = scene.Bytes("out/report.html");
  EXPECT_EQ(page.find("http"), std::string::npos) << "nothing comes from elsewhere";
  const std::regex link("(?:src|href)=\"([^\"#]+)\"");
  std::set<std::string> linked;
  for (std::sregex_iterator match(page.begin(), page.end(), link), end; match != end; ++match)
  {
    linked.insert((*match)[1]);
    EXPECT_FALSE(scene.Bytes("out/" + (*match)[1].str()).empty()) << (*match)[1];
  }
  for (const char* file : { "results.csv", "results.json", "scene/texcoord_p95-mesh.png",
         "scene/flip_mean-smooth.png", "scene/relief-high.png", "scene/plain-worst.png" })
  {
    EXPECT_EQ(linked.count(file), 1u) << file;
  }
}

TEST(MesoBench, PicturesShowWhatTheySay)
{
  SceneFolder scene(BrickSphere);
  ASSERT_EQ(Bench(scene).ExitCode, 0);
  // In the strip the truth comes first, then the technique, each 64 wide and 4 apart.
  scene.Render({ "--technique", "relief", "--quality", "high" });
  for (const int column : { 3, 25, 32, 40 })
  {
    EXPECT_EQ(
      scene.Color(64 + 4 + column, 24, "out/scene/relief-high"), scene.Color(column, 24, "x"));
    EXPECT_EQ(scene.Color(column, 24, "out/scene/relief-high"),
      scene.Color(column, 24, "out/scene/truth-mesh"));
  }
  // The plot has the curve of relief in its colour, and the one of plain.
  std::set<std::array<int, 3>> colors;
  for (int row = 0; row < 520; ++row)
  {
    for (int column = 0; column < 720; ++column)
    {
      colors.insert(scene.Color(column, row, "out/scene/texcoord_p95-mesh"));
    }
  }
  EXPECT_EQ(colors.count({ 255, 255, 255 }), 1u);
  EXPECT_EQ(colors.count({ 86, 180, 233 }), 1u) << "relief";
  EXPECT_EQ(colors.count({ 60, 60, 60 }), 1u) << "plain";
}

TEST(MesoBench, SearchesAreRowsOfTheirOwn)
{
  const SceneFolder scene(BrickPlane);
  const auto labelsOf = [](const Json& results)
  {
    std::vector<std::string> labels;
    for (const Json& row : results["rows"])
    {
      EXPECT_EQ(row["status"], "ok") << row;
      labels.push_back(row["technique"].get<std::string>() + " " +
        row["quality"].get<std::string>() + " " + row["search"].get<std::string>());
    }
    return labels;
  };
  ASSERT_EQ(Bench(scene, { "--searches", "cone,certified" }).ExitCode, 0);
  const Json results = Results(scene);
  EXPECT_EQ(labelsOf(results),
    (std::vector<std::string>{ "plain  ", "relief draft cone", "relief draft certified",
      "relief high cone", "relief high certified" }));
  const auto errorOf = [&](std::size_t row)
  { return results["rows"][row]["errors"]["solver"]["texcoord_p99"].get<double>(); };
  EXPECT_EQ(errorOf(2), errorOf(4)) << "certified draws one picture in every quality";
  EXPECT_LE(errorOf(2), errorOf(1));
  EXPECT_LT(errorOf(2), 0.01);
  EXPECT_NE(scene.Bytes("out/report.html").find("relief draft cone"), std::string::npos);

  // The quality certified takes no other search than its own; plain has none.
  ASSERT_EQ(RunMeso({ "bench", scene.PathOf("scene.json"), "-o", scene.PathOf("out"), "--quick",
                      "--fresh", "--size", "64x48", "--techniques", "plain,relief", "--qualities",
                      "certified", "--searches", "cone,certified" })
              .ExitCode,
    0);
  EXPECT_EQ(labelsOf(Results(scene)),
    (std::vector<std::string>{ "plain  ", "relief certified certified" }));
  EXPECT_EQ(Bench(scene, { "--searches", "binary" }).ExitCode, 2);
}

TEST(MesoBench, GoesOnWhereItStopped)
{
  const SceneFolder scene(BrickPlane);
  ASSERT_EQ(Bench(scene).ExitCode, 0);
  const Json first = Results(scene);
  const std::string csv = scene.Bytes("out/results.csv");
  ASSERT_EQ(Bench(scene).ExitCode, 0);
  EXPECT_EQ(Results(scene), first) << "nothing is measured again";
  EXPECT_EQ(scene.Bytes("out/results.csv"), csv);

  // As after an interruption: one row is not there yet.
  Json cut = first;
  cut["rows"].erase(cut["rows"].size() - 1);
  std::ofstream(scene.PathOf("out/results.json")) << cut;
  ASSERT_EQ(Bench(scene).ExitCode, 0);
  const Json again = Results(scene);
  ASSERT_EQ(again["rows"].size(), 3u);
  EXPECT_EQ(again["rows"][0], first["rows"][0]);
  EXPECT_EQ(again["rows"][1], first["rows"][1]);
  EXPECT_EQ(again["rows"][2]["errors"], first["rows"][2]["errors"]);
  EXPECT_NE(again["rows"][2]["frame_ms"], first["rows"][2]["frame_ms"]) << "not measured";

  // Other numbers of the scene make all of it new, and take the old rows' place.
  std::string text = scene.Bytes("scene.json");
  text.replace(text.find("0.1"), 3, "0.2");
  std::ofstream(scene.PathOf("scene.json")) << text;
  ASSERT_EQ(Bench(scene).ExitCode, 0);
  const Json other = Results(scene);
  EXPECT_EQ(other["rows"].size(), 3u);
  EXPECT_EQ(other["scenes"].size(), 1u);
  EXPECT_NE(Row(other, "plain", "")["errors"], Row(first, "plain", "")["errors"]);

  // --fresh measures what is there.
  ASSERT_EQ(Bench(scene, { "--fresh" }).ExitCode, 0);
  EXPECT_NE(Row(Results(scene), "plain", "")["frame_ms"], Row(other, "plain", "")["frame_ms"]);
}

TEST(MesoBench, WhatIsRefusedIsARowWithTheReason)
{
  std::string lights;
  for (int i = 0; i < 13; ++i) // one more than AOVs hold
  {
    lights += std::string(i ? ", " : "") + R"({"type": "directional", "direction": [0, 0, -1],
      "intensity": 0.1})";
  }
  const SceneFolder scene("\"lights\": [" + lights + "], " + BrickPlane);
  const MesoRun run = Bench(scene);
  EXPECT_EQ(run.ExitCode, 0) << run.Messages;
  const Json results = Results(scene);
  ASSERT_EQ(results["rows"].size(), 3u);
  for (const Json& row : results["rows"])
  {
    EXPECT_EQ(row["status"], "refused");
    EXPECT_NE(row["reason"].get<std::string>().find("lights"), std::string::npos);
  }
  EXPECT_NE(scene.Bytes("out/report.html").find("refused: "), std::string::npos);
  EXPECT_EQ(Lines(scene.Bytes("out/results.csv")).size(), 4u);
}

TEST(MesoBench, ASceneWithoutATruthFailsAndTheOthersGoOn)
{
  const SceneFolder scene(BrickPlane);
  std::ofstream(scene.PathOf("glass.json"))
    << R"({"meso": 1, "nodes": [{"name": "pane", "mesh": {"shape": "plane"},
         "material": {"opacity": 0.5}}]})";
  const MesoRun run = Bench(scene, { scene.PathOf("scene.json") }, "glass.json");
  EXPECT_EQ(run.ExitCode, 1);
  EXPECT_EQ(Lines(run.Messages).size(), 1u) << run.Messages;
  EXPECT_NE(run.Messages.find("glass: "), std::string::npos) << run.Messages;
  EXPECT_NE(run.Messages.find("pane"), std::string::npos) << run.Messages;
  const Json results = Results(scene);
  ASSERT_EQ(results["scenes"].size(), 2u);
  EXPECT_EQ(results["scenes"][0]["status"], "failed");
  EXPECT_EQ(results["scenes"][1]["status"], "ok");
  EXPECT_EQ(results["rows"].size(), 3u);
}

TEST(MesoBench, RefusesWithOneLine)
{
  const SceneFolder scene(BrickPlane);
  const auto expect = [&](const MesoRun& run, int exitCode, const std::string& part)
  {
    EXPECT_EQ(run.ExitCode, exitCode);
    EXPECT_EQ(Lines(run.Messages).size(), 1u) << run.Messages;
    EXPECT_NE(run.Messages.find(part), std::string::npos) << part << "\nis not in\n"
                                                          << run.Messages;
  };
  expect(Bench(scene, {}, "none.json"), 1, "none.json");
  expect(RunMeso({ "bench", scene.PathOf("scene.json"), "-o", scene.PathOf("out"), "--techniques",
           "magic" }),
    2, "magic");
  expect(RunMeso({ "bench", scene.PathOf("scene.json"), "-o", scene.PathOf("out"), "--qualities",
           "best" }),
    2, "best");
  expect(RunMeso({ "bench", scene.PathOf("scene.json") }), 2, "output");
  expect(Bench(scene, { scene.PathOf("scene.json") }), 1, "another scene");
  EXPECT_EQ(scene.Names(), (std::vector<std::string>{ "scene.json" }));
  expect(RunMeso({ "bench", scene.PathOf("scene.json"), "-o", scene.PathOf("scene.json/x") }), 1,
    "cannot be made");
  std::filesystem::create_directory(scene.PathOf("out"));
  std::ofstream(scene.PathOf("out/results.json")) << "{\"other\": 1}";
  expect(Bench(scene), 1, "results.json");
  EXPECT_EQ(scene.Bytes("out/results.json"), "{\"other\": 1}");
}

TEST(MesoBench, AblationShowsWhatEachEffectIsWorth)
{
  // Deep, on a mesh that is close to its smooth shape, lit from the side: all effects matter.
  const SceneFolder scene(R"("lights": [{"type": "directional", "direction": [1, -0.6, -0.3]}],
    "nodes": [{"mesh": {"shape": "sphere", "rings": 48, "sides": 96},
      "mesostructure": {"technique": "relief", "scale": 0.12, "tiles": [8, 4],
                        "height_map": {"pattern": "smooth", "size": [64, 64]}}}])");
  const MesoRun run = RunMeso(
    { "bench", scene.PathOf("scene.json"), "-o", scene.PathOf("out"), "--quick", "--size", "96x72",
      "--techniques", "relief-quadric,tessellated", "--qualities", "draft", "--ablation" });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  const Json results = Results(scene);
  std::map<std::string, Json> without;
  for (const Json& row : results["ablations"])
  {
    without[row["technique"].get<std::string>() + " " + row["without"].get<std::string>()] = row;
  }
  EXPECT_EQ(without.size(), 8u + 6u); // none, and each effect
  const auto error = [&](const std::string& effect, const char* figure) -> double
  {
    const Json& row = without["relief-quadric " + effect];
    return row["errors"][row["judged_by"].get<std::string>()][figure];
  };
  // Each effect off makes its own figure worse.
  EXPECT_GT(error("shading", "normal_mean"), 1.5 * error("none", "normal_mean"));
  EXPECT_GT(error("occlusion", "texcoord_p95"), 1.5 * error("none", "texcoord_p95"));
  EXPECT_GT(error("self_shadow", "shadow_cast"), error("none", "shadow_cast"));
  EXPECT_LT(error("silhouette", "coverage_iou"), error("none", "coverage_iou"));
  EXPECT_LT(error("curvature", "coverage_iou"), error("none", "coverage_iou"));
  EXPECT_EQ(without["tessellated depth"]["status"], "refused");
  EXPECT_NE(scene.Bytes("out/report.html").find("What each effect is worth"), std::string::npos);
}

TEST(MesoBench, ScalingMeasuresEachSeries)
{
  const SceneFolder scene(BrickSphere);
  std::vector<std::string> arguments = { "bench", scene.PathOf("scene.json"), "-o",
    scene.PathOf("out"), "--quick", "--size", "64x48", "--qualities", "draft", "--scaling",
    "--techniques", "relief" };
  ASSERT_EQ(RunMeso(arguments).ExitCode, 0);
  const Json series = Results(scene)["scaling"]["series"];
  EXPECT_EQ(series.size(), 4u * 2u); // relief and the floor
  for (const Json& one : series)
  {
    EXPECT_EQ(one["points"].size(), 3u);
    EXPECT_LT(one["points"][0][0], one["points"][2][0]);
    EXPECT_TRUE(one["ns_per_unit"].is_number());
  }
  // Results of the same settings are kept.
  ASSERT_EQ(RunMeso(arguments).ExitCode, 0);
  EXPECT_EQ(Results(scene)["scaling"]["series"], series);
  // Those of other techniques are not.
  arguments.back() = "relief-quadric";
  ASSERT_EQ(RunMeso(arguments).ExitCode, 0);
  const Json others = Results(scene)["scaling"]["series"];
  EXPECT_EQ(others.size(), series.size());
  for (const Json& one : others)
  {
    EXPECT_TRUE(one["technique"] == "plain" || one["technique"] == "relief-quadric") << one;
  }
}

TEST(MesoBench, MakesABrokenTruthAgain)
{
  const SceneFolder scene(BrickSphere);
  ASSERT_EQ(Bench(scene).ExitCode, 0);
  const std::string before = scene.Bytes("out/scene/truth-mesh.png");
  for (const char* file : { "truth-mesh.png", "truth-smooth.aov.exr" })
  {
    std::ofstream(scene.PathOf(std::string("out/scene/") + file)) << "broken";
  }
  const MesoRun run = Bench(scene);
  EXPECT_EQ(run.ExitCode, 0) << run.Messages;
  EXPECT_EQ(scene.Bytes("out/scene/truth-mesh.png"), before);
}

// A scene of a volume is drawn by the techniques for volumes, not by those for maps.
TEST(MesoBench, DrawsWhatTheSceneHolds)
{
  const SceneFolder scene(R"("lights": [{"type": "directional", "direction": [1, -0.6, -0.6]}],
    "nodes": [{"mesh": {"shape": "sphere", "radius": 0.9, "rings": 6, "sides": 12},
    "mesostructure": {"technique": "shell-sdf", "scale": 0.1, "tiles": [4, 2],
                      "volume": {"pattern": "grid", "size": [16, 16, 8]}}}])");
  const MesoRun run =
    RunMeso({ "bench", scene.PathOf("scene.json"), "-o", scene.PathOf("out"), "--quick", "--size",
      "64x48", "--techniques", "plain,relief,shell-sdf", "--qualities", "medium,full" });
  ASSERT_EQ(run.ExitCode, 0) << run.Messages;
  const Json results = Results(scene);
  ASSERT_EQ(results["rows"].size(), 2u);
  const Json plain = Row(results, "plain", "");
  const Json shell = Row(results, "shell-sdf", "medium");
  ASSERT_EQ(plain["status"], "ok");
  ASSERT_EQ(shell["status"], "ok");
  EXPECT_LT(plain["errors"]["mesh"]["coverage_iou"], 0.9); // the grid stands out
  EXPECT_GT(shell["errors"]["mesh"]["coverage_iou"], 0.95);
  EXPECT_LT(shell["errors"]["mesh"]["texcoord_p50"], 0.1);
  EXPECT_LT(
    shell["errors"]["mesh"]["depth_p95"], 0.1 * double(plain["errors"]["mesh"]["depth_p95"]));
}
