#ifndef HeightSearchCases_h
#define HeightSearchCases_h

// Maps and paths on which searches fail, and where a path truly meets a map: cut at every line of
// texel centres it crosses, and solved piece by piece in double precision, written apart from the
// kernels.

#include "KernelTypes.h"
#include "MesoHeightCones.h"
#include "MesoHeightPyramid.h"

#include <algorithm>
#include <cmath>

struct SearchMap
{
  const char* Name;
  int Width;
  int Height;
  std::vector<float> Heights;
};

/// Heights as a file of so many bits holds them.
inline std::vector<float> Quantised(std::vector<float> heights, double steps)
{
  for (float& height : heights)
  {
    height = float(std::round(double(height) * steps) / steps);
  }
  return heights;
}

inline std::vector<SearchMap> HardMaps(std::mt19937& generator)
{
  const auto random = [&generator](int width, int height)
  {
    std::uniform_real_distribution<double> any(0., 1.);
    return MakeHeights(width, height, [&](int, int) { return any(generator); });
  };
  std::vector<float> spikes(31 * 17, 0.f);
  std::vector<float> slots(31 * 17, 1.f);
  for (std::size_t i = 40; i < spikes.size(); i += 97)
  {
    spikes[i] = 1.f;
    slots[i] = 0.f;
  }
  const auto checker = [](int column, int row) { return (column + row) % 2; };
  const auto walls = [](int column, int row) { return column % 8 == 3 || row == 5 ? 1. : 0.1; };
  const auto hill = [](int column, int row)
  { return 0.5 + 0.5 * std::sin(0.4 * column) * std::cos(0.3 * row); };
  return { { "all high", 4, 4, std::vector<float>(16, 1.f) },
    { "all low", 4, 4, std::vector<float>(16, 0.f) }, { "spikes", 31, 17, spikes },
    { "slots", 31, 17, slots }, { "checkerboard", 16, 12, MakeHeights(16, 12, checker) },
    { "walls", 32, 9, MakeHeights(32, 9, walls) }, { "hill", 40, 28, MakeHeights(40, 28, hill) },
    { "noise", 23, 37, random(23, 37) },
    { "noise of 8 bits", 16, 16, Quantised(random(16, 16), 255.) },
    { "noise of 16 bits", 9, 13, Quantised(random(9, 13), 65535.) }, { "1 x 1", 1, 1, { 0.4f } },
    { "1 x 9", 1, 9, random(1, 9) }, { "9 x 1", 9, 1, random(9, 1) },
    { "2 x 2", 2, 2, random(2, 2) } };
}

/// Does the work at once.
inline bool RunAtOnce(int count, const std::function<void(int, int)>& work, double, double)
{
  work(0, count);
  return true;
}

inline MesoHeightCones ConesOf(const SearchMap& map, MesoWrap wrap)
{
  return MesoMakeHeightCones(map.Width, map.Height, wrap, map.Heights.data(), RunAtOnce);
}

/// A kernel's height field with its cones.
template <typename HeightField>
HeightField FieldOf(const SearchMap& map, MesoWrap wrap)
{
  HeightField field(map.Width, map.Height, wrap, map.Heights);
  const MesoHeightCones cones = ConesOf(map, wrap);
  field.SetCones(cones.Apex, cones.Steepness);
  return field;
}

/// The same and its pyramid, of which `searched` is looked for.
template <typename HeightField>
HeightField FieldOf(
  const SearchMap& map, MesoWrap wrap, const std::vector<MesoHeightLevel>& pyramid, int searched)
{
  HeightField field = FieldOf<HeightField>(map, wrap);
  std::vector<typename HeightField::Level> levels;
  for (const MesoHeightLevel& level : pyramid)
  {
    MesoHeightCones cones =
      MesoMakeHeightCones(level.Width, level.Height, wrap, level.Heights.data(), RunAtOnce);
    levels.push_back({ level.Width, level.Height, level.Heights, std::move(cones.Apex),
      std::move(cones.Steepness) });
  }
  field.SetLevels(std::move(levels), searched);
  return field;
}

/// A level of it, 1 or more, as a map of its own.
inline SearchMap LevelOf(
  const SearchMap& map, const std::vector<MesoHeightLevel>& pyramid, int number)
{
  const MesoHeightLevel& level = pyramid[std::size_t(number) - 1];
  return { map.Name, level.Width, level.Height, level.Heights };
}

/// The surface itself.
class TrueSurface
{
public:
  TrueSurface(const SearchMap& map, MesoWrap wrap)
    : Map(map)
    , Wrap(wrap)
  {
  }

