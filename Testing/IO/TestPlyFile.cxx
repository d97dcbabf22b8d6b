// PLY: the three encodings say the same, texture coordinates in all their places, and the literal
// line for each kind of bad input.

#include "MesoMeshSurface.h"
#include "MesoPlyFile.h"
#include "MessageOf.h"

#include <gtest/gtest.h>

namespace
{
const std::string Quad = "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\n"
                         "property float x\nproperty float y\nproperty float z\n"
                         "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
                         "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

std::string Refusal(const std::string& bytes)
{
  return MessageOf([&] { MesoParsePly(bytes, "m.ply"); });
}

/// A square of two triangles: doubles, normals, texture coordinates, and colours to pass over.
std::string Binary(bool isBig)
{
  std::string bytes = std::string("ply\nformat binary_") + (isBig ? "big" : "little") +
    "_endian 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
    "property float s\nproperty float t\n"
    "element face 2\nproperty list uchar ushort vertex_index\nend_header\n";
  for (int i = 0; i < 4; ++i)
  {
    const double x = i == 1 || i == 2 ? 1000000.0625 : 1000000.;
    const double y = i > 1 ? 1. : 0.;
    bytes += BytesOf(x, isBig) + BytesOf(y, isBig) + BytesOf(-0.5, isBig);
    bytes += BytesOf(0.f, isBig) + BytesOf(0.f, isBig) + BytesOf(2.f, isBig) + '\x7f';
    bytes +=
      BytesOf(static_cast<float>(x - 1000000.), isBig) + BytesOf(static_cast<float>(y), isBig);
  }
  for (const auto& face : { std::array<int, 3>{ 0, 1, 2 }, std::array<int, 3>{ 0, 2, 3 } })
  {
    bytes += '\x03';
    for (int vertex : face)
    {
      bytes += BytesOf(static_cast<std::uint16_t>(vertex), isBig);
    }
  }
  return bytes;
}
}

TEST(PlyFile, ReadsText)
{
  const auto file = MesoParsePly(Quad + "3 0 1 2\n\n3 0 2 3\n", "m.ply");
  EXPECT_EQ(file.Positions[2], (std::array<double, 3>{ 1., 1., 0. }));
  ASSERT_EQ(file.NumberOfFaces(), 2u);
  EXPECT_EQ(file.Corners[4].Position, 2);
  EXPECT_EQ(file.Corners[4].TextureCoordinate, -1);
  EXPECT_EQ(file.FacePlace, (std::vector<std::size_t>{ 15, 17 }));
  EXPECT_STREQ(file.PlaceName, "line");
  EXPECT_TRUE(file.Notes.empty());
}

TEST(PlyFile, ReadsBothByteOrdersInDouble)
{
  const auto little = MesoParsePly(Binary(false), "m.ply");
  const auto big = MesoParsePly(Binary(true), "m.ply");
  EXPECT_EQ(little.Positions, big.Positions);
  EXPECT_EQ(little.Normals, big.Normals);
  EXPECT_EQ(little.TextureCoordinates, big.TextureCoordinates);
  EXPECT_EQ(big.Positions[2], (std::array<double, 3>{ 1000000.0625, 1., -0.5 }));
  EXPECT_EQ(big.Normals[3], (std::array<double, 3>{ 0., 0., 2. }));
  EXPECT_EQ(big.TextureCoordinates[1], (std::array<double, 2>{ 0.0625, 0. }));
  ASSERT_EQ(big.NumberOfFaces(), 2u);
  EXPECT_EQ(big.Corners[5].Position, 3);
  EXPECT_EQ(big.Corners[5].TextureCoordinate, 3);
  EXPECT_EQ(big.Corners[5].Normal, 3);
  EXPECT_STREQ(big.PlaceName, "face");
  EXPECT_EQ(big.Notes, std::vector<std::string>{ "properties of vertex that are not used: red" });
}

TEST(PlyFile, ReadsTextureCoordinatesOfVerticesUnderAllNames)
{
  for (const auto& names : { std::array<std::string, 2>{ "s", "t" }, { "u", "v" },
         { "texture_u", "texture_v" }, { "texture_s", "texture_t" } })
  {
    const auto file = MesoParsePly("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                                   "property float y\nproperty float z\nproperty float " +
        names[1] + "\nproperty float " + names[0] +
        "\nelement face 1\nproperty list uchar int vertex_index\nend_header\n"
        "0 0 0 0.25 0.5\n1 0 0 0 1\n0 1 0 1 0\n3 0 1 2\n",
      "m.ply");
    ASSERT_EQ(file.TextureCoordinates.size(), 3u) << names[0];
    EXPECT_EQ(file.TextureCoordinates[0], (std::array<double, 2>{ 0.5, 0.25 }));
    EXPECT_EQ(file.Corners[2].TextureCoordinate, 2);
  }
}

