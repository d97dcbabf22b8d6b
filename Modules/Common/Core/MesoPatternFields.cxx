#include "MesoPatternFields.h"

#include <algorithm>
#include <cmath>
#include <complex>

namespace
{
constexpr double Pi = 3.141592653589793238462643;

std::uint64_t Mix(std::uint64_t x)
{
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

std::uint64_t Hash(std::uint32_t seed, int a, int b, int c)
{
  std::uint64_t h = Mix(seed);
  h = Mix(h ^ static_cast<std::uint32_t>(a));
  h = Mix(h ^ static_cast<std::uint32_t>(b));
  return Mix(h ^ static_cast<std::uint32_t>(c));
}

double Fade(double x)
{
  return x * x * x * (x * (x * 6. - 15.) + 10.);
}

double Mixed(double a, double b, double t)
{
  return a + (b - a) * t;
}

// Dot product of an offset with one of 16 unit gradients, a sixteenth of a turn apart, the first
// half a step off the axes so that lattice lines do not show.
double GradientDot(std::uint64_t hash, double dx, double dy)
{
  constexpr double c0 = 0.98078528040323044; // cos(pi/16)
  constexpr double s0 = 0.19509032201612827;
  constexpr double c1 = 0.83146961230254524; // cos(3 pi/16)
  constexpr double s1 = 0.55557023301960222;
  double x = (hash & 1) ? c0 : c1;
  double y = (hash & 1) ? s0 : s1;
  if (hash & 2)
  {
    std::swap(x, y);
  }
  return ((hash & 4) ? x : -x) * dx + ((hash & 8) ? y : -y) * dy;
}

int Wrapped(int i, int period)
{
  const int rest = i % period;
  return rest < 0 ? rest + period : rest;
}

class SmoothField : public MesoPattern::Field
{
public:
  SmoothField(std::uint32_t seed, int frequency, double falloff)
    : Frequency(frequency)
  {
    // One of each pair (m, n), (-m, -n), which are the same wave.
    double bend = 0.; // bound of the second derivative in any direction
    for (int m = 0; m <= frequency; ++m)
    {
      for (int n = -frequency; n <= frequency; ++n)
      {
        const int square = m * m + n * n;
        if (square == 0 || square > frequency * frequency || (m == 0 && n < 0))
        {
          continue;
        }
        const double amplitude = std::pow(square, -0.5 * falloff);
        const double phase = 2. * Pi * MesoSeededRandom(seed, m, n);
        this->Waves.push_back({ m, n, std::polar(amplitude, phase) });
        bend += amplitude * 4. * Pi * Pi * square;
      }
    }
    // At an extreme the slope is 0, and the nearest lattice point is at most half a cell's
    // diagonal away.
    constexpr int lattice = 256;
    const double margin = 0.5 * bend * 0.5 / (lattice * lattice);
    const auto range = MesoRangeOfField(*this, lattice);
    this->Low = range[0] - margin;
    this->Factor = 1. / (range[1] - range[0] + 2. * margin);
  }

  double At(double s, double t) const override
  {
    std::array<std::complex<double>, 9> alongS;
    std::array<std::complex<double>, 9> alongT;
    const auto powers = [this](double x, auto& row)
    {
      const auto base = std::polar(1., 2. * Pi * x);
      row[0] = 1.;
      for (int k = 1; k <= this->Frequency; ++k)
      {
        row[k] = Times(row[k - 1], base);
      }
    };
    powers(s, alongS);
    powers(t, alongT);
    double sum = 0.;
    for (const auto& wave : this->Waves)
    {
      const auto tFactor = wave.N < 0 ? std::conj(alongT[-wave.N]) : alongT[wave.N];
      const auto product = Times(wave.Factor, alongS[wave.M]);
      sum += product.real() * tFactor.real() - product.imag() * tFactor.imag();
    }
    return (sum - this->Low) * this->Factor;
  }

private:
  struct Wave
  {
    int M;
    int N;
    std::complex<double> Factor;
  };

  // std::complex's own product also repairs infinities, which takes most of its time.
  static std::complex<double> Times(std::complex<double> a, std::complex<double> b)
  {
    return { a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real() };
  }

  int Frequency;
  std::vector<Wave> Waves;
  double Low = 0.;
  double Factor = 1.;
};

class NoiseField : public MesoPattern::Field
{
public:
  NoiseField(std::uint32_t seed, int frequency, int octaves, double gain)
    : Seed(seed)
    , Frequency(frequency)
    , Octaves(octaves)
    , Gain(gain)
  {
    const auto range = MesoRangeOfField(*this, 256);
    this->Low = range[0];
    this->Factor = range[1] > range[0] ? 1. / (range[1] - range[0]) : 1.;
  }

  double At(double s, double t) const override
  {
    double sum = 0.;
    double amplitude = 1.;
    int cells = this->Frequency;
    for (int k = 0; k < this->Octaves; ++k)
    {
      sum += amplitude * MesoGradientNoise(s * cells, t * cells, { cells, cells }, this->Seed, k);
      amplitude *= this->Gain;
      cells *= 2;
    }
    return (sum - this->Low) * this->Factor;
  }

private:
  std::uint32_t Seed;
  int Frequency;
  int Octaves;
  double Gain;
  double Low = 0.;
  double Factor = 1.;
};

class StepField : public MesoPattern::Field
{
public:
  StepField(double position, double low)
    : Position(position)
    , Low(low)
  {
  }

  double At(double s, double) const override { return s < this->Position ? 1. : this->Low; }

private:
  double Position;
  double Low;
};
}

std::array<double, 2> MesoRangeOfField(const MesoPattern::Field& field, int n)
{
  std::array<double, 2> range = { field.At(0., 0.), field.At(0., 0.) };
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const double value = field.At((i + 0.5) / n, (j + 0.5) / n);
      range = { std::min(range[0], value), std::max(range[1], value) };
    }
  }
  return range;
}

