// vtkMesoDisplacedMesh: closed meshes stay closed, to the last bit, whatever the segments of their
// edges; where the surface itself tears, the tear is what the map says.

#include "DicedMeshes.h"

#include "vtkFloatArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

namespace
{
class DisplacedMeshClosed : public ::testing::Test
{
protected:
  vtkNew<vtkMesoDisplacedMesh> Filter;

  vtkPolyData* Dice(vtkPolyData* mesh, vtkImageData* map, double facetsPerTexel = 1.)
  {
    this->Filter->SetInputData(mesh);
    this->Filter->SetHeightMapData(map);
    this->Filter->SetFacetsPerTexel(facetsPerTexel);
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  void ExpectClosed(vtkPolyData* mesh, const char* what)
  {
    const MergedEdges edges(mesh);
    EXPECT_GT(edges.Edges, 100) << what;
    EXPECT_EQ(edges.Wrong, 0) << what << " of " << edges.Edges;
    EXPECT_EQ(this->Filter->GetNumberOfTornEdges(), 0) << what;
    EXPECT_EQ(this->Filter->GetLargestTear(), 0.) << what;
    EXPECT_EQ(2 * edges.Edges, 3 * mesh->GetNumberOfPolys()) << what;
  }
};

/// A map that changes along t alone, so that a sphere's poles are closed.
vtkSmartPointer<vtkImageData> Rings(int height)
{
  return MakeMap(
    8, height, [height](int, int j) { return 0.5 + 0.5 * std::sin(40. * j / height); });
}

/// An octahedron whose texture coordinates are at random: every edge has two sides, of any lengths.
vtkSmartPointer<vtkPolyData> ScatteredOctahedron()
{
  const std::vector<MesoVector> corners = { { 1., 0., 0. }, { 0., 1., 0. }, { -1., 0., 0. },
    { 0., -1., 0. }, { 0., 0., 1. }, { 0., 0., -1. } };
  const int faces[8][3] = { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 }, { 1, 0, 5 },
    { 2, 1, 5 }, { 3, 2, 5 }, { 0, 3, 5 } };
  std::vector<MesoVector> positions;
  std::vector<std::array<double, 2>> coordinates;
  std::vector<std::vector<vtkIdType>> cells;
  std::mt19937 random(5);
  const auto number = [&]() { return static_cast<double>(random()) / 4294967295.; };
  for (const auto& face : faces)
  {
    const auto first = static_cast<vtkIdType>(positions.size());
    cells.push_back({ first, first + 1, first + 2 });
    for (int corner : face)
    {
      positions.push_back(corners[corner]);
      const double u = number();
      coordinates.push_back({ u, number() });
    }
  }
  return MakeMesh(positions, coordinates, cells);
}
}

TEST_F(DisplacedMeshClosed, TorusAtEveryFineness)
{
  this->Filter->SetScale(0.1);
  this->Filter->SetTiles(3., 2.);
  for (int precision : { vtkAlgorithm::DOUBLE_PRECISION, vtkAlgorithm::SINGLE_PRECISION })
  {
    const auto torus = ShapeMesh("torus", { { "rings", { 10. } }, { "sides", { 7. } } }, precision);
    const auto map = PatternMap("brick", 32);
    for (double facets : { 0.01, 0.1, 0.25, 0.6, 1., 2. })
    {
      this->ExpectClosed(this->Dice(torus, map, facets), std::to_string(facets).c_str());
    }
  }
}

TEST_F(DisplacedMeshClosed, TilesThatMirror)
{
  this->Filter->SetScale(0.1);
  this->Filter->SetTiles(4., 2.);
  this->Filter->SetWrap(MesoWrap::Mirror);
  this->ExpectClosed(this->Dice(ShapeMesh("torus", { { "rings", { 9. } }, { "sides", { 5. } } }),
                       PatternMap("noise", 24)),
    "mirror");
}

TEST_F(DisplacedMeshClosed, SphereWithItsPoles)
{
  this->Filter->SetScale(0.2);
  const auto sphere = ShapeMesh("sphere", { { "rings", { 6. } }, { "sides", { 9. } } });
  for (double facets : { 0.3, 1., 3. })
  {
    this->ExpectClosed(this->Dice(sphere, Rings(40), facets), "sphere");
  }
}

TEST_F(DisplacedMeshClosed, EdgesOfAnyNumberOfSegments)
{
  // Each edge takes the longer of its sides. A constant map continues across all of them.
  this->Filter->SetScale(0.3);
  const auto map = MakeMap(40, 25, [](int, int) { return 0.25; });
  vtkPolyData* mesh = this->Dice(ScatteredOctahedron(), map);
  this->ExpectClosed(mesh, "octahedron");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const MesoVector p = PositionOf(mesh, i);
    EXPECT_GE(std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]), 0.55);
    EXPECT_LE(MesoLength(p), 1. - 0.75 * 0.3 + 1e-12);
  }
}

