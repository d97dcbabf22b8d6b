// glTF and GLB: transforms, mirrors, strips and fans, buffers in all their places, refusals.

#include "MesoGltfFile.h"
#include "TemporaryFolder.h"
#include "TinyGltf.h"

#include <gtest/gtest.h>

namespace
{
std::string Base64(const std::string& bytes)
{
  const char* const alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      bits = (bits << 8) | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (std::size_t k = 0; k < 4; ++k)
    {
      text += i + k > bytes.size() ? '=' : alphabet[(bits >> (18 - 6 * k)) & 63];
    }
  }
  return text;
}

MesoMeshFile Parse(const std::string& json)
{
  return MesoParseGltf(TinyGlb(json), "m.glb");
}

std::string Refusal(const std::string& json)
{
  return MessageOf([&] { Parse(json); });
}

std::string With(const std::string& what, const std::string& instead)
{
  std::string json = TinyGltfJson("");
  const std::size_t place = json.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return json.replace(place, what.size(), instead);
}

using Vector = std::array<double, 3>;
}

TEST(GltfFile, ReadsWhereverTheBufferIs)
{
  const TemporaryFolder folder;
  folder.Write("the buffer.bin", TinyGltfBuffer());
  const std::string inside = TinyGltfJson(
    R"("uri": "data:application/octet-stream;base64,)" + Base64(TinyGltfBuffer()) + R"(", )");
  const std::string beside = TinyGltfJson(R"("uri": "the%20buffer.bin", )");
  for (const std::string& bytes : { TinyGlb(), inside, beside })
  {
    const auto file = MesoParseGltf(bytes, folder.PathOf("m.gltf"));
    ASSERT_EQ(file.NumberOfFaces(), 2u);
    EXPECT_EQ(file.Positions[2], (Vector{ 1., 1., 0. }));
    EXPECT_EQ(file.Normals[2], (Vector{ 0., 0., 1. }));
    EXPECT_EQ(file.TextureCoordinates[2], (std::array<double, 2>{ 1., 1. })) << "t runs up";
    EXPECT_EQ(file.Corners[5].Position, 3);
    EXPECT_TRUE(file.Notes.empty());
  }
}

TEST(GltfFile, AppliesTransformsOfAllNodesAbove)
{
  // Turned by 90 degrees about z, then stretched and moved by the parent's column-major matrix.
  const auto file = Parse(TinyGltfJson("", R"([{"matrix": [2,0,0,0, 0,4,0,0, 0,0,1,0, 10,20,30,1],
    "children": [1]}, {"mesh": 0, "rotation": [0, 0, 1, 1], "scale": [1, 3, 1]}])"));
  // (1, 1, 0) -> scaled (1, 3, 0) -> turned (-3, 1, 0) -> (4, 24, 30)
  EXPECT_NEAR(file.Positions[2][0], 4., 1e-12);
  EXPECT_NEAR(file.Positions[2][1], 24., 1e-12);
  EXPECT_EQ(file.Positions[2][2], 30.);
  EXPECT_GT(file.Normals[0][2], 0.);
}

TEST(GltfFile, AMirrorTurnsTheCornersAndNotTheOutside)
{
  const auto file = Parse(TinyGltfJson("", R"([{"mesh": 0, "scale": [-1, 1, 1]}])"));
  const Vector& a = file.Positions[file.Corners[0].Position];
  const Vector& b = file.Positions[file.Corners[1].Position];
  const Vector& c = file.Positions[file.Corners[2].Position];
  const double z = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  EXPECT_GT(z, 0.) << "counter-clockwise seen from the normal's side";
  EXPECT_GT(file.Normals[0][2], 0.);
}

TEST(GltfFile, AppendsNodesAndPrimitives)
{
  const auto file =
    Parse(TinyGltfJson("", R"([{"mesh": 0}, {"mesh": 0, "translation": [0, 0, 5]}])",
      R"("scenes": [{"nodes": [1, 0]}], )"));
  ASSERT_EQ(file.NumberOfFaces(), 4u);
  EXPECT_EQ(file.Positions[0][2], 5.);
  EXPECT_EQ(file.Positions[4][2], 0.);
  EXPECT_EQ(file.Corners[6].Position, 4);
  EXPECT_EQ(file.Corners[6].TextureCoordinate, 4);
}

TEST(GltfFile, ReadsStripsAndFans)
{
  const auto corners = [](const std::string& mode)
  {
    const auto file = Parse(With("\"indices\": 3", mode));
    std::vector<int> positions;
    for (const MesoMeshCorner& corner : file.Corners)
    {
      positions.push_back(corner.Position);
    }
    return positions;
  };
  EXPECT_EQ(corners("\"mode\": 5"), (std::vector<int>{ 0, 1, 2, 2, 1, 3 }));
  EXPECT_EQ(corners("\"mode\": 6"), (std::vector<int>{ 0, 1, 2, 0, 2, 3 }));
}

