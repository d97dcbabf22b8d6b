// Whole scenes through MesoReference: what each pixel knows, on hand-made cases.

#include "ReferenceWorld.h"

#include "vtkSMPTools.h"

#include <cmath>

namespace
{
// A pixel is 0.05 wide; pixel (column, row) shows x = 0.05 (column + 0.5 - 32) and so on.
constexpr int Width = 64;
constexpr int Height = 48;
const char* const FromFront = R"("camera": {"position": [0, 0, 5], "parallel_scale": 1.2}, )";

MesoReferenceResult Trace(const std::string& rest,
  MesoReference::Surface surface = MesoReference::Surface::Mesh,
  const std::string& camera = FromFront)
{
  return MesoReference(SceneOf(camera + rest), surface).Render(Width, Height);
}

int Covered(const MesoReferenceResult& result, const std::string& channel = "coverage")
{
  int covered = 0;
  for (int row = 0; row < result.AOVs.Height; ++row)
  {
    for (int column = 0; column < result.AOVs.Width; ++column)
    {
      covered += ValueAt(result.AOVs, channel, column, row) > 0.5 ? 1 : 0;
    }
  }
  return covered;
}

/// Greatest difference of a channel over pixels that both cover; fails where coverage differs.
double Difference(const MesoReferenceResult& a, const MesoReferenceResult& b,
  const std::string& channel, double sign = 1., bool mirrored = false)
{
  double greatest = 0.;
  for (int row = 0; row < Height; ++row)
  {
    for (int column = 0; column < Width; ++column)
    {
      const int other = mirrored ? Width - 1 - column : column;
      EXPECT_EQ(ValueAt(a.AOVs, "coverage", column, row), ValueAt(b.AOVs, "coverage", other, row))
        << column << ", " << row;
      greatest = std::max(greatest,
        std::abs(
          ValueAt(a.AOVs, channel, column, row) - sign * ValueAt(b.AOVs, channel, other, row)));
    }
  }
  return greatest;
}

std::string Shape(const std::string& shape, const std::string& mesostructure,
  const std::string& transform = "{}", const std::string& material = "{}")
{
  return R"("nodes": [{"name": "thing", "transform": )" + transform + R"(, "mesh": {"shape": )" +
    shape + R"(}, "material": )" + material +
    (mesostructure.empty() ? std::string() : R"(, "mesostructure": )" + mesostructure) + "}]";
}

const char* const Bricks = R"({"technique": "relief", "scale": 0.1, "tiles": [2, 2],
  "height_map": {"pattern": "brick", "size": [64, 32]}})";
}

TEST(ReferenceScenes, EveryChannelIsZeroWhereNothingIsHit)
{
  const auto result = Trace(Shape(R"("plane")", Bricks));
  EXPECT_EQ(Covered(result), 20 * 20);
  for (const std::string& channel : result.AOVs.ChannelNames)
  {
    EXPECT_EQ(ValueAt(result.AOVs, channel, 0, 0), 0.) << channel;
  }
  const std::vector<std::string> expected = { "coverage", "depth", "texcoord.u", "texcoord.v",
    "relief", "normal.x", "normal.y", "normal.z", "object", "fetches", "texel_reads", "iterations",
    "shadow.0", "base" };
  EXPECT_EQ(result.AOVs.ChannelNames, expected);
  EXPECT_EQ(std::get<double>(result.AOVs.Attributes.at("meso.1.map_width")), 64.);
}

TEST(ReferenceScenes, OfAPlaneFromTheFront)
{
  const auto result = Trace(Shape(R"("plane", "size": [2, 2])", Bricks));
  int deep = 0;
  for (int row = 4; row < 44; ++row)
  {
    for (int column = 12; column < 52; ++column)
    {
      const auto value = [&](const char* name) { return ValueAt(result.AOVs, name, column, row); };
      const double x = 0.05 * (column + 0.5 - 0.5 * Width);
      const double y = 0.05 * (0.5 * Height - row - 0.5);
      ASSERT_EQ(value("coverage"), 1.);
      ASSERT_EQ(value("object"), 1.);
      ASSERT_EQ(value("base"), 1.);
      ASSERT_NEAR(value("texcoord.u"), x + 1., 1e-6);
      ASSERT_NEAR(value("texcoord.v"), y + 1., 1e-6);
      ASSERT_NEAR(value("depth"), 5. + 0.1 * value("relief"), 1e-6);
      ASSERT_NEAR(std::hypot(value("normal.x"), value("normal.y"), value("normal.z")), 1., 1e-6);
      deep += value("relief") > 0.7 ? 1 : 0;
    }
  }
  EXPECT_GT(deep, 50);
  EXPECT_LT(result.Counters.LargestResidual, 1e-12);
  EXPECT_EQ(result.Counters.UnresolvedCells, 0u);
}