  /// Height of texel centre i, j of the endless map.
  double Texel(long i, long j) const
  {
    const auto inMap = [this](long k, long n)
    {
      const long period = this->Wrap == MesoWrap::Mirror ? 2 * n : n;
      if (this->Wrap == MesoWrap::Clamp)
      {
        return k < 0 ? 0 : (k < n ? k : n - 1);
      }
      const long k0 = ((k % period) + period) % period;
      return k0 < n ? k0 : period - 1 - k0;
    };
    return this->Map.Heights[std::size_t(
      inMap(j, this->Map.Height) * this->Map.Width + inMap(i, this->Map.Width))];
  }
  /// Bilinear over the patch of lower left texel i, j.
  double Height(double x, double y, long i, long j) const
  {
    const double u = x - double(i);
    const double v = y - double(j);
    return (1. - v) * ((1. - u) * this->Texel(i, j) + u * this->Texel(i + 1, j)) +
      v * ((1. - u) * this->Texel(i, j + 1) + u * this->Texel(i + 1, j + 1));
  }

private:
  const SearchMap& Map;
  MesoWrap Wrap;
};

/// A path, cut into pieces over one patch each.
class TrueClearance
{
public:
  template <typename Path>
  TrueClearance(const SearchMap& map, MesoWrap wrap, const Path& path)
    : Surface(map, wrap)
    , X0(double(path.MapStart.x) * map.Width - 0.5)
    , Y0(double(path.MapStart.y) * map.Height - 0.5)
    , SpanX(double(path.MapSpan.x) * map.Width)
    , SpanY(double(path.MapSpan.y) * map.Height)
    , Start(double(path.DepthStart))
    , Fall(double(path.DepthEnd) - double(path.DepthStart))
    , Sag(double(path.Sag))
    , Cuts({ 0., 1. })
  {
    this->AddCuts(this->X0, this->SpanX);
    this->AddCuts(this->Y0, this->SpanY);
    std::sort(this->Cuts.begin(), this->Cuts.end());
  }

  double Depth(double w) const { return this->Start + w * (this->Fall + this->Sag * (1. - w)); }
  double At(double w) const { return this->Over(w, w); }
  /// The least clearance up to a part.
  double Least(double end) const
  {
    double least = this->At(0.);
    this->ForPieces(end,
      [&](double from, double to, double c0, double c1, double c2)
      {
        const double length = to - from;
        least = std::min({ least, c0, c0 + length * (c1 + length * c2) });
        const double turn = c2 > 0. ? -c1 / (2. * c2) : -1.;
        if (turn > 0. && turn < length)
        {
          least = std::min(least, c0 + turn * (c1 + turn * c2));
        }
      });
    return least;
  }
  /// How much depth changes at most when map coordinates are off by so many texels: heights differ by
  /// 1 from texel to texel at most.
  double Size() const
  {
    return std::abs(this->X0) + std::abs(this->Y0) + std::abs(this->SpanX) + std::abs(this->SpanY);
  }
  double DepthSize() const
  {
    return 1. + std::abs(this->Start) + std::abs(this->Fall) + std::abs(this->Sag);
  }

private:
  void AddCuts(double start, double span)
  {
    const double low = std::ceil(std::min(start, start + span));
    for (double line = low; line < std::max(start, start + span); line += 1.)
    {
      this->Cuts.push_back(std::clamp((line - start) / span, 0., 1.));
    }
  }
  /// At a part, by the patch that the path is over at another.
  double Over(double w, double over) const
  {
    const double height = this->Surface.Height(this->X0 + w * this->SpanX,
      this->Y0 + w * this->SpanY, long(std::floor(this->X0 + over * this->SpanX)),
      long(std::floor(this->Y0 + over * this->SpanY)));
    return 1. - height - this->Depth(w);
  }
  /// Each piece's clearance c0 + t (c1 + t c2), from three of its values.
  template <typename Visit>
  void ForPieces(double end, const Visit& visit) const
  {
    for (std::size_t k = 0; k + 1 < this->Cuts.size() && this->Cuts[k] < end; ++k)
    {
      const double from = this->Cuts[k];
      const double to = std::min(this->Cuts[k + 1], end);
      if (!(to > from))
      {
        continue;
      }
      const double middle = 0.5 * (from + this->Cuts[k + 1]);
      const double length = to - from;
      const double f0 = this->Over(from, middle);
      const double f1 = this->Over(from + 0.5 * length, middle);
      const double f2 = this->Over(to, middle);
      const double c2 = 2. * (f0 - 2. * f1 + f2) / (length * length);
      const double c1 = (4. * f1 - 3. * f0 - f2) / length;
      visit(from, to, f0, c1, c2);
    }
  }

  TrueSurface Surface;
  double X0;
  double Y0;
  double SpanX;
  double SpanY;
  double Start;
  double Fall;
  double Sag;
  std::vector<double> Cuts;
};

#endif
