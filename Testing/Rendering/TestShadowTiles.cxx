// Where lights look from (MesoShadowTiles).

#include "MesoShadowTiles.h"

#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <gtest/gtest.h>
#include <random>

namespace
{
class ShadowTiles : public testing::Test
{
protected:
  std::mt19937 Engine{ 7 };

  double In(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Engine()) / 4294967296.;
  }

  MesoShadowCaster Box()
  {
    MesoShadowCaster caster;
    for (int i = 0; i < 3; ++i)
    {
      caster.Bounds[2 * i] = this->In(-2., 2.);
      caster.Bounds[2 * i + 1] = caster.Bounds[2 * i] + this->In(0.1, 1.);
    }
    return caster;
  }
};

/// Coordinates of a point across a tile, [0,1] where it is seen, and along its view.
std::array<double, 3> Seen(const MesoShadowTile& tile, const std::array<double, 3>& point)
{
  double from[3];
  vtkMath::Subtract(point.data(), tile.Position.data(), from);
  double right[3];
  vtkMath::Cross(tile.Direction.data(), tile.Up.data(), right);
  const double along = vtkMath::Dot(from, tile.Direction.data());
  const double by = tile.Perspective ? along : 1.;
  return { (vtkMath::Dot(from, right) / by - tile.Left) / (tile.Right - tile.Left),
    (vtkMath::Dot(from, tile.Up.data()) / by - tile.Bottom) / (tile.Top - tile.Bottom), along };
}

bool Holds(const MesoShadowTile& tile, const std::array<double, 3>& point)
{
  const auto seen = Seen(tile, point);
  return seen[0] > 0. && seen[0] < 1. && seen[1] > 0. && seen[1] < 1. && seen[2] > tile.Near &&
    seen[2] < tile.Far;
}
}

TEST_F(ShadowTiles, OfADirectionalLightHoldAllCornersAndLittleMore)
{
  for (int trial = 0; trial < 200; ++trial)
  {
    const std::vector<MesoShadowCaster> boxes = { this->Box(), this->Box() };
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(this->In(-1., 1.), this->In(-1., 1.), this->In(-1., 1.));
    const auto tiles = MesoShadowTilesOf(light, boxes, 64);
    ASSERT_EQ(tiles.size(), 1u);
    std::array<double, 2> low = { 1., 1. };
    std::array<double, 2> high = { 0., 0. };
    for (const auto& box : boxes)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        const std::array<double, 3> point = { box.Bounds[corner & 1],
          box.Bounds[2 + ((corner >> 1) & 1)], box.Bounds[4 + (corner >> 2)] };
        EXPECT_TRUE(Holds(tiles[0], point)) << trial;
        const auto seen = Seen(tiles[0], point);
        for (int i = 0; i < 2; ++i)
        {
          low[i] = std::min(low[i], seen[i]);
          high[i] = std::max(high[i], seen[i]);
        }
      }
    }
    for (int i = 0; i < 2; ++i)
    {
      EXPECT_NEAR(low[i], 2. / 64., 1e-9) << "two texels' border";
      EXPECT_NEAR(high[i], 62. / 64., 1e-9);
    }
  }
}

TEST_F(ShadowTiles, OfASpotHoldWhatItsConeLights)
{
  for (int trial = 0; trial < 200; ++trial)
  {
    const std::vector<MesoShadowCaster> boxes = { this->Box(), this->Box() };
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->PositionalOn();
    light->SetConeAngle(this->In(10., 80.));
    light->SetPosition(this->In(-4., 4.), this->In(-4., 4.), this->In(-4., 4.));
    const auto tiles = MesoShadowTilesOf(light, boxes, 64);
    ASSERT_LE(tiles.size(), 1u);
    double position[3];
    light->GetPosition(position);
    double axis[3] = { -position[0], -position[1], -position[2] };
    vtkMath::Normalize(axis);
    for (int sample = 0; sample < 50; ++sample)
    {
      const auto& bounds = boxes[sample % 2].Bounds;
      const std::array<double, 3> point = { this->In(bounds[0], bounds[1]),
        this->In(bounds[2], bounds[3]), this->In(bounds[4], bounds[5]) };
      double from[3];
      vtkMath::Subtract(point.data(), position, from);
      const double distance = vtkMath::Normalize(from);
      const bool lit =
        vtkMath::Dot(from, axis) > std::cos(vtkMath::RadiansFromDegrees(light->GetConeAngle()));
      if (lit && distance > 0.05)
      {
        ASSERT_EQ(tiles.size(), 1u);
        EXPECT_TRUE(Holds(tiles[0], point)) << trial;
      }
    }
  }
}

TEST_F(ShadowTiles, OfAPointLightSeeEveryPoint)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(90.);
  light->SetPosition(0.3, -0.2, 0.1);
  MesoShadowCaster box;
  box.Bounds = { -2., 2., -2., 2., -2., 2. };
  const auto tiles = MesoShadowTilesOf(light, { box }, 64);
  ASSERT_EQ(tiles.size(), 6u);
  for (int trial = 0; trial < 1000; ++trial)
  {
    const std::array<double, 3> point = { this->In(-2., 2.), this->In(-2., 2.), this->In(-2., 2.) };
    EXPECT_TRUE(std::any_of(
      tiles.begin(), tiles.end(), [&](const MesoShadowTile& tile) { return Holds(tile, point); }));
  }
}

TEST_F(ShadowTiles, OfAFloorAreWhereOthersAre)
{
  MesoShadowCaster floor;
  floor.Bounds = { -100., 100., -0., 0., -100., 100. };
  floor.Flat = true;
  MesoShadowCaster box;
  box.Bounds = { -1., 1., 0., 2., -1., 1. };
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(1., 2., 0.5);
  const auto tiles = MesoShadowTilesOf(light, { floor, box }, 64);
  ASSERT_EQ(tiles.size(), 1u);
  EXPECT_LT(tiles[0].Right - tiles[0].Left, 5.);
  EXPECT_LT(tiles[0].Top - tiles[0].Bottom, 5.);
}

TEST_F(ShadowTiles, AreNoneWhereALightCastsNone)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(0., 0., 1.);
  EXPECT_EQ(MesoShadowTilesOf(light, { this->Box() }, 64).size(), 1u);
  EXPECT_TRUE(MesoShadowTilesOf(light, {}, 64).empty());
  light->SetShadowAttenuation(0.f);
  EXPECT_TRUE(MesoShadowTilesOf(light, { this->Box() }, 64).empty());
  light->SetShadowAttenuation(1.f);
  light->SwitchOff();
  EXPECT_TRUE(MesoShadowTilesOf(light, { this->Box() }, 64).empty());
  light->SwitchOn();
  light->SetLightTypeToHeadlight();
  EXPECT_TRUE(MesoShadowTilesOf(light, { this->Box() }, 64).empty());
  // A spot that looks away from all.
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(30.);
  light->SetPosition(0., 0., 10.);
  light->SetFocalPoint(0., 0., 20.);
  EXPECT_TRUE(MesoShadowTilesOf(light, { this->Box() }, 64).empty());
}
