#include "MesoPatternFields.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Pi = 3.141592653589793238462643;

/**
 * Cells around points that are shifted at random from a square lattice's middles (Worley 1996, "A
 * Cellular Texture Basis Function"). A stone rises from the joint by a parabola of the bevel's width, with
 * the distance to the borders of its cell, which are straight lines.
 */
class StoneField : public MesoPattern::Field
{
public:
  StoneField(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , Cells(static_cast<int>(values.at("cells")))
    , Jitter(values.at("jitter"))
    , Joint(values.at("joint"))
    , Bevel(values.at("bevel"))
    , Variation(values.at("variation"))
    , Roughness(values.at("roughness"))
  {
  }

  double At(double s, double t) const override
  {
    const double x = s * this->Cells;
    const double y = t * this->Cells;
    const int i0 = static_cast<int>(x);
    const int j0 = static_cast<int>(y);
    Site nearest = this->SiteAt(i0, j0, x, y);
    for (int j = j0 - 1; j <= j0 + 1; ++j)
    {
      for (int i = i0 - 1; i <= i0 + 1; ++i)
      {
        const Site site = this->SiteAt(i, j, x, y);
        nearest = site.Square() < nearest.Square() ? site : nearest;
      }
    }
    // Borders lie half way to other sites; those that count are among the next two around.
    // A smooth minimum (the logarithm of a sum of exponentials) rounds the stones' corners; it is at
    // most the minimum, so that the height is the joint's on every border.
    const double sharpness = 4. / this->Bevel;
    double sum = 0.;
    for (int j = nearest.J - 2; j <= nearest.J + 2; ++j)
    {
      for (int i = nearest.I - 2; i <= nearest.I + 2; ++i)
      {
        const Site other = this->SiteAt(i, j, x, y);
        const double dx = other.X - nearest.X;
        const double dy = other.Y - nearest.Y;
        const double apart = std::hypot(dx, dy);
        if (apart > 1e-9)
        {
          const double middle =
            0.5 * ((other.X + nearest.X) * dx + (other.Y + nearest.Y) * dy) / apart;
          sum += std::exp(-sharpness * middle);
        }
      }
    }
    const double border = -std::log(sum) / sharpness;
    const int period = 4 * this->Cells;
    const double grain =
      0.6 * MesoGradientNoise(4. * x, 4. * y, { period, period }, this->Seed, 70) +
      0.4 * MesoGradientNoise(8. * x, 8. * y, { 2 * period, 2 * period }, this->Seed, 71);
    const double ground = 0.08 + 0.08 * this->Roughness * grain;
    const double rise = std::clamp((border - 0.5 * this->Joint) / this->Bevel, 0., 1.);
    const double face = 1. - 0.12 * this->Roughness * (1. + grain) -
      0.35 * this->Variation *
        MesoSeededRandom(this->Seed, 5002, Wrapped(nearest.I), Wrapped(nearest.J));
    return ground + (face - ground) * rise * (2. - rise);
  }

private:
  /// A site, and where it lies seen from a place.
  struct Site
  {
    int I;
    int J;
    double X;
    double Y;
    double Square() const { return this->X * this->X + this->Y * this->Y; }
  };

  int Wrapped(int i) const { return (i + 2 * this->Cells) % this->Cells; }

  Site SiteAt(int i, int j, double x, double y) const
  {
    const auto shift = [&](int what)
    {
      return 0.5 +
        this->Jitter * (MesoSeededRandom(this->Seed, 5000 + what, Wrapped(i), Wrapped(j)) - 0.5);
    };
    return { i, j, i + shift(0) - x, j + shift(1) - y };
  }

  std::uint32_t Seed;
  int Cells;
  double Jitter;
  double Joint;
  double Bevel;
  double Variation;
  double Roughness;
};

/**
 * Octaves of gradient noise, each twice as fine, as they are (hills, fractional Brownian motion) and as
 * ridges, (1 - |noise|)^2 weighted with the ridges of the octave before (Musgrave, in Ebert et al. 2003,
 * "Texturing and Modeling", chapter 16: ridged multifractal), mixed; looked up at places that
 * noise has moved.
 */
class TerrainField : public MesoPattern::Field
{
public:
  TerrainField(std::uint32_t seed, const MesoPatternValues& values)
    : Seed(seed)
    , Frequency(static_cast<int>(values.at("frequency")))
    , Octaves(static_cast<int>(values.at("octaves")))
    , Gain(values.at("gain"))
    , Ridges(values.at("ridges"))
    , Warp(values.at("warp"))
  {
    const auto range = MesoRangeOfField(*this, 256);
    this->Low = range[0];
    this->Factor = range[1] > range[0] ? 1. / (range[1] - range[0]) : 1.;
  }

