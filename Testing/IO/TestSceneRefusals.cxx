// Scene files that are refused: each with the literal line that the user sees.

#include "MesoJson.h"
#include "MesoScene.h"

#include <gtest/gtest.h>

namespace
{
std::string MessageOf(const std::string& text)
{
  try
  {
    MesoParseScene(text, "s.json");
  }
  catch (const MesoInputError& error)
  {
    return error.what();
  }
  return "read without an error";
}

std::string OfScene(const std::string& members)
{
  return MessageOf("{\"meso\": 1, " + members + "}");
}

std::string OfNode(const std::string& members)
{
  return OfScene("\"nodes\": [{" + members + "}]");
}

std::string OfRelief(const std::string& members)
{
  return OfNode(
    R"("mesh": "a.obj", "mesostructure": {"technique": "relief", "scale": 1)" + members + "}");
}

bool Mentions(const std::string& message, const std::string& part)
{
  return message.find(part) != std::string::npos && message.find('\n') == std::string::npos;
}
}

TEST(SceneRefusals, SyntaxGivesLineAndColumn)
{
  EXPECT_TRUE(Mentions(MessageOf("{\n  \"meso\": 1,\n}"), "s.json: line 3, column 1: "));
  EXPECT_TRUE(Mentions(MessageOf(""), "s.json: line 1, column 1: "));
  EXPECT_TRUE(Mentions(MessageOf("{\"meso\": 1"), "s.json: line 1, column 11: "));
  EXPECT_TRUE(Mentions(MessageOf("{\"meso\": 1} x"), "s.json: line 1, column 13: "));
  EXPECT_TRUE(Mentions(MessageOf("{\"meso\":\n 1e999}"), "s.json: line 2, column "));
  EXPECT_TRUE(Mentions(MessageOf("{\"meso\": NaN}"), "s.json: line 1, column "));
  EXPECT_TRUE(Mentions(MessageOf("\xff\xfe\x01"), "s.json: line 1, column "));
  EXPECT_TRUE(Mentions(MessageOf(std::string(5, '\0')), "s.json: line 1, column 1: "));
}

TEST(SceneRefusals, Version)
{
  EXPECT_EQ(MessageOf("{}"), "s.json: meso is missing");
  EXPECT_EQ(MessageOf("[1]"), "s.json: must be an object, is a list");
  EXPECT_EQ(MessageOf(R"({"meso": 2, "new_key": 1})"),
    "s.json: meso: scene format 2 is not known; this program reads format 1");
  EXPECT_EQ(MessageOf(R"({"meso": "1"})"), "s.json: meso: must be a number, is a string");
}

TEST(SceneRefusals, DuplicateKeysAndDepth)
{
  EXPECT_EQ(OfScene(R"("nodes": [{}, {"name": "a", "name": "b"}])"),
    "s.json: nodes[1].name: key given twice");
  const std::string deep(MesoJsonMaximumDepth + 1, '[');
  EXPECT_TRUE(Mentions(MessageOf(deep), ": nested deeper than 64 levels"));
  EXPECT_TRUE(Mentions(MessageOf(std::string(1000000, '[')), ": nested deeper than 64 levels"));
}

TEST(SceneRefusals, UnknownKeys)
{
  EXPECT_EQ(OfNode(R"("mesh": "a.obj", "mesostructure": {"hieght_map": "h.png"})"),
    "s.json: nodes[0].mesostructure.hieght_map: unknown key (did you mean height_map?)");
  EXPECT_EQ(
    OfNode(R"("scale": 2)"), "s.json: nodes[0].scale: unknown key here (it is one of transform)");
  EXPECT_EQ(OfNode(R"("transform": {"xyz": 2})"),
    "s.json: nodes[0].transform.xyz: unknown key (there are: matrix, translate, rotate, scale)");
  EXPECT_EQ(OfNode(R"("mesh": {"shape": "plane", "radius": 2})"),
    "s.json: nodes[0].mesh.radius: unknown key here (it is one of shape_sphere)");
  EXPECT_EQ(OfScene(R"("line\nbreak": 1)").find('\n'), std::string::npos);
}

TEST(SceneRefusals, KnownButNotYetServed)
{
  EXPECT_EQ(OfScene(R"("environment": {})"), "s.json: environment: is not available yet");
}

