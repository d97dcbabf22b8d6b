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
    { "weave", { { "threads", 2. }, { "width", 0.1 }, { "strands", 1. }, { "variation", 1. } } },
    { "weave", { { "threads", 16. }, { "width", 0.95 }, { "strands", 0. } } },
    { "stone", { { "cells", 1. }, { "jitter", 1. }, { "roughness", 1. }, { "variation", 1. } } },
    { "stone", { { "cells", 16. }, { "jitter", 0. }, { "joint", 0.5 }, { "bevel", 0.01 } } },
    { "spikes", { { "count", 1. }, { "power", 8. }, { "variation", 1. } } },
    { "spikes", { { "count", 4. }, { "radius", 0.05 }, { "power", 0.125 } } },
    { "checkerboard", { { "squares", 64. }, { "low", 0.5 } } },
    { "pits", { { "count", 4. }, { "radius", 0.5 }, { "variation", 1. } } },
    { "terrain", { { "frequency", 1. }, { "octaves", 1. }, { "ridges", 1. }, { "warp", 1. } } },
    { "terrain", { { "octaves", 12. }, { "gain", 1. }, { "ridges", 0. }, { "warp", 0. } } },
    { "waves", { { "waves", 1. }, { "frequency", 1. }, { "steepness", 1. }, { "time", 1e6 } } },
    { "waves", { { "waves", 64. }, { "frequency", 64. }, { "spread", 180. } } },
  };
  for (const auto& [name, values] : extremes)
  {
    SCOPED_TRACE(name);
    EXPECT_GT(Range(MesoMakePattern(name, { 64, 64 }, 3, values)), 0.2);
  }
}

TEST(Pattern, TilesExactly)
{
  for (const std::string name : { "brick", "smooth", "noise", "weave", "stone", "spikes",
         "checkerboard", "pits", "terrain", "waves" })
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
      // At a tile's edge are the edges of spikes' and pits' cells, which mirror each other.
      EXPECT_TRUE(edge > 0. || name == "spikes" || name == "pits");
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
    // Continuous across the edge, but for steps that are ones.
    const double across = std::abs(pattern.At(1e-9, 0.3) - pattern.At(1. - 1e-9, 0.3));
    const double along = std::abs(pattern.At(0.3, 1e-9) - pattern.At(0.3, 1. - 1e-9));
    EXPECT_NEAR(across, name == "step" || name == "checkerboard" ? 1. : 0., 1e-5) << name;
    EXPECT_NEAR(along, name == "checkerboard" ? 1. : 0., 1e-5) << name;
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
    // Spikes are all alike unless they are told to vary.
    if (name != "step" && name != "checkerboard" && name != "spikes")
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
  EXPECT_EQ(HashOf(MesoMakePattern("weave", { 64, 64 }, 1)), 1141018382608116261u);
  EXPECT_EQ(HashOf(MesoMakePattern("stone", { 64, 64 }, 1)), 14606459475992686723u);
  EXPECT_EQ(HashOf(MesoMakePattern("spikes", { 64, 64 }, 1)), 13067103256991734309u);
  EXPECT_EQ(HashOf(MesoMakePattern("pits", { 64, 64 }, 1)), 10040086022884643954u);
  EXPECT_EQ(HashOf(MesoMakePattern("terrain", { 64, 64 }, 1)), 12671050744764756691u);
  EXPECT_EQ(HashOf(MesoMakePattern("waves", { 64, 64 }, 1)), 14328361657284974994u);
}

TEST(Pattern, SizesShowTheSameSurface)
{
  for (const std::string name : { "brick", "smooth", "noise", "stone", "waves" })
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

TEST(Pattern, ThreadsGoOverAndUnder)
{
  const MesoPattern weave("weave", 1, { { "strands", 0. }, { "variation", 0. } });
  for (int j = 0; j < 8; ++j)
  {
    for (int i = 0; i < 8; ++i)
    {
      // At a crossing one thread is on top; a quarter of the way on, along each, the higher falls.
      const double s = (i + 0.5) / 8.;
      const double t = (j + 0.5) / 8.;
      EXPECT_NEAR(weave.At(s, t), 1., 1e-12);
      // Along t over even sums, along s over odd ones: only the other thread's edge shows a fall.
      const double edge = 0.4 / 8.;
      const double acrossS = weave.At(s + edge, t);
      const double acrossT = weave.At(s, t + edge);
      EXPECT_EQ(acrossS < acrossT, (i + j) % 2 == 0) << i << " " << j;
      EXPECT_EQ(weave.At(i / 8., j / 8.), 0.); // between four threads is the ground
    }
  }
}

TEST(Pattern, StonesAreHigherThanTheirJoints)
{
  // Without jitter cells are squares: the border is where sites are equally far.
  const MesoPattern stone(
    "stone", 1, { { "jitter", 0. }, { "roughness", 0. }, { "variation", 0. } });
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_NEAR(stone.At(i / 6., 0.25), 0.08, 1e-12);
    EXPECT_NEAR(stone.At((i + 0.5) / 6., 0.25), 1., 1e-12);
    // A parabola over the bevel of 0.25 beyond half a joint, 0.04; the other borders round it a little.
    EXPECT_NEAR(stone.At((i + 0.04 + 0.125) / 6., 0.25), 0.08 + 0.92 * 0.75, 0.01);
  }
  // With it, borders are straight lines between cells: the height falls to the joint's on any way
  // from one stone's middle to another's.
  const MesoPattern cobbles("stone", 3, { { "roughness", 0. } });
  double least = 1.;
  for (double s = 0.; s < 1.; s += 0.001)
  {
    least = std::min(least, cobbles.At(s, 0.37));
  }
  EXPECT_NEAR(least, 0.08, 1e-12);
}

