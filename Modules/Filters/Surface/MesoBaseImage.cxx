#include "MesoBaseImage.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace
{
using Coordinate = std::array<double, 2>;

constexpr int LeastSize = 16; // texels along an axis
constexpr double Same = 1e-5; // of the mesh's size: positions nearer than this are one
constexpr std::int64_t None = -1;
constexpr std::int64_t Several = -2;

/// Weights of a triangle's corners at a point of the image.
struct Weights
{
  std::array<double, 3> W;

  /// How far outside the triangle: 0 inside.
  double Outside() const { return -std::min({ this->W[0], this->W[1], this->W[2], 0. }); }
};

/// A triangle in texels.
class Patch
{
public:
  Patch(const Coordinate& a, const Coordinate& b, const Coordinate& c)
    : Start(a)
    , AlongB{ b[0] - a[0], b[1] - a[1] }
    , AlongC{ c[0] - a[0], c[1] - a[1] }
    , Area(this->AlongB[0] * this->AlongC[1] - this->AlongB[1] * this->AlongC[0])
  {
  }

  bool Spans() const
  {
    const double size =
      std::hypot(this->AlongB[0], this->AlongB[1]) * std::hypot(this->AlongC[0], this->AlongC[1]);
    return std::abs(this->Area) > 1e-12 * size && size > 0.;
  }

  Weights At(double x, double y) const
  {
    const double dx = x - this->Start[0];
    const double dy = y - this->Start[1];
    const double b = (dx * this->AlongC[1] - dy * this->AlongC[0]) / this->Area;
    const double c = (dy * this->AlongB[0] - dx * this->AlongB[1]) / this->Area;
    return { { 1. - b - c, b, c } };
  }

private:
  Coordinate Start;
  Coordinate AlongB;
  Coordinate AlongC;
  double Area;
};

double SizeOf(const std::vector<MesoVector>& positions)
{
  double size = 0.;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto ends = std::minmax_element(positions.begin(), positions.end(),
      [axis](const MesoVector& a, const MesoVector& b) { return a[axis] < b[axis]; });
    size = std::max(size, (*ends.second)[axis] - (*ends.first)[axis]);
  }
  return size;
}

double Distance(const MesoVector& a, const MesoVector& b)
{
  return MesoLength(MesoDifference(a, b));
}

/// Where the triangles lie along an axis of the texture.
struct Extents
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
  std::vector<double> OfTriangles; ///< of those that have one

  Extents(const MesoBaseImageInput& input, int axis)
  {
    for (const auto& corners : input.Triangles)
    {
      const auto at = [&](int k) { return input.Coordinates[corners[k]][axis]; };
      const double first = std::min({ at(0), at(1), at(2) });
      const double last = std::max({ at(0), at(1), at(2) });
      this->Low = std::min(this->Low, first);
      this->High = std::max(this->High, last);
      if (last > first)
      {
        this->OfTriangles.push_back(last - first);
      }
    }
  }
};

class Maker
{
public:
  Maker(const MesoBaseImageInput& input, const std::array<int, 2>& size)
    : Input(input)
    , Near(Same * SizeOf(input.Positions))
  {
    this->Image.Size = size;
    this->PlaceTexels();
    this->Rasterise();
    this->GoOnBeside();
    this->Evaluate();
  }

  MesoBaseImage Image;

private:
  Coordinate InTexels(std::int64_t point) const
  {
    const Coordinate& uv = this->Input.Coordinates[point];
    return { uv[0] * this->Image.Scale[0] + this->Image.Offset[0],
      uv[1] * this->Image.Scale[1] + this->Image.Offset[1] };
  }
  Patch PatchOf(std::int64_t triangle) const
  {
    const auto& corners = this->Input.Triangles[triangle];
    return { this->InTexels(corners[0]), this->InTexels(corners[1]), this->InTexels(corners[2]) };
  }
  MesoVector Between(
    const std::vector<MesoVector>& values, std::int64_t triangle, const Weights& weights) const
  {
    MesoVector sum = { 0., 0., 0. };
    for (int k = 0; k < 3; ++k)
    {
      sum = MesoSum(sum, MesoScaled(values[this->Input.Triangles[triangle][k]], weights.W[k]));
    }
    return sum;
  }
  std::size_t TexelAt(int x, int y) const
  {
    return std::size_t(y) * std::size_t(this->Image.Size[0]) + std::size_t(x);
  }

