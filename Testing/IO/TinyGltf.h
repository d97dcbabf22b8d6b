#ifndef TinyGltf_h
#define TinyGltf_h

#include "MessageOf.h"

#include <cstdint>
#include <string>

/// A square as glTF: four positions, normals and texture coordinates, then six indices.
inline std::string TinyGltfBuffer()
{
  std::string bytes;
  const float positions[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  for (const auto& position : positions)
  {
    for (float number : position)
    {
      bytes += BytesOf(number);
    }
  }
  for (int i = 0; i < 4; ++i)
  {
    bytes += BytesOf(0.f) + BytesOf(0.f) + BytesOf(1.f);
  }
  for (const auto& position : positions)
  {
    bytes += BytesOf(position[0]) + BytesOf(1.f - position[1]); // t runs down
  }
  for (std::uint16_t index : { 0, 1, 2, 0, 2, 3 })
  {
    bytes += BytesOf(index);
  }
  return bytes;
}

/// Its JSON; `buffer` is the buffer's `"uri": ..., ` or empty, `nodes` the list of nodes, `more`
/// further keys with a comma after each.
inline std::string TinyGltfJson(const std::string& buffer,
  const std::string& nodes = R"([{"mesh": 0}])", const std::string& more = "")
{
  return R"({"asset": {"version": "2.0"}, )" + more + R"("nodes": )" + nodes + R"(,
"meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}, "indices": 3}]}],
"accessors": [
 {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
 {"bufferView": 0, "byteOffset": 48, "componentType": 5126, "count": 4, "type": "VEC3"},
 {"bufferView": 0, "byteOffset": 96, "componentType": 5126, "count": 4, "type": "VEC2"},
 {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
"bufferViews": [{"buffer": 0, "byteLength": 128}, {"buffer": 0, "byteOffset": 128, "byteLength": 12}],
"buffers": [{)" +
    buffer + R"("byteLength": 140}]})";
}

/// The same as GLB.
inline std::string TinyGlb(const std::string& json = TinyGltfJson(""))
{
  std::string text = json;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string binary = TinyGltfBuffer();
  const auto chunk = [](std::uint32_t kind, const std::string& bytes)
  { return BytesOf(static_cast<std::uint32_t>(bytes.size())) + BytesOf(kind) + bytes; };
  const std::string chunks = chunk(0x4E4F534A, text) + chunk(0x004E4942, binary);
  return "glTF" + BytesOf(std::uint32_t(2)) +
    BytesOf(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

#endif