TEST(ReferenceScenes, AFlatMapGivesTheBaseMesh)
{
  const char* const flat = R"({"technique": "relief", "scale": 0.2,
    "height_map": {"pattern": "step", "position": 1, "low": 1}})";
  for (const char* shape : { R"("torus", "rings": 12, "sides": 8)", R"("sphere", "rings": 5)" })
  {
    const auto plain = Trace(Shape(shape, ""));
    const auto relief = Trace(Shape(shape, flat));
    ASSERT_GT(Covered(plain), 300);
    for (const char* channel : { "depth", "normal.x", "normal.y", "normal.z", "texcoord.u" })
    {
      // Sums in another order: a unit or two of float's last place.
      EXPECT_LT(Difference(plain, relief, channel), 1e-6) << channel;
    }
    EXPECT_EQ(Covered(relief, "base"), Covered(relief));
    EXPECT_LT(Difference(plain, relief, "shadow.0"), 0.5);
  }
}

TEST(ReferenceScenes, BacksArePassedThrough)
{
  const std::string away = R"({"rotate": [180, 0, 1, 0]})";
  EXPECT_EQ(Covered(Trace(Shape(R"("plane")", Bricks, away))), 0);
  EXPECT_EQ(Covered(Trace(Shape(R"("plane")", "", away))), 0);
  // Within a closed surface nothing of it is seen.
  EXPECT_EQ(Covered(Trace(Shape(R"("sphere", "radius": 20)", Bricks))), 0);
}

TEST(ReferenceScenes, TwoSidedShowsThePlainBaseFromBehind)
{
  const std::string away = R"({"rotate": [180, 0, 1, 0]})";
  for (const char* mesostructure : { Bricks, "" })
  {
    const auto result = Trace(Shape(R"("plane")", mesostructure, away, R"({"two_sided": true})"));
    EXPECT_EQ(Covered(result), 20 * 20);
    EXPECT_EQ(Covered(result, "base"), 0);
    EXPECT_NEAR(ValueAt(result.AOVs, "depth", 32, 24), 5., 1e-6);
    EXPECT_EQ(ValueAt(result.AOVs, "relief", 32, 24), 0.);
    EXPECT_NEAR(ValueAt(result.AOVs, "normal.z", 32, 24), 1., 1e-6); // turned to the eye
  }
  // From the front the relief is there, and its own base does not keep the light out.
  const auto front =
    Trace(Shape(R"("plane", "size": [2, 2])", Bricks, "{}", R"({"two_sided": true})"));
  const auto single = Trace(Shape(R"("plane", "size": [2, 2])", Bricks));
  EXPECT_EQ(Difference(front, single, "depth"), 0.);
  EXPECT_EQ(Difference(front, single, "shadow.0"), 0.);
}

TEST(ReferenceScenes, OpenBordersAreSeenBesideTheBase)
{
  // Inward relief, half a unit deep, seen from the side: what lies below the border is no base's.
  const char* const deep = R"({"technique": "relief", "scale": 0.5,
    "height_map": {"pattern": "step", "position": 0, "low": 0}})";
  const auto result = Trace(Shape(R"("plane")", deep), MesoReference::Surface::Mesh,
    R"("camera": {"position": [3, 0, 3], "parallel_scale": 1.2}, )");
  const int covered = Covered(result);
  const int base = Covered(result, "base");
  ASSERT_GT(covered, 100);
  // The sheet is the plane moved by half a unit: it is covered by the plane for the half of it.
  EXPECT_NEAR(base, covered / 2., 0.06 * covered);
}

TEST(ReferenceScenes, AMirroredNodeIsTheMirrorImage)
{
  const std::string light = R"("lights": [{"type": "directional", "direction": [0, -0.5, -1]}], )";
  const std::string shape = R"("torus", "rings": 16, "sides": 10)";
  const auto result = Trace(light + Shape(shape, Bricks, R"({"rotate": [60, 1, 0, 0]})"));
  const auto mirrored =
    Trace(light + Shape(shape, Bricks, R"({"matrix": [-1, 0, 0, 0,  0, 0.5, -0.8660254037844386, 0,
                             0, 0.8660254037844386, 0.5, 0,  0, 0, 0, 1]})"));
  ASSERT_GT(Covered(result), 300);
  EXPECT_LT(Difference(result, mirrored, "depth", 1., true), 1e-5);
  EXPECT_LT(Difference(result, mirrored, "texcoord.u", 1., true), 1e-4);
  EXPECT_LT(Difference(result, mirrored, "normal.x", -1., true), 1e-3);
  EXPECT_LT(Difference(result, mirrored, "shadow.0", 1., true), 0.5);
}