TEST_F(DisplacedMeshClosed, DegenerateTrianglesLeaveNoHole)
{
  // A tetrahedron with one edge split in the middle for one of its triangles alone; a triangle without
  // area closes the gap. Another has two corners in one point.
  const auto mesh = MakeMesh(
    { { 0., 0., 0. }, { 1., 0., 0. }, { 0., 1., 0. }, { 0., 0., 1. }, { 0.5, 0., 0. } },
    { { 0., 0. }, { 1., 0. }, { 0., 1. }, { 1., 1. }, { 0.5, 0. } },
    { { 0, 2, 1 }, { 0, 1, 4 }, { 0, 4, 3 }, { 4, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 2, 2, 3 } });
  this->Filter->SetScale(0.1);
  for (double facets : { 0.1, 0.5, 1., 2.3 })
  {
    // Points of the triangle without area may fall on others by position, so they go by number.
    const MergedEdges edges(this->Dice(mesh, PatternMap("smooth", 16), facets), false);
    EXPECT_EQ(edges.Wrong, 0) << facets;
    EXPECT_GE(edges.Edges, 9) << facets;
    EXPECT_EQ(this->Filter->GetNumberOfTornEdges(), 0) << facets;
  }
}

namespace
{
/// Two squares of 1 side by side along x, with points of their own at x = 1, in the texture from
/// `left` to `leftEnd` and from `right` to `rightEnd` along u. Coordinates are floats.
vtkSmartPointer<vtkPolyData> TwoSquares(float left, float leftEnd, float right, float rightEnd)
{
  const auto mesh = MakeMesh({ { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. }, { 0., 1., 0. },
                               { 1., 0., 0. }, { 2., 0., 0. }, { 2., 1., 0. }, { 1., 1., 0. } },
    {}, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } });
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  const float us[8] = { left, leftEnd, leftEnd, left, right, rightEnd, rightEnd, right };
  for (int i = 0; i < 8; ++i)
  {
    coordinates->InsertNextTuple2(us[i], i % 4 < 2 ? 0.f : 0.7f);
  }
  mesh->GetPointData()->SetTCoords(coordinates);
  return mesh;
}
}

TEST_F(DisplacedMeshClosed, SeamsThatRoundingAloneSeparatesAreClosed)
{
  // A whole tile between the sides, which floats near 0.3 and 5.3 do not hold alike.
  this->Filter->SetScale(0.5);
  const auto map = PatternMap("noise", 32);
  const auto mesh = TwoSquares(0.1f, 0.3f, 5.3f, 5.6f);
  ASSERT_NE(double(0.3f) + 5., double(5.3f));
  vtkPolyData* diced = this->Dice(mesh, map);
  EXPECT_EQ(this->Filter->GetNumberOfTornEdges(), 0);
  EXPECT_EQ(this->Filter->GetLargestTear(), 0.);
  // Open are the rims alone: 7, 7 (9.6 texels) and 2 x 23 (22.4 texels) segments.
  EXPECT_EQ(MergedEdges(diced).Wrong, 2 * (7 + 10) + 2 * 23);
  // A thousandth of a tile more is no rounding.
  this->Dice(TwoSquares(0.1f, 0.3f, 5.301f, 5.6f), map);
  EXPECT_EQ(this->Filter->GetNumberOfTornEdges(), 1);
  EXPECT_LT(this->Filter->GetLargestTear(), 0.1);
}

TEST_F(DisplacedMeshClosed, TheLongestSideDecides)
{
  const auto map = ConstantMap(0.5);
  for (bool turn : { false, true })
  {
    const auto mesh = TwoSquares(0.f, 1.f, 1.f, 2.f);
    // One square's chart is 2 x 0.7 tiles of 4 texels high, 5.6 texels, the other's half of that.
    for (int i = 0; i < 8; ++i)
    {
      const double v = mesh->GetPointData()->GetTCoords()->GetComponent(i, 1);
      const bool tall = (i < 4) == turn;
      mesh->GetPointData()->GetTCoords()->SetComponent(i, 1, tall ? 2. * v : v);
    }
    vtkPolyData* diced = this->Dice(mesh, map);
    std::set<double> onSeam;
    for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
    {
      const MesoVector p = PositionOf(diced, i);
      if (p[0] == 1.)
      {
        onSeam.insert(p[1]);
      }
    }
    EXPECT_EQ(onSeam.size(), 7u);
    EXPECT_EQ(this->Filter->GetNumberOfTornEdges(), 0);
  }
}

