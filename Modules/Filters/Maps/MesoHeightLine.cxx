#include "MesoHeightLine.h"

#include <algorithm>
#include <cmath>

namespace
{
/// Cuts nearer to each other than this part of a texel are one.
constexpr double LeastStep = 1e-9;

int Wrapped(double texel, int size)
{
  return static_cast<int>(texel - size * std::floor(texel / size));
}

/// A sum of two numbers within a size, back in it.
int WrappedOnce(int texel, int size)
{
  return texel >= size ? texel - size : texel;
}
}

MesoHeightLine::MesoHeightLine(int width, int height, double azimuth, double reach)
  : Width(width)
  , Height(height)
{
  // Directions along an axis are meant exactly.
  const auto exact = [](double part) { return std::abs(part) < 1e-12 ? 0. : part; };
  const double perColumn = exact(std::cos(azimuth)) * width; // texels a tile of the line
  const double perRow = exact(std::sin(azimuth)) * height;
  this->BendPerTwist = perColumn * perRow;

  const double texelsAcross = std::abs(perColumn);
  const double texelsUp = std::abs(perRow);
  double nextColumn = 0.; // number of the next column and row that are crossed
  double nextRow = 0.;
  while (this->Offsets.size() < 2 || this->Offsets[this->Offsets.size() - 2] < reach)
  {
    const double atColumn = texelsAcross > 0. ? nextColumn / texelsAcross : HUGE_VAL;
    const double atRow = texelsUp > 0. ? nextRow / texelsUp : HUGE_VAL;
    const double offset = std::min(atColumn, atRow);
    const bool onColumn = atColumn - offset <= LeastStep / std::max(width, height);
    const bool onRow = atRow - offset <= LeastStep / std::max(width, height);
    // An axis that the line runs along is crossed nowhere, and its texel is exact throughout.
    const double x =
      onColumn || texelsAcross == 0. ? std::copysign(nextColumn, perColumn) : offset * perColumn;
    const double y = onRow || texelsUp == 0. ? std::copysign(nextRow, perRow) : offset * perRow;
    Cut cut = {};
    cut.Column[0] = cut.Column[1] = Wrapped(std::floor(x), width);
    cut.Row[0] = cut.Row[1] = Wrapped(std::floor(y), height);
    if (x != std::floor(x))
    {
      cut.Column[1] = Wrapped(std::floor(x) + 1., width);
      cut.Weight = x - std::floor(x);
    }
    else if (y != std::floor(y))
    {
      cut.Row[1] = Wrapped(std::floor(y) + 1., height);
      cut.Weight = y - std::floor(y);
    }
    // The patch that is entered: towards where the line goes.
    const double left = perColumn < 0. ? std::ceil(x) - 1. : std::floor(x);
    const double low = perRow < 0. ? std::ceil(y) - 1. : std::floor(y);
    cut.Cell[0] = Wrapped(left, width);
    cut.Cell[1] = Wrapped(low, height);
    this->Offsets.push_back(offset);
    this->Cuts.push_back(cut);
    nextColumn += onColumn ? 1. : 0.;
    nextRow += onRow ? 1. : 0.;
  }
}

MesoHeightLine::Profile::Profile(const MesoHeightLine& line, const float* depths)
  : Line(line)
  , Map(depths)
  , Depths(line.GetCutCount())
  , Bends(line.GetCutCount())
  , Sags(line.GetCutCount())
{
}

void MesoHeightLine::Profile::Start(int column, int row)
{
  this->Column = column;
  this->Row = row;
  this->Known = 0;
}

void MesoHeightLine::Profile::Extend(std::size_t cut)
{
  constexpr std::size_t AtOnce = 16;
  const std::size_t end = std::min(cut + AtOnce, this->Depths.size());
  const int width = this->Line.Width;
  const int height = this->Line.Height;
  const auto at = [&](int column, int row) -> double
  {
    return this->Map[std::size_t(WrappedOnce(this->Row + row, height)) * width +
      WrappedOnce(this->Column + column, width)];
  };
  for (std::size_t k = this->Known; k < end; ++k)
  {
    const Cut& place = this->Line.Cuts[k];
    const double first = at(place.Column[0], place.Row[0]);
    this->Depths[k] = first + place.Weight * (at(place.Column[1], place.Row[1]) - first);
    if (this->Line.BendPerTwist != 0. && k + 1 < this->Depths.size())
    {
      const int right = WrappedOnce(place.Cell[0] + 1, width);
      const int above = WrappedOnce(place.Cell[1] + 1, height);
      const double twist = at(place.Cell[0], place.Cell[1]) + at(right, above) -
        at(right, place.Cell[1]) - at(place.Cell[0], above);
      const double step = this->Line.Offsets[k + 1] - this->Line.Offsets[k];
      this->Bends[k] = twist * this->Line.BendPerTwist;
      this->Sags[k] = 0.25 * step * step * std::abs(this->Bends[k]);
    }
  }
  this->Known = end;
}

double MesoHeightLine::Profile::DepthBetween(std::size_t cut, double along) const
{
  const double step = this->Line.Offsets[cut + 1] - this->Line.Offsets[cut];
  const double bend = this->Bends[cut];
  const double slope = (this->Depths[cut + 1] - this->Depths[cut]) / step - bend * step;
  return this->Depths[cut] + along * (slope + along * bend);
}