TEST(ReferenceScenes, DepthScalesWithTheNode)
{
  // Twice as deep, and moved: displacement happens before the matrix.
  const auto result =
    Trace(Shape(R"("plane")", Bricks, R"({"translate": [0, 0, 0.5], "scale": [2, 1, 2]})"));
  ASSERT_EQ(Covered(result), 40 * 20);
  double deepest = 0.;
  for (int row = 14; row < 34; ++row)
  {
    for (int column = 12; column < 52; ++column)
    {
      const double relief = ValueAt(result.AOVs, "relief", column, row);
      deepest = std::max(deepest, relief);
      ASSERT_NEAR(ValueAt(result.AOVs, "depth", column, row), 4.5 + 0.2 * relief, 1e-6);
    }
  }
  EXPECT_GT(deepest, 0.8);
}

TEST(ReferenceScenes, TheShadingNormalHasAllTerms)
{
  // On a smooth cylinder with waves along its axis, q is known: so is q_s x q_t. The gradient is the
  // central difference of neighbouring texels, interpolated.
  constexpr int Texels = 32;
  const auto heights = HeightsOf(
    1, Texels, [](int, int row) { return 0.5 + 0.5 * std::sin(2. * 3.14159265358979 * row / 8.); });
  ReferenceWorld world(R"([{"mesh": {"shape": "cylinder", "sides": 9},
    "mesostructure": {"technique": "relief", "scale": 0.1, "height_map": {"pattern": "noise"}}}])",
    true, 0., heights);
  const auto* values = static_cast<const float*>(heights->GetScalarPointer());
  const auto texel = [&](int row) { return double(values[(row + Texels) % Texels]); };
  RandomNumbers random(9);
  for (int i = 0; i < 200; ++i)
  {
    const glm::dvec3 direction(random.In(-0.12, 0.12), random.In(-0.05, 0.05), -1.);
    const double t = world.T(glm::dvec3(0., random.In(-0.2, 0.2), 3.), direction);
    ASSERT_TRUE(std::isfinite(t));
    const auto point = world.Surfaces[0]->Describe(world.Hit, direction);
    const double y = point.MapCoord.y * Texels - 0.5;
    const int row = static_cast<int>(std::floor(y));
    const double weight = y - row;
    const double slope = 0.5 *
      ((1. - weight) * (texel(row + 1) - texel(row - 1)) + weight * (texel(row + 2) - texel(row)));
    // q = (R + (h - 1) D) out + y up: its normal leans by D h_y against the axis; the cylinder is 1
    // high. The radius plays no part, since h does not change around.
    const glm::dvec3 up(0., 1., 0.);
    const double turn = 2. * 3.14159265358979324 * (point.MapCoord.x - 0.5);
    const glm::dvec3 out(std::sin(turn), 0., std::cos(turn));
    const glm::dvec3 expected = glm::normalize(out - 0.1 * slope * Texels * up);
    ASSERT_LT(glm::length(point.Shading - expected), 1e-9) << "ray " << i;
  }
}

TEST(ReferenceScenes, ShadowsFollowTheLightsRules)
{
  // A small plane before a large one; the light falls straight on both.
  const std::string nodes = R"("nodes": [
    {"mesh": {"shape": "plane", "size": [2, 2]}},
    {"transform": {"translate": [0.4, 0, 1]}, "mesh": {"shape": "plane", "size": [0.5, 0.5]}}])";
  const std::string lights = R"("lights": [
    {"type": "directional", "direction": [-0.8, 0, -1]},
    {"type": "directional", "direction": [-0.8, 0, -1], "shadow": false},
    {"type": "point", "position": [0, 0, 0.5]},
    {"type": "directional", "direction": [0, 0, 1]}], )";
  const auto result = Trace(lights + nodes);
  const auto shadow = [&](int light, double x, double y)
  {
    return ValueAt(result.AOVs, "shadow." + std::to_string(light),
      static_cast<int>(x / 0.05 + 0.5 * Width), static_cast<int>(0.5 * Height - y / 0.05));
  };
  // The shadow of x in [0.15, 0.65], moved by -0.8.
  EXPECT_EQ(shadow(0, -0.4, 0.), 1.);
  EXPECT_EQ(shadow(0, -0.4, 0.3), 0.);
  EXPECT_EQ(shadow(0, -0.7, 0.), 0.);
  EXPECT_EQ(shadow(0, 0.9, 0.), 0.);
  // Without `shadow`, other nodes do not count.
  EXPECT_EQ(shadow(1, -0.4, 0.), 0.);
  // The small plane lies behind the point light, and faces away from it.
  EXPECT_EQ(shadow(2, -0.4, 0.), 0.);
  EXPECT_EQ(shadow(2, 0.4, 0.), 1.);
  // From behind: attached shadow everywhere.
  EXPECT_EQ(shadow(3, -0.4, 0.), 1.);
  EXPECT_EQ(shadow(3, 0.9, 0.), 1.);
}

