#include "MesoHeightCones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace
{
constexpr int Ways = 4;
constexpr int Left = 1;
constexpr int Down = 2;
constexpr float Deepest = 65535.f; // of depths as whole numbers

/// Where texels along an axis lie in the map, and whether the map is seen mirrored there.
struct Axis
{
  int Size;
  MesoWrap Wrap;

  int Period() const { return this->Wrap == MesoWrap::Mirror ? 2 * this->Size : this->Size; }
  int InPeriod(int i) const
  {
    const int period = this->Period();
    return ((i % period) + period) % period;
  }
  int Texel(int i) const
  {
    if (this->Wrap == MesoWrap::Clamp)
    {
      return std::clamp(i, 0, this->Size - 1);
    }
    const int inPeriod = this->InPeriod(i);
    return inPeriod < this->Size ? inPeriod : 2 * this->Size - 1 - inPeriod;
  }
  bool IsMirrored(int i) const
  {
    return this->Wrap == MesoWrap::Mirror && this->InPeriod(i) >= this->Size;
  }
};

class ConeMaker
{
public:
  ConeMaker(int width, int height, MesoWrap wrap, const float* heights)
    : Columns{ width, wrap }
    , Rows{ height, wrap }
  {
    const std::size_t count = std::size_t(width) * std::size_t(height);
    std::vector<std::uint16_t> depths(count);
    // Rounded to less deep; what 8 and 16 bits hold comes out as it is.
    std::transform(heights, heights + count, depths.begin(),
      [](float h) { return std::uint16_t(std::floor((1. - double(h)) * Deepest + 0.01)); });
    for (auto& highest : this->Highest)
    {
      highest = depths;
    }
    for (auto& grown : this->Grown)
    {
      grown.resize(count);
    }
    this->Cones.Apex.resize(count * Ways);
    this->Cones.Steepness.assign(count * Ways, 0);
    for (int code = 0; code < 255; ++code)
    {
      const double part = code / 255.;
      this->SteepnessOfCode[std::size_t(code)] = float(0.5 * part * part * (1. - 1e-6));
    }
    this->SteepnessOfCode.back() =
      1.f; // the steepest there can be is 1/2: a whole depth in 2 texels
  }

  /// The apexes: the least depth of the patch ahead.
  void MakeApexes(int first, int end)
  {
    for (int row = first; row < end; ++row)
    {
      for (int column = 0; column < this->Columns.Size; ++column)
      {
        for (int way = 0; way < Ways; ++way)
        {
          const int columns[] = { column, this->Columns.Texel(column + (way & Left ? -1 : 1)) };
          const int rows[] = { row, this->Rows.Texel(row + (way & Down ? -1 : 1)) };
          int least = int(Deepest);
          for (int r : rows)
          {
            for (int c : columns)
            {
              least = std::min<int>(least, this->Highest[0][this->At(c, r)]);
            }
          }
          this->Cones.Apex[Ways * this->At(column, row) + std::size_t(way)] =
            static_cast<unsigned char>(least / 257); // 65535 = 255 * 257
        }
      }
    }
  }

  /// Prepares for triangles that are larger by `growth`. Reach: distance of their farthest texels.
  void StartGrowing(int growth)
  {
    this->Growth = growth;
    for (int side = 0; side < 2; ++side)
    {
      auto& steps = this->Steps[std::size_t(side)];
      steps.resize(std::size_t(this->Columns.Size));
      for (int column = 0; column < this->Columns.Size; ++column)
      {
        const int there = column + (side == 0 ? growth : -growth);
        steps[std::size_t(column)] = { this->Columns.Texel(there),
          this->Columns.IsMirrored(there) };
      }
    }
  }

  /// The highest texels of the larger triangles, and the cones that stay below them.
  void Grow(int first, int end)
  {
    for (int row = first; row < end; ++row)
    {
      for (int way = 0; way < Ways; ++way)
      {
        this->GrowRow(row, way);
      }
    }
  }

  void EndGrowing()
  {
    std::swap(this->Highest, this->Grown);
    this->Reach += this->Growth;
  }

  /// Distance up to which all texels ahead are known.
  int GetReach() const { return this->Reach; }
  MesoHeightCones Take() { return std::move(this->Cones); }

private:
  struct Step
  {
    int Column;
    bool Mirrored;
  };

  std::size_t At(int column, int row) const
  {
    return std::size_t(row) * std::size_t(this->Columns.Size) + std::size_t(column);
  }

  void GrowRow(int row, int way)
  {
    const int side = way & Left ? 1 : 0;
    const int rowThere = row + (way & Down ? -this->Growth : this->Growth);
    const int wayThere = this->Rows.IsMirrored(rowThere) ? way ^ Down : way;
    const auto at = [&](int ofWay, int ofRow)
    { return this->Highest[std::size_t(ofWay)].data() + this->At(0, ofRow); };
    const std::uint16_t* here = at(way, row);
    const std::uint16_t* besides[] = { here, at(way ^ Left, row) };
    const std::uint16_t* ahead = at(wayThere, this->Rows.Texel(rowThere));
    std::uint16_t* grown = this->Grown[std::size_t(way)].data() + this->At(0, row);
    const Step* steps = this->Steps[std::size_t(side)].data();
    const unsigned char* apex = this->Cones.Apex.data() + Ways * this->At(0, row) + way;
    unsigned char* steepness = this->Cones.Steepness.data() + Ways * this->At(0, row) + way;
    // The nearest that has come in: all that is nearer has been looked at.
    const float perTexel = 1.f / (float(this->Reach + 1) * Deepest);
    for (int column = 0; column < this->Columns.Size; ++column)
    {
      const Step step = steps[column];
      const std::uint16_t least =
        std::min({ here[column], besides[step.Mirrored ? 1 : 0][step.Column], ahead[column] });
      grown[column] = least;
      const float needed = float(int(apex[Ways * column]) * 257 - int(least)) * perTexel;
      unsigned char& code = steepness[Ways * column];
      while (this->SteepnessOfCode[code] < needed)
      {
        ++code;
      }
    }
  }

  Axis Columns;
  Axis Rows;
  int Reach = 0;
  int Growth = 0;
  /// Of each way and texel: the least depth in the triangle of texels ahead no further than Reach.
  std::array<std::vector<std::uint16_t>, Ways> Highest;
  std::array<std::vector<std::uint16_t>, Ways> Grown;
  std::array<std::vector<Step>, 2> Steps;      ///< of columns, rightwards and leftwards by Growth
  std::array<float, 256> SteepnessOfCode = {}; ///< what a code surely covers
  MesoHeightCones Cones;
};
}

MesoHeightCones MesoMakeHeightCones(
  int width, int height, MesoWrap wrap, const float* heights, const MesoConeRunner& run)
{
  ConeMaker maker(width, height, wrap, heights);
  // Beyond a period in each way there is nothing that is not nearer as well.
  const int farthest = (wrap == MesoWrap::Mirror ? 2 : 1) * (width + height);
  std::vector<int> growths;
  for (int reach = 0; reach < farthest; reach += growths.back())
  {
    // Three triangles of size k, two of them moved by g, are one of size k + g for g <= (k + 2) / 2.
    growths.push_back(std::max(1, reach / 4));
  }
  const double part = 1. / double(growths.size() + 1);
  bool going = run(
    height, [&](int first, int end) { maker.MakeApexes(first, end); }, 0., part);
  for (std::size_t i = 0; i < growths.size() && going; ++i)
  {
    maker.StartGrowing(growths[i]);
    going = run(
      height, [&](int first, int end) { maker.Grow(first, end); }, part * double(i + 1), part);
    maker.EndGrowing();
  }
  return maker.Take();
}