TEST(SceneRefusals, TablesThatDoNotGoTogether)
{
  const std::string head = R"("mesh": "a.obj", "mesostructure": {"technique": "vdm", )";
  const std::string place = "s.json: nodes[0].mesostructure";
  EXPECT_EQ(
    OfNode(head + R"("scale": 1})"), place + ": technique vdm needs a height_map or a depth_map");
  EXPECT_EQ(OfNode(head + R"("baked": "a.vdm.vti"})"),
    place + ": technique vdm needs scale, the height of its relief in object units");
  EXPECT_EQ(OfNode(head + R"("wrap": "clamp"})"),
    place + ".wrap: technique vdm has a table of a tile that repeats");
  EXPECT_EQ(OfNode(head + R"("quality": "full", "rank": [8, 4]})"),
    place + ".rank: quality full is the table itself, without factors");
  EXPECT_EQ(OfNode(head + R"("quality": "certified"})"),
    place + ".quality: technique vdm has no quality certified");
  EXPECT_TRUE(Mentions(OfNode(head + R"("rank": [0, 4]})"), place + ".rank[0]"));
  EXPECT_TRUE(Mentions(OfNode(head + R"("rank": [13, 4]})"), place + ".rank[0]"));
  EXPECT_EQ(
    OfRelief(R"(, "rank": [8, 4])"), place + ".rank: technique relief has no table with factors");
  EXPECT_EQ(OfRelief(R"(, "baked": "a.vti")"),
    place + ".baked: technique relief has no use for a baked table");
}

TEST(SceneRefusals, WordsThatAreNoChoice)
{
  const std::string head = R"("mesh": "a.obj", "mesostructure": {)";
  EXPECT_EQ(OfNode(head + R"("technique": "releif"})"),
    "s.json: nodes[0].mesostructure.technique: there is no technique \"releif\" (did you mean "
    "relief? choices: plain, bump, normal, normal-object, parallax, horizon, relief, "
    "relief-quadric, relief-quadric-exact, vdm, gdm, slices, shell-sdf, displacement, "
    "geometry-image, tessellated)");
  EXPECT_EQ(OfRelief(R"(, "parallax": "offset")"),
    "s.json: nodes[0].mesostructure.parallax: technique relief has no parallax to choose");
  EXPECT_EQ(OfRelief(R"(, "curvature_at": "vertex")"),
    "s.json: nodes[0].mesostructure.curvature_at: technique relief has no choice of where "
    "curvature is taken; vdm has");
  EXPECT_EQ(OfRelief(R"(, "penumbra": 2)"),
    "s.json: nodes[0].mesostructure.penumbra: technique relief has no penumbra");
  EXPECT_EQ(OfRelief(R"(, "facet_pixels": 2)"),
    "s.json: nodes[0].mesostructure.facet_pixels: technique relief does not cut by pixels");
  EXPECT_EQ(OfRelief(R"(, "baked": "a.vti")"),
    "s.json: nodes[0].mesostructure.baked: technique relief has no use for a baked table");
  EXPECT_EQ(OfNode(head + R"("technique": "geometry-image", "height_map": "a.png"})"),
    "s.json: nodes[0].mesostructure.height_map: technique geometry-image draws the mesh itself, "
    "without relief");
  EXPECT_EQ(OfNode(R"("mesh": {"shape": "torus"}, "subdivide": 1)"),
    "s.json: nodes[0].subdivide: is for mesh files; a built-in shape has finer numbers of its own");
  EXPECT_EQ(OfNode(R"("mesh": "a.obj", "material": {"normal_map_y": "up"})"),
    "s.json: nodes[0].material.normal_map_y: there is no normal_map that it is of");
  EXPECT_TRUE(Mentions(
    OfNode(R"("mesh": "a.obj", "material": {"normal_map": "n.png", "normal_map_y": "left"})"),
    "up, down"));
  EXPECT_EQ(OfNode(head + R"("technique": "normal"})"),
    "s.json: nodes[0].mesostructure: technique normal needs a height_map or a depth_map, or a "
    "normal_map of the material");
  EXPECT_EQ(OfRelief(R"(, "quadric": "full")"),
    "s.json: nodes[0].mesostructure.quadric: technique relief has no quadric");
  EXPECT_TRUE(Mentions(
    OfNode(head + R"("technique": "relief-quadric", "quadric": "cubic"})"), "full, diagonal"));
  EXPECT_EQ(OfNode(head + R"("quality": "full"})"),
    "s.json: nodes[0].mesostructure.quality: technique plain has no quality full: it has no table");
  EXPECT_EQ(OfNode(head + R"("quality": "certified"})"),
    "s.json: nodes[0].mesostructure.quality: technique plain has no quality certified");
  EXPECT_EQ(OfRelief(R"(, "quality": "certified", "search": "cone")"),
    "s.json: nodes[0].mesostructure.search: quality certified is the search certified, not cone; "
    "name another quality, or no search");
  EXPECT_EQ(OfNode(head + R"("technique": "relief-quadric-exact", "curved": "bent"})"),
    "s.json: nodes[0].mesostructure.curved: technique relief-quadric-exact has no choice of curved "
    "bases; relief-quadric has");
  EXPECT_TRUE(Mentions(OfNode(head + R"("technique": "relief-quadric", "curved": "sphere"})"),
    "there is no curved base \"sphere\" (choices: quadric, bent, osculating, surface)"));
  EXPECT_TRUE(Mentions(OfNode(head + R"("quality": "best"})"), "there is no quality \"best\""));
  EXPECT_TRUE(Mentions(OfRelief(R"(, "search": "linear-binery")"), "did you mean linear-binary?"));
  EXPECT_EQ(OfNode(head + R"("search": "linear-secant"})"),
    "s.json: nodes[0].mesostructure.search: technique plain has no search");
  EXPECT_TRUE(Mentions(OfNode(head + R"("wrap": "tile"})"), "choices: repeat, clamp, mirror"));
  EXPECT_TRUE(Mentions(OfNode(R"("mesh": {"shape": "taurus"})"), "did you mean torus?"));
  EXPECT_TRUE(Mentions(OfRelief(R"(, "height_map": {"pattern": "bricks"})"), "mean brick?"));
  EXPECT_TRUE(Mentions(OfScene(R"("lights": [{"type": "sun"}])"),
    "lights[0].type: there is no light \"sun\" (choices: headlight, directional, point, spot)"));
}

