// STL, text and binary: positions, notes, and the literal line for each kind of bad input.

#include "MesoMeshSurface.h"
#include "MesoStlFile.h"
#include "MessageOf.h"

#include <gtest/gtest.h>

namespace
{
const std::string Facet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n"
                          "  vertex 0 1 0\n endloop\nendfacet\n";

std::string Refusal(const std::string& bytes)
{
  return MessageOf([&] { MesoParseStl(bytes, "m.stl"); });
}

/// The four sides of a tetrahedron.
std::string Binary(const std::string& header = "by hand")
{
  const float points[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const int faces[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  std::string bytes = header;
  bytes.resize(80, ' ');
  bytes += BytesOf(std::uint32_t(4));
  for (const auto& face : faces)
  {
    bytes += std::string(12, '\0');
    for (int corner : face)
    {
      for (float number : points[corner])
      {
        bytes += BytesOf(number);
      }
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}
}

TEST(StlFile, ReadsText)
{
  const auto file =
    MesoParseStl("solid a b c\n" + Facet + "endsolid a\nSOLID\n" + Facet + "endsolid\n", "m.stl");
  ASSERT_EQ(file.NumberOfFaces(), 2u);
  EXPECT_EQ(file.Positions[1], (std::array<double, 3>{ 1., 0., 0. }));
  EXPECT_EQ(file.FacePlace, (std::vector<std::size_t>{ 2, 11 }));
  EXPECT_EQ(file.Notes, std::vector<std::string>{ "2 solids are taken as one mesh" });
}

TEST(StlFile, ReadsBinaryAndJoinsFacets)
{
  const auto file = MesoParseStl(Binary(), "m.stl");
  EXPECT_TRUE(file.Notes.empty());
  const auto surface = MesoMakeSurface(file, "m.stl");
  EXPECT_EQ(surface.Positions.size(), 4u);
  EXPECT_EQ(surface.Triangles.size(), 4u);
  EXPECT_EQ(surface.NumberOfOpenEdges, 0u);
  // Many writers begin the header's free text of binary files with "solid".
  EXPECT_EQ(MesoParseStl(Binary("solid thing\n"), "m.stl").NumberOfFaces(), 4u);
}

TEST(StlFile, NotesWhatItPassesOver)
{
  std::string bytes = Binary();
  bytes[84 + 48] = 1;
  bytes.replace(84 + 8, 4, BytesOf(1.f)); // the first facet looks down
  const auto file = MesoParseStl(bytes + "xyz", "m.stl");
  EXPECT_EQ(file.Notes,
    (std::vector<std::string>{ "3 bytes after the last facet (from byte 284) are not read",
      "attributes (colours) of 1 facets are not used",
      "1 of 4 facets have normals against the order of their corners, which is what is taken" }));
  // Facets without area have normals of all kinds.
  const std::string odd = "facet normal nan nan nan" + Facet.substr(Facet.find('\n'));
  EXPECT_TRUE(MesoParseStl("solid\n" + odd + "endsolid\n", "m.stl").Notes.empty());
}

TEST(StlFile, RefusesBadText)
{
  EXPECT_EQ(Refusal("solid a\nendsolid\n"), "m.stl: holds no faces");
  EXPECT_EQ(Refusal("solid a\n" + Facet), "m.stl: line 8: the file ends before endsolid");
  EXPECT_EQ(
    Refusal("solid a\n" + Facet.substr(0, 70)), "m.stl: line 6: vertex has fewer than 3 numbers");
  EXPECT_EQ(Refusal("solid a\n" + Facet.substr(0, 66)),
    "m.stl: line 6: \"ver\" stands where vertex should");
  EXPECT_EQ(
    Refusal("solid a\nfacet normal 0 0 1\n"), "m.stl: line 2: the file ends where outer should be");
  EXPECT_EQ(
    Refusal("solid a\nhello\n"), "m.stl: line 2: \"hello\" stands where facet or endsolid should");
  std::string bad = "solid a\n" + Facet + "endsolid\n";
  bad.replace(bad.find("1 0 0"), 5, "1 inf 0");
  EXPECT_EQ(Refusal(bad), "m.stl: line 5: vertex \"inf\" is not finite or beyond 1e30");
}

TEST(StlFile, RefusesBadBinaries)
{
  const std::string bytes = Binary();
  EXPECT_EQ(Refusal("junk"),
    "m.stl: is no STL: it does not begin with \"solid\", and has 4 bytes where a binary header "
    "has 84");
  EXPECT_EQ(Refusal(bytes.substr(0, 200)), "m.stl: byte 200: the file ends after 2 of 4 facets");
  std::string huge = bytes;
  huge.replace(80, 4, BytesOf(std::uint32_t(4000000000u)));
  EXPECT_EQ(Refusal(huge), "m.stl: byte 284: the file ends after 4 of 4000000000 facets");
  std::string notFinite = bytes;
  notFinite.replace(84 + 50 + 12, 4, BytesOf(std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(
    Refusal(notFinite), "m.stl: byte 146: facet 1: a coordinate is not finite or beyond 1e30");
  EXPECT_EQ(Refusal(bytes.substr(0, 80) + std::string(4, '\0')), "m.stl: holds no faces");
}
