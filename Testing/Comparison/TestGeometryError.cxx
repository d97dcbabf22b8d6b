// Figures of depth, texture coordinate, normal and shadow, each by a case whose answer is known.

#include "HandMadeAOVs.h"
#include "MesoGeometryError.h"

#include <cmath>
#include <gtest/gtest.h>

namespace
{
MesoGeometryError Compare(const HandMadeAOVs& truth, const HandMadeAOVs& test)
{
  return MesoCompareGeometry(MesoAOVsOfImage(truth.Image), MesoAOVsOfImage(test.Image));
}
}

TEST(GeometryError, DepthIsAFractionOfD)
{
  const HandMadeAOVs truth(10, 10);
  HandMadeAOVs test = truth;
  test.At("depth", 4, 6) = 5.04f; // 0.4 of D = 0.1 in one pixel of 100
  const MesoGeometryError error = Compare(truth, test);
  EXPECT_TRUE(error.DepthInScale);
  EXPECT_NEAR(error.Depth.Maximum, 0.4, 1e-5);
  EXPECT_NEAR(error.Depth.Rms, 0.04, 1e-6);
  EXPECT_EQ(error.Depth.P95, 0.);
  EXPECT_EQ(error.Depth.WorstPixel, 64u);
  EXPECT_EQ(error.Classes[64], MesoPixelClass::Farther);
  test.At("depth", 4, 6) = 4.998f; // 0.02 of D
  EXPECT_EQ(Compare(truth, test).Classes[64], MesoPixelClass::Nearer);
  test.At("depth", 4, 6) = 4.9995f; // 0.005 of D
  EXPECT_EQ(Compare(truth, test).Classes[64], MesoPixelClass::Equal);
}

TEST(GeometryError, EachObjectHasItsOwnD)
{
  // The left half has D = 0.1, the right half D = 0.5, and both are off by 0.05.
  HandMadeAOVs truth(10, 10);
  truth.Describe(3, 0.5, 128, 64);
  truth.Fill("object", [](int column, int) { return column < 5 ? 1.f : 3.f; });
  HandMadeAOVs test = truth;
  test.Fill("depth", 5.05f);
  const MesoGeometryError error = Compare(truth, test);
  ASSERT_EQ(error.Objects.size(), 2u);
  EXPECT_EQ(error.Objects[0].Number, 1);
  EXPECT_EQ(error.Objects[1].Number, 3);
  EXPECT_EQ(error.Objects[1].Name, "object 3");
  EXPECT_NEAR(error.Objects[0].Depth.Rms, 0.5, 1e-5);
  EXPECT_NEAR(error.Objects[1].Depth.Rms, 0.1, 1e-5);
  EXPECT_NEAR(error.Depth.Rms, std::sqrt(0.5 * (0.25 + 0.01)), 1e-5);
  EXPECT_NEAR(error.Depth.Maximum, 0.5, 1e-5);
}

TEST(GeometryError, DCountsInWorldUnits)
{
  HandMadeAOVs truth(4, 4);
  truth.Image.Attributes["meso.1.world_units"] = 4.;
  HandMadeAOVs test = truth;
  test.Fill("depth", 5.1f);
  EXPECT_NEAR(Compare(truth, test).Depth.Maximum, 0.25, 1e-5);
}

TEST(GeometryError, WithoutReliefDepthIsInWorldUnits)
{
  HandMadeAOVs truth(4, 4);
  truth.Describe(1, 0., 0, 0);
  HandMadeAOVs test = truth;
  test.Fill("depth", 5.25f);
  const MesoGeometryError flat = Compare(truth, test);
  EXPECT_FALSE(flat.DepthInScale);
  EXPECT_FALSE(flat.Objects[0].DepthInScale);
  EXPECT_NEAR(flat.Depth.Rms, 0.25, 1e-6);
  EXPECT_TRUE(std::isnan(flat.Texcoord.Maximum)) << "no map";

  // Beside an object with relief it is left out of the common figure.
  truth.Describe(2, 0.5, 16, 16);
  truth.At("object", 0, 0) = 2.f;
  test = truth;
  test.Fill("depth", 5.25f);
  const MesoGeometryError mixed = Compare(truth, test);
  EXPECT_TRUE(mixed.DepthInScale);
  EXPECT_EQ(mixed.Depth.Count, 1u);
  EXPECT_NEAR(mixed.Depth.Maximum, 0.5, 1e-6);
}