  double At(double s, double t) const override
  {
    const double x0 = s * this->Frequency;
    const double y0 = t * this->Frequency;
    const double x = this->Inside(x0 + this->Warp * this->Noise(x0, y0, 1, 100));
    const double y = this->Inside(y0 + this->Warp * this->Noise(x0, y0, 1, 101));
    double hills = 0.;
    double ridges = 0.;
    double amplitude = 1.;
    double weight = 1.;
    int finer = 1;
    for (int k = 0; k < this->Octaves; ++k)
    {
      const double noise = this->Noise(x, y, finer, k);
      hills += amplitude * noise;
      const double crest = (1. - std::abs(noise)) * (1. - std::abs(noise)) * weight;
      ridges += amplitude * crest;
      weight = std::clamp(2. * crest, 0., 1.);
      amplitude *= this->Gain;
      finer *= 2;
    }
    const double sum = (1. - this->Ridges) * hills + this->Ridges * ridges;
    return (sum - this->Low) * this->Factor;
  }

private:
  double Inside(double x) const { return x - this->Frequency * std::floor(x / this->Frequency); }
  double Noise(double x, double y, int finer, int key) const
  {
    const int period = this->Frequency * finer;
    return MesoGradientNoise(x * finer, y * finer, { period, period }, this->Seed, 200 + key);
  }

  std::uint32_t Seed;
  int Frequency;
  int Octaves;
  double Gain;
  double Ridges;
  double Warp;
  double Low = 0.;
  double Factor = 1.;
};

/**
 * A sum of sines that travel as waves on deep water do: a wave of (m, n) periods a tile turns by
 * sqrt(k) periods in a unit of time, k^2 = m^2 + n^2. The sum has the normal distribution that
 * many waves come to, and the height is the part of it that lies lower: no time needs another scale. A
 * power of it sharpens crests and flattens troughs.
 */
class WavesField : public MesoPattern::Field
{
public:
  WavesField(std::uint32_t seed, const MesoPatternValues& values)
    : Power(1. + 2. * values.at("steepness"))
  {
    const int count = static_cast<int>(values.at("waves"));
    const double finest = values.at("frequency");
    double squares = 0.;
    for (int i = 0; i < count; ++i)
    {
      const auto random = [&](int what) { return MesoSeededRandom(seed, 6000 + what, i); };
      const double k = count > 1 ? std::pow(finest, static_cast<double>(i) / (count - 1)) : 1.;
      const double angle =
        Pi / 180. * (values.at("direction") + values.at("spread") * (2. * random(0) - 1.));
      Wave wave;
      wave.M = std::round(k * std::cos(angle));
      wave.N = std::round(k * std::sin(angle));
      if (wave.M == 0. && wave.N == 0.)
      {
        (std::abs(std::cos(angle)) < std::abs(std::sin(angle)) ? wave.N : wave.M) = 1.;
      }
      const double length = std::hypot(wave.M, wave.N);
      wave.Phase = random(1) - values.at("time") * std::sqrt(length);
      wave.Phase -= std::floor(wave.Phase);
      wave.Amplitude = 1. / length;
      squares += 0.5 * wave.Amplitude * wave.Amplitude;
      this->Waves.push_back(wave);
    }
    this->Spread = std::sqrt(2. * squares);
  }

  double At(double s, double t) const override
  {
    double sum = 0.;
    for (const Wave& wave : this->Waves)
    {
      sum += wave.Amplitude * std::cos(2. * Pi * (wave.M * s + wave.N * t + wave.Phase));
    }
    return std::pow(0.5 + 0.5 * std::erf(sum / this->Spread), this->Power);
  }

private:
  struct Wave
  {
    double M;
    double N;
    double Phase; ///< in periods
    double Amplitude;
  };

  double Power;
  std::vector<Wave> Waves;
  double Spread; ///< the standard deviation of the sum, times the root of 2
};
}

MesoFieldPointer MesoMakeStoneField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<StoneField>(seed, values);
}

MesoFieldPointer MesoMakeTerrainField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<TerrainField>(seed, values);
}

MesoFieldPointer MesoMakeWavesField(std::uint32_t seed, const MesoPatternValues& values)
{
  return std::make_shared<WavesField>(seed, values);
}
