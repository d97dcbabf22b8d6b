// Every pixel's hit against closed forms: a plane with one step, seen at 45 degrees. The step's wall
// is a ramp of one texel, since heights are bilinear between texel centres.

#include "MesoTiltedPlane.h"

#include <gtest/gtest.h>

namespace
{
constexpr int Texels = 64;
constexpr double Depth = 0.1;
// Texel centres beside the two ramps: down from TopEnd to FloorStart, up from FloorEnd.
constexpr double TopEnd = 31.5 / Texels;
constexpr double FloorStart = 32.5 / Texels;
constexpr double FloorEnd = 63.5 / Texels;

/// Where the ray that enters at u meets the step, as depth in [0,1].
double ExpectedRelief(double u, double travel)
{
  if (u >= 0.5 / Texels && u <= TopEnd)
  {
    return 0.;
  }
  if (u + travel <= FloorEnd)
  {
    return 1.;
  }
  // On the upward ramp depth is 64.5 - 64 u'; the ray has it at u' = u + s travel.
  return (Texels + 0.5 - Texels * u) / (1. + Texels * travel);
}

class ReliefStep : public testing::Test
{
protected:
  MesoTiltedPlane Plane{ 45., Depth, MesoTestScene::Pattern("step", Texels, Texels), 90 };

  /// Calls check(column, row, u of the entry) for the pixels on the plane's closed-form part.
  template <typename Check>
  int ForPixels(Check check)
  {
    int count = 0;
    for (int row = 0; row < 90; row += 3)
    {
      for (int column = 0; column < 90; ++column)
      {
        const double u = this->Plane.EntryU(column);
        if (u > 0.5 / Texels && u < 1.)
        {
          check(column, row, u);
          ++count;
        }
      }
    }
    return count;
  }
};
}

TEST_F(ReliefStep, HitAndDepthAreExact)
{
  this->Plane.Capture();
  const double travel = this->Plane.TravelU();
  int walls = 0;
  const int count = this->ForPixels(
    [&](int column, int row, double u)
    {
      const double relief = ExpectedRelief(u, travel);
      walls += relief > 0. && relief < 1. ? 1 : 0;
      const auto value = [&](const char* channel)
      { return this->Plane.Pass->GetValue(channel, column, row); };
      EXPECT_EQ(value("coverage"), 1.f);
      // Hardware snaps corners to 1/256 pixel, which is 4e-5 of u here; on the wall a texel of u is
      // all of the depth.
      EXPECT_NEAR(value("relief"), relief, 1e-3) << "u = " << u;
      EXPECT_NEAR(value("texcoord.u"), u + relief * travel, 4e-5);
      EXPECT_NEAR(value("texcoord.v"), this->Plane.EntryV(row), 4e-5);
      const double depth = MesoTiltedPlane::Distance +
        this->Plane.ScreenX(column) * std::tan(this->Plane.Angle) +
        relief * Depth / std::cos(this->Plane.Angle);
      EXPECT_NEAR(value("depth"), depth, 1e-4);
    });
  EXPECT_GT(count, 1500);
  EXPECT_GT(walls, 30) << "the camera does not see the wall";
}

TEST_F(ReliefStep, NormalIsThatOfTheBaseOnFlatGround)
{
  this->Plane.Capture();
  this->ForPixels(
    [&](int column, int row, double)
    {
      const double u = this->Plane.Pass->GetValue("texcoord.u", column, row);
      const bool top = u > 1.5 / Texels && u < TopEnd - 1. / Texels;
      const bool floor = u > FloorStart + 1. / Texels && u < FloorEnd - 1. / Texels;
      if (top || floor)
      {
        EXPECT_NEAR(this->Plane.Pass->GetValue("normal.x", column, row), 0., 1e-6);
        EXPECT_NEAR(this->Plane.Pass->GetValue("normal.z", column, row), 1., 1e-6);
      }
    });
  // Beside the edge the central difference is half the step: q_u = (1, 0, D h_u), h_u = -32.
  int column = 0;
  while (column < 89 && this->Plane.EntryU(column + 1) < TopEnd)
  {
    ++column;
  }
  const double u = this->Plane.Pass->GetValue("texcoord.u", column, 45);
  const double part = 1. - (TopEnd - u) * Texels; // of the way to the last centre on top
  ASSERT_GT(part, 0.);
  ASSERT_LE(part, 1.);
  const double slope = Depth * -0.5 * Texels * part;
  EXPECT_NEAR(this->Plane.Pass->GetValue("normal.x", column, 45),
    -slope / std::sqrt(1. + slope * slope), 1e-4);
}