  void PlaceTexels();
  bool Closes(int axis, double low, double high) const;
  void Rasterise();
  void GoOnBeside();
  void Evaluate();

  const MesoBaseImageInput& Input;
  const double Near;
  std::vector<std::int64_t> Owner; ///< a triangle for each texel
};

/// Whether the points at the one end of an axis and those at the other are the same.
bool Maker::Closes(int axis, double low, double high) const
{
  const double rounding = 1e-6 * (high - low);
  std::array<std::vector<std::pair<double, std::int64_t>>, 2> ends;
  for (std::size_t i = 0; i < this->Input.Coordinates.size(); ++i)
  {
    const Coordinate& uv = this->Input.Coordinates[i];
    for (int end = 0; end < 2; ++end)
    {
      if (std::abs(uv[axis] - (end == 0 ? low : high)) <= rounding)
      {
        ends[end].emplace_back(uv[1 - axis], static_cast<std::int64_t>(i));
      }
    }
  }
  if (ends[0].size() < 2 || ends[0].size() != ends[1].size())
  {
    return false;
  }
  std::sort(ends[0].begin(), ends[0].end());
  std::sort(ends[1].begin(), ends[1].end());
  for (std::size_t i = 0; i < ends[0].size(); ++i)
  {
    if (std::abs(ends[0][i].first - ends[1][i].first) > rounding ||
      Distance(this->Input.Positions[ends[0][i].second], this->Input.Positions[ends[1][i].second]) >
        this->Near)
    {
      return false;
    }
  }
  return true;
}

void Maker::PlaceTexels()
{
  for (int axis = 0; axis < 2; ++axis)
  {
    const Extents extents(this->Input, axis);
    if (extents.OfTriangles.empty())
    {
      throw std::invalid_argument("the texture coordinates span no area");
    }
    const bool wraps = this->Closes(axis, extents.Low, extents.High);
    const int margin = wraps ? 0 : MesoBaseImageMargin;
    const double texels = this->Image.Size[axis] - 2 * margin;
    this->Image.Wraps[axis] = wraps;
    this->Image.Scale[axis] = texels / (extents.High - extents.Low);
    this->Image.Offset[axis] = margin - 0.5 - extents.Low * this->Image.Scale[axis];
  }
}

void Maker::Rasterise()
{
  const auto& size = this->Image.Size;
  this->Owner.assign(std::size_t(size[0]) * std::size_t(size[1]), None);
  for (std::size_t triangle = 0; triangle < this->Input.Triangles.size(); ++triangle)
  {
    const auto number = static_cast<std::int64_t>(triangle);
    const Patch patch = this->PatchOf(number);
    if (!patch.Spans())
    {
      continue;
    }
    std::array<int, 2> first;
    std::array<int, 2> last;
    for (int axis = 0; axis < 2; ++axis)
    {
      const auto at = [&](int k) { return this->InTexels(this->Input.Triangles[number][k])[axis]; };
      first[axis] = std::max(0, static_cast<int>(std::ceil(std::min({ at(0), at(1), at(2) }))));
      last[axis] =
        std::min(size[axis] - 1, static_cast<int>(std::floor(std::max({ at(0), at(1), at(2) }))));
    }
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        const Weights weights = patch.At(x, y);
        if (weights.Outside() > 1e-9)
        {
          continue;
        }
        std::int64_t& owner = this->Owner[this->TexelAt(x, y)];
        const auto apart = [&]
        {
          return Distance(this->Between(this->Input.Positions, number, weights),
                   this->Between(this->Input.Positions, owner, this->PatchOf(owner).At(x, y))) >
            this->Near;
        };
        owner = owner == None ? number : owner != Several && apart() ? Several : owner;
      }
    }
  }
  for (const std::int64_t owner : this->Owner)
  {
    this->Image.NumberOfAmbiguous += owner == Several ? 1 : 0;
    this->Image.NumberOfInside += owner >= 0 ? 1 : 0;
  }
  this->Image.Kinds.assign(this->Owner.size(), MesoBaseTexel::Unknown);
  for (std::size_t i = 0; i < this->Owner.size(); ++i)
  {
    if (this->Owner[i] >= 0)
    {
      this->Image.Kinds[i] = MesoBaseTexel::Inside;
    }
  }
}

