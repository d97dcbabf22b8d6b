// OFF: its kinds of text, and the literal line for each kind of bad input.

#include "MesoOffFile.h"
#include "MessageOf.h"

#include <gtest/gtest.h>

namespace
{
const std::string Triangle = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

std::string Refusal(const std::string& text)
{
  return MessageOf([&] { MesoParseOff(text, "m.off"); });
}
}

TEST(OffFile, ReadsCountsWhereverTheyStand)
{
  for (const char* head : { "OFF\n3 1 0\n", "OFF 3 1 0\n", "3 1 0\n", "# x\nOFF # y\n\n3 1\n" })
  {
    const auto file = MesoParseOff(head + Triangle, "m.off");
    ASSERT_EQ(file.NumberOfFaces(), 1u) << head;
    EXPECT_EQ(file.Positions[1], (std::array<double, 3>{ 1., 0., 0. }));
    EXPECT_EQ(file.Corners[2].Position, 2);
    EXPECT_TRUE(file.Notes.empty());
  }
}

TEST(OffFile, ReadsNormalsAndTextureCoordinates)
{
  const auto file = MesoParseOff("STCNOFF\n3 1 0\n0 0 0 0 0 2 255 0 0 255 0.25 0.5\n"
                                 "1 0 0 0 0 1 255 0 0 1 0\n0 1 0 0 0 1 255 0 0 0 1\n"
                                 "3 0 1 2 255 255 0\n",
    "m.off");
  EXPECT_EQ(file.Normals[0], (std::array<double, 3>{ 0., 0., 2. }));
  EXPECT_EQ(file.TextureCoordinates[0], (std::array<double, 2>{ 0.25, 0.5 }));
  EXPECT_EQ(file.TextureCoordinates[1], (std::array<double, 2>{ 1., 0. }));
  EXPECT_EQ(file.Corners[1].TextureCoordinate, 1);
  EXPECT_EQ(file.Corners[1].Normal, 1);
  EXPECT_EQ(file.Notes,
    std::vector<std::string>{ "colours or further numbers of 4 vertices and faces are not used" });
}

TEST(OffFile, RefusesBadFiles)
{
  EXPECT_EQ(
    Refusal("hello"), "m.off: line 1: the file begins with \"hello\", neither OFF nor a count");
  EXPECT_EQ(Refusal("4OFF\n3 1 0\n"),
    "m.off: line 1: \"4OFF\" is a kind of OFF that is not read ([ST][C][N]OFF are)");
  EXPECT_EQ(Refusal("OFF BINARY\nxyz"), "m.off: line 1: binary OFF is not read; text is");
  EXPECT_EQ(Refusal("OFF"), "m.off: line 1: the file ends where the counts should be");
  EXPECT_EQ(Refusal("OFF\n3 x\n"), "m.off: line 2: number of faces: \"x\" is not a whole number");
  EXPECT_EQ(Refusal("OFF\n9999999 1 0\n"),
    "m.off: line 2: says 9999999 vertices, which a file of 16 bytes cannot hold");
  EXPECT_EQ(
    Refusal("OFF\n3 -1 0\n"), "m.off: line 2: says -1 faces, which a file of 11 bytes cannot hold");
  EXPECT_EQ(
    Refusal("OFF\n3 1 0\n0 0 0\n"), "m.off: line 3: the file ends where vertex 1 of 3 should be");
  EXPECT_EQ(Refusal("OFF\n3 1 0\n0 0\n"), "m.off: line 3: vertex 0: position has too few numbers");
  EXPECT_EQ(Refusal("OFF\n3 1 0\n0 nan 0\n"),
    "m.off: line 3: vertex 0: position \"nan\" is not finite or beyond 1e30");
  const std::string head = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(Refusal(head + "3 0 1 3\n"),
    "m.off: line 6: face 0: there is no vertex 3 (there are 3, from 0)");
  EXPECT_EQ(Refusal(head + "3 0 1\n"), "m.off: line 6: face 0: too few corners");
  EXPECT_EQ(Refusal(head + "2 0 1\n"), "m.off: line 6: face 0 has 2 corners, fewer than 3");
  EXPECT_EQ(
    Refusal(head + "9999999 0 1\n"), "m.off: line 6: face 0 has 9999999 corners, more than 4096");
  EXPECT_EQ(Refusal("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n"), "m.off: holds no faces");
}

TEST(OffFile, NotesWhatFollows)
{
  EXPECT_EQ(MesoParseOff("OFF 3 1 0\n" + Triangle + "3 0 1 2\n", "m.off").Notes,
    std::vector<std::string>{ "line 6 and what follows are after the last face and are not read" });
}