TEST_F(ReliefStep, ShadowFallsAsFarAsTheLightSays)
{
  this->Plane.AddDirectionalLight(2., 0., -1.); // from the left, lower than the eye
  this->Plane.AddDirectionalLight(0., 0., 1.);  // from below: blocked everywhere
  this->Plane.Capture();
  int lit = 0;
  int shadowed = 0;
  this->ForPixels(
    [&](int column, int row, double)
    {
      const double u = this->Plane.Pass->GetValue("texcoord.u", column, row);
      const float shadow = this->Plane.Pass->GetValue("shadow.0", column, row);
      EXPECT_EQ(this->Plane.Pass->GetValue("shadow.1", column, row), 1.f);
      if (u > 1. / Texels && u < TopEnd)
      {
        EXPECT_EQ(shadow, 0.f) << "on top, u = " << u;
      }
      // The ray from the floor passes the edge's corner where it is 2 D away from it.
      const double past = u - (TopEnd + 2. * Depth);
      if (u > FloorStart && u < FloorEnd && std::abs(past) > 0.002)
      {
        EXPECT_EQ(shadow, past < 0. ? 1.f : 0.f) << "on the floor, u = " << u;
        (past < 0. ? shadowed : lit) += 1;
      }
    });
  EXPECT_GT(lit, 100);
  EXPECT_GT(shadowed, 100);
}

TEST_F(ReliefStep, NothingBehindALightCastsShadow)
{
  // A point light in the hollow, low: the wall is on the far side of it from the floor's end.
  vtkLight* light = this->Plane.AddDirectionalLight(1., 0., -1.);
  light->PositionalOn();
  light->SetConeAngle(90.);
  light->SetPosition(0.25, 0., -0.9 * Depth);
  light->SetFocalPoint(0.25, 0., -1.);
  this->Plane.Capture();
  int floor = 0;
  this->ForPixels(
    [&](int column, int row, double)
    {
      const double u = this->Plane.Pass->GetValue("texcoord.u", column, row);
      if (u > 0.8 && u < FloorEnd - 0.5 / Texels)
      {
        EXPECT_EQ(this->Plane.Pass->GetValue("shadow.0", column, row), 0.f) << "u = " << u;
        ++floor;
      }
    });
  EXPECT_GT(floor, 100);
}

TEST_F(ReliefStep, CountsWhatItReads)
{
  this->Plane.Capture();
  this->ForPixels(
    [&](int column, int row, double u)
    {
      const float iterations = this->Plane.Pass->GetValue("iterations", column, row);
      if (u < TopEnd)
      {
        EXPECT_EQ(iterations, 0.f) << "the start itself is the hit";
      }
      if (ExpectedRelief(u, this->Plane.TravelU()) == 1.)
      {
        EXPECT_EQ(iterations, 128.f + 8.f);
      }
      const float fetches = this->Plane.Pass->GetValue("fetches", column, row);
      EXPECT_GE(fetches, iterations);
      EXPECT_GE(this->Plane.Pass->GetValue("texel_reads", column, row), 4.f * (fetches - 1.f));
    });
}

TEST_F(ReliefStep, ObjectsAreNumbered)
{
  this->Plane.Pass->SetObjectNumber(this->Plane.Actor, 7);
  this->Plane.Capture();
  EXPECT_EQ(this->Plane.Pass->GetValue("object", 45, 45), 7.f);
  this->Plane.Renderer->GetActiveCamera()->SetParallelScale(2.);
  this->Plane.Capture();
  for (const std::string& channel : this->Plane.Pass->GetChannelNames())
  {
    EXPECT_EQ(this->Plane.Pass->GetValue(channel, 0, 0), 0.f) << channel << " of an empty pixel";
  }
  EXPECT_TRUE(std::isnan(this->Plane.Pass->GetValue("no such channel", 0, 0)));
}
