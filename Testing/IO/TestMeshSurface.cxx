// OBJ faces as triangles over split points: seams, merged positions, sheets, and all that is noted.

#include "MesoMeshSurface.h"
#include "MesoObjFile.h"
#include "MesoScene.h" // for MesoInputError

#include <gtest/gtest.h>

#include <set>

namespace
{
const std::string Square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

MesoMeshSurface Make(const std::string& text)
{
  return MesoMakeSurface(MesoParseObj(text, "m.obj"), "m.obj");
}

using Triangle = std::array<std::int32_t, 3>;
}

TEST(ObjSurface, PointsAreSplitAtSeams)
{
  // Two triangles with one texture coordinate of the shared edge different.
  const auto surface =
    Make(Square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 9 9\nf 1/1 2/2 3/3\nf 1/1 3/5 4/4\n");
  ASSERT_EQ(surface.Positions.size(), 5u);
  EXPECT_EQ(surface.NumberOfVertices, 4u);
  EXPECT_EQ(surface.Vertex, (std::vector<std::int32_t>{ 0, 1, 2, 2, 3 }));
  EXPECT_EQ(surface.Triangles, (std::vector<Triangle>{ { 0, 1, 2 }, { 0, 3, 4 } }));
  EXPECT_EQ(surface.TextureCoordinates[3], (std::array<double, 2>{ 9., 9. }));
  EXPECT_EQ(surface.Positions[2], surface.Positions[3]);
  EXPECT_EQ(surface.NumberOfOpenEdges, 4u);
  EXPECT_TRUE(surface.Notes.empty());
}

TEST(ObjSurface, EqualValuesUnderDifferentNumbersAreOne)
{
  const auto surface = Make("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 -0 -0\nv 1 1 0\nv 0 1 0\n"
                            "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 0\nvt 1 1\nvt 0 1\n"
                            "f 1/1 2/2 3/3\nf 4/4 5/5 6/6\n");
  EXPECT_EQ(surface.Positions.size(), 4u);
  EXPECT_EQ(surface.NumberOfVertices, 4u);
  EXPECT_EQ(surface.NumberOfOpenEdges, 4u);
}

TEST(ObjSurface, NormalsSplitPointsAndGetUnitLength)
{
  const auto surface = Make(Square + "vn 0 0 2\nvn 0 3 4\nf 1//1 2//1 3//1\nf 1//2 3//1 4//1\n");
  ASSERT_EQ(surface.Normals.size(), 5u);
  EXPECT_EQ(surface.Normals[0], (std::array<double, 3>{ 0., 0., 1. }));
  EXPECT_DOUBLE_EQ(surface.Normals[3][2], 0.8);
  EXPECT_EQ(surface.Vertex[3], surface.Vertex[0]);
  EXPECT_TRUE(surface.TextureCoordinates.empty());
}

TEST(ObjSurface, IncompleteNormalsAreNotUsed)
{
  for (const char* faces :
    { "f 1//1 2//1 3//1\nf 1 3 4\n", "f 1//1 2//1 3//2\nf 1//1 3//1 4//1\n" })
  {
    const auto surface = Make(Square + "vn 0 0 1\nvn 0 0 0\n" + faces);
    EXPECT_TRUE(surface.Normals.empty());
    EXPECT_EQ(surface.Positions.size(), 4u) << "a normal that is not used splits nothing";
    ASSERT_EQ(surface.Notes.size(), 2u);
    EXPECT_EQ(surface.Notes[1].substr(0, 41), "1 faces have corners without a normal, or");
  }
}

TEST(ObjSurface, MissingTextureCoordinatesAreSaid)
{
  const auto none = Make(Square + "vt 1 1\nf 1 2 3\n");
  EXPECT_TRUE(none.TextureCoordinates.empty());
  EXPECT_EQ(none.Notes,
    (std::vector<std::string>{
      "1 of 4 vertices are in no face (first vertex 4)", "has no texture coordinates" }));
  const auto some = Make(Square + "vt 1 1\nf 1/1 2/1 3/1\nf 1 3 4\n");
  ASSERT_EQ(some.TextureCoordinates.size(), 6u);
  EXPECT_EQ(some.TextureCoordinates[3], (std::array<double, 2>{ 0., 0. }));
  EXPECT_EQ(some.Notes,
    (std::vector<std::string>{
      "1 faces have corners without texture coordinates, taken as (0, 0) (first line 7)" }));
}

TEST(ObjSurface, PolygonsKeepOrderAndWinding)
{
  const auto surface = Make(Square + "v 0.5 2 0\nvt 0 0\nf 1/1 2/1 3/1 4/1\nf 4/1 3/1 5/1\n");
  EXPECT_EQ(surface.Triangles, (std::vector<Triangle>{ { 0, 1, 2 }, { 0, 2, 3 }, { 3, 2, 4 } }));
  EXPECT_EQ(surface.NumberOfOpenEdges, 5u);
}

TEST(ObjSurface, FacesThatDoNotFitBecomeSheets)
{
  const std::string wing = Square + "v 0 0 1\nvt 0 0\n";
  // A third face at the edge 1-3, the same face again, the same face turned over.
  for (const char* third : { "f 1/1 3/1 5/1\n", "f 1/1 2/1 3/1\n", "f 3/1 2/1 1/1\n" })
  {
    const auto surface = Make(wing + "f 1/1 2/1 3/1\nf 1/1 3/1 4/1\n" + third);
    EXPECT_EQ(surface.Triangles.size(), 3u) << third;
    EXPECT_EQ(surface.NumberOfSheets, 2u) << third;
    EXPECT_EQ(surface.NumberOfVertices, 7u) << third;
    EXPECT_EQ(surface.Positions.size(), 7u) << third;
    const auto& last = surface.Triangles[2];
    for (std::int32_t point : last)
    {
      EXPECT_GE(surface.Vertex[point], 4) << "the sheet has vertices of its own";
    }
    EXPECT_NE(surface.Notes.back().find("1 faces do not join"), std::string::npos);
    EXPECT_NE(surface.Notes.back().find("(first line 9)"), std::string::npos);
  }
}

TEST(ObjSurface, ManyCopiesOfAFaceEndInLooseFaces)
{
  std::string text = Square + "vt 0 0\n";
  for (int i = 0; i < 3000; ++i)
  {
    text += "f 1/1 2/1 3/1\n";
  }
  const auto surface = Make(text);
  EXPECT_EQ(surface.Triangles.size(), 3000u);
  EXPECT_EQ(surface.NumberOfVertices, 9000u);
  EXPECT_EQ(surface.NumberOfSheets, 8u);
  EXPECT_EQ(surface.NumberOfOpenEdges, 9000u);
}

TEST(ObjSurface, CornersThatFallTogether)
{
  // A quad closed to a triangle, a triangle closed to a line, and one that is a line by its form.
  const auto surface = Make(Square +
    "v 2 0 0\nvt 0 0\nf 1/1 2/1 3/1 3/1\nf 1/1 1/1 3/1\n"
    "f 2/1 1/1 5/1\n");
  EXPECT_EQ(surface.Triangles.size(), 2u);
  ASSERT_EQ(surface.Notes.size(), 4u);
  EXPECT_EQ(surface.Notes[1],
    "1 faces have fewer than three different positions and are left out (first line 8)");
  EXPECT_EQ(surface.Notes[2],
    "1 faces have neighbouring corners at one position, of which the "
    "first is kept (first line 7)");
  EXPECT_EQ(
    surface.Notes[3], "1 faces are folded over, cross themselves or have no area (first line 9)");
  EXPECT_THROW(Make(Square + "f 1 1 2\n"), MesoInputError);
}

TEST(ObjSurface, PolygonThatComesBackToAVertexIsCutIntoFaces)
{
  // A square with a square hole, joined by a cut that is walked twice.
  const auto surface = Make("v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\n"
                            "v 2 1 0\nvt 0 0\nf 1/1 2/1 3/1 4/1 1/1 5/1 6/1 7/1 8/1 5/1\n");
  EXPECT_EQ(surface.Triangles.size(), 8u);
  EXPECT_EQ(surface.NumberOfVertices, 8u);
  EXPECT_EQ(surface.NumberOfSheets, 1u);
  EXPECT_EQ(surface.NumberOfOpenEdges, 8u);
}
