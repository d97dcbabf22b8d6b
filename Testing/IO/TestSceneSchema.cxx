// Holds the published JSON Schema and the documentation to what the reader serves.

#include "MesoColorMap.h"
#include "MesoPattern.h"
#include "MesoScene.h"
#include "MesoSceneKeys.h"
#include "MesoShape.h"
#include "MesoVolumePattern.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>

namespace
{
using Json = nlohmann::json;

std::string ReadDocument(const std::string& name)
{
  std::ifstream file(std::string(MESO_DOCUMENTATION_DIR) + "/" + name);
  EXPECT_TRUE(file) << name;
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

Json Schema()
{
  return Json::parse(ReadDocument("scene.schema.json"));
}

Json Definition(const Json& schema, const std::string& object)
{
  return object == "scene" ? schema : schema.at("$defs").at(object);
}

std::set<std::string> SetOf(const std::vector<std::string>& words)
{
  return std::set<std::string>(words.begin(), words.end());
}

void ExpectParameters(const Json& properties, const std::vector<MesoParameter>& parameters)
{
  for (const MesoParameter& parameter : parameters)
  {
    const Json& property = properties.at(parameter.Key);
    const bool isList = parameter.Default.size() > 1;
    const Json& number = isList ? property.at("items") : property;
    EXPECT_EQ(number.at("type"), parameter.Integer ? "integer" : "number") << parameter.Key;
    EXPECT_EQ(number.at("minimum"), parameter.Minimum) << parameter.Key;
    EXPECT_EQ(number.at("maximum"), parameter.Maximum) << parameter.Key;
    const Json value = isList ? Json(parameter.Default) : Json(parameter.Default[0]);
    EXPECT_EQ(property.at("default"), value) << parameter.Key;
  }
}
}

TEST(SceneSchema, HasTheKeysThatTheReaderServes)
{
  const Json schema = Schema();
  for (const MesoSceneKeyGroup& group : MesoSceneKeyTable())
  {
    const Json definition = Definition(schema, group.Object);
    std::set<std::string> keys;
    for (const auto& [key, property] : definition.at("properties").items())
    {
      keys.insert(key);
      const bool described =
        property.contains("description") || property.contains("const") || property.contains("$ref");
      EXPECT_TRUE(described) << group.Object << "." << key;
    }
    EXPECT_EQ(keys, SetOf(group.Served)) << group.Object;
    EXPECT_EQ(definition.at("additionalProperties"), false) << group.Object;
    EXPECT_TRUE(definition.contains("description")) << group.Object;
  }
  EXPECT_EQ(schema.at("$defs").size() + 1, MesoSceneKeyTable().size());
}

TEST(SceneSchema, HasTheChoicesOfTheReader)
{
  const Json schema = Schema();
  const Json keys = schema.at("$defs").at("mesostructure").at("properties");
  EXPECT_EQ(keys.at("technique").at("enum"), Json(MesoTechniqueNames()));
  EXPECT_EQ(keys.at("quality").at("enum"), Json(MesoQualityNames()));
  EXPECT_EQ(keys.at("search").at("enum"), Json(MesoSearchNames()));
  EXPECT_EQ(keys.at("wrap").at("enum"), Json(MesoWrapNames()));
  const Json table = schema.at("$defs").at("lookup_table").at("properties");
  EXPECT_EQ(table.at("name").at("enum"), Json(MesoColorMapNames()));
  EXPECT_EQ(keys.at("effects").at("anyOf").at(1).at("items").at("enum"), Json(MesoEffectNames()));
}

TEST(SceneSchema, HasTheNumbersOfShapesAndPatterns)
{
  const Json definitions = Schema().at("$defs");
  for (const std::string& shape : MesoShapeNames())
  {
    ExpectParameters(definitions.at("shape_" + shape).at("properties"), MesoShapeParameters(shape));
  }
  for (const std::string& pattern : MesoPatternNames())
  {
    ExpectParameters(
      definitions.at("pattern_" + pattern).at("properties"), MesoPatternParameters(pattern));
  }
  for (const std::string& pattern : MesoVolumePatternNames())
  {
    ExpectParameters(
      definitions.at("volume_" + pattern).at("properties"), MesoVolumePatternParameters(pattern));
  }
}

TEST(SceneSchema, DefaultsAreThoseOfTheReader)
{
  const Json definitions = Schema().at("$defs");
  const auto of = [&](const char* object, const char* key)
  { return definitions.at(object).at("properties").at(key).at("default"); };
  const MesoSceneCamera camera;
  EXPECT_EQ(of("camera", "position"), Json(camera.Position));
  EXPECT_EQ(of("camera", "view_up"), Json(camera.ViewUp));
  EXPECT_EQ(of("camera", "view_angle"), camera.ViewAngle);
  const MesoSceneLight light;
  EXPECT_EQ(of("light", "direction"), Json(light.Direction));
  EXPECT_EQ(of("light", "position"), Json(light.Position));
  EXPECT_EQ(of("light", "cone_angle"), light.ConeAngle);
  EXPECT_EQ(of("light", "exponent"), light.Exponent);
  EXPECT_EQ(of("light", "attenuation"), Json(light.Attenuation));
  EXPECT_EQ(of("light", "shadow"), light.Shadow);
  const MesoSceneMaterial material;
  EXPECT_EQ(of("material", "color"), Json(material.Color));
  EXPECT_EQ(of("material", "ambient"), material.Ambient);
  EXPECT_EQ(of("material", "diffuse"), material.Diffuse);
  EXPECT_EQ(of("material", "specular"), material.Specular);
  EXPECT_EQ(of("material", "specular_power"), material.SpecularPower);
  EXPECT_EQ(of("material", "opacity"), material.Opacity);
  const MesoSceneContours contours;
  EXPECT_EQ(of("contours", "color"), Json(contours.Color));
  EXPECT_EQ(of("contours", "width"), contours.Width);
  const MesoSceneMap map;
  EXPECT_EQ(of("pattern_brick", "size"), Json(map.Size));
  EXPECT_EQ(of("pattern_brick", "seed"), map.Seed);
  const MesoMesostructureOptions options;
  EXPECT_EQ(of("mesostructure", "tiles"), Json(options.Tiles));
  EXPECT_EQ(of("mesostructure", "scale"), options.Scale);
  EXPECT_EQ(of("mesostructure", "reference"), options.Reference);
  EXPECT_EQ(of("mesostructure", "quality"), MesoName(options.Quality));
}

TEST(SceneSchema, DocumentationNamesEveryKeyAndItsExampleIsRead)
{
  const std::string text = ReadDocument("SceneFile.md");
  for (const MesoSceneKeyGroup& group : MesoSceneKeyTable())
  {
    for (const auto& keys : { group.Served, group.Later })
    {
      for (const std::string& key : keys)
      {
        const bool named = text.find("`" + key + "`") != std::string::npos ||
          text.find("\"" + key + "\"") != std::string::npos;
        EXPECT_TRUE(named) << group.Object << "." << key;
      }
    }
  }
  const std::string fence = "```json\n";
  const std::size_t begin = text.find(fence) + fence.size();
  const std::string example = text.substr(begin, text.find("```", begin) - begin);
  EXPECT_LE(std::count(example.begin(), example.end(), '\n'), 10);
  const MesoScene scene = MesoParseScene(example, "example.json");
  EXPECT_EQ(scene.Nodes.at(0).Mesostructure.Technique, MesoTechnique::Relief);
}