TEST(GltfFile, NotesWhatItPassesOver)
{
  const auto file = Parse(TinyGltfJson(
    "", R"([{"mesh": 0}])", R"("materials": [{}, {}], "images": [{"uri": "missing.png"}], )"));
  EXPECT_EQ(file.Notes, std::vector<std::string>{ "what is not used: materials (2), images (1)" });
  EXPECT_EQ(Refusal(With("\"indices\": 3", "\"mode\": 1")), "m.glb: holds no faces");
}

TEST(GltfFile, RefusesBadStructure)
{
  EXPECT_EQ(Refusal(With("2.0", "1.0")), "m.glb: asset.version: glTF 1.0 is not read; 2.0 is");
  EXPECT_EQ(Refusal(TinyGltfJson(
              "", R"([{"children": [1]}, {"children": [0]}])", R"("scenes": [{"nodes": [0]}], )")),
    "m.glb: nodes[0]: is reached twice: nodes must make trees");
  EXPECT_EQ(Refusal(TinyGltfJson("", R"([{"mesh": 3}])")),
    "m.glb: nodes[0].mesh: there is no meshes[3] (there are 1)");
  EXPECT_EQ(Refusal(TinyGltfJson("", R"([{"children": [7]}])")),
    "m.glb: nodes[0].children[0]: there is no nodes[7] (there are 1)");
  EXPECT_EQ(Refusal(TinyGltfJson(
              "", R"([{"mesh": 0}])", R"("extensionsRequired": ["KHR_draco_mesh_compression"], )")),
    "m.glb: extensionsRequired[0]: the file requires the extension KHR_draco_mesh_compression, "
    "which is not read");
  EXPECT_EQ(Refusal("[]"), "m.glb: is not a glTF file: its JSON is a list");
  EXPECT_EQ(Refusal(With("\"POSITION\": 0, ", "")),
    "m.glb: meshes[0].primitives[0].attributes: POSITION is missing");
}

TEST(GltfFile, RefusesBadAccessors)
{
  EXPECT_EQ(Refusal(With("\"count\": 4", "\"count\": 40")),
    "m.glb: accessors[0]: its 40 elements go beyond the 128 bytes of its bufferView");
  EXPECT_EQ(Refusal(With("\"byteLength\": 128", "\"byteLength\": 1280")),
    "m.glb: bufferViews[0]: ends at byte 1280 of a buffer of 140");
  EXPECT_EQ(Refusal(With("\"byteLength\": 140", "\"byteLength\": 1400")),
    "m.glb: buffers[0]: has 140 of the 1400 bytes that byteLength says");
  EXPECT_EQ(Refusal(With("5126", "5124")),
    "m.glb: accessors[0].componentType: is no type of number (5120 to 5123, 5125, 5126)");
  EXPECT_EQ(Refusal(With("VEC3", "VEC4")), "m.glb: accessors[0].type: must be VEC3");
  EXPECT_EQ(Refusal(With("\"count\": 4, \"type\": \"VEC2\"", "\"count\": 3, \"type\": \"VEC2\"")),
    "m.glb: meshes[0].primitives[0].attributes.TEXCOORD_0: has 3 elements for 4 positions");
  EXPECT_EQ(Refusal(With("\"bufferView\": 1", "\"sparse\": {}, \"bufferView\": 1")),
    "m.glb: accessors[3].sparse: sparse accessors are not read");
  EXPECT_EQ(Refusal(With("5123, \"count\": 6", "5125, \"count\": 3")),
    "m.glb: meshes[0].primitives[0].indices: index 0: there is no vertex 65536 (there are 4, from "
    "0)");
}

TEST(GltfFile, RefusesBadBinaries)
{
  const std::string whole = TinyGlb();
  const auto refusal = [](const std::string& bytes)
  { return MessageOf([&] { MesoParseGltf(bytes, "m.glb"); }); };
  EXPECT_EQ(refusal(whole.substr(0, 16)), "m.glb: byte 16: the file ends within its header");
  EXPECT_EQ(refusal("glTF" + BytesOf(1) + whole.substr(8)),
    "m.glb: byte 4: GLB version 1 is not read; 2 is");
  for (std::size_t size = 4; size < whole.size(); ++size)
  {
    EXPECT_EQ(refusal(whole.substr(0, size)).compare(0, 7, "m.glb: "), 0) << size;
  }
  EXPECT_EQ(MessageOf([] { MesoParseGltf(TinyGltfJson(R"("uri": "none.bin", )"), "/tmp/m.gltf"); }),
    "/tmp/m.gltf: buffers[0].uri: \"/tmp/none.bin\": there is no such file");
}
