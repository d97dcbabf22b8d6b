#ifndef BenchResults_h
#define BenchResults_h

#include <nlohmann/json.hpp>

#include <optional>
#include <string>

/**
 * What a bench has found so far, kept in `results.json` and `results.csv` of its folder.
 *
 * results.json: `machine`, `device`, `version`, `scenes` and `rows`. A scene: `scene` (name), `file`,
 * `key`, `size`, `status`, `reason`, `truths` ("mesh", and "smooth" where there is such a truth) and
 * `surfaces`, the figures of the mesh's truth against the smooth one. A row: `scene`, `technique`,
 * `quality`, `key`, `status` ("ok" or "refused") and `reason`; where ok also `judged_by` ("mesh" or
 * "smooth"), `errors` (figures of JsonOfError() by "mesh", by "smooth", and by "solver", the technique's own model
 * solved exactly, where there are such) and figures of cost. `ablations` are rows as well, each with
 * the effect that was off in `without` ("none": all on). `scaling` holds what BenchScaling found. A key
 * is a sum over all that the numbers depend on but the program itself, so that what is there need not be
 * done again.
 */
class BenchResults
{
public:
  using Json = nlohmann::ordered_json;

  /// Takes what the folder holds; `fresh` leaves it out. Throws MesoInputError where results.json is
  /// there but none of this program's.
  BenchResults(const std::string& folder, bool fresh);

  void Describe(const std::string& device);

  /// The scene or row of this key, null where there is none.
  const Json* FindScene(const std::string& name, const std::string& key) const;
  const Json* FindRow(const std::string& key) const;
  /// Takes the place of a scene of the same name, or a row of the same scene, technique, quality and
  /// ablation.
  void SetScene(Json scene);
  void SetRow(Json row);

  const Json& All() const { return this->Content; }
  /// The rows of a scene, in the order of techniques and qualities that the program knows.
  std::vector<Json> RowsOf(const std::string& scene) const;
  /// The rows of its ablations, in the order of techniques, qualities and effects.
  std::vector<Json> AblationsOf(const std::string& scene) const;

  void SetScaling(Json scaling) { this->Content["scaling"] = std::move(scaling); }

  /// Writes results.json and results.csv.
  void Save() const;

private:
  std::string Csv() const;

  std::string Folder;
  Json Content;
};

/// A sum of 64 bits over some bytes (FNV-1a), 16 hexadecimal digits: tells contents apart.
std::string BenchKey(const std::string& bytes);

#endif
