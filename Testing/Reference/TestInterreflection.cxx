// Light over several surfaces, where the answer is known: inside a closed sphere, in a corner of two
// walls, over a flat plane, which sees nothing of itself; and what must not depend on the noise.

#include "MesoSampling.h"
#include "ReferenceWorld.h"

#include "vtkSMPTools.h"

#include <cmath>

namespace
{
constexpr int Width = 24;
constexpr int Height = 16;

/// Mean of the red of all pixels, 0 to 1.
double MeanRed(const MesoReferenceResult& result)
{
  const auto* bytes = static_cast<const unsigned char*>(result.Picture->GetScalarPointer());
  const vtkIdType pixels = result.Picture->GetNumberOfPoints();
  double sum = 0.;
  for (vtkIdType i = 0; i < pixels; ++i)
  {
    sum += bytes[3 * i] / 255.;
  }
  return sum / static_cast<double>(pixels);
}

MesoReferenceResult Trace(const std::string& scene, int samples, int bounces)
{
  return MesoReference(SceneOf(scene)).Render(Width, Height, samples, {}, bounces);
}

// Without lights VTK lights every surface with 1 from its own side.
const char* const InsideASphere = R"("camera": {"position": [0, 0, 0], "focal_point": [0, 0, -1]},
  "lights": [], "nodes": [{"mesh": {"shape": "sphere"},
    "material": {"color": [0.5, 0.5, 0.5], "two_sided": true}}])";

std::string Corner(const std::string& more = "")
{
  // A floor and a wall of 2000 x 1000 each that meet in the x axis, seen close to it.
  return R"("camera": {"position": [0, 0.4, 0.5], "focal_point": [0, 0.1, 0], "view_angle": 20},
    "lights": [], "nodes": [
    {"transform": {"translate": [0, 0, 500], "rotate": [-90, 1, 0, 0]},
     "mesh": {"shape": "plane", "size": [2000, 1000]}, "material": {"color": [0.5, 0.5, 0.5])" +
    more + R"(}},
    {"transform": {"translate": [0, 500, 0]},
     "mesh": {"shape": "plane", "size": [2000, 1000]}, "material": {"color": [0.5, 0.5, 0.5]}}])";
}

const char* const Bricks = R"("camera": {"position": [0.4, -0.6, 1], "view_angle": 30},
  "lights": [{"type": "directional", "direction": [0.4, 0.3, -1]}],
  "nodes": [{"mesh": {"shape": "plane", "size": [3, 3]}, "material": {"color": [0.8, 0.6, 0.4]},
    "mesostructure": {"technique": "relief", "scale": 0.08, "tiles": [3, 3],
                      "height_map": {"pattern": "brick", "size": [64, 64]}}}])";
}

TEST(Interreflection, DirectionsAreAsDenseAsTheCosine)
{
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.8, 0.5));
  MesoRandom random(5);
  glm::dvec3 mean(0.);
  double cosines = 0.;
  double squares = 0.;
  constexpr int Runs = 100000;
  for (int run = 0; run < Runs; ++run)
  {
    const double u = random.Next();
    const glm::dvec3 direction = MesoCosineDirection(normal, u, random.Next());
    ASSERT_NEAR(glm::length(direction), 1., 1e-12);
    const double cosine = glm::dot(direction, normal);
    ASSERT_GE(cosine, 0.);
    mean += direction / double(Runs);
    cosines += cosine / Runs;
    squares += cosine * cosine / Runs;
  }
  // Of the density cos / pi: the mean cosine is 2/3, that of its square 1/2, and no side is preferred.
  EXPECT_NEAR(cosines, 2. / 3., 0.005);
  EXPECT_NEAR(squares, 0.5, 0.005);
  EXPECT_NEAR(glm::length(mean - 2. / 3. * normal), 0., 0.01);
}

TEST(Interreflection, InsideAClosedSphereIsAGeometricSeries)
{
  // Every path meets the sphere again, so that there is no noise: 1/2 + 1/4 + 1/8 + ...
  EXPECT_NEAR(MeanRed(Trace(InsideASphere, 1, 0)), 0.5, 0.003);
  EXPECT_NEAR(MeanRed(Trace(InsideASphere, 1, 1)), 0.75, 0.003);
  EXPECT_NEAR(MeanRed(Trace(InsideASphere, 4, 3)), 0.9375, 0.003);
}

TEST(Interreflection, InACornerHalfOfTheLightComesFromTheOtherWall)
{
  // Of Lambert's cosine each wall of an endless corner fills half: 1/2 (1 + 1/4 + 1/16 + ...).
  EXPECT_NEAR(MeanRed(Trace(Corner(), 256, 1)), 0.5 * 1.25, 0.01);
  EXPECT_NEAR(MeanRed(Trace(Corner(), 256, 3)), 0.5 * 1.328125, 0.01);
  // Nothing comes over a black floor.
  const std::string black = Corner(R"(, "diffuse": 0)");
  EXPECT_NEAR(MeanRed(Trace(black, 16, 3)), MeanRed(Trace(black, 16, 0)), 1e-6);
}

TEST(Interreflection, EachDirectionOfAPathIsDrawnAnewWithOneSampleToo)
{
  // Over two surfaces come 1/16 of the light; not so where the second direction repeats the first.
  const MesoReference corner(SceneOf(Corner()));
  const auto mean = [&](int bounces)
  { return MeanRed(corner.Render(16 * Width, 16 * Height, 1, {}, bounces)); };
  EXPECT_NEAR(mean(2) - mean(1), 0.5 / 16., 0.003);
}

TEST(Interreflection, AFlatPlaneSeesNothingOfItself)
{
  const std::string plane = R"("camera": {"position": [0.4, -0.6, 1], "view_angle": 30},
    "lights": [{"type": "directional", "direction": [0.4, 0.3, -1]}],
    "nodes": [{"mesh": {"shape": "plane", "size": [9, 9]}, "material": {"color": [0.8, 0.6, 0.4]},
      "mesostructure": {"technique": "relief", "scale": 0.08,
                        "height_map": {"pattern": "step", "position": 1, "low": 0.5}}}])";
  EXPECT_NEAR(MeanRed(Trace(plane, 4, 4)), MeanRed(Trace(plane, 4, 0)), 1e-6);
}

TEST(Interreflection, DetailLightsItself)
{
  const double straight = MeanRed(Trace(Bricks, 16, 0));
  const double once = MeanRed(Trace(Bricks, 64, 1));
  const double often = MeanRed(Trace(Bricks, 64, 4));
  EXPECT_GT(once, straight + 0.003);
  EXPECT_GT(often, once);
  // At most as much as in a closed hull.
  EXPECT_LT(often, straight / (1. - 0.8));
}

TEST(Interreflection, IsTheSameWithAnyNumberOfThreads)
{
  const MesoReferenceResult one = Trace(Bricks, 3, 2);
  vtkSMPTools::Initialize(1);
  const MesoReferenceResult other = Trace(Bricks, 3, 2);
  vtkSMPTools::Initialize(0);
  const auto* a = static_cast<const unsigned char*>(one.Picture->GetScalarPointer());
  const auto* b = static_cast<const unsigned char*>(other.Picture->GetScalarPointer());
  EXPECT_TRUE(std::equal(a, a + 3 * Width * Height, b));
  EXPECT_EQ(one.AOVs.Data, Trace(Bricks, 3, 0).AOVs.Data) << "what pixels know hangs on bounces";
}
