// A map of elevations in metres: what pixels know reads back as the numbers in the file, on a plane and on
// a globe, drawn and traced.

#include "DrawnAOVs.h"
#include "MesoExr.h"
#include "ReferenceWorld.h"

#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>
#include <unistd.h>

namespace
{
constexpr int Columns = 40;
constexpr int Rows = 30;
constexpr double Low = 236.;
constexpr double High = 1076.;

/// An EXR file of elevations, whole metres, removed with it.
class Elevations
{
public:
  Elevations()
    : Name(testing::TempDir() + "meso_elevations_" + std::to_string(getpid()) + ".exr")
  {
    for (int row = 0; row < Rows; ++row)
    {
      for (int column = 0; column < Columns; ++column)
      {
        const double hill = std::sin(0.31 * column) * std::cos(0.4 * row + 0.1 * column);
        this->Metres.push_back(static_cast<float>(std::round(656. + 420. * hill)));
      }
    }
    MesoWriteExr(this->Name, Columns, Rows, { "Y" }, this->Metres.data());
  }
  ~Elevations() { std::remove(this->Name.c_str()); }
  Elevations(const Elevations&) = delete;
  void operator=(const Elevations&) = delete;

  double At(int column, int row) const { return double(this->Metres[row * Columns + column]); }

  std::string Name;

private:
  std::vector<float> Metres; ///< row 0 is north
};

/// From straight above a plane, a pixel a sample.
MesoScene FromAbove(const Elevations& map, const std::string& technique, double exaggeration)
{
  return MesoParseScene(
    R"({"meso": 1, "camera": {"position": [0, 0, 50000], "parallel_scale": 1350},
    "nodes": [{"mesh": {"shape": "plane"}, "mesostructure": {"technique": ")" +
      technique + R"(", "quality": "high", "height_map": ")" + map.Name +
      R"(", "range": [236, 1076], "sample_spacing": [90, 90], "wrap": "clamp", "reference": 0,
      "scale": )" +
      std::to_string(exaggeration * (High - Low)) + "}}]}",
    "above.json");
}

/// The largest differences to the file of elevations by `relief` and by `depth`.
std::array<double, 2> Differences(
  const Elevations& map, const MesoExrImage& pixels, double exaggeration)
{
  std::array<double, 2> largest = { 0., 0. };
  for (int row = 0; row < Rows; ++row)
  {
    for (int column = 0; column < Columns; ++column)
    {
      const double relief = High - ValueAt(pixels, "relief", column, row) * (High - Low);
      const double depth = Low + (50000. - ValueAt(pixels, "depth", column, row)) / exaggeration;
      EXPECT_EQ(ValueAt(pixels, "coverage", column, row), 1.);
      largest[0] = std::max(largest[0], std::abs(relief - map.At(column, row)));
      largest[1] = std::max(largest[1], std::abs(depth - map.At(column, row)));
    }
  }
  return largest;
}
}

TEST(HeightFieldUnits, PixelsReadBackAsTheFilesMetres)
{
  const Elevations map;
  for (double exaggeration : { 1., 3. })
  {
    for (const char* technique : { "relief", "tessellated", "reference" })
    {
      const bool traced = technique == std::string("reference");
      const MesoScene scene = FromAbove(map, traced ? "relief" : technique, exaggeration);
      const MesoExrImage pixels =
        traced ? MesoReference(scene).Render(Columns, Rows).AOVs : DrawnImage(scene, Columns, Rows);
      const auto largest = Differences(map, pixels, exaggeration);
      std::cout << technique << " x " << exaggeration << ": " << largest[0] << " m by relief, "
                << largest[1] << " m by depth\n";
      // A float's step at 50 km is 4 mm. Diced, the corners do not lie on the samples.
      const double most = technique == std::string("tessellated") ? 0.02 * (High - Low) : 0.05;
      EXPECT_LT(largest[0], most) << technique;
      EXPECT_LT(largest[1], most) << technique;
    }
  }
}

TEST(HeightFieldUnits, GlobesAreAsHighAsTheirMaps)
{
  // Above the point u = 3/4, v = 1/2 (+x) of a globe of 6371 km, between samples; and the way round.
  const Elevations map;
  const MesoScene scene = MesoParseScene(R"({"meso": 1,
    "camera": {"position": [7000000, 0, 0], "view_angle": 0.001},
    "nodes": [{"mesh": {"shape": "sphere", "radius": 6371000, "rings": 128, "sides": 256},
      "mesostructure": {"technique": "relief", "height_map": ")" +
      map.Name + R"(", "range": [236, 1076], "scale": 840, "reference": 0}}]})",
    "globe.json");
  const MesoExrImage pixels =
    MesoReference(scene, MesoReference::Surface::Smooth).Render(1, 1).AOVs;
  // Column 29.5 and row 14.5 of samples.
  const double wanted = 0.25 * (map.At(29, 14) + map.At(30, 14) + map.At(29, 15) + map.At(30, 15));
  EXPECT_NEAR(High - ValueAt(pixels, "relief", 0, 0) * (High - Low), wanted, 0.01);
  EXPECT_NEAR(7000000. - ValueAt(pixels, "depth", 0, 0) - 6371000. + Low, wanted, 0.1);
}