TEST(SceneRefusals, EffectsThatTheTechniqueLacks)
{
  EXPECT_EQ(OfNode(R"("mesh": "a.obj", "mesostructure": {"effects": ["depth"]})"),
    "s.json: nodes[0].mesostructure.effects[0]: technique plain does not provide depth (it "
    "provides cast_shadow)");
  EXPECT_TRUE(Mentions(OfRelief(R"(, "height_map": "h", "effects": ["shadow"])"),
    "effects[0]: there is no effect \"shadow\""));
  EXPECT_TRUE(Mentions(OfRelief(R"(, "height_map": "h", "effects": "most")"),
    "there is no choice of effects \"most\" (choices: auto, all, none)"));
}

TEST(SceneRefusals, TypesAndRanges)
{
  const std::pair<const char*, const char*> cases[] = {
    { R"("nodes": {})", "nodes: must be a list, is an object" },
    { R"("nodes": [1])", "nodes[0]: must be an object, is a number" },
    { R"("camera": {"position": [1, 2]})", "camera.position: must be a list of 3, has 2" },
    { R"("camera": {"position": [1, "2", 3]})",
      "camera.position[1]: must be a number, is a string" },
    { R"("camera": {"view_angle": 180})", "camera.view_angle: must be in (0, 180), is 180" },
    { R"("camera": {"view_angle": 1e300})", "camera.view_angle: must not be beyond 1e+18" },
    { R"("camera": {"parallel_scale": 0})", "parallel_scale: must be more than 0, is 0" },
    { R"("camera": {"clipping_range": [2, 1]})", "the near distance must be less" },
    { R"("camera": {"position": [1, 1, 1], "focal_point": [1, 1, 1]})", "focal_point must differ" },
    { R"("camera": {"view_up": [0, 0, -2]})", "camera: view_up must not lie along the view" },
    { R"("camera": {"view_up": [0, 0, 0]})", "camera.view_up: must have a direction, is 0" },
    { R"("background": [0, 0, 1.5])", "background[2]: must be in [0, 1], is 1.5" },
    { R"("lights": [{"type": "spot", "cone_angle": 90}])",
      "cone_angle: must be in (0, 90), is 90" },
    { R"("lights": [{"type": "point", "direction": [0, 0, 1]}])", "is not a key of a point light" },
    { R"("lights": [{"type": "spot", "position": [0, 0, 0]}])", "lights[0]: position and" },
    { R"("lights": [{"type": "point", "attenuation": [0, 0, 0]}])", "must be more than 0" },
    { R"("lights": [{"intensity": -1}])", "intensity: must be 0 or more, is -1" },
    { R"("lights": [{"shadow": 1}])", "shadow: must be true or false, is a number" },
    { R"("lights": [{"type": "spot", "coordinates": "eye"}])", "choices: world, camera" },
  };
  for (const auto& [text, part] : cases)
  {
    EXPECT_TRUE(Mentions(OfScene(text), part)) << text << " gives " << OfScene(text);
  }
}

