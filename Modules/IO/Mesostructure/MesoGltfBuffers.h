#ifndef MesoGltfBuffers_h
#define MesoGltfBuffers_h

/**
 * @file MesoGltfBuffers.h
 * @brief The numbers of a glTF file: accessors over views of buffers, all checked.
 */

#include "MesoSceneValue.h"

#include <string>
#include <vector>

class MesoGltfBuffers
{
public:
  /// `root` is the file's JSON and stays the caller's; `binary` is the GLB's chunk, moved in.
  MesoGltfBuffers(const MesoSceneValue& root, const std::string& fileName, std::string binary);

  /**
   * The accessor whose number is `index`, as `components` numbers for each element (3 for VEC3, 1
   * for SCALAR), normalised integers brought to [0, 1] or [-1, 1]. Fails where the file has no such
   * accessor or the accessor is of another type, sparse, or beyond its buffer.
   */
  std::vector<double> Read(const MesoSceneValue& index, std::size_t components);

private:
  const std::string& Buffer(const MesoSceneValue& index);

  const MesoSceneValue& Root;
  std::string FileName;
  std::string Binary;
  std::vector<std::string> Buffers; ///< empty until it is needed
};

/// The element of the list `key` of `root` that `index` numbers; fails at `index` where there is
/// none.
MesoSceneValue MesoGltfElement(
  const MesoSceneValue& root, const std::string& key, const MesoSceneValue& index);

#endif