TEST(PlyFile, ReadsTextureCoordinatesOfFaces)
{
  std::string text = Quad;
  text.insert(
    text.find("end_header"), "property list uchar float texcoord\nproperty int texnumber\n");
  const auto file =
    MesoParsePly(text + "3 0 1 2 6 0 0 1 0 1 1 0\n3 0 2 3 6 0.5 0.5 1 1 0 1 1\n", "m.ply");
  ASSERT_EQ(file.TextureCoordinates.size(), 6u);
  EXPECT_EQ(file.TextureCoordinates[3], (std::array<double, 2>{ 0.5, 0.5 }));
  EXPECT_EQ(file.Corners[3].TextureCoordinate, 3);
  EXPECT_EQ(file.Notes,
    std::vector<std::string>{ "faces use 2 different images (texnumber), which are taken as one" });
  // The seam splits the points at vertex 0; (1, 1) at vertex 2 is the same in both faces.
  EXPECT_EQ(MesoMakeSurface(file, "m.ply").Positions.size(), 5u);

  const auto half = MesoParsePly(text + "3 0 1 2 0 0\n3 0 2 3 6 0 0 1 1 0 1 0\n", "m.ply");
  EXPECT_EQ(half.Corners[0].TextureCoordinate, -1);
  EXPECT_EQ(half.Corners[3].TextureCoordinate, 0);
  EXPECT_EQ(Refusal(text + "3 0 1 2 4 0 0 1 0 0\n"),
    "m.ply: line 17: face 0: texcoord has 4 numbers for 3 corners, not two each");
}

TEST(PlyFile, ReadsStrips)
{
  std::string text = Quad;
  text.replace(text.find("face 2"), 6, "tristrips 1");
  const auto file = MesoParsePly(text + "8 0 1 3 2 -1 0 1 2\n", "m.ply");
  ASSERT_EQ(file.NumberOfFaces(), 3u);
  const int expected[] = { 0, 1, 3, 3, 1, 2, 0, 1, 2 };
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_EQ(file.Corners[i].Position, expected[i]) << i;
  }
}

TEST(PlyFile, NotesWhatItPassesOver)
{
  std::string text = Quad;
  text.insert(text.find("end_header"),
    "element edge 1\nproperty int vertex1\nproperty int vertex2\nelement none 0\n");
  const auto file = MesoParsePly(text + "3 0 1 2\n3 0 2 3\n0 1\n7 7\n", "m.ply");
  EXPECT_EQ(file.Notes,
    (std::vector<std::string>{ "1 elements \"edge\" are not used",
      "line 22 and what follows are after the last element and are not read" }));
  EXPECT_EQ(MesoParsePly(Binary(false) + "more", "m.ply").Notes.back().compare(0, 5, "byte "), 0);
}

TEST(PlyFile, RefusesBadHeaders)
{
  EXPECT_EQ(Refusal("plyer\n"), "m.ply: line 1: the file does not begin with the line \"ply\"");
  EXPECT_EQ(Refusal("ply\nformat ascii 1.0\n"), "m.ply: line 2: the file ends before end_header");
  EXPECT_EQ(Refusal("ply\nend_header\n"), "m.ply: line 2: the header has no line \"format\"");
  EXPECT_EQ(Refusal("ply\nformat utf8 1.0\n"),
    "m.ply: line 2: \"utf8\" is not a format of PLY (ascii, binary_little_endian, "
    "binary_big_endian)");
  EXPECT_EQ(
    Refusal("ply\nformat ascii 2.0\n"), "m.ply: line 2: version \"2.0\" is not read; 1.0 is");
  EXPECT_EQ(
    Refusal("ply\nproperty int x\n"), "m.ply: line 2: a property comes before the first element");
  EXPECT_EQ(Refusal("ply\nelement vertex -3\n"), "m.ply: line 2: element needs a name and a count");
  EXPECT_EQ(Refusal("ply\nelement vertex 4000000000\n"),
    "m.ply: line 2: says 4000000000 elements \"vertex\", which a file of 30 bytes cannot hold");
  EXPECT_EQ(Refusal("ply\nelement vertex 4\nproperty real x\n"),
    "m.ply: line 3: \"real\" is not a type of PLY");
  EXPECT_EQ(Refusal("ply\nelement a 4\nproperty list float int x\n"),
    "m.ply: line 3: a list's count must be a whole number");
  EXPECT_EQ(Refusal("ply\nelement a 4\nproperty int x\nproperty int x\n"),
    "m.ply: line 4: property \"x\" is there already");
  EXPECT_EQ(
    Refusal("ply\nelement a 4\nelement a 4\n"), "m.ply: line 3: element \"a\" is there already");
  EXPECT_EQ(Refusal("ply\nfoo\n"), "m.ply: line 2: \"foo\" is not a keyword of a PLY header");
}