double MesoSeededRandom(std::uint32_t seed, int a, int b, int c)
{
  return static_cast<double>(Hash(seed, a, b, c) >> 11) * 0x1p-53;
}

double MesoGradientNoise(double x, double y, std::array<int, 2> period, std::uint32_t seed, int key)
{
  const double floorX = std::floor(x);
  const double floorY = std::floor(y);
  const double dx = x - floorX;
  const double dy = y - floorY;
  const int i0 = Wrapped(static_cast<int>(floorX), period[0]);
  const int j0 = Wrapped(static_cast<int>(floorY), period[1]);
  const int i1 = i0 + 1 == period[0] ? 0 : i0 + 1;
  const int j1 = j0 + 1 == period[1] ? 0 : j0 + 1;
  const double u = Fade(dx);
  const double v = Fade(dy);
  const double bottom = Mixed(GradientDot(Hash(seed, key, i0, j0), dx, dy),
    GradientDot(Hash(seed, key, i1, j0), dx - 1., dy), u);
  const double top = Mixed(GradientDot(Hash(seed, key, i0, j1), dx, dy - 1.),
    GradientDot(Hash(seed, key, i1, j1), dx - 1., dy - 1.), u);
  return 1.4142135623730951 * Mixed(bottom, top, v);
}

MesoFieldPointer MesoMakeSmoothField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<SmoothField>(
    seed, static_cast<int>(values.at("frequency")), values.at("falloff"));
}

MesoFieldPointer MesoMakeNoiseField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<NoiseField>(seed, static_cast<int>(values.at("frequency")),
    static_cast<int>(values.at("octaves")), values.at("gain"));
}

MesoFieldPointer MesoMakeStepField(const MesoPatternValues& values)
{
  return std::make_shared<StepField>(values.at("position"), values.at("low"));
}
