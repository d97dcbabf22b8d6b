#ifndef MesoSceneKeys_h
#define MesoSceneKeys_h

/**
 * @file MesoSceneKeys.h
 * @brief Which keys the objects of a scene file have: the one list that reader, schema and
 * documentation are held to.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <string>
#include <vector>

/// The keys of one kind of object.
struct MesoSceneKeyGroup
{
  /// "scene", "camera", "light", "transform", "node", "material", "lookup_table",
  /// "scalar_bar", "contours", "mesostructure", "volume_file", "mesh_tile", "shape_<name>", "pattern_<name>" and
  /// "volume_<name>"; the JSON Schema defines each under the same name.
  std::string Object;
  std::vector<std::string> Served; ///< read and used
  std::vector<std::string> Later;  ///< part of the format, refused as not available yet
};

/// All kinds of objects; the first is "scene".
MESOIOMESOSTRUCTURE_EXPORT const std::vector<MesoSceneKeyGroup>& MesoSceneKeyTable();

/// The group of that name. Throws std::out_of_range where there is none.
MESOIOMESOSTRUCTURE_EXPORT const MesoSceneKeyGroup& MesoSceneKeysOf(const std::string& object);

/**
 * The one of `choices` that `word` is most likely a misspelling of, or an empty string where none
 * is near: at most a third of its letters inserted, left out, replaced or swapped with the next.
 */
MESOIOMESOSTRUCTURE_EXPORT std::string MesoNearestWord(
  const std::string& word, const std::vector<std::string>& choices);

#endif
