// The closed-form solver of paths against a march of tiny steps, on maps that searches miss things in:
// no meeting missed, none found where there is none.

#include "MesoPathSolver.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

namespace
{
struct NamedMap
{
  const char* Name;
  std::function<double(int, int, std::mt19937&)> Height;
};

const NamedMap Maps[] = {
  { "noise",
    [](int, int, std::mt19937& generator)
    { return std::uniform_real_distribution<double>(0., 1.)(generator); } },
  { "checkerboard", [](int column, int row, std::mt19937&) { return (column + row) % 2 * 1.; } },
  { "spike", [](int column, int row, std::mt19937&) { return column == 5 && row == 3 ? 1. : 0.; } },
  { "slot", [](int column, int row, std::mt19937&) { return column == 5 && row == 3 ? 0. : 1.; } },
  { "wall", [](int column, int, std::mt19937&) { return column == 5 ? 0.9 : 0.1; } },
};

class PathSolver : public testing::Test
{
protected:
  std::mt19937 Generator{ 7 };

  double Random(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Generator);
  }

  MesoModelField Field(const NamedMap& map, MesoWrap wrap)
  {
    constexpr int Width = 11;
    constexpr int Height = 8;
    std::vector<float> heights;
    for (int row = 0; row < Height; ++row)
    {
      for (int column = 0; column < Width; ++column)
      {
        heights.push_back(static_cast<float>(map.Height(column, row, this->Generator)));
      }
    }
    return MesoModelField(Width, Height, wrap, heights);
  }

  /// Down to the bottom or back to the top, straight or bent either way.
  MesoModelPath Path()
  {
    MesoModelPath path;
    path.MapStart = { this->Random(-3., 3.), this->Random(-3., 3.) };
    const double length = std::pow(10., this->Random(-2., 0.5));
    const double azimuth = this->Random(0., 6.3);
    path.MapSpan = { length * std::cos(azimuth), length * std::sin(azimuth) };
    path.DepthStart = 0.;
    path.DepthEnd = this->Random(0., 1.) < 0.6 ? 1. : 0.;
    path.Sag = path.DepthEnd > 0. ? this->Random(-0.9, 1.) : this->Random(0., 3.9);
    return path;
  }

  static double Clearance(const MesoModelField& field, const MesoModelPath& path, double part)
  {
    return field.exactClearance(path, part);
  }
};
}

TEST_F(PathSolver, FindsTheFirstMeetingOfEveryPath)
{
  int met = 0;
  int missed = 0;
  for (const NamedMap& map : Maps)
  {
    for (MesoWrap wrap : { MesoWrap::Repeat, MesoWrap::Clamp, MesoWrap::Mirror })
    {
      for (int run = 0; run < 200; ++run)
      {
        const MesoModelField field = this->Field(map, wrap);
        const MesoModelPath path = this->Path();
        const double found = MesoFirstMeeting(field, path);
        constexpr int Steps = 2000;
        // No step before the meeting lies inside.
        for (int i = 0; i < Steps; ++i)
        {
          const double part = i / double(Steps);
          if (part >= found - 1e-9)
          {
            break;
          }
          ASSERT_GT(this->Clearance(field, path, part), -1e-12)
            << map.Name << " met at " << found << ", inside at " << part;
        }
        if (found <= 1.)
        {
          ++met;
          // And the meeting is one: on the relief, or inside from the start.
          const double clearance = this->Clearance(field, path, found);
          ASSERT_TRUE(found == 0. ? clearance <= 0. : std::abs(clearance) < 1e-9)
            << map.Name << " at " << found << ": " << clearance;
        }
        else
        {
          ++missed;
          ASSERT_EQ(path.DepthEnd, 0.) << "a path to the bottom meets it";
        }
      }
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(missed, 100);
}

TEST_F(PathSolver, TellsWhatIsBlocked)
{
  int blocked = 0;
  int clear = 0;
  for (const NamedMap& map : Maps)
  {
    for (int run = 0; run < 400; ++run)
    {
      const MesoModelField field = this->Field(map, MesoWrap::Repeat);
      MesoModelPath path = this->Path();
      path.DepthStart = this->Random(0.01, 1.);
      path.DepthEnd = 0.;
      path.Sag = this->Random(-0.5, 1.) * path.DepthStart;
      double least = 1.;
      constexpr int Steps = 4000;
      for (int i = 0; i <= Steps; ++i)
      {
        least = std::min(least, this->Clearance(field, path, i / double(Steps)));
      }
      if (std::abs(least) < 1e-4)
      {
        continue; // grazes: the march cannot tell
      }
      ASSERT_EQ(MesoIsBlocked(field, path), least < 0.) << map.Name << ": " << least;
      (least < 0. ? blocked : clear) += 1;
    }
  }
  EXPECT_GT(blocked, 200);
  EXPECT_GT(clear, 200);
}

TEST_F(PathSolver, TakesPathsThatAreNone)
{
  const MesoModelField field = this->Field(Maps[0], MesoWrap::Repeat);
  MesoModelPath path = field.straightPath({ 0.1, 0.2 }, { 0.3, 0.4 }, 0., 1.);
  path.MapSpan.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_GT(MesoFirstMeeting(field, path), 1.);
  EXPECT_FALSE(MesoIsBlocked(field, path));
  path.MapSpan = { 1e12, 0. };
  EXPECT_GT(MesoFirstMeeting(field, path), 1.);
  // Far out on a map that is clamped, where whole tiles are not taken off.
  const MesoModelField clamped = this->Field(Maps[0], MesoWrap::Clamp);
  EXPECT_GT(MesoFirstMeeting(clamped, clamped.straightPath({ 1e12, 0. }, { 0., 0. }, 0., 1.)), 1.);
  EXPECT_LE(MesoFirstMeeting(clamped, clamped.straightPath({ 1e6, 0. }, { 0., 0. }, 0., 1.)), 1.);
  // Straight down, and along a line of texel centres.
  EXPECT_LE(MesoFirstMeeting(field, field.straightPath({ 0.1, 0.2 }, { 0., 0. }, 0., 1.)), 1.);
  EXPECT_LE(
    MesoFirstMeeting(field, field.straightPath({ 0.5 / 11, 0.5 / 8 }, { 1., 0. }, 0., 1.)), 1.);
}