TEST(ReferenceScenes, AStepThrowsItsShadow)
{
  // 0.25 deep right of the middle; light from the left at 45 degrees: a shadow 0.25 long.
  const auto result = Trace(R"("lights": [{"type": "directional", "direction": [1, 0, -1]}], )" +
    Shape(R"("plane", "size": [2, 2])", R"({"technique": "relief", "scale": 0.25, "wrap": "clamp",
        "height_map": {"pattern": "step", "size": [128, 4]}})"));
  for (int column = 12; column < 52; ++column)
  {
    const double x = 0.05 * (column + 0.5 - 0.5 * Width);
    EXPECT_EQ(ValueAt(result.AOVs, "shadow.0", column, 24), x > 0. && x < 0.25 ? 1. : 0.)
      << "x = " << x;
  }
}

TEST(ReferenceScenes, DoNotDependOnTheNumberOfThreads)
{
  const MesoReference reference(
    SceneOf(R"("camera": {"position": [0, 3, 4]}, )" + Shape(R"("torus")", Bricks)));
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  vtkSMPTools::Initialize(1);
  const auto one = reference.Render(100, 80, 2);
  vtkSMPTools::Initialize(2);
  const auto two = reference.Render(100, 80, 2);
  vtkSMPTools::Initialize(threads);
  ASSERT_GT(Covered(one), 1000);
  EXPECT_EQ(one.AOVs.Data, two.AOVs.Data);
  const auto* a = static_cast<unsigned char*>(one.Picture->GetScalarPointer());
  const auto* b = static_cast<unsigned char*>(two.Picture->GetScalarPointer());
  EXPECT_TRUE(std::equal(a, a + 3 * 100 * 80, b));
  EXPECT_EQ(one.Counters.Rays, two.Counters.Rays);
}

TEST(ReferenceScenes, TellProgressAndHearAnAbort)
{
  const MesoReference reference(SceneOf(FromFront + Shape(R"("plane")", Bricks)));
  std::vector<double> told;
  const auto all = reference.Render(200, 200, 1,
    [&](double part)
    {
      told.push_back(part);
      return true;
    });
  EXPECT_NE(all.Picture, nullptr);
  EXPECT_GT(told.size(), 2u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.);
  const auto aborted = reference.Render(200, 200, 1, [](double part) { return part < 0.3; });
  EXPECT_EQ(aborted.Picture, nullptr);
  EXPECT_LT(aborted.Counters.Rays, all.Counters.Rays);
}

TEST(ReferenceScenes, CameraInsideTheShellAndClippingRange)
{
  // The camera between base and floor: the floor is seen, the base is behind.
  const char* const deep = R"({"technique": "relief", "scale": 0.5,
    "height_map": {"pattern": "step", "position": 0, "low": 0}})";
  const std::string plane = Shape(R"("plane", "size": [4, 4])", deep);
  const auto inside = Trace(plane, MesoReference::Surface::Mesh,
    R"("camera": {"position": [0, 0, -0.25], "focal_point": [0, 0, -1]}, )");
  EXPECT_EQ(Covered(inside), Width * Height);
  EXPECT_NEAR(ValueAt(inside.AOVs, "depth", 32, 24), 0.25, 1e-6);
  EXPECT_EQ(Covered(inside, "base"), 0);
  const auto clipped = Trace(plane, MesoReference::Surface::Mesh,
    R"("camera": {"position": [0, 0, 5], "clipping_range": [1, 5.4]}, )");
  EXPECT_EQ(Covered(clipped), 0);
}
