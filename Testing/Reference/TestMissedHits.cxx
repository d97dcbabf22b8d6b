// No hit is missed and none is made up: random rays against one displaced triangle with spikes,
// slots, checkerboards and noise on flat, bent, sheared and mirrored charts, beside a brute-force march.
// Every hit of the solver is checked to lie on the sheet and on the ray, on a front side; every hit
// of the march must be found, or an earlier one.

#include "MarchedSheet.h"

namespace
{
constexpr int Texels = 16;
constexpr double Margin = 1e-6; // weights from the triangle's edge that the march leaves out

std::vector<float> MapOf(const std::string& kind)
{
  RandomNumbers random(11);
  std::vector<float> heights;
  for (int row = 0; row < Texels; ++row)
  {
    for (int column = 0; column < Texels; ++column)
    {
      const bool one = (column % 5 == 2) && (row % 5 == 2);
      const double height = kind == "spikes" ? (one ? 1. : 0.)
        : kind == "slots"                    ? (one ? 0. : 1.)
        : kind == "checkerboard"             ? (column + row) % 2
        : kind == "flat"                     ? 0.4
                                             : random.In(0., 1.);
      heights.push_back(static_cast<float>(height));
    }
  }
  return heights;
}

/// bend: how far the corners' normals lean outward; shear and mirror act on the chart.
MarchedSheet MakeSheet(
  const std::string& map, double bend, double shear, bool mirror, MesoWrap wrap)
{
  MarchedSheet sheet{ {}, {}, {}, { Texels, Texels, wrap, MapOf(map) }, 0.12 };
  sheet.Positions = { glm::dvec3(0., 0., 0.), glm::dvec3(1., 0.1, 0.05),
    glm::dvec3(0.2, 0.9, -0.1) };
  const glm::dvec3 middle = (sheet.Positions[0] + sheet.Positions[1] + sheet.Positions[2]) / 3.;
  for (int k = 0; k < 3; ++k)
  {
    sheet.Normals[k] =
      glm::normalize(glm::dvec3(0., 0., 1.) + bend * (sheet.Positions[k] - middle));
    const glm::dvec3& p = sheet.Positions[k];
    sheet.Coordinates[k] = { 1.3 * p.x + shear * p.y - 0.4, 1.1 * p.y - 0.25 * p.x + 0.3 };
    sheet.Coordinates[k].x *= mirror ? -1. : 1.;
  }
  return sheet;
}

struct Counts
{
  int Hits = 0;
  int Missed = 0;
  int False = 0;
  int Earlier = 0; // than the march's first, and right
  double LargestResidual = 0.;
};

Counts Compare(const MarchedSheet& sheet, int rays, double grazing, unsigned int seed)
{
  std::array<glm::dvec2, 3> places;
  for (int k = 0; k < 3; ++k)
  {
    places[k] = sheet.Coordinates[k] * double(Texels) - 0.5;
  }
  const MesoTrianglePatch patch(sheet.Positions, sheet.Normals, places);
  std::vector<float> heights;
  for (int row = 0; row < Texels; ++row)
  {
    for (int column = 0; column < Texels; ++column)
    {
      heights.push_back(static_cast<float>(sheet.Texture.fetchHeight({ column, row })));
    }
  }
  const MesoHeightPyramid map(
    Texels, Texels, static_cast<MesoWrap>(sheet.Texture.wrapMode()), std::move(heights));
  MesoDisplacement over;
  over.Map = &map;
  over.Scale = sheet.Scale;

  RandomNumbers random(seed);
  Counts counts;
  for (int i = 0; i < rays; ++i)
  {
    MarchedSheet::Place aim;
    aim.Second = random.In(0., 1.);
    aim.Third = random.In(0., 1. - aim.Second);
    aim.G = -sheet.Scale * random.In(0., 1.);
    glm::dvec3 direction = random.Direction();
    direction.z *= grazing;
    const glm::dvec3 origin = sheet.PointAt(aim) - 0.8 * direction;

    MesoPatchSolver solver(origin, direction, 0., std::numeric_limits<double>::infinity());
    MesoPatchHit hit;
    const bool found = solver.FirstHit(patch, over, MesoFacing::Front, false, hit);
    EXPECT_EQ(solver.Work().Unresolved, 0u);
    if (found)
    {
      ++counts.Hits;
      // Apart from the solver: the sheet's point at the hit, and the side it faces.
      const glm::dvec3 point = origin + hit.T * direction;
      MarchedSheet::Place at;
      const glm::dvec3 weights = patch.Weights(hit.X, hit.Y);
      at.Second = weights.y;
      at.Third = weights.z;
      at.G = sheet.SheetAt(at);
      const double residual = glm::length(sheet.PointAt(at) - point);
      counts.LargestResidual = std::max(counts.LargestResidual, residual);
      const auto above = [&](double t)
      {
        MarchedSheet::Place near = at;
        return sheet.Find(origin + t * direction, near) && near.G > sheet.SheetAt(near);
      };
      if (residual > 1e-12 || !at.Inside(-1e-10) || !above(hit.T - 1e-7) || above(hit.T + 1e-7))
      {
        ++counts.False;
      }
    }
    const double marched = sheet.FirstHit(origin, direction, 0., 1.9, 1500, Margin);
    if (std::isfinite(marched))
    {
      if (!found || hit.T > marched + 1e-9)
      {
        ++counts.Missed;
        std::cout << "ray " << i << ": march " << marched << " solver " << (found ? hit.T : -1.)
                  << "\n";
      }
      else if (hit.T < marched - 1e-9)
      {
        ++counts.Earlier;
      }
    }
  }
  return counts;
}

class MissedHits : public testing::TestWithParam<const char*>
{
protected:
  void Check(const MarchedSheet& sheet, double grazing, unsigned int seed)
  {
    constexpr int Rays = 1000;
    const Counts counts = Compare(sheet, Rays, grazing, seed);
    EXPECT_EQ(counts.Missed, 0) << "of " << Rays;
    EXPECT_LE(counts.False, 0) << "of " << Rays;
    EXPECT_GT(counts.Hits, Rays / 8);
    // What the march steps over: corners of a spike cut within a step, and the margin.
    EXPECT_LE(counts.Earlier, Rays / 20);
    EXPECT_LT(counts.LargestResidual, 1e-12);
    this->RecordProperty("LargestResidual", std::to_string(counts.LargestResidual));
  }
};
}

