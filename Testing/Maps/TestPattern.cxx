// The functions of MesoPattern: they tile, stay in [0,1], repeat byte for byte, and do not depend on
// the size of the map.

#include "MesoPattern.h"

#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace
{
double Range(const std::vector<float>& heights)
{
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  EXPECT_GE(*low, 0.f);
  EXPECT_LE(*high, 1.f);
  return *high - *low;
}

double RootMeanSquare(double sum, std::size_t count)
{
  return std::sqrt(sum / static_cast<double>(count));
}

// FNV-1a over heights rounded to 16 bits, so that the last bit of a machine's cosine is no matter.
std::uint64_t HashOf(const std::vector<float>& heights)
{
  std::uint64_t hash = 14695981039346656037u;
  for (float height : heights)
  {
    hash = (hash ^ static_cast<std::uint64_t>(std::lround(65535. * height))) * 1099511628211u;
  }
  return hash;
}
}

TEST(Pattern, HeightsFillMostOfTheUnitInterval)
{
  for (const std::string& name : MesoPatternNames())
  {
    for (std::uint32_t seed : { 0u, 1u, 7u, 4294967295u })
    {
      SCOPED_TRACE(name + " " + std::to_string(seed));
      EXPECT_GT(Range(MesoMakePattern(name, { 128, 96 }, seed)), 0.8);
    }
  }
  // Extreme values of the keys.
  const std::vector<std::pair<std::string, MesoPatternValues>> extremes = {
    { "brick", { { "variation", 1. }, { "roughness", 1. }, { "mortar", 0.8 }, { "bevel", 0.5 } } },
    { "brick", { { "mortar", 0. }, { "roughness", 0. }, { "variation", 0. }, { "bevel", 0.3 } } },
    { "brick", { { "rows", 1. }, { "columns", 1. }, { "offset", 0. } } },
    { "brick", { { "rows", 16. }, { "columns", 16. } } },
    { "smooth", { { "frequency", 8. }, { "falloff", 0. } } },
    { "smooth", { { "frequency", 1. }, { "falloff", 4. } } },
    { "noise", { { "frequency", 1. }, { "octaves", 1. }, { "gain", 0. } } },
    { "noise", { { "frequency", 32. }, { "octaves", 10. }, { "gain", 1. } } },
  };
  for (const auto& [name, values] : extremes)
  {
    SCOPED_TRACE(name);
    EXPECT_GT(Range(MesoMakePattern(name, { 64, 64 }, 3, values)), 0.2);
  }
}

TEST(Pattern, TilesExactly)
{
  for (const std::string name : { "brick", "smooth", "noise" })
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      SCOPED_TRACE(name + " " + std::to_string(axis));
      const int n = 128;
      const auto heights = MesoMakePattern(name, { n, n }, 5);
      // Differences of neighbours across each line between texels: line 0 is the tile's edge.
      std::vector<double> lines(n, 0.);
      for (int line = 0; line < n; ++line)
      {
        for (int k = 0; k < n; ++k)
        {
          const int before = (line + n - 1) % n;
          const double step = axis == 0 ? heights[k * n + line] - heights[k * n + before]
                                        : heights[line * n + k] - heights[before * n + k];
          lines[line] += step * step;
        }
      }
      const double edge = RootMeanSquare(lines[0], n);
      const double most = RootMeanSquare(*std::max_element(lines.begin() + 1, lines.end()), n);
      EXPECT_LE(edge, most);
      EXPECT_GT(edge, 0.);
    }
  }
}

TEST(Pattern, IsPeriodic)
{
  for (const std::string& name : MesoPatternNames())
  {
    const MesoPattern pattern(name, 2);
    for (double s = 0.01; s < 1.; s += 0.07)
    {
      for (double t = 0.02; t < 1.; t += 0.09)
      {
        // 1e-9: s + 3 rounds s by 4e-16, times the steepest slope.
        EXPECT_NEAR(pattern.At(s + 3., t - 2.), pattern.At(s, t), 1e-9) << name;
      }
    }
    // Continuous across the edge, but for the step that is one.
    const double jump = std::abs(pattern.At(1e-9, 0.3) - pattern.At(1. - 1e-9, 0.3));
    if (name == "step")
    {
      EXPECT_EQ(jump, 1.);
    }
    else
    {
      EXPECT_LT(jump, 1e-5) << name;
    }
    EXPECT_LT(std::abs(pattern.At(0.3, 1e-9) - pattern.At(0.3, 1. - 1e-9)), 1e-5) << name;
  }
}

TEST(Pattern, SameBytesForAnyNumberOfThreads)
{
  for (const std::string& name : MesoPatternNames())
  {
    vtkSMPTools::SetBackend("Sequential");
    const auto one = MesoMakePattern(name, { 200, 77 }, 9);
    vtkSMPTools::SetBackend("STDThread");
    vtkSMPTools::Initialize(4);
    const auto four = MesoMakePattern(name, { 200, 77 }, 9);
    EXPECT_EQ(std::memcmp(one.data(), four.data(), one.size() * sizeof(float)), 0) << name;
    if (name != "step")
    {
      EXPECT_NE(HashOf(one), HashOf(MesoMakePattern(name, { 200, 77 }, 10))) << name;
    }
  }
}

