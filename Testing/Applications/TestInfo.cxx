// `meso info`: text and JSON of the same content, exit codes, and what is said of each kind of file.

#include "MessageOf.h"
#include "RunMeso.h"
#include "TemporaryFolder.h"

#include "MesoBakedFile.h"
#include "MesoImageFile.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using Json = nlohmann::json;

const std::string Square = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                           "f 1/1 2/2 3/3 4/4\n";

class Info : public testing::Test
{
protected:
  TemporaryFolder Folder;

  Json Of(const std::string& name)
  {
    const MesoRun run = RunMeso({ "info", this->Folder.PathOf(name), "--json" });
    EXPECT_EQ(run.ExitCode, 0) << run.Messages;
    EXPECT_EQ(run.Messages, "");
    return Json::parse(run.Output, nullptr, false);
  }

  void ExpectRefused(const std::string& name, const std::string& part)
  {
    const MesoRun run = RunMeso({ "info", this->Folder.PathOf(name), "--json" });
    EXPECT_EQ(run.ExitCode, 1);
    EXPECT_EQ(run.Output, "");
    EXPECT_EQ(std::count(run.Messages.begin(), run.Messages.end(), '\n'), 1) << run.Messages;
    EXPECT_NE(run.Messages.find(part), std::string::npos) << run.Messages;
  }

  /// A grey ramp of 16 bits.
  void WriteRamp(const std::string& name, int width, int height)
  {
    std::vector<float> values;
    for (int i = 0; i < width * height; ++i)
    {
      values.push_back(float(i % width) / float(width));
    }
    MesoWriteImage(this->Folder.PathOf(name), width, height, 1,
      MesoImageHeader::Type::UnsignedShort, values.data());
  }

  static bool HasWarning(const Json& report, const std::string& part)
  {
    const Json& warnings = report.at("warnings");
    return std::any_of(warnings.begin(), warnings.end(),
      [&](const Json& warning)
      { return warning.get<std::string>().find(part) != std::string::npos; });
  }
};

/// All keys of objects and all values, in any depth, as the text names them.
void Flatten(const Json& json, std::vector<std::string>& words)
{
  for (const auto& [key, value] : json.items())
  {
    if (json.is_object())
    {
      std::string name = key;
      std::replace(name.begin(), name.end(), '_', ' ');
      words.push_back(name);
    }
    if (value.is_structured())
    {
      Flatten(value, words);
    }
    else if (value.is_string())
    {
      words.push_back(value.get<std::string>());
    }
    else if (value.is_number_integer())
    {
      words.push_back(value.dump());
    }
  }
}
}

TEST_F(Info, TextSaysWhatTheJsonSays)
{
  this->Folder.Write("m.obj", Square + "v 9 9 9\n");
  this->WriteRamp("h.png", 8, 4);
  this->Folder.Write("s.json", R"({"meso": 1, "nodes": [{"name": "wall", "mesh": "m.obj",
    "mesostructure": {"technique": "relief", "height_map": "h.png", "scale": 0.1}}]})");
  for (const char* name : { "m.obj", "h.png", "s.json" })
  {
    const MesoRun text = RunMeso({ "info", this->Folder.PathOf(name) });
    EXPECT_EQ(text.ExitCode, 0);
    std::vector<std::string> words;
    Flatten(this->Of(name), words);
    EXPECT_GT(words.size(), 10u);
    for (const std::string& word : words)
    {
      EXPECT_NE(text.Output.find(word), std::string::npos) << word << "\n" << text.Output;
    }
  }
}

TEST_F(Info, Meshes)
{
  this->Folder.Write("m.obj", Square + "v 9 9 9\n");
  const Json mesh = this->Of("m.obj");
  EXPECT_EQ(mesh["kind"], "mesh");
  EXPECT_EQ(mesh["triangles"], 2);
  EXPECT_EQ(mesh["boundary_edges"], 4);
  EXPECT_EQ(mesh["texture_coordinates"]["charts"], 1);
  EXPECT_EQ(mesh["texture_coordinates"]["object_units_a_unit"], 4.);
  EXPECT_TRUE(mesh["volume"].is_null());
  EXPECT_TRUE(this->HasWarning(mesh, "1 of 5 vertices are in no face"));

  this->Folder.Write("latin1.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nproperty float caf\xe9\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0 1\n1 0 0 1\n0 1 0 1\n3 0 1 2\n");
  EXPECT_TRUE(this->HasWarning(this->Of("latin1.ply"), "not used: caf"));

  this->Folder.Write("bad.ply", "ply\nformat ascii 1.0\nend_header\n");
  this->ExpectRefused("bad.ply", "bad.ply: holds no faces");
  this->ExpectRefused("none.stl", "none.stl: there is no such file");
  this->ExpectRefused("", "is a folder, not a file");
}