TEST_P(MissedHits, OnAFlatTriangle)
{
  this->Check(MakeSheet(GetParam(), 0., 0., false, MesoWrap::Repeat), 1., 1);
}

TEST_P(MissedHits, OnABentTriangle)
{
  this->Check(MakeSheet(GetParam(), 0.9, 0., false, MesoWrap::Repeat), 1., 2);
}

TEST_P(MissedHits, OnAHollowShearedMirroredTriangle)
{
  this->Check(MakeSheet(GetParam(), -0.9, 0.8, true, MesoWrap::Mirror), 1., 3);
}

TEST_P(MissedHits, OfGrazingRays)
{
  this->Check(MakeSheet(GetParam(), 0.5, 0.2, false, MesoWrap::Clamp), 0.05, 4);
}

INSTANTIATE_TEST_SUITE_P(Maps, MissedHits,
  testing::Values("spikes", "slots", "checkerboard", "noise", "flat"),
  [](const testing::TestParamInfo<const char*>& info) { return std::string(info.param); });

TEST(SolverHardCases, NormalsThatTurnAround)
{
  // Corners' normals more than 90 degrees apart, and one of length 0: no bounds of N hold over the
  // whole triangle. Every hit is still on the sheet and on the ray, and there is an end.
  MarchedSheet sheet = MakeSheet("noise", 0., 0., false, MesoWrap::Repeat);
  sheet.Normals = { glm::dvec3(1., 0., 0.3), glm::dvec3(-1., 0.2, 0.3), glm::dvec3(0.) };
  std::array<glm::dvec2, 3> places;
  for (int k = 0; k < 3; ++k)
  {
    places[k] = sheet.Coordinates[k] * double(Texels) - 0.5;
  }
  const MesoTrianglePatch patch(sheet.Positions, sheet.Normals, places);
  const MesoHeightPyramid map(Texels, Texels, MesoWrap::Repeat, MapOf("noise"));
  MesoDisplacement over;
  over.Map = &map;
  over.Scale = 0.12;
  RandomNumbers random(5);
  int hits = 0;
  std::uint64_t pieces = 0;
  for (int i = 0; i < 500; ++i)
  {
    const glm::dvec3 direction = random.Direction();
    const glm::dvec3 target(random.In(0., 0.6), random.In(0., 0.6), random.In(-0.1, 0.1));
    MesoPatchSolver solver(target - direction, direction, 0., 3.);
    MesoPatchHit hit;
    if (solver.FirstHit(patch, over, MesoFacing::Front, false, hit))
    {
      ++hits;
      MarchedSheet::Place at;
      const glm::dvec3 weights = patch.Weights(hit.X, hit.Y);
      at.Second = weights.y;
      at.Third = weights.z;
      at.G = sheet.SheetAt(at);
      EXPECT_LT(glm::length(sheet.PointAt(at) - (target + (hit.T - 1.) * direction)), 1e-11);
    }
    pieces += solver.Work().Pieces;
  }
  EXPECT_GT(hits, 50);
  EXPECT_LT(pieces, 500u * 5000u);
}

TEST(SolverHardCases, RaysWithinASheetEndSoon)
{
  // Along a flat sheet, in it: edge-on, so not a hit, and not a search without end.
  const MarchedSheet sheet = MakeSheet("flat", 0., 0., false, MesoWrap::Repeat);
  std::array<glm::dvec2, 3> places;
  for (int k = 0; k < 3; ++k)
  {
    places[k] = sheet.Coordinates[k] * double(Texels) - 0.5;
  }
  const MesoTrianglePatch patch(sheet.Positions, sheet.Normals, places);
  const MesoHeightPyramid map(Texels, Texels, MesoWrap::Repeat, MapOf("flat"));
  MesoDisplacement over;
  over.Map = &map;
  over.Scale = 0.12;
  for (double lean : { 0., 1e-14, 1e-9, -1e-9 })
  {
    for (const auto facing : { MesoFacing::Front, MesoFacing::Both })
    {
      const glm::dvec3 inside =
        (sheet.Positions[0] + sheet.Positions[1] + sheet.Positions[2]) / 3. -
        0.6 * 0.12 * sheet.Normals[0];
      const glm::dvec3 direction =
        glm::normalize(sheet.Positions[1] - sheet.Positions[0]) + lean * sheet.Normals[0];
      MesoPatchSolver solver(inside - 2. * direction, direction, 0., 5.);
      MesoPatchHit hit;
      solver.FirstHit(patch, over, facing, false, hit);
      EXPECT_LT(solver.Work().Pieces + solver.Work().Blocks, 100000u) << lean;
    }
  }
}
