// Tables of view-dependent displacements at the ends of their axes, under motions of the map that must move
// the table alike, and of maps and depths at the ends of what there is.

#include "BentRelief.h"
#include "VDMTables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace
{
using namespace VDMTables;

/// Both tables' numbers and angles at all places, the second's place told by the first's.
template <typename Place>
void ExpectMoved(vtkImageData* one, vtkImageData* other, const MesoVDMLayout& layout,
  const Place& placeOf, double slack)
{
  for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
  {
    for (int row = 0; row < layout.Height; ++row)
    {
      for (int column = 0; column < layout.Width; ++column)
      {
        const std::array<int, 3> at = placeOf(column, row, azimuth);
        for (int k = 0; k < layout.Curvatures; ++k)
        {
          EXPECT_NEAR(AngleAt(one, layout, column, row, azimuth, k),
            AngleAt(other, layout, at[0], at[1], at[2], k), slack)
            << column << " " << row << " " << azimuth << " " << k;
          for (int i = 0; i < layout.Polars; ++i)
          {
            EXPECT_NEAR(NumberAt(one, layout, column, row, azimuth, i, k),
              NumberAt(other, layout, at[0], at[1], at[2], i, k), slack)
              << column << " " << row << " " << azimuth << " " << i << " " << k;
          }
        }
      }
    }
  }
}

void ExpectNumbers(vtkImageData* image)
{
  ASSERT_GT(image->GetNumberOfPoints(), 0);
  ASSERT_GT(image->GetPointData()->GetNumberOfArrays(), 0);
  for (int i = 0; i < image->GetFieldData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = image->GetFieldData()->GetArray(i);
    for (vtkIdType k = 0; k < array->GetNumberOfValues(); ++k)
    {
      EXPECT_TRUE(std::isfinite(array->GetVariantValue(k).ToDouble())) << array->GetName();
    }
  }
}
}

TEST(VDMEdges, MovedMapsGiveMovedTables)
{
  // Over the tile's edges: what is moved out at one comes in at the other.
  const MesoVDMLayout layout = SmallLayout(8, 6);
  vtkSmartPointer<vtkImageData> map = RandomMap(8, 6);
  vtkSmartPointer<vtkImageData> moved = MakeMap(8, 6,
    [&](int column, int row)
    { return map->GetScalarComponentAsDouble((column + 3) % 8, (row + 5) % 6, 0, 0); });
  ExpectMoved(
    Bake(moved, layout), Bake(map, layout), layout,
    [](int column, int row, int azimuth) {
      return std::array<int, 3>{ (column + 3) % 8, (row + 5) % 6, azimuth };
    },
    2e-5);
}

TEST(VDMEdges, TurnedMapsGiveTurnedTables)
{
  // By a quarter, so that azimuths go over their end.
  const MesoVDMLayout layout = SmallLayout(7, 7);
  vtkSmartPointer<vtkImageData> map = RandomMap(7, 7);
  vtkSmartPointer<vtkImageData> turned = MakeMap(7, 7,
    [&](int column, int row) { return map->GetScalarComponentAsDouble(row, 6 - column, 0, 0); });
  ExpectMoved(
    Bake(map, layout), Bake(turned, layout), layout,
    [](int column, int row, int azimuth) {
      return std::array<int, 3>{ 6 - row, column, (azimuth + 3) % 12 };
    },
    2e-4);
}

TEST(VDMEdges, MirroredMapsGiveMirroredTables)
{
  const MesoVDMLayout layout = SmallLayout(8, 6);
  vtkSmartPointer<vtkImageData> map = RandomMap(8, 6);
  vtkSmartPointer<vtkImageData> mirrored = MakeMap(8, 6,
    [&](int column, int row) { return map->GetScalarComponentAsDouble(column, 5 - row, 0, 0); });
  ExpectMoved(
    Bake(map, layout), Bake(mirrored, layout), layout,
    [](int column, int row, int azimuth) {
      return std::array<int, 3>{ column, 5 - row, (12 - azimuth) % 12 };
    },
    2e-4);
}