TEST_F(Info, Images)
{
  this->WriteRamp("h.png", 8, 4);
  const Json image = this->Of("h.png");
  EXPECT_EQ(image["kind"], "image");
  EXPECT_EQ(image["values"], "uint16");
  EXPECT_EQ(image["size"], (Json{ 8, 4 }));
  EXPECT_EQ(image["channels"][0]["least"], 0.);
  EXPECT_EQ(image["over_the_border_in_u"]["tiles"], "no");
  EXPECT_EQ(image["over_the_border_in_v"]["tiles"], "yes");
  EXPECT_TRUE(image["polarity"].is_null());
  this->Folder.Write("bad.png", "junk");
  this->ExpectRefused("bad.png", "is not an image that can be read");
}

TEST_F(Info, PolarityIsToldByTheNormalMapBeside)
{
  std::vector<float> depth;
  std::vector<float> normals;
  for (int j = 0; j < 16; ++j)
  {
    for (int i = 0; i < 16; ++i)
    {
      const float u = float(i) * 0.7f;
      const float v = float(15 - j) * 0.5f; // rows run down
      depth.push_back(0.5f + 0.25f * (std::sin(u) + std::sin(v)));
      normals.insert(normals.end(), { 0.5f + 0.4f * std::cos(u), 0.5f - 0.4f * std::cos(v), 1.f });
    }
  }
  using Type = MesoImageHeader::Type;
  MesoWriteImage(
    this->Folder.PathOf("wool_height.png"), 16, 16, 1, Type::UnsignedShort, depth.data());
  MesoWriteImage(
    this->Folder.PathOf("wool_nor_gl.png"), 16, 16, 3, Type::UnsignedChar, normals.data());
  const Json polarity = this->Of("wool_height.png")["polarity"];
  EXPECT_LT(polarity["correlation_in_u"].get<double>(), -0.9);
  EXPECT_EQ(polarity["brighter_is"], "deeper");
  EXPECT_EQ(polarity["y_of_normals"], "down");
}

TEST_F(Info, ScenesNameAllThatIsMissing)
{
  this->Folder.Write("s.json", R"({"meso": 1, "nodes": [{"mesh": "a.obj"}, {"children": [
    {"mesh": {"shape": "plane"}, "material": {"color_map": "b.png"},
     "mesostructure": {"technique": "relief", "scale": 1, "height_map": "c.png"}}]}]})");
  const Json scene = this->Of("s.json");
  ASSERT_EQ(scene["missing"].size(), 3u);
  EXPECT_NE(scene["missing"][0].get<std::string>().find("nodes[0].mesh: "), std::string::npos);
  EXPECT_NE(
    scene["missing"][2].get<std::string>().find("nodes[1].children[0].mesostructure.height_map: "),
    std::string::npos);
  EXPECT_EQ(scene["nodes"].size(), 3u);
  EXPECT_EQ(scene["nodes"][2]["technique"], "relief");
  this->Folder.Write("bad.json", R"({"meso": 1, "nodes": [{"mesh": 3}]})");
  this->ExpectRefused("bad.json", "bad.json: nodes[0].mesh: ");
}

TEST_F(Info, SampleSpacingIsHeldToTheSurface)
{
  this->WriteRamp("h.png", 8, 4);
  this->Folder.Write("m.obj", Square); // 4 x 4 object units
  const auto warns = [&](const std::string& mesh, const std::string& spacing)
  {
    this->Folder.Write("s.json",
      R"({"meso": 1, "nodes": [{"mesh": )" + mesh +
        R"(, "mesostructure": {"technique": "relief", "scale": 0.1, "height_map": "h.png",
      "tiles": [2, 1], "sample_spacing": )" +
        spacing + "}}]}");
    return this->HasWarning(this->Of("s.json"), "samples are");
  };
  EXPECT_FALSE(warns("\"m.obj\"", "[0.25, 1]"));
  EXPECT_FALSE(warns("\"m.obj\"", "[0.26, 0.95]")) << "within a tenth";
  EXPECT_TRUE(warns("\"m.obj\"", "[0.3, 1]"));
  EXPECT_TRUE(warns("\"m.obj\"", "[0.25, 0.5]"));
  EXPECT_FALSE(warns(R"({"shape": "plane"})", "[7, 7]")) << "which it sizes";
  EXPECT_TRUE(warns(R"({"shape": "plane", "size": [4, 4]})", "[7, 7]"));
}

TEST_F(Info, BakedTables)
{
  MesoBaked baked;
  baked.Kind = "cone";
  baked.Parameters["wrap"] = std::string("repeat");
  baked.Parameters["range"] = std::vector<double>{ 0., 0.5 };
  baked.Table = vtkSmartPointer<vtkImageData>::New();
  baked.Table->SetDimensions(3, 2, 1);
  baked.Table->AllocateScalars(VTK_FLOAT, 1);
  baked.Table->GetPointData()->GetScalars()->SetName("ratio");
  baked.Table->GetPointData()->GetScalars()->Fill(2.5);
  MesoWriteBaked(this->Folder.PathOf("t.cone.vti"), baked);
  const Json table = this->Of("t.cone.vti");
  EXPECT_EQ(table["kind"], "baked table");
  EXPECT_EQ(table["table"], "cone");
  EXPECT_EQ(table["size"], (Json{ 3, 2, 1 }));
  EXPECT_EQ(table["parameters"]["wrap"], "repeat");
  EXPECT_EQ(table["parameters"]["range"], (Json{ 0., 0.5 }));
  EXPECT_EQ(table["arrays"][0]["name"], "ratio");
  EXPECT_EQ(table["arrays"][0]["range_of_magnitude"], (Json{ 2.5, 2.5 }));
}

