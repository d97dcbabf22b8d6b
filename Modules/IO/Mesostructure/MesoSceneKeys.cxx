#include "MesoSceneKeys.h"

#include "MesoPattern.h"
#include "MesoShape.h"
#include "MesoVolumePattern.h"

#include <algorithm>
#include <stdexcept>

namespace
{
std::vector<MesoSceneKeyGroup> MakeTable()
{
  std::vector<MesoSceneKeyGroup> table = {
    { "scene", { "meso", "camera", "lights", "background", "clipping_planes", "nodes" },
      { "environment" } },
    { "camera",
      { "position", "focal_point", "view_up", "view_angle", "parallel_scale", "clipping_range" },
      {} },
    { "light",
      { "type", "direction", "position", "focal_point", "cone_angle", "exponent", "attenuation",
        "color", "intensity", "shadow", "coordinates" },
      {} },
    { "transform", { "matrix", "translate", "rotate", "scale" }, {} },
    { "node",
      { "name", "transform", "children", "mesh", "feature_angle", "subdivide", "part", "material",
        "mesostructure" },
      {} },
    { "part", { "by", "range" }, {} },
    { "material",
      { "color", "color_map", "normal_map", "normal_map_y", "color_by", "lookup_table",
        "scalar_bar", "contours", "ambient", "diffuse", "specular", "specular_power", "opacity",
        "two_sided", "edges" },
      {} },
    { "lookup_table", { "name", "range" }, {} },
    { "scalar_bar", { "title", "units", "values_of" }, {} },
    { "contours", { "spacing", "values", "values_of", "color", "width" }, {} },
    { "mesostructure",
      { "technique", "height_map", "depth_map", "relief_map", "range", "sample_spacing", "scale",
        "reference", "tiles", "wrap", "quality", "search", "quadric", "curved", "parallax",
        "penumbra", "facet_pixels", "baked", "rank", "effects", "volume", "tile_mesh",
        "volume_colors", "segments", "exits", "stack", "interpolation", "filter", "curvature_at" },
      {} },
    { "volume_file", { "file", "threshold", "solid", "crop", "blend", "size" }, {} },
    { "mesh_tile", { "file", "box", "size" }, {} },
  };
  for (const std::string& shape : MesoShapeNames())
  {
    MesoSceneKeyGroup group = { "shape_" + shape, { "shape" }, {} };
    for (const MesoParameter& parameter : MesoShapeParameters(shape))
    {
      group.Served.push_back(parameter.Key);
    }
    table.push_back(group);
  }
  for (const std::string& pattern : MesoPatternNames())
  {
    MesoSceneKeyGroup group = { "pattern_" + pattern, { "pattern", "size", "seed" }, {} };
    for (const MesoParameter& parameter : MesoPatternParameters(pattern))
    {
      group.Served.push_back(parameter.Key);
    }
    table.push_back(group);
  }
  for (const std::string& pattern : MesoVolumePatternNames())
  {
    MesoSceneKeyGroup group = { "volume_" + pattern, { "pattern", "size", "seed" }, {} };
    for (const MesoParameter& parameter : MesoVolumePatternParameters(pattern))
    {
      group.Served.push_back(parameter.Key);
    }
    table.push_back(group);
  }
  return table;
}

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b` (optimal
/// string alignment).
std::size_t EditDistance(const std::string& a, const std::string& b)
{
  std::vector<std::vector<std::size_t>> distance(
    a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
  {
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
      if (i == 0 || j == 0)
      {
        distance[i][j] = i + j;
        continue;
      }
      const std::size_t replaced = distance[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      distance[i][j] = std::min({ distance[i - 1][j] + 1, distance[i][j - 1] + 1, replaced });
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
      {
        distance[i][j] = std::min(distance[i][j], distance[i - 2][j - 2] + 1);
      }
    }
  }
  return distance[a.size()][b.size()];
}
}

const std::vector<MesoSceneKeyGroup>& MesoSceneKeyTable()
{
  static const std::vector<MesoSceneKeyGroup> table = MakeTable();
  return table;
}

const MesoSceneKeyGroup& MesoSceneKeysOf(const std::string& object)
{
  for (const MesoSceneKeyGroup& group : MesoSceneKeyTable())
  {
    if (group.Object == object)
    {
      return group;
    }
  }
  throw std::out_of_range("the scene file has no object " + object);
}

std::string MesoNearestWord(const std::string& word, const std::vector<std::string>& choices)
{
  constexpr std::size_t longest = 64; // no key is longer, and the distance takes quadratic time
  std::string nearest;
  if (word.size() > longest)
  {
    return nearest;
  }
  std::size_t least = std::max<std::size_t>(word.size() / 3, 1) + 1;
  for (const std::string& choice : choices)
  {
    const std::size_t distance = EditDistance(word, choice);
    if (distance < least)
    {
      least = distance;
      nearest = choice;
    }
  }
  return nearest;
}