TEST(Pattern, SpikesPitsAndSquaresAreComputableByHand)
{
  const MesoPattern spikes("spikes", 1, { { "count", 4. }, { "power", 2. } });
  EXPECT_NEAR(spikes.At(0.375, 0.125), 1., 1e-12);
  EXPECT_NEAR(spikes.At(0.375 + 0.05, 0.125), 0.25, 1e-12); // half of 0.4 cells of 1/4
  EXPECT_EQ(spikes.At(0.375 + 0.101, 0.125), 0.);
  const MesoPattern pits("pits", 1, { { "count", 4. }, { "variation", 0. } });
  EXPECT_NEAR(pits.At(0.375, 0.125), 0., 1e-12);
  EXPECT_NEAR(pits.At(0.375 + 0.06, 0.125), 0.2, 1e-12); // 1 - sqrt(1 - 0.6^2)
  EXPECT_EQ(pits.At(0.25, 0.125), 1.);
  const auto squares =
    MesoMakePattern("checkerboard", { 4, 4 }, 0, { { "squares", 4. }, { "low", 0.25 } });
  for (int k = 0; k < 16; ++k)
  {
    EXPECT_EQ(squares[k], (k / 4 + k) % 2 == 0 ? 1.f : 0.25f) << k;
  }
}

TEST(Pattern, RidgesHaveCrestsAndHillsDoNot)
{
  // At a crest the slope jumps: second differences along lines, the largest beside their typical size.
  const auto sharpness = [](double ridges)
  {
    const auto map = MesoMakePattern(
      "terrain", { 512, 512 }, 2, { { "ridges", ridges }, { "octaves", 1. }, { "warp", 0. } });
    double largest = 0.;
    double sum = 0.;
    for (std::size_t k = 1; k + 1 < map.size(); ++k)
    {
      if (k % 512 > 0 && k % 512 < 511)
      {
        const double bend = -(map[k - 1] - 2. * map[k] + map[k + 1]); // crests only
        largest = std::max(largest, bend);
        sum += std::abs(bend);
      }
    }
    return largest / (sum / static_cast<double>(map.size()));
  };
  EXPECT_GT(sharpness(1.), 5. * sharpness(0.));
}

TEST(Pattern, WavesTravel)
{
  // One wave of one period along s: after a time it stands that much further on.
  const MesoPatternValues one = { { "waves", 1. }, { "direction", 0. }, { "spread", 0. } };
  const auto at = [&](double time)
  {
    auto values = one;
    values["time"] = time;
    return MesoPattern("waves", 4, values);
  };
  for (double time : { 0.1, 0.37, 5.25 })
  {
    for (double s = 0.; s < 1.; s += 0.13)
    {
      EXPECT_NEAR(at(time).At(s, 0.4), at(0.).At(s - time, 0.4), 1e-9);
    }
  }
  // 90 degrees: along t, and not along s.
  const MesoPattern up("waves", 4, { { "waves", 1. }, { "direction", 90. }, { "spread", 0. } });
  EXPECT_NEAR(up.At(0.1, 0.3), up.At(0.8, 0.3), 1e-12);
  EXPECT_GT(std::abs(up.At(0.1, 0.3) - up.At(0.1, 0.6)), 0.05);
  // Many waves: another picture at another time, by a little after a little.
  const auto map = [](double time) {
    return MesoMakePattern("waves", { 64, 64 }, 1, { { "time", time } });
  };
  const auto apart = [](const std::vector<float>& a, const std::vector<float>& b)
  {
    double sum = 0.;
    for (std::size_t k = 0; k < a.size(); ++k)
    {
      sum += (a[k] - b[k]) * (a[k] - b[k]);
    }
    return RootMeanSquare(sum, a.size());
  };
  EXPECT_GT(apart(map(0.), map(0.01)), 1e-3);
  EXPECT_LT(apart(map(0.), map(0.01)), 0.2 * apart(map(0.), map(0.5)));
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
    { "brig", {}, "unknown pattern 'brig' (known: 'brick', 'smooth', 'noise', 'step'," },
    { "brick", { { "row", 4. } }, "unknown key 'row'" },
    { "brick", { { "rows", 7. } }, "'rows' must be even" },
    { "brick", { { "rows", 2. }, { "columns", 4. }, { "mortar", 0.5 } },
      "'mortar' leaves no width" },
    { "smooth", { { "frequency", 2.5 } }, "'frequency' is 2.5, allowed are whole numbers" },
    { "noise", { { "frequency", 1024. }, { "octaves", 10. } }, "above 16384" },
    { "noise", { { "gain", std::numeric_limits<double>::quiet_NaN() } }, "'gain' is nan" },
    { "weave", { { "threads", 7. } }, "'threads' must be even" },
    { "weave", { { "width", 1. } }, "'width' is 1, allowed are 0.1 to 0.95" },
    { "checkerboard", { { "squares", 3. } }, "'squares' must be even" },
    { "terrain", { { "frequency", 256. }, { "octaves", 12. } }, "above 16384" },
    { "waves", { { "time", 2e6 } }, "'time' is 2e+06" },
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
