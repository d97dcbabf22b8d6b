// The OBJ scanner: what it reads, and the literal line for each kind of bad input.

#include "MesoObjFile.h"
#include "MesoScene.h" // for MesoInputError

#include <gtest/gtest.h>

namespace
{
const std::string Triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string MessageOf(const std::string& text)
{
  try
  {
    MesoParseObj(text, "m.obj");
  }
  catch (const MesoInputError& error)
  {
    return error.what();
  }
  return "read without an error";
}

bool Mentions(const std::string& message, const std::string& part)
{
  return message.find(part) != std::string::npos && message.find('\n') == std::string::npos;
}
}

TEST(ObjFile, ReadsCornersOfAllForms)
{
  const auto file = MesoParseObj(Triangle +
      "vt 0.25 0.5\nvt 1\nvn 0 0 2\n"
      "f 1 2 3\nf 1/1 2/2 3/1\nf 1//1 2//1 3//1\n"
      "f 1/1/1 2/2/1 3/2/1\nf -3/-2/-1 -2/-1/-1 -1/-1/-1\n",
    "m.obj");
  ASSERT_EQ(file.NumberOfFaces(), 5u);
  EXPECT_EQ(file.TextureCoordinates[1], (std::array<double, 2>{ 1., 0. }));
  EXPECT_EQ(file.Normals[0], (std::array<double, 3>{ 0., 0., 2. }));
  const auto corner = [&](std::size_t i)
  {
    const MesoMeshCorner& c = file.Corners[i];
    return std::array<int, 3>{ c.Position, c.TextureCoordinate, c.Normal };
  };
  EXPECT_EQ(corner(1), (std::array<int, 3>{ 1, -1, -1 }));
  EXPECT_EQ(corner(4), (std::array<int, 3>{ 1, 1, -1 }));
  EXPECT_EQ(corner(7), (std::array<int, 3>{ 1, -1, 0 }));
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(corner(9 + i), corner(12 + i)) << "negative indices count back";
  }
  EXPECT_EQ(file.FacePlace, (std::vector<std::size_t>{ 7, 8, 9, 10, 11 }));
}

TEST(ObjFile, NegativeIndicesCountFromTheirOwnLine)
{
  const auto file = MesoParseObj(Triangle + "f -3 -2 -1\nv 5 5 5\nv 6 6 6\nf -2 -1 1\n", "m.obj");
  EXPECT_EQ(file.Corners[0].Position, 0);
  EXPECT_EQ(file.Corners[3].Position, 3);
  EXPECT_EQ(file.Corners[4].Position, 4);
}

TEST(ObjFile, ReadsDoublesAndWhatWritersDoToLines)
{
  const auto file = MesoParseObj("\xef\xbb\xbf# mark\r\n  v\t1234567.8901234 +2 -3e-2 1.0\r\n"
                                 "v 1 2 3 0.5 0.5 0.5\nv 1e-400 0 0\n\nmtllib none.mtl\no x\n"
                                 "usemtl y\ns off\nf 1 \\\r\n 2 \\\n 3 # a comment\r\nf 1 2 3#x",
    "m.obj");
  EXPECT_EQ(file.Positions[0], (std::array<double, 3>{ 1234567.8901234, 2., -0.03 }));
  EXPECT_EQ(file.Positions[2][0], 0.);
  EXPECT_EQ(file.NumberOfFaces(), 2u);
  EXPECT_EQ(file.FacePlace, (std::vector<std::size_t>{ 10, 13 }));
  EXPECT_TRUE(file.Notes.empty());
}

TEST(ObjFile, NotesWhatItPassesOver)
{
  const auto file = MesoParseObj(Triangle + "l 1 2\np 1\nfoo bar\nf 1 2 3\n", "m.obj");
  ASSERT_EQ(file.Notes.size(), 2u);
  EXPECT_EQ(file.Notes[0], "1 lines have keywords that OBJ does not have (first line 6: foo)");
  EXPECT_EQ(file.Notes[1], "2 points, lines, curves or surfaces are left out (first line 4: l)");
}

TEST(ObjFile, FacesMayComeBeforeTheirVertices)
{
  EXPECT_EQ(MesoParseObj("f 1 2 3\n" + Triangle, "m.obj").Corners[2].Position, 2);
  EXPECT_EQ(MessageOf("v 0 0 0\nf 1 2 4\n" + Triangle.substr(8)),
    "m.obj: line 2: there is no vertex 4 (there are 3)");
}