TEST(PlyFile, RefusesBadElements)
{
  EXPECT_EQ(Refusal(Quad + "3 0 1 4\n3 0 1 2\n"),
    "m.ply: line 15: face 0: there is no vertex 4 (there are 4, from 0)");
  EXPECT_EQ(Refusal(Quad + "3 0 1 -1\n3 0 1 2\n"),
    "m.ply: line 15: face 0: there is no vertex -1 (there are 4, from 0)");
  EXPECT_EQ(Refusal(Quad + "3 0 1 1.5\n3 0 1 2\n"),
    "m.ply: line 15: face 0: there is no vertex 1.5 (there are 4, from 0)");
  EXPECT_EQ(Refusal(Quad + "2 0 1\n"), "m.ply: line 15: face 0: has 2 corners, fewer than 3");
  EXPECT_EQ(Refusal(Quad + "3 0 1\n"),
    "m.ply: line 15: face 0: vertex_indices: the line has no number for it");
  EXPECT_EQ(Refusal(Quad + "3 0 1 2 3\n"),
    "m.ply: line 15: face 0: the line has more numbers than the element's properties");
  EXPECT_EQ(
    Refusal(Quad + "3 0 1 2\n"), "m.ply: line 15: face 1: the file ends before this one of 2");
  EXPECT_EQ(Refusal(Quad + "9999 0 1 2\n"),
    "m.ply: line 15: face 0: vertex_indices: a list cannot have 9999 numbers here");
  std::string bad = Quad;
  bad.replace(bad.find("1 1 0\n"), 5, "1 nan 0");
  EXPECT_EQ(Refusal(bad), "m.ply: line 13: vertex 2: y: \"nan\" is not finite or beyond 1e30");
  std::string none = Quad;
  none.replace(none.find("face 2"), 6, "face 0");
  EXPECT_EQ(Refusal(none), "m.ply: holds no faces (4 vertices alone)");
}

TEST(PlyFile, RefusesBadBinaries)
{
  const std::string bytes = Binary(false);
  const std::size_t data = bytes.find("end_header\n") + 11;
  EXPECT_EQ(Refusal(bytes.substr(0, data + 20)),
    "m.ply: byte " + std::to_string(data + 20) + ": vertex 0: z: the file ends");
  EXPECT_EQ(Refusal(bytes.substr(0, bytes.size() - 1)),
    "m.ply: byte " + std::to_string(bytes.size() - 1) + ": face 1: vertex_index: the file ends");
  std::string notFinite = bytes;
  notFinite.replace(data + 8, 8, BytesOf(std::numeric_limits<double>::infinity()));
  EXPECT_EQ(Refusal(notFinite),
    "m.ply: byte " + std::to_string(data + 8) + ": vertex 0: y is not finite or beyond 1e30");
  std::string index = bytes;
  index.replace(bytes.size() - 2, 2, BytesOf(std::uint16_t(9)));
  EXPECT_EQ(Refusal(index),
    "m.ply: byte " + std::to_string(bytes.size()) +
      ": face 1: there is no vertex 9 (there are 4, from 0)");
}

TEST(PlyFile, EveryTruncationIsReadOrRefused)
{
  for (const std::string& whole : { Binary(true), Quad + "3 0 1 2\n3 0 2 3\n" })
  {
    for (std::size_t size = 0; size + 1 < whole.size(); ++size)
    {
      const std::string message = Refusal(whole.substr(0, size));
      EXPECT_EQ(message.compare(0, 7, "m.ply: "), 0) << size << ": " << message;
    }
  }
}