TEST(GeometryError, TexcoordIsInTexelsModuloOneTile)
{
  // The map has 128 x 64 texels.
  const HandMadeAOVs truth(10, 10);
  HandMadeAOVs test = truth;
  test.Fill("texcoord.u", 3.f); // whole tiles are no error
  test.Fill("texcoord.v", -2.f);
  EXPECT_EQ(Compare(truth, test).Texcoord.Maximum, 0.);
  test.At("texcoord.u", 1, 1) = 3.f + 1.f / 128.f;
  EXPECT_NEAR(Compare(truth, test).Texcoord.Maximum, 1., 1e-4);
  test.At("texcoord.v", 1, 1) = -2.f + 2.f / 64.f;
  EXPECT_NEAR(Compare(truth, test).Texcoord.Maximum, std::sqrt(5.), 1e-4);
  EXPECT_EQ(Compare(truth, test).Texcoord.WorstPixel, 11u);
}

TEST(GeometryError, TexcoordAcrossATilesBorderIsSmall)
{
  HandMadeAOVs truth(10, 10);
  HandMadeAOVs test = truth;
  truth.Fill("texcoord.u", 0.99609375f); // half a texel before the border
  test.Fill("texcoord.u", 0.00390625f);  // half a texel past it
  EXPECT_NEAR(Compare(truth, test).Texcoord.P50, 1., 1e-4);
  test.Fill("texcoord.u", 0.49609375f); // half a tile is the farthest
  EXPECT_NEAR(Compare(truth, test).Texcoord.Maximum, 64., 1e-4);
}

TEST(GeometryError, TexcoordHasPercentiles)
{
  const HandMadeAOVs truth(101, 1);
  HandMadeAOVs test = truth;
  test.Fill("texcoord.u", [](int column, int) { return 0.25f * float(column) / 128.f; });
  const MesoErrorSpread texcoord = Compare(truth, test).Texcoord;
  EXPECT_NEAR(texcoord.P50, 12.5, 1e-4);
  EXPECT_NEAR(texcoord.P95, 23.75, 1e-4);
  EXPECT_NEAR(texcoord.P99, 24.75, 1e-4);
  EXPECT_NEAR(texcoord.Maximum, 25., 1e-4);
}

TEST(GeometryError, ObjectsInFrontOfOthersAreCounted)
{
  HandMadeAOVs truth(4, 4);
  truth.Describe(2, 0.2, 16, 16);
  HandMadeAOVs test = truth;
  test.At("object", 2, 1) = 2.f;
  test.At("texcoord.u", 2, 1) = 0.3f;
  const MesoGeometryError error = Compare(truth, test);
  EXPECT_EQ(error.OtherObjectPixels, 1u);
  EXPECT_EQ(error.Texcoord.Count, 15u);
  EXPECT_EQ(error.Texcoord.Maximum, 0.) << "maps of different objects are not compared";
  EXPECT_EQ(error.Depth.Count, 16u);
  EXPECT_EQ(error.Classes[6], MesoPixelClass::OtherObject);
}