TEST_F(DisplacedMeshClosed, NormalsAtASeamAreTheMeanOfItsSides)
{
  // Heights rise along s alone, and the right chart is twice as long: its relief is twice as steep.
  this->Filter->SetScale(0.25);
  const int size = 32;
  const auto map = MakeMap(
    size, size, [](int i, int) { return 0.5 + 0.4 * std::sin(2. * std::acos(-1.) * i / 32.); });
  vtkPolyData* diced = this->Dice(TwoSquares(0.f, 0.5f, 1.5f, 2.5f), map);
  // At s = 1/2, between texels 15 and 16, from texels 14 and 17 as well.
  const auto height = [&](int i) { return double(map->GetScalarComponentAsFloat(i, 0, 0, 0)); };
  const double slope = 0.25 * (height(16) - height(14) + height(17) - height(15)) * size;
  MesoVector mean = { 0., 0., 0. };
  for (double length : { 0.5, 1. })
  {
    const MesoVector n = { -0.25 * slope * length, 0., 1. };
    mean = MesoSum(mean, MesoScaled(n, 1. / MesoLength(n)));
  }
  mean = MesoScaled(mean, 1. / MesoLength(mean));
  int count = 0;
  for (vtkIdType i = 0; i < diced->GetNumberOfPoints(); ++i)
  {
    // Away from the corners, where the halves of the squares are weighted by their angles.
    const MesoVector p = PositionOf(diced, i);
    if (p[0] == 1. && p[1] > 0. && p[1] < 1.)
    {
      EXPECT_LT(DistanceOf(TupleOf(diced, "Normals", i), mean), 1e-6);
      ++count;
    }
  }
  EXPECT_GT(count, 40);
}

TEST_F(DisplacedMeshClosed, SeamsTearByTheDifferenceOfTheHeights)
{
  // Two squares side by side, flat. The map falls along s from 1 to 0, and the right square begins
  // anew: at the seam the left one is at s = 0.8, the right one at 0.1.
  const auto mesh = MakeMesh({ { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. }, { 0., 1., 0. },
                               { 1., 0., 0. }, { 2., 0., 0. }, { 2., 1., 0. }, { 1., 1., 0. } },
    { { 0.2, 0. }, { 0.8, 0. }, { 0.8, 0.5 }, { 0.2, 0.5 }, { 0.1, 0. }, { 0.7, 0. }, { 0.7, 0.5 },
      { 0.1, 0.5 } },
    { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } });
  const int width = 64;
  const auto map = MakeMap(width, 4, [](int i, int) { return 1. - (i + 0.5) / width; });
  this->Filter->SetScale(0.5);
  this->Filter->SetWrap(MesoWrap::Clamp);
  this->Dice(mesh, map);
  EXPECT_EQ(this->Filter->GetNumberOfTornEdges(), 1);
  EXPECT_NEAR(this->Filter->GetLargestTear(), 0.5 * 0.7, 1e-6); // heights are floats
}

TEST_F(DisplacedMeshClosed, HardEdgesTear)
{
  // Two squares at a right angle with a normal each: the sheets move apart along their normals.
  const auto mesh = MakeMesh({ { 0., 0., 0. }, { 1., 0., 0. }, { 1., 1., 0. }, { 0., 1., 0. },
                               { 1., 0., 0. }, { 1., 0., -1. }, { 1., 1., -1. }, { 1., 1., 0. } },
    { { 0., 0. }, { 1., 0. }, { 1., 1. }, { 0., 1. }, { 1., 0. }, { 2., 0. }, { 2., 1. },
      { 1., 1. } },
    { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } });
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 8; ++i)
  {
    normals->InsertNextTuple3(i < 4 ? 0. : 1., 0., i < 4 ? 1. : 0.);
  }
  mesh->GetPointData()->SetNormals(normals);
  this->Filter->SetScale(0.5);
  this->Dice(mesh, ConstantMap(0.));
  EXPECT_EQ(this->Filter->GetNumberOfTornEdges(), 1);
  EXPECT_NEAR(this->Filter->GetLargestTear(), 0.5 * std::sqrt(2.), 1e-12);
}

TEST_F(DisplacedMeshClosed, SeamsShowInNoNormal)
{
  // The same map position on both sides of the seam has one normal, though charts are two.
  this->Filter->SetScale(0.1);
  this->Filter->SetTiles(3., 2.);
  vtkPolyData* mesh = this->Dice(
    ShapeMesh("torus", { { "rings", { 10. } }, { "sides", { 7. } } }), PatternMap("smooth", 32));
  std::map<MesoVector, MesoVector> normals;
  int shared = 0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const MesoVector normal = TupleOf(mesh, "Normals", i);
    const auto known = normals.emplace(PositionOf(mesh, i), normal);
    shared += known.second ? 0 : 1;
    EXPECT_EQ(known.first->second, normal);
  }
  EXPECT_GT(shared, 100);
}