TEST_F(Info, ElevationsSizeAPlaneInMetres)
{
  std::string record(1024, ' ');
  const auto put = [&](std::size_t place, const std::string& field)
  { record.replace(place, field.size(), field); };
  put(528, "     2     2     4");
  for (std::size_t i = 0; i < 8; ++i)
  {
    put(546 + 24 * i, "   0.000000000000000D+00");
  }
  put(816, "0.300000E+020.200000E+020.100000E+01     1     2");
  std::string bytes = record;
  for (int profile = 0; profile < 2; ++profile)
  {
    record.assign(1024, ' ');
    put(0, "     1     1     3     1");
    for (std::size_t i = 0; i < 5; ++i)
    {
      put(24 + 24 * i, "   0.000000000000000D+00");
    }
    put(144, "   100   150   300");
    bytes += record;
  }
  this->Folder.Write("t.dem", bytes);
  const Json elevations = this->Of("t.dem");
  EXPECT_EQ(elevations["kind"], "elevations");
  EXPECT_EQ(elevations["size"], (Json{ 2, 3 }));
  EXPECT_EQ(elevations["scale_in_true_proportion"], 200.);
  EXPECT_EQ(elevations["extent"], (Json{ 60., 60. }));

  const auto scene = [&](const std::string& size)
  {
    this->Folder.Write("s.json",
      R"({"meso": 1, "nodes": [{"mesh": {"shape": "plane")" + size +
        R"(}, "mesostructure": {"technique": "relief", "scale": 200, "height_map": "t.dem"}}]})");
    return this->Of("s.json");
  };
  const Json sized = scene("");
  EXPECT_EQ(sized["warnings"].size(), 0u) << sized.dump();
  EXPECT_TRUE(
    this->HasWarning(scene(R"(, "size": [120, 60])"), "are 30 x 20 apart, but lie 60 x 20"));
}

TEST_F(Info, ReliefMaps)
{
  // Waves of depth; where depth rises with u or v, normals lean that way, or against it (sign -1).
  const auto write = [&](const std::string& name, float sign, int channels)
  {
    std::vector<float> values;
    for (int j = 0; j < 16; ++j)
    {
      for (int i = 0; i < 16; ++i)
      {
        const float u = float(i) * 0.7f;
        const float v = float(15 - j) * 0.5f; // rows run down
        const float pixel[4] = { 0.5f + sign * 0.4f * std::cos(u), 0.5f + sign * 0.4f * std::cos(v),
          1.f, 0.5f + 0.25f * (std::sin(u) + std::sin(v)) };
        values.insert(values.end(), pixel, pixel + channels);
      }
    }
    MesoWriteImage(this->Folder.PathOf(name), 16, 16, channels, MesoImageHeader::Type::UnsignedChar,
      values.data());
  };
  const auto scene = [&](const std::string& map)
  {
    return this->Folder.Write("s.json",
      R"({"meso": 1, "nodes": [{"mesh": {"shape": "plane"},
      "mesostructure": {"technique": "relief", "scale": 0.1, "relief_map": ")" +
        map + R"("}}]})");
  };
  write("rgba.png", 1.f, 4);
  write("rgb.png", 1.f, 3);
  scene("rgba.png");
  const Json agrees = this->Of("s.json");
  EXPECT_EQ(agrees["nodes"][0]["map_size"], (Json{ 16, 16 }));
  EXPECT_FALSE(this->HasWarning(agrees, "normal map"));
  write("wrong.png", -1.f, 4);
  scene("wrong.png");
  EXPECT_TRUE(this->HasWarning(this->Of("s.json"), "one of heights, not of depths"));
  scene("rgb.png");
  this->ExpectRefused("s.json", "a relief map has four channels");
}

TEST_F(Info, SaysWhatAVolumeHolds)
{
  std::string text = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 8 4 4\nspacings: 1 1 2\n"
                     "encoding: text\n\n";
  for (int i = 0; i < 128; ++i)
  {
    text += std::to_string(i % 8) + " ";
  }
  this->Folder.Write("v.nrrd", text);
  const Json json = this->Of("v.nrrd");
  EXPECT_EQ(json["kind"], "volume");
  EXPECT_EQ(json["size"], Json({ 8, 4, 4 }));
  EXPECT_EQ(json["values"], "unsigned char");
  EXPECT_EQ(json["least"], 0.);
  EXPECT_EQ(json["most"], 7.);
  EXPECT_EQ(json["depth_in_tile_widths"], 1.);
  EXPECT_EQ(json["over_the_border_in_x"]["tiles"], "no");
  EXPECT_EQ(json["over_the_border_in_y"]["tiles"], "yes");
  this->Folder.Write("junk.nrrd", "junk");
  this->ExpectRefused("junk.nrrd", "no NRRD file");
}