TEST(VDMEdges, EndsOfCurvatureAreWhatTheyAreAlone)
{
  const MesoVDMLayout layout = SmallLayout(8, 6);
  vtkSmartPointer<vtkImageData> map = RandomMap(8, 6);
  vtkSmartPointer<vtkImageData> all = Bake(map, layout);
  for (const int k : { 0, 1, layout.Curvatures - 1 })
  {
    MesoVDMLayout one = layout;
    one.Curvatures = 1;
    one.FirstCurvature = one.LastCurvature = layout.CurvatureAt(k);
    vtkSmartPointer<vtkImageData> alone = Bake(map, one);
    for (int i = 0; i < layout.Polars; ++i)
    {
      for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
      {
        EXPECT_NEAR(NumberAt(alone, one, 3, 4, azimuth, i, 0) * one.Range(),
          NumberAt(all, layout, 3, 4, azimuth, i, k) * layout.Range(), 3e-5 * layout.Range())
          << k << " " << i << " " << azimuth;
        EXPECT_EQ(AngleAt(alone, one, 3, 4, azimuth, 0), AngleAt(all, layout, 3, 4, azimuth, k));
      }
    }
  }
  EXPECT_EQ(layout.CurvatureAt(0), layout.FirstCurvature);
  EXPECT_EQ(layout.CurvatureAt(layout.Curvatures - 1), layout.LastCurvature);
}

TEST(VDMEdges, TheFirstAngleOfEdgesIsTheMap)
{
  // Down the normal every azimuth and every curvature meets the texel itself, a tile's distance off being as
  // deep.
  for (const auto stores : { MesoVDMStores::Depth, MesoVDMStores::Offset })
  {
    MesoVDMLayout layout = SmallLayout(8, 6);
    layout.Nodes = MesoVDMNodes::Edges;
    layout.Stores = stores;
    vtkSmartPointer<vtkImageData> map = RandomMap(8, 6);
    vtkSmartPointer<vtkImageData> table = Bake(map, layout);
    EXPECT_EQ(layout.PolarAt(0), 0.);
    EXPECT_NEAR(layout.PolarAt(layout.Polars - 1), Pi / 2., 1e-7);
    EXPECT_LT(layout.RayPolarAt(layout.Polars - 1), Pi / 2. - 1e-3);
    for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
    {
      for (int k = 0; k < layout.Curvatures; ++k)
      {
        const double depth = layout.Depth * (1. - map->GetScalarComponentAsDouble(5, 2, 0, 0));
        EXPECT_NEAR(NumberAt(table, layout, 5, 2, azimuth, 0, k) * layout.Range(),
          stores == MesoVDMStores::Depth ? depth : 0., 2e-5 * layout.Range());
      }
    }
  }
}

