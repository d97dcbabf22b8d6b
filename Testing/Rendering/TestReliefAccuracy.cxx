// The hits of `relief` at quality high against 8192 steps in double precision, on a plane at 60
// degrees off the normal, D a tenth of a tile: 99 of 100 pixels within a tenth of a texel on maps
// whose detail is wider than a step. (The noise map's figure is reported, not bounded.)

#include "MesoTiltedPlane.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace
{
constexpr int Texels = 256;
constexpr int Pixels = 100;

/// Bilinear depth, written apart from the kernels.
double DepthAt(const float* heights, double u, double v)
{
  const double x = u * Texels - 0.5;
  const double y = v * Texels - 0.5;
  const double i = std::floor(x);
  const double j = std::floor(y);
  const auto texel = [&](double column, double row)
  {
    const int c = ((static_cast<int>(column) % Texels) + Texels) % Texels;
    const int r = ((static_cast<int>(row) % Texels) + Texels) % Texels;
    return 1. - static_cast<double>(heights[r * Texels + c]);
  };
  const double a = x - i;
  const double b = y - j;
  return (1. - b) * ((1. - a) * texel(i, j) + a * texel(i + 1, j)) +
    b * ((1. - a) * texel(i, j + 1) + a * texel(i + 1, j + 1));
}

/// Depth at which the ray first goes below the relief.
double MarchedDepth(const float* heights, double u, double v, double travel)
{
  constexpr int Steps = 8192;
  double above = 0.;
  for (int step = 0; step <= Steps; ++step)
  {
    double s = static_cast<double>(step) / Steps;
    if (DepthAt(heights, u + s * travel, v) <= s)
    {
      for (int i = 0; i < 50 && step > 0; ++i)
      {
        const double middle = 0.5 * (above + s);
        (DepthAt(heights, u + middle * travel, v) <= middle ? s : above) = middle;
      }
      return s;
    }
    above = s;
  }
  return 1.;
}

/// Distances between hit and truth in texels, sorted.
std::vector<double> Errors(const std::string& pattern)
{
  const auto heights = MesoTestScene::Pattern(pattern, Texels, Texels);
  MesoTiltedPlane plane(60., 0.1, heights, Pixels);
  plane.Capture();
  const auto* values = static_cast<const float*>(heights->GetScalarPointer());
  std::vector<double> errors;
  for (int row = 0; row < Pixels; ++row)
  {
    for (int column = 0; column < Pixels; ++column)
    {
      const double u = plane.EntryU(column);
      if (u <= 0. || u >= 1.)
      {
        continue;
      }
      const double s = MarchedDepth(values, u, plane.EntryV(row), plane.TravelU());
      const double hit = plane.Pass->GetValue("texcoord.u", column, row);
      errors.push_back(std::abs(hit - (u + s * plane.TravelU())) * Texels);
    }
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

double Percentile(const std::vector<double>& sorted, double part)
{
  return sorted[static_cast<std::size_t>(part * (sorted.size() - 1))];
}

void Report(const std::string& pattern, const std::vector<double>& errors)
{
  std::cout << pattern << ": texels p50 " << Percentile(errors, 0.5) << " p95 "
            << Percentile(errors, 0.95) << " p99 " << Percentile(errors, 0.99) << " max "
            << errors.back() << " over " << errors.size() << " pixels\n";
}
}

TEST(ReliefAccuracy, Smooth)
{
  const auto errors = Errors("smooth");
  Report("smooth", errors);
  ASSERT_GT(errors.size(), 5000u);
  EXPECT_LT(Percentile(errors, 0.99), 0.1);
}

TEST(ReliefAccuracy, Brick)
{
  const auto errors = Errors("brick");
  Report("brick", errors);
  ASSERT_GT(errors.size(), 5000u);
  EXPECT_LT(Percentile(errors, 0.99), 0.1);
}

TEST(ReliefAccuracy, NoiseIsReported)
{
  const auto errors = Errors("noise");
  Report("noise", errors);
  EXPECT_LT(Percentile(errors, 0.5), 0.1);
}