/// A chart's triangles go on, flat, for some texels beside it, so that texels between the last
/// centre and the edge can be interpolated.
void Maker::GoOnBeside()
{
  const auto& size = this->Image.Size;
  const auto neighbour = [&](int i, int axis)
  {
    return this->Image.Wraps[axis] ? (i + size[axis]) % size[axis]
                                   : std::clamp(i, 0, size[axis] - 1);
  };
  for (int pass = 0; pass < MesoBaseImageMargin; ++pass)
  {
    const std::vector<std::int64_t> before = this->Owner;
    for (int y = 0; y < size[1]; ++y)
    {
      for (int x = 0; x < size[0]; ++x)
      {
        std::int64_t& owner = this->Owner[this->TexelAt(x, y)];
        if (owner != None)
        {
          continue;
        }
        double least = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 9; ++k)
        {
          const int dx = k % 3 - 1;
          const int dy = k / 3 - 1;
          const std::int64_t other =
            before[this->TexelAt(neighbour(x + dx, 0), neighbour(y + dy, 1))];
          // Over the wrap the triangle lies a whole image away: its own end goes on instead.
          const bool wraps = neighbour(x + dx, 0) != x + dx || neighbour(y + dy, 1) != y + dy;
          if (other < 0 || wraps)
          {
            continue;
          }
          const double outside = this->PatchOf(other).At(x, y).Outside();
          if (outside < least)
          {
            least = outside;
            owner = other;
          }
        }
      }
    }
  }
}

void Maker::Evaluate()
{
  MesoBaseImage& image = this->Image;
  image.Positions.assign(this->Owner.size(), { 0., 0., 0. });
  image.Normals.assign(this->Owner.size(), { 0., 0., 0. });
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto ends =
      std::minmax_element(this->Input.Positions.begin(), this->Input.Positions.end(),
        [axis](const MesoVector& a, const MesoVector& b) { return a[axis] < b[axis]; });
    image.Centre[axis] = 0.5 * ((*ends.first)[axis] + (*ends.second)[axis]);
  }
  for (int y = 0; y < image.Size[1]; ++y)
  {
    for (int x = 0; x < image.Size[0]; ++x)
    {
      const std::size_t texel = this->TexelAt(x, y);
      const std::int64_t owner = this->Owner[texel];
      if (owner < 0)
      {
        continue;
      }
      const Weights weights = this->PatchOf(owner).At(x, y);
      const MesoVector normal = this->Between(this->Input.Normals, owner, weights);
      const double length = MesoLength(normal);
      if (!(length > 0.))
      {
        image.Kinds[texel] = MesoBaseTexel::Unknown;
        continue;
      }
      image.Normals[texel] = MesoScaled(normal, 1. / length);
      image.Positions[texel] =
        MesoDifference(this->Between(this->Input.Positions, owner, weights), image.Centre);
      if (image.Kinds[texel] == MesoBaseTexel::Unknown)
      {
        image.Kinds[texel] = MesoBaseTexel::Beside;
      }
    }
  }
}
}

std::array<int, 2> MesoBaseImageSize(
  const MesoBaseImageInput& input, double texelsPerTriangle, int most)
{
  std::array<int, 2> size = { LeastSize, LeastSize };
  for (int axis = 0; axis < 2; ++axis)
  {
    Extents extents(input, axis);
    std::vector<double>& all = extents.OfTriangles;
    if (!all.empty())
    {
      const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
      std::nth_element(all.begin(), middle, all.end());
      const double wanted =
        std::ceil(texelsPerTriangle * (extents.High - extents.Low) / *middle - 1e-3);
      size[axis] = static_cast<int>(std::clamp(
        wanted + 2 * MesoBaseImageMargin, double(LeastSize), double(std::max(LeastSize, most))));
    }
  }
  return size;
}

MesoBaseImage MesoMakeBaseImage(const MesoBaseImageInput& input, const std::array<int, 2>& size)
{
  Maker maker(input, size);
  if (maker.Image.NumberOfInside + maker.Image.NumberOfAmbiguous == 0)
  {
    throw std::invalid_argument("the texture coordinates span no area");
  }
  return std::move(maker.Image);
}