TEST(VDMEdges, BentPointsAreThoseOfTheAppendix)
{
  // The appendix once more, out of the flat table's offsets and by points of the plane.
  MesoVDMLayout layout = SmallLayout(8, 6);
  layout.Polars = 12;
  layout.Stores = MesoVDMStores::Offset;
  vtkSmartPointer<vtkImageData> map = RandomMap(8, 6);
  vtkSmartPointer<vtkImageData> exact = Bake(map, layout);
  vtkSmartPointer<vtkImageData> bent = Bake(map, layout, 0, MesoVDMCurved::Bent);
  const int flat = 1; // the curvature 0
  ASSERT_EQ(layout.CurvatureAt(flat), 0.);
  int compared = 0;
  int hidden = 0;
  for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
  {
    for (const int k : { 0, 2, 3 })
    {
      const double radius = 1. / layout.CurvatureAt(k);
      std::vector<double> angles = { 0. };
      std::vector<double> offsets = { 0. };
      for (int i = 0; i < layout.Polars; ++i)
      {
        const double offset = NumberAt(exact, layout, 2, 3, azimuth, i, flat) * layout.Range();
        const double depth = offset / std::tan(layout.PolarAt(i));
        const double psi = offset / radius;
        const double angle =
          std::atan2((radius - depth) * std::sin(psi), radius - (radius - depth) * std::cos(psi));
        if (angle > angles.back())
        {
          angles.push_back(angle);
          offsets.push_back(offset);
        }
        else
        {
          ++hidden;
        }
      }
      for (int i = 0; i < layout.Polars && layout.PolarAt(i) < angles.back(); ++i)
      {
        const auto next = std::upper_bound(angles.begin(), angles.end(), layout.PolarAt(i));
        const std::size_t n = next - angles.begin();
        const double part = (layout.PolarAt(i) - angles[n - 1]) / (angles[n] - angles[n - 1]);
        EXPECT_NEAR(NumberAt(bent, layout, 2, 3, azimuth, i, k) * layout.Range(),
          offsets[n - 1] + part * (offsets[n] - offsets[n - 1]), 2e-4 * layout.Range())
          << azimuth << " " << k << " " << i;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 250);
  EXPECT_GT(hidden, 5);
}

TEST(VDMEdges, MissesHoldThePointThatIsSeenMostFlatly)
{
  // The point is on the ray at the largest angle, and its number that of the last ray's end.
  MesoVDMLayout layout = SmallLayout(8, 6);
  layout.Stores = MesoVDMStores::Offset;
  vtkSmartPointer<vtkImageData> map = RandomMap(8, 6);
  vtkSmartPointer<vtkImageData> table = Bake(map, layout);
  int missed = 0;
  for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
  {
    for (int k = 2; k < layout.Curvatures; ++k)
    {
      const double radius = 1. / layout.CurvatureAt(k);
      const double largest = AngleAt(table, layout, 4, 1, azimuth, k);
      for (int i = 0; i < layout.Polars; ++i)
      {
        if (layout.PolarAt(i) > largest + 1e-3)
        {
          ++missed;
          const double psi = NumberAt(table, layout, 4, 1, azimuth, i, k) * layout.Range() / radius;
          // By the law of sines, how deep the ray at the largest angle is there: within the relief.
          const double depth = radius - radius * std::sin(largest) / std::sin(largest + psi);
          EXPECT_GT(depth, -1e-3) << azimuth << " " << k << " " << i;
          EXPECT_LT(depth, layout.Depth + 1e-3) << azimuth << " " << k << " " << i;
          EXPECT_EQ(NumberAt(table, layout, 4, 1, azimuth, i, k),
            NumberAt(table, layout, 4, 1, azimuth, layout.Polars - 1, k));
        }
      }
    }
  }
  EXPECT_GT(missed, 30);
}

TEST(VDMEdges, WhatIsSeenMostFlatlyMayBeARidgeBetweenTexels)
{
  // Two texels are high, and the way between them goes from one low texel to another.
  MesoVDMLayout layout = SmallLayout(24, 24);
  layout.Azimuths = 8;
  vtkSmartPointer<vtkImageData> map = MakeMap(24, 24,
    [](int column, int row)
    { return (column == 13 && row == 12) || (column == 12 && row == 13) ? 1. : 0.2; });
  vtkSmartPointer<vtkImageData> table = Bake(map, layout);
  constexpr int Diagonal = 1;
  // From where neither texel's height would be the flattest, over the two convex bases.
  for (const auto& [k, texel] : { std::array<int, 2>{ 2, 2 }, { 3, 5 } })
  {
    const BentRelief relief(map, layout, texel, texel, Pi / 4., layout.CurvatureAt(k));
    EXPECT_NEAR(AngleAt(table, layout, texel, texel, Diagonal, k), relief.Flattest(), 1.5e-5) << k;
  }
}

TEST(VDMEdges, LevelMapsHaveFewFactors)
{
  // A level's depths are the same at all places: one product is all of the table, and the rest nothing.
  const MesoVDMLayout layout = SmallLayout(6, 6);
  for (const double height : { 0., 0.5, 1. })
  {
    vtkSmartPointer<vtkImageData> map = MakeMap(6, 6, [=](int, int) { return height; });
    vtkSmartPointer<vtkImageData> table = Bake(map, layout);
    for (const int rank : { 1, 3, 64 })
    {
      for (const int bits : { 8, 16 })
      {
        vtkSmartPointer<vtkImageData> factored =
          Bake(map, layout, rank, MesoVDMCurved::Exact, bits);
        ExpectNumbers(factored);
        EXPECT_LT(RootMeanSquareError(factored, table, layout,
                    factored->GetFieldData()->GetArray("VDMFunctions")->GetNumberOfComponents()),
          5e-5)
          << height << " " << rank << " " << bits;
        EXPECT_EQ(MesoVDMProblem(factored, layout), "");
      }
    }
  }
}

TEST(VDMEdges, AllFactorsAreTheTable)
{
  // The largest angles too, of an odd number of places.
  const MesoVDMLayout layout = SmallLayout(5, 3);
  vtkSmartPointer<vtkImageData> map = RandomMap(5, 3);
  vtkSmartPointer<vtkImageData> table = Bake(map, layout);
  vtkSmartPointer<vtkImageData> factored = Bake(map, layout, layout.Columns());
  for (vtkIdType tuple = 0; tuple < table->GetNumberOfPoints(); ++tuple)
  {
    for (int column = 0; column < layout.DistanceColumns(); ++column)
    {
      EXPECT_NEAR(FactoredAt(factored, tuple, column, layout.Columns()),
        table->GetPointData()->GetArray("VDM")->GetComponent(tuple, column) / 65535., 1e-4);
    }
    for (int k = 0; k < layout.Curvatures; ++k)
    {
      EXPECT_NEAR(1. - FactoredAt(factored, tuple, k, layout.Columns(), "MVMFunctions"),
        table->GetPointData()->GetArray("MVM")->GetComponent(tuple, k) / 65535., 1e-4);
    }
  }
}

TEST(VDMEdges, MapsOfOneTexelOrRow)
{
  for (const auto& size : { std::array<int, 2>{ 1, 1 }, { 1, 9 }, { 9, 1 } })
  {
    MesoVDMLayout layout = SmallLayout(size[0], size[1]);
    vtkSmartPointer<vtkImageData> map = RandomMap(size[0], size[1]);
    vtkSmartPointer<vtkImageData> table = Bake(map, layout);
    ExpectNumbers(table);
    if (size[0] == size[1])
    {
      const double depth = layout.Depth * (1. - map->GetScalarComponentAsDouble(0, 0, 0, 0));
      for (int i = 0; i < layout.Polars; ++i)
      {
        EXPECT_NEAR(NumberAt(table, layout, 0, 0, 5, i, 0) * layout.Range(), depth, 1e-5);
      }
      // A level of one texel, whose largest angles are within the stretch to the next.
      for (int k = 2; k < layout.Curvatures; ++k)
      {
        EXPECT_NEAR(
          AngleAt(table, layout, 0, 0, 5, k), std::asin(1. - layout.CurvatureAt(k) * depth), 3e-5)
          << k;
      }
    }
    ExpectNumbers(Bake(map, layout, 4));
  }
}

TEST(VDMEdges, SpikesAndSlotsOfATexel)
{
  const MesoVDMLayout layout = SmallLayout(8, 8);
  vtkSmartPointer<vtkImageData> spike = Bake(OneTexel(8, 0., 1.), layout);
  vtkSmartPointer<vtkImageData> slot = Bake(OneTexel(8, 1., 0.), layout);
  for (int k = 0; k < layout.Curvatures; ++k)
  {
    // On the spike's top and beside the slot the base itself is met, from everywhere.
    EXPECT_EQ(NumberAt(spike, layout, 1, 2, 0, 2, k), 0.);
    EXPECT_EQ(NumberAt(slot, layout, 5, 5, 7, 4, k), 0.);
    // A steep ray into the slot's middle comes down to its walls, and not all the way.
    const double depth = NumberAt(slot, layout, 1, 2, 0, 1, k) * layout.Range();
    EXPECT_GT(depth, 0.2 * layout.Depth);
    EXPECT_LT(depth, layout.Depth);
  }
}

TEST(VDMEdges, AsShallowAndAsDeepAsThereIs)
{
  vtkSmartPointer<vtkImageData> map = RandomMap(8, 8);
  for (const auto stores : { MesoVDMStores::Depth, MesoVDMStores::Distance, MesoVDMStores::Offset })
  {
    MesoVDMLayout layout = SmallLayout(8, 8);
    layout.Stores = stores;
    layout.Depth = 1e-6;
    ASSERT_EQ(layout.Problem(), "");
    vtkSmartPointer<vtkImageData> shallow = Bake(map, layout);
    ExpectNumbers(shallow);
    ExpectNumbers(Bake(map, layout, 4));
    // So shallow a relief is met where it is entered, by all but the flattest rays.
    for (int azimuth = 0; azimuth < layout.Azimuths; ++azimuth)
    {
      for (int i = 0; i < layout.Polars - 1; ++i)
      {
        const double steep = 1e-6 * (1. - map->GetScalarComponentAsDouble(3, 3, 0, 0));
        const double polar = layout.PolarAt(i);
        const double expected = stores == MesoVDMStores::Depth ? steep
          : stores == MesoVDMStores::Offset                    ? steep * std::tan(polar)
                                                               : steep / std::cos(polar);
        EXPECT_NEAR(NumberAt(shallow, layout, 3, 3, azimuth, i, 2) * layout.Range(), expected,
          1e-3 * expected + 2e-5 * layout.Range())
          << static_cast<int>(stores) << " " << azimuth << " " << i;
      }
    }
    layout.Depth = 16.;
    layout.LastCurvature = 0.05;
    ASSERT_EQ(layout.Problem(), "");
    vtkSmartPointer<vtkImageData> deep = Bake(map, layout);
    ExpectNumbers(deep);
    ExpectNumbers(Bake(map, layout, 4));
    // Nor is a ray into it lost: it meets a wall a tile on at the latest.
    EXPECT_GT(NumberAt(deep, layout, 3, 3, 1, 1, 0), 0.);
  }
}