TEST(ObjFile, RefusesBadIndices)
{
  const std::string at = "m.obj: line 4: there is no ";
  EXPECT_EQ(MessageOf(Triangle + "f 0 1 2\n"), at + "vertex 0 (there are 3)");
  EXPECT_EQ(MessageOf(Triangle + "f 1 2 4\n"), at + "vertex 4 (there are 3)");
  EXPECT_EQ(MessageOf(Triangle + "f 1 2 -4\n"), at + "vertex -4 (there are 3)");
  EXPECT_EQ(MessageOf(Triangle + "f 1/1 2/1 3/1\n"), at + "texture coordinate 1 (there are 0)");
  EXPECT_EQ(MessageOf(Triangle + "f 1//9 2 3\n"), at + "normal 9 (there are 0)");
  EXPECT_TRUE(Mentions(MessageOf(Triangle + "f 1 2 99999999999\n"), at + "vertex 99999999999"));
  EXPECT_TRUE(
    Mentions(MessageOf(Triangle + "f 1 2 99999999999999999999\n"), at + "vertex 9999999"));
  EXPECT_TRUE(Mentions(MessageOf(Triangle + "f 1 2 3.5\n"), "line 4: \"3.5\" is not an index"));
  EXPECT_TRUE(Mentions(MessageOf(Triangle + "f 1 2 /3\n"), "line 4: \"/3\" names no vertex"));
  EXPECT_TRUE(Mentions(MessageOf(Triangle + "f 1 2 1/2/3/4\n"), "is not a corner of a face"));
}

TEST(ObjFile, RefusesBadNumbers)
{
  for (const char* word : { "nan", "NaN", "inf", "-inf", "1e31", "1e999" })
  {
    EXPECT_TRUE(Mentions(MessageOf(Triangle + "v 0 " + word + " 0\n"),
      std::string("m.obj: line 4: \"") + word + "\" is not finite"))
      << word;
    EXPECT_TRUE(Mentions(MessageOf("vt 0 " + std::string(word)), "line 1: \"")) << word;
  }
  EXPECT_EQ(MessageOf("v 0 0 x\n"), "m.obj: line 1: \"x\" is not a number");
  EXPECT_EQ(MessageOf("v 0 0 1,5\n"), "m.obj: line 1: \"1,5\" is not a number");
  EXPECT_EQ(MessageOf("v 0 0"), "m.obj: line 1: v has 2 of 3 numbers");
  EXPECT_EQ(MessageOf("vt"), "m.obj: line 1: vt has 0 of 1 numbers");
}

TEST(ObjFile, RefusesFilesThatAreNoMesh)
{
  EXPECT_EQ(MessageOf(""), "m.obj: is empty");
  EXPECT_EQ(MessageOf("# nothing\n"), "m.obj: holds no faces");
  EXPECT_EQ(MessageOf(Triangle), "m.obj: holds no faces");
  EXPECT_EQ(MessageOf("hello world\nmore\n"), "m.obj: holds no faces (line 1: hello is not OBJ)");
  EXPECT_TRUE(Mentions(MessageOf("\x89PNG\r\n\x1a\n"), "m.obj: line 1: "));
  EXPECT_TRUE(Mentions(MessageOf(std::string(100, '\0')), "m.obj: line 1: "));
  EXPECT_EQ(MessageOf(Triangle + "f 1 2"), "m.obj: line 4: face has 2 corners, fewer than 3");
  std::string wide = "f";
  for (std::size_t i = 0; i <= MesoMeshMostCorners; ++i)
  {
    wide += " 1";
  }
  EXPECT_EQ(MessageOf(Triangle + wide), "m.obj: line 4: face has more than 4096 corners");
}

TEST(ObjFile, EveryTruncationIsReadOrRefused)
{
  const std::string text =
    Triangle + "vt 0 0\nvt 1 0\nvn 0 0 1\nf 1/1/1 2/2/1 3/1/1\nf 3/1/1 2/2/1 1/1/1\n";
  for (std::size_t length = 0; length < text.size(); ++length)
  {
    const std::string message = MessageOf(text.substr(0, length));
    EXPECT_TRUE(Mentions(message, "m.obj: ") || message == "read without an error") << length;
  }
}