TEST(SceneRefusals, NodesAndSurfaces)
{
  const std::pair<const char*, const char*> cases[] = {
    { R"("transform": {"matrix": [1]})", "transform.matrix: must be a list of 16, has 1" },
    { R"("transform": {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 5,5,5,1]})", "the last row must be" },
    { R"("transform": {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1], "scale": 2})",
      "transform.scale: there is a matrix already" },
    { R"("transform": {"rotate": [90, 0, 0, 0]})", "transform.rotate: the axis" },
    { R"("transform": {"scale": "2"})", "transform.scale: must be a list of 3, is a string" },
    { R"("material": {})", "nodes[0].material: there is no mesh beside it" },
    { R"("mesh": "")", "nodes[0].mesh: must not be empty" },
    { R"("mesh": 5)", "nodes[0].mesh: must be a file name, or an object with the key shape" },
    { R"("mesh": "a\u0000b")", "nodes[0].mesh: must not hold control characters" },
    { R"("mesh": {"shape": "torus", "rings": 2.5})", "mesh.rings: must be" },
    { R"("mesh": {"shape": "torus", "tube": 3})", "nodes[0].mesh: shape 'torus': 'tube' must be" },
    { R"("mesh": {"shape": "branch", "radius": 1})", "'radius' must be less than a quarter of" },
    { R"("mesh": {"shape": "cube", "size": [1, 1]})", "mesh.size: must be a list of 3, has 2" },
    { R"("mesh": {"shape": "plane", "size": 2})", "mesh.size: must be a list of 2, is a number" },
    { R"("part": {"by": "x", "range": [0, 1]})", "nodes[0].part: there is no mesh beside it" },
    { R"("mesh": "a", "part": {"range": [0, 1]})", "nodes[0].part" },
    { R"("mesh": "a", "part": {"by": "x"})", "nodes[0].part" },
    { R"("mesh": "a", "part": {"by": "x", "range": [1, 1]})",
      "part.range: the first number must be less than the second" },
    { R"("mesh": "a", "part": {"by": "[0]", "range": [0, 1]})", "part.by: must be the name of" },
    { R"("mesh": "a", "feature_angle": 181)", "feature_angle: must be in [0, 180], is 181" },
    { R"("mesh": "a", "material": {"opacity": 2})", "opacity: must be in [0, 1], is 2" },
    { R"("mesh": "a", "material": {"specular_power": 200})", "must be in [0, 128], is 200" },
    { R"("mesh": "a", "mesostructure": {"reference": 1.5})",
      "reference: must be in [0, 1], is 1.5" },
    { R"("mesh": "a", "mesostructure": {"relief_map": "r", "depth_map": "d"})",
      "relief_map: there is a depth_map already" },
    { R"("mesh": "a", "mesostructure": {"relief_map": "r", "height_map": "h"})",
      "relief_map: there is a height_map already" },
    { R"("mesh": "a", "mesostructure": {"relief_map": {"pattern": "brick"}})",
      "relief_map: must be a string, is an object" },
    { R"("mesh": "a", "mesostructure": {"range": [0, 1]})", "there is no height_map or depth_map" },
    { R"("mesh": "a", "mesostructure": {"technique": "relief", "height_map": "h"})",
      "needs scale" },
  };
  for (const auto& [text, part] : cases)
  {
    EXPECT_TRUE(Mentions(OfNode(text), part)) << text << " gives " << OfNode(text);
  }
}

