#include "InfoScene.h"

#include "MesoFileBytes.h"
#include "MesoScene.h"
#include "MesoSceneBuilder.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

namespace
{
using Json = nlohmann::ordered_json;

class SceneReporter
{
public:
  explicit SceneReporter(const std::string& fileName)
    : Scene(MesoParseScene(MesoReadBytes(fileName, MesoLargestSceneFile, "a scene file"), fileName))
  {
  }

  Json Report()
  {
    Json nodes = Json::array();
    for (std::size_t i = 0; i < this->Scene.Nodes.size(); ++i)
    {
      this->Add(this->Scene.Nodes[i], "nodes[" + std::to_string(i) + "]", nodes);
    }
    Json json;
    json["file"] = this->Scene.File;
    json["kind"] = "scene";
    json["lights"] = this->Scene.Lights.size();
    json["missing"] = this->Missing;
    Json warnings = Json::array();
    if (this->Missing.empty())
    {
      MesoSceneBuilder builder;
      vtkNew<vtkRenderer> renderer;
      builder.Build(this->Scene, renderer);
      for (const MesoSceneBuilder::Object& object : builder.GetObjects())
      {
        Json& node = nodes[object.Number - 1];
        node["triangles"] = static_cast<std::size_t>(object.Mesh->GetNumberOfPolys());
        if (object.HeightMap)
        {
          int size[3];
          object.HeightMap->GetDimensions(size);
          node["map_size"] = { size[0], size[1] };
        }
      }
      warnings = builder.GetWarnings();
    }
    json["nodes"] = nodes;
    json["warnings"] = warnings;
    return json;
  }

private:
  /// Nodes in the order in which the builder counts them: children after their parent.
  void Add(const MesoSceneNode& node, const std::string& place, Json& nodes)
  {
    Json json;
    json["place"] = place;
    if (!node.Name.empty())
    {
      json["name"] = node.Name;
    }
    if (node.Mesh)
    {
      const bool isFile = !node.Mesh->File.empty();
      json["mesh"] = isFile ? node.Mesh->File : "shape " + node.Mesh->Shape;
      this->Check(node.Mesh->File, place + ".mesh");
      json["technique"] = MesoName(node.Mesostructure.Technique);
      json["quality"] = MesoName(node.Mesostructure.Quality);
      std::string effects;
      for (const std::string& name : MesoEffectsOn(node.Mesostructure).Names())
      {
        effects += (effects.empty() ? "" : ", ") + name;
      }
      json["effects"] = effects.empty() ? "none" : effects;
      this->Check(node.Material.ColorMap, place + ".material.color_map");
    }
    if (node.Map)
    {
      const std::string key = node.Map->IsReliefMap ? "relief_map"
        : node.Map->IsDepth                         ? "depth_map"
                                                    : "height_map";
      json[key] = node.Map->File.empty() ? "pattern " + node.Map->Pattern : node.Map->File;
      json["scale"] = node.Mesostructure.Scale;
      json["tiles"] = node.Mesostructure.Tiles;
      this->Check(node.Map->File, place + ".mesostructure." + key);
    }
    nodes.push_back(json);
    for (std::size_t i = 0; i < node.Children.size(); ++i)
    {
      this->Add(node.Children[i], place + ".children[" + std::to_string(i) + "]", nodes);
    }
  }

  void Check(const std::string& file, const std::string& place)
  {
    const std::string reason = file.empty() ? "" : MesoWhyNoFile(file);
    if (!reason.empty())
    {
      this->Missing.push_back(place + ": " + file + ": " + reason);
    }
  }

  const MesoScene Scene;
  Json Missing = Json::array();
};
}

nlohmann::ordered_json JsonOfScene(const std::string& fileName)
{
  return SceneReporter(fileName).Report();
}