TEST(GeometryError, NormalsByTheAngleBetween)
{
  const HandMadeAOVs truth(20, 1);
  HandMadeAOVs test = truth;
  const double tilt = 3.14159265358979 / 6.;
  test.At("normal.x", 3, 0) = float(std::sin(tilt));
  test.At("normal.z", 3, 0) = float(std::cos(tilt));
  MesoErrorSpread normal = Compare(truth, test).Normal;
  EXPECT_NEAR(normal.Mean, 30. / 20., 1e-4);
  EXPECT_NEAR(normal.P95, 0.05 * 30., 1e-3); // place 18.05 of 19 zeros and the one
  test.At("normal.x", 3, 0) = 1e-6f;         // far below what acos resolves
  test.At("normal.z", 3, 0) = 1.f;
  EXPECT_NEAR(Compare(truth, test).Normal.Maximum, 1e-6 * 180. / 3.14159265, 1e-9);
  test.At("normal.x", 3, 0) = 0.f;
  test.At("normal.z", 3, 0) = 0.f;
  EXPECT_EQ(Compare(truth, test).Normal.Maximum, 180.) << "a normal that is missing";
  EXPECT_EQ(Compare(test, truth).Normal.Count, 19u) << "a truth without one";
}

TEST(GeometryError, ShadowsAreAttachedWhereTheSurfaceTurnsAway)
{
  // The light comes along +z. Rows 0 to 2 face it, row 3 faces away.
  HandMadeAOVs truth(10, 4);
  truth.Fill("normal.z", [](int, int row) { return row < 3 ? 1.f : -1.f; });
  truth.Fill("shadow.0", [](int, int row) { return row < 3 ? 0.f : 1.f; });
  HandMadeAOVs test = truth;
  EXPECT_EQ(Compare(truth, test).ShadowAttached, 0.);
  EXPECT_EQ(Compare(truth, test).ShadowCast, 0.);
  test.At("shadow.0", 0, 0) = 1.f;
  test.At("shadow.0", 1, 1) = 0.6f; // past the threshold
  test.At("shadow.0", 2, 2) = 0.4f; // not past it
  test.At("shadow.0", 4, 3) = 0.f;
  const MesoGeometryError error = Compare(truth, test);
  EXPECT_DOUBLE_EQ(error.ShadowCast, 2. / 30.);
  EXPECT_DOUBLE_EQ(error.ShadowAttached, 1. / 10.);
  EXPECT_EQ(error.Classes[0], MesoPixelClass::ShadowDiffers);
  EXPECT_EQ(error.Classes[22], MesoPixelClass::Equal);
}

TEST(GeometryError, ALightWithAPlaceIsSeenFromEachPoint)
{
  // The camera at 0 looks along -z at a wall from x = -5 to 5 at z = -5. With normals along +x, its
  // left half faces a light at (0, 0, -3) and its right half turns away from it.
  HandMadeAOVs truth(10, 2);
  truth.Fill("normal.x", 1.f);
  truth.Fill("normal.z", 0.f);
  for (const char* axis : { ".x", ".y", ".z" })
  {
    truth.Image.Attributes.erase("meso.light.0.towards" + std::string(axis));
    truth.Image.Attributes["meso.light.0.position" + std::string(axis)] = 0.;
  }
  truth.Image.Attributes["meso.light.0.position.z"] = -3.;
  HandMadeAOVs test = truth;
  test.At("shadow.0", 4, 0) = 1.f; // x = -0.5: faces the light
  MesoGeometryError error = Compare(truth, test);
  EXPECT_DOUBLE_EQ(error.ShadowCast, 1. / 10.);
  EXPECT_EQ(error.ShadowAttached, 0.);
  test = truth;
  test.At("shadow.0", 5, 0) = 1.f; // x = 0.5
  error = Compare(truth, test);
  EXPECT_EQ(error.ShadowCast, 0.);
  EXPECT_DOUBLE_EQ(error.ShadowAttached, 1. / 10.);
}

TEST(GeometryError, WithoutTheLightsShadowsAreNotTold)
{
  HandMadeAOVs truth(4, 4);
  truth.Image.Attributes.erase("meso.light.0.towards.x");
  const MesoGeometryError error = Compare(truth, truth);
  EXPECT_TRUE(std::isnan(error.ShadowAttached));
  EXPECT_TRUE(std::isnan(error.ShadowCast));
}