TEST(SceneRefusals, Maps)
{
  const std::pair<const char*, const char*> cases[] = {
    { "", "technique relief needs a height_map or a depth_map" },
    { R"(, "height_map": "h", "depth_map": "d")", "only one map is taken" },
    { R"(, "height_map": "h", "range": [1, 1])", "range: the first number must be less" },
    { R"(, "height_map": "h", "sample_spacing": [1, 0])",
      "sample_spacing[1]: must be more than 0" },
    { R"(, "height_map": "h", "tiles": [0, 1])", "tiles[0]: must be more than 0, is 0" },
    { R"(, "height_map": "h", "tiles": 3)", "tiles: must be a list of 2, is a number" },
    { R"(, "height_map": {"size": [8, 8]})",
      "must be a file name, or an object with the key pattern" },
    { R"(, "height_map": {"pattern": "step", "size": [16385, 1]})", "must be in [1, 16384]" },
    { R"(, "height_map": {"pattern": "step", "size": [0, 1]})", "must be in [1, 16384], is 0" },
    { R"(, "height_map": {"pattern": "step", "size": [1.5, 1]})",
      "must be a whole number, is 1.5" },
    { R"(, "height_map": {"pattern": "step", "seed": -1})", "seed: must be in [0, 4294967295]" },
  };
  for (const auto& [text, part] : cases)
  {
    EXPECT_TRUE(Mentions(OfRelief(text), part)) << text << " gives " << OfRelief(text);
  }
  EXPECT_TRUE(Mentions(
    OfNode(R"("mesh": "a", "mesostructure": {"scale": -1})"), "scale: must be 0 or more, is -1"));
}

TEST(SceneRefusals, ClippingPlanes)
{
  EXPECT_EQ(OfScene(R"("clipping_planes": [])"), "read without an error");
  EXPECT_TRUE(Mentions(OfScene(R"("clipping_planes": [[0, 0, 1]])"),
    "s.json: clipping_planes[0]: must be a list of 2, has 3"));
  EXPECT_TRUE(Mentions(
    OfScene(R"("clipping_planes": [[[0, 0, 0], [0, 0, 0]]])"), "s.json: clipping_planes[0][1]: "));
  std::string planes = "[[0, 0, 0], [0, 0, 1]]";
  for (int i = 0; i < 6; ++i)
  {
    planes += ", [[0, 0, 0], [0, 0, 1]]";
  }
  EXPECT_EQ(OfScene("\"clipping_planes\": [" + planes + "]"),
    "s.json: clipping_planes: at most 6 planes can be drawn");
}

TEST(SceneRefusals, ContoursAndScalarBars)
{
  const std::pair<const char*, const char*> cases[] = {
    { R"("contours": true)", "s.json: nodes[0].material.contours: must be an object" },
    { R"("contours": {})", "contours: needs either spacing or values" },
    { R"("contours": {"spacing": 1, "values": [1]})", "contours: needs either spacing or values" },
    { R"("contours": {"spacing": 0})", "contours.spacing: must be more than 0" },
    { R"("contours": {"values": []})", "contours.values: needs 1 to 32 numbers" },
    { R"("contours": {"spacing": 0.1, "width": 0})", "contours.width: must be more than 0" },
    { R"("contours": {"spacing": 0.1, "values_of": "metres"})",
      "contours.values_of: there is no kind of values \"metres\"" },
    { R"("contours": {"spacing": 0.1})",
      "contours: contour lines are those of a height_map or a depth_map, and the node has none" },
    { R"("scalar_bar": true)", "scalar_bar: there is no color_by that it is of" },
    { R"("color_by": "A", "scalar_bar": 1)", "scalar_bar: must be an object" },
    { R"("color_by": "A", "scalar_bar": {"title": ""})", "title: must not be empty" },
    { R"("color_by": "A", "scalar_bar": {"values_of": "map"})",
      "scalar_bar.values_of: is for color_by height" },
  };
  for (const auto& [text, part] : cases)
  {
    const std::string message =
      OfNode(std::string(R"("mesh": "a.obj", "material": {)") + text + "}");
    EXPECT_TRUE(Mentions(message, part)) << text << " gives " << message;
  }
}

