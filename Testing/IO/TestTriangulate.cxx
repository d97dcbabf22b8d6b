// Polygons cut into triangles: areas add up, none is turned over, whatever the form.

#include "MesoTriangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace
{
using Polygon = std::vector<std::array<double, 3>>;

double SignedArea(const Polygon& p, int a, int b, int c)
{
  return 0.5 *
    ((p[b][0] - p[a][0]) * (p[c][1] - p[a][1]) - (p[b][1] - p[a][1]) * (p[c][0] - p[a][0]));
}

/// Cuts a polygon in the xy plane and checks the number of triangles, their sign and their sum.
void ExpectSoundCut(const Polygon& polygon, double scale = 1.)
{
  std::vector<int> triangles;
  EXPECT_TRUE(MesoTriangulate(polygon, triangles));
  ASSERT_EQ(triangles.size(), 3 * (polygon.size() - 2));
  double whole = 0.;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
  {
    whole += SignedArea(polygon, 0, int(i), int(i + 1));
  }
  double sum = 0.;
  for (std::size_t i = 0; i < triangles.size(); i += 3)
  {
    const double area = SignedArea(polygon, triangles[i], triangles[i + 1], triangles[i + 2]);
    EXPECT_GT(area, 0.);
    sum += area;
  }
  EXPECT_NEAR(sum, whole, 1e-12 * scale * scale * double(polygon.size()));
}
}

TEST(Triangulate, QuadsTakeTheDiagonalInside)
{
  std::vector<int> triangles;
  EXPECT_TRUE(MesoTriangulate({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } }, triangles));
  EXPECT_EQ(triangles, (std::vector<int>{ 0, 1, 2, 0, 2, 3 }));
  // Of the first the diagonal inside is the shorter one, of the second the longer one.
  for (const Polygon& arrow : { Polygon{ { 0, 0, 0 }, { 2, -1, 0 }, { 0.5, 0, 0 }, { 2, 1, 0 } },
         Polygon{ { -5, 0, 0 }, { 1, -0.5, 0 }, { 0.5, 0, 0 }, { 1, 0.5, 0 } } })
  {
    for (int turn = 0; turn < 4; ++turn)
    {
      Polygon turned = arrow;
      std::rotate(turned.begin(), turned.begin() + turn, turned.end());
      ExpectSoundCut(turned);
    }
  }
  triangles.clear();
  MesoTriangulate({ { 0, 0, 0 }, { 1, 0, 0 }, { 3, 1, 0 }, { 0, 1, 0 } }, triangles);
  EXPECT_EQ(triangles, (std::vector<int>{ 0, 1, 3, 1, 2, 3 })) << "the shorter diagonal";
}

TEST(Triangulate, PolygonsWithBaysCollinearCornersAndRepeatedEdges)
{
  ExpectSoundCut({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 3, 0 }, { 3, 3, 0 }, { 3, 1, 0 }, { 1, 1, 0 },
    { 1, 3, 0 }, { 0, 3, 0 } });
  ExpectSoundCut({ { 0, 0, 0 }, { 0.5, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } });
  // A square with a square hole, joined by a cut that is walked twice.
  ExpectSoundCut({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 0, 3, 0 }, { 0, 0, 0 }, { 1, 1, 0 },
    { 1, 2, 0 }, { 2, 2, 0 }, { 2, 1, 0 }, { 1, 1, 0 } });
}

TEST(Triangulate, RandomStarsAtAllScalesAndPlaces)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.1, 1.);
  for (double scale : { 1., 1e-6, 1e6 })
  {
    for (int corners : { 4, 5, 8, 31, 200 })
    {
      Polygon star;
      for (int i = 0; i < corners; ++i)
      {
        const double angle = 2. * std::acos(-1.) * i / corners;
        const double r = radius(random) * scale;
        star.push_back({ r * std::cos(angle), r * std::sin(angle), 0. });
      }
      ExpectSoundCut(star, scale);
    }
  }
}

TEST(Triangulate, PlaneDoesNotMatter)
{
  std::vector<int> flat;
  std::vector<int> tilted;
  Polygon polygon = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 3, 0 }, { 2, 1, 0 }, { 0, 3, 0 } };
  EXPECT_TRUE(MesoTriangulate(polygon, flat));
  for (auto& p : polygon)
  {
    p = { 0.6 * p[0] + 100., p[1], -0.8 * p[0] }; // a turn about the y axis
  }
  EXPECT_TRUE(MesoTriangulate(polygon, tilted));
  EXPECT_EQ(flat, tilted);
}

TEST(Triangulate, SaysWhenThereIsNoSoundCut)
{
  std::vector<int> triangles;
  EXPECT_FALSE(MesoTriangulate({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } }, triangles));
  EXPECT_FALSE(MesoTriangulate({ { 0, 0, 0 }, { 1, 1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, triangles));
  EXPECT_FALSE(MesoTriangulate(Polygon(6, { 1, 2, 3 }), triangles));
  EXPECT_FALSE(MesoTriangulate(
    { { 0, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 2, 1, 0 } }, triangles));
  EXPECT_EQ(triangles.size(), 3u * (1 + 2 + 4 + 4));
  for (int corner : triangles)
  {
    EXPECT_TRUE(corner >= 0 && corner < 6);
  }
  EXPECT_FALSE(MesoTriangulate({ { 0, 0, 0 }, { 1, 0, 0 } }, triangles));
}