TEST(Pattern, RecordedHashes)
{
  // Scenes name patterns by seed: another hash means that every such picture has changed.
  EXPECT_EQ(HashOf(MesoMakePattern("brick", { 64, 64 }, 1)), 6907397425413396881u);
  EXPECT_EQ(HashOf(MesoMakePattern("smooth", { 64, 64 }, 1)), 1085648954875272096u);
  EXPECT_EQ(HashOf(MesoMakePattern("noise", { 64, 64 }, 1)), 3514454775351185311u);
}

TEST(Pattern, SizesShowTheSameSurface)
{
  for (const std::string name : { "brick", "smooth", "noise" })
  {
    const auto small = MesoMakePattern(name, { 64, 64 }, 1);
    const auto large = MesoMakePattern(name, { 256, 256 }, 1);
    double sum = 0.;
    for (int j = 0; j < 64; ++j)
    {
      for (int i = 0; i < 64; ++i)
      {
        // A small texel's centre is the corner of the middle four of its sixteen large ones.
        const int at = (4 * j + 1) * 256 + 4 * i + 1;
        const double mean = 0.25 * (large[at] + large[at + 1] + large[at + 256] + large[at + 257]);
        const double difference = mean - small[j * 64 + i];
        sum += difference * difference;
      }
    }
    // The mean of four differs from the middle by about a texel squared times the curvature; bevels
    // of the bricks are 3 texels of 256 wide.
    EXPECT_LT(RootMeanSquare(sum, 64 * 64), name == "smooth" ? 1e-4 : 0.02) << name;
  }
}

TEST(Pattern, StepIsComputableByHand)
{
  const auto heights =
    MesoMakePattern("step", { 8, 2 }, 0, { { "position", 0.3 }, { "low", 0.25 } });
  // Centres at 1/16, 3/16 are below 0.3, 5/16 is not.
  for (int j = 0; j < 2; ++j)
  {
    for (int i = 0; i < 8; ++i)
    {
      EXPECT_EQ(heights[j * 8 + i], i < 2 ? 1.f : 0.25f);
    }
  }
  const auto half = MesoMakePattern("step", { 4, 1 });
  EXPECT_EQ(half, (std::vector<float>{ 1.f, 1.f, 0.f, 0.f }));
  EXPECT_EQ(
    MesoMakePattern("step", { 2, 1 }, 0, { { "position", 1. } }), (std::vector<float>{ 1.f, 1.f }));
  EXPECT_EQ(
    MesoMakePattern("step", { 2, 1 }, 0, { { "position", 0. } }), (std::vector<float>{ 0.f, 0.f }));
}

TEST(Pattern, BricksAreHigherThanTheirJoints)
{
  const MesoPattern brick("brick", 1);
  // 8 rows of 3: row 0 has its joints at thirds, row 1 half a brick on.
  for (int row = 0; row < 8; ++row)
  {
    const double t = (row + 0.5) / 8.;
    for (int column = 0; column < 3; ++column)
    {
      const double joint = (column + (row % 2 ? 0.5 : 0.)) / 3.;
      EXPECT_LT(brick.At(joint, t), 0.2);
      EXPECT_GT(brick.At(joint + 0.5 / 3., t), 0.5);
      EXPECT_LT(brick.At(joint + 0.25 / 3., row / 8.), 0.2);
    }
  }
}

TEST(Pattern, RefusalsNameWhatIsWrong)
{
  struct Refusal
  {
    std::string Pattern;
    MesoPatternValues Values;
    std::string Message;
  };
  const std::vector<Refusal> refusals = {
    { "brig", {}, "unknown pattern 'brig' (known: 'brick', 'smooth', 'noise', 'step')" },
    { "brick", { { "row", 4. } }, "unknown key 'row'" },
    { "brick", { { "rows", 7. } }, "'rows' must be even" },
    { "brick", { { "rows", 2. }, { "columns", 4. }, { "mortar", 0.5 } },
      "'mortar' leaves no width" },
    { "smooth", { { "frequency", 2.5 } }, "'frequency' is 2.5, allowed are whole numbers" },
    { "noise", { { "frequency", 1024. }, { "octaves", 10. } }, "above 16384" },
    { "noise", { { "gain", std::numeric_limits<double>::quiet_NaN() } }, "'gain' is nan" },
    { "step", { { "position", -0.1 } }, "'position' is -0.1, allowed are 0 to 1" },
  };
  for (const Refusal& refusal : refusals)
  {
    const std::string problem = MesoPatternProblem(refusal.Pattern, refusal.Values);
    EXPECT_NE(problem.find(refusal.Message), std::string::npos) << problem;
    EXPECT_THROW(
      MesoMakePattern(refusal.Pattern, { 4, 4 }, 0, refusal.Values), std::invalid_argument);
  }
  EXPECT_THROW(MesoMakePattern("step", { 0, 4 }), std::invalid_argument);
  EXPECT_THROW(MesoMakePattern("step", { 4, MesoPatternMaximumSize + 1 }), std::invalid_argument);
  EXPECT_EQ(MesoPatternProblem("brick", { { "rows", 7. }, { "offset", 0. } }), "");
}