TEST(SceneRefusals, ColorBy)
{
  const std::pair<const char*, const char*> cases[] = {
    { R"("color_by": 1)", "s.json: nodes[0].material.color_by: must be a string, is a number" },
    { R"("color_by": "")", "color_by: must not be empty" },
    { R"("color_by": "A[]")", "color_by: must be the name of a point array, or NAME[i]" },
    { R"("color_by": "A[-1]")", "color_by: must be the name of a point array, or NAME[i]" },
    { R"("color_by": "A[x]")", "color_by: must be the name of a point array, or NAME[i]" },
    { R"("color_by": "A[99999]")", "color_by: must be the name of a point array, or NAME[i]" },
    { R"("color_by": "[0]")", "color_by: must be the name of a point array, or NAME[i]" },
    { R"("color_by": "A]")", "color_by: must be the name of a point array, or NAME[i]" },
    { R"("color_by": "height[0]")", "color_by: height has no components" },
    { R"("color_by": "height")",
      "color_by: height is that of a height_map or a depth_map, and the node has none" },
    { R"("color_by": "A", "color_map": "c.png")",
      "color_map: there is a color_by already; only one of them gives the color" },
    { R"("lookup_table": {})", "lookup_table: there is no color_by that it is of" },
    { R"("color_by": "A", "lookup_table": "viridis")", "lookup_table: must be an object" },
    { R"("color_by": "A", "lookup_table": {"nme": "grey"})",
      "lookup_table.nme: unknown key (did you mean name?)" },
    { R"("color_by": "A", "lookup_table": {"name": "viridris"})",
      "lookup_table.name: there is no lookup table \"viridris\" (did you mean viridis? choices: "
      "viridis, coolwarm, grey, terrain)" },
    { R"("color_by": "A", "lookup_table": {"range": [1, 1]})",
      "lookup_table.range: the first number must be less than the second" },
    { R"("color_by": "A", "lookup_table": {"range": [1]})", "range: must be a list of 2, has 1" },
  };
  for (const auto& [text, part] : cases)
  {
    const std::string message =
      OfNode(std::string(R"("mesh": "a.obj", "material": {)") + text + "}");
    EXPECT_TRUE(Mentions(message, part)) << text << " gives " << message;
  }
}

TEST(SceneRefusals, ShellsOfVolumes)
{
  const auto of = [](const std::string& keys)
  { return OfNode(R"("mesh": "a.obj", "mesostructure": {)" + keys + "}"); };
  const std::string volume = R"("volume": {"pattern": "weave"}, )";
  const std::string place = "s.json: nodes[0].mesostructure";
  for (const char* name : { "gdm", "slices", "shell-sdf" })
  {
    const std::string technique = std::string(R"("technique": ")") + name + "\"";
    EXPECT_EQ(of(technique),
      place + ": technique " + name + " needs a volume, a tile_mesh or a height_map" +
        (std::string(name) == "gdm" ? ", or a baked table" : ""));
    EXPECT_EQ(of(volume + technique),
      place + ": technique " + name + " needs scale, the thickness of its shell in object units");
    EXPECT_EQ(
      of(volume + R"("scale": 0, )" + technique), place + ".scale: a shell needs some thickness");
    EXPECT_TRUE(Mentions(of(volume + R"("scale": 1, "wrap": "clamp", )" + technique), "wrap: "));
    EXPECT_TRUE(Mentions(of(volume + R"("scale": 1, "segments": 65, )" + technique), "segments: "));
  }
  EXPECT_EQ(OfRelief(R"(, "segments": 2)"),
    place + ".segments: technique relief has no prisms that rays run through");
  EXPECT_EQ(OfRelief(R"(, "volume_colors": "c.vti")"),
    place + ".volume_colors: technique relief draws no volume");
  EXPECT_EQ(OfRelief(R"(, "exits": "exact")"),
    place + ".exits: technique relief has no prisms that rays run through");
  EXPECT_TRUE(Mentions(
    of(volume + R"("scale": 1, "technique": "slices", "exits": "exact")"), "no rays that run"));
  EXPECT_TRUE(Mentions(of(volume + R"("scale": 1, "technique": "gdm", "exits": "interpolate")"),
    "did you mean interpolated"));
  EXPECT_EQ(OfRelief(R"(, "stack": "prism")"),
    place + ".stack: technique relief has no prisms that rays run through");
  EXPECT_EQ(of(volume + R"("scale": 1, "technique": "gdm", "stack": "screen")"),
    place + ".stack: technique gdm draws no slices");
  EXPECT_TRUE(Mentions(of(volume + R"("scale": 1, "technique": "slices", "stack": "screens")"),
    "did you mean screen"));
}
