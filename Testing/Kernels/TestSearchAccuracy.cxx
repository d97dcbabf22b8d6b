// The search against 8192 steps in double precision, written apart from the kernels: 60 degrees off
// the normal, relief 0.1 tile deep, 256 x 256 texels.

#include "KernelTypes.h"
#include "MesoPattern.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int Size = 256;
constexpr int Rays = 2000;

struct Ray
{
  glm::dvec2 Entry;
  glm::dvec2 Slope;
};

// Rays whose numbers are floats, so that both copies search along the same ones.
std::vector<Ray> MakeRays(unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> any(0., 1.);
  const double pi = std::acos(-1.);
  const double run = 0.1 * std::tan(pi / 3.);
  std::vector<Ray> rays;
  for (int i = 0; i < Rays; ++i)
  {
    const double azimuth = 2. * pi * any(generator);
    rays.push_back({ { float(any(generator)), float(any(generator)) },
      { float(run * std::cos(azimuth)), float(run * std::sin(azimuth)) } });
  }
  return rays;
}

std::vector<float> SumOfCosines(unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> any(0., 1.);
  const double pi = std::acos(-1.);
  std::vector<glm::dvec3> waves(6); // whole periods along u and v, and the phase
  for (glm::dvec3& wave : waves)
  {
    wave = { double(generator() % 9u) - 4., double(generator() % 9u) - 4., any(generator) };
  }
  return MakeHeights(Size, Size,
    [&](int column, int row)
    {
      double height = 0.5;
      for (const glm::dvec3& wave : waves)
      {
        const double turns = wave.x * (column + 0.5) / Size + wave.y * (row + 0.5) / Size + wave.z;
        height += 0.5 / double(waves.size()) * std::cos(2. * pi * turns);
      }
      return height;
    });
}

double TrueDepth(const std::vector<float>& heights, const glm::dvec2& uv)
{
  const double x = (uv.x - std::floor(uv.x)) * Size - 0.5;
  const double y = (uv.y - std::floor(uv.y)) * Size - 0.5;
  const double left = std::floor(x);
  const double low = std::floor(y);
  const auto height = [&](double column, double row)
  {
    const std::size_t wrappedRow = std::size_t(int(row) + Size) % Size;
    const std::size_t wrappedColumn = std::size_t(int(column) + Size) % Size;
    return double(heights[wrappedRow * Size + wrappedColumn]);
  };
  const double right = x - left;
  const double up = y - low;
  return 1. - (1. - up) * ((1. - right) * height(left, low) + right * height(left + 1., low)) -
    up * ((1. - right) * height(left, low + 1.) + right * height(left + 1., low + 1.));
}

// Ray depth of the first crossing.
double MarchFinely(const std::vector<float>& heights, const Ray& ray)
{
  const int steps = 8192;
  const auto clearance = [&](double s)
  { return TrueDepth(heights, ray.Entry + s * ray.Slope) - s; };
  if (clearance(0.) <= 0.)
  {
    return 0.;
  }
  for (int i = 1; i <= steps; ++i)
  {
    double inside = double(i) / steps;
    if (clearance(inside) <= 0.)
    {
      double outside = double(i - 1) / steps;
      for (int halving = 0; halving < 40; ++halving)
      {
        const double middle = 0.5 * (outside + inside);
        (clearance(middle) <= 0. ? inside : outside) = middle;
      }
      return inside;
    }
  }
  return 1.;
}

std::vector<double> MarchFinely(const std::vector<float>& heights, const std::vector<Ray>& rays)
{
  std::vector<double> depths(rays.size());
  std::transform(rays.begin(), rays.end(), depths.begin(),
    [&](const Ray& ray) { return MarchFinely(heights, ray); });
  return depths;
}

double Quantile(std::vector<double> values, double part)
{
  std::sort(values.begin(), values.end());
  return values[std::size_t(part * double(values.size() - 1))];
}

template <typename Field>
std::vector<double> SearchedDepths(
  Field field, const std::vector<Ray>& rays, int linear, int binary, int weightBits)
{
  using Vec2 = decltype(field.patchGradient({}));
  field.SetWeightBits(weightBits);
  std::vector<double> depths;
  for (const Ray& ray : rays)
  {
    const auto hit = field.searchLinearBinary(
      field.straightPath(Vec2(ray.Entry), Vec2(ray.Slope), 0, 1), linear, binary);
    EXPECT_TRUE(hit.Hit);
    depths.push_back(double(hit.RayDepth));
  }
  return depths;
}

// Along the surface, in texels.
std::vector<double> Errors(
  const std::vector<double>& depths, const std::vector<double>& truth, const std::vector<Ray>& rays)
{
  std::vector<double> errors;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    errors.push_back(std::abs(depths[i] - truth[i]) * glm::length(rays[i].Slope) * Size);
  }
  return errors;
}

void ExpectAccurate(const std::vector<float>& heights, unsigned seed, const std::string& name)
{
  const std::vector<Ray> rays = MakeRays(seed);
  const std::vector<double> truth = MarchFinely(heights, rays);
  const MesoKernels::Float::HeightField floats(Size, Size, MesoWrap::Repeat, heights);
  const MesoKernels::Double::HeightField doubles(Size, Size, MesoWrap::Repeat, heights);
  const std::vector<double> inFloat = SearchedDepths(floats, rays, 128, 8, 8);
  const std::vector<double> inDouble = SearchedDepths(doubles, rays, 128, 8, 0);
  const std::vector<double> floatErrors = Errors(inFloat, truth, rays);
  const std::vector<double> doubleErrors = Errors(inDouble, truth, rays);
  EXPECT_LT(Quantile(floatErrors, 0.99), 0.1) << name;
  EXPECT_LT(Quantile(doubleErrors, 0.99), 0.1) << name;
  // Both copies on the same sampler: the same crossing but for rays that graze a crest, and there
  // the same point to the ulp of a map coordinate below 2 (1.2e-7, times 256 texels) over the
  // angle.
  const std::vector<double> exact = SearchedDepths(floats, rays, 128, 8, 0);
  EXPECT_LT(Quantile(Errors(exact, inDouble, rays), 0.99), 1e-3) << name;
  for (double part : { 0.5, 0.99, 1. })
  {
    ::testing::Test::RecordProperty(
      name + "_float_texels_" + std::to_string(part), std::to_string(Quantile(floatErrors, part)));
  }
}
}

TEST(SearchAccuracy, SmoothMaps)
{
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    ExpectAccurate(SumOfCosines(seed), seed, "smooth" + std::to_string(seed));
  }
}

TEST(SearchAccuracy, BrickMap)
{
  ExpectAccurate(MesoMakePattern("brick", { Size, Size }, 1, {}), 4, "brick");
}

TEST(SearchAccuracy, GrowsWithQuality)
{
  const std::vector<float> heights = SumOfCosines(5);
  const std::vector<Ray> rays = MakeRays(5);
  const std::vector<double> truth = MarchFinely(heights, rays);
  const MesoKernels::Float::HeightField field(Size, Size, MesoWrap::Repeat, heights);
  double previous = Infinite;
  const int qualities[][2] = { { 16, 5 }, { 32, 6 }, { 64, 7 }, { 128, 8 } };
  for (const auto& [linear, binary] : qualities)
  {
    const double error =
      Quantile(Errors(SearchedDepths(field, rays, linear, binary, 8), truth, rays), 0.99);
    EXPECT_LE(error, 1.01 * previous) << linear << " + " << binary;
    previous = error;
  }
}
