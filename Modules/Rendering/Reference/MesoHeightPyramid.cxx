#include "MesoHeightPyramid.h"

#include <algorithm>
#include <limits>

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();
}

MesoHeightPyramid::Axis::Axis(int texels, MesoWrap wrap)
  : NumberOfTexels(texels)
  , NumberOfCells(wrap == MesoWrap::Repeat ? texels
        : wrap == MesoWrap::Mirror         ? 2 * texels
                                           : texels + 1)
  , Wrap(wrap)
{
}

int MesoHeightPyramid::Axis::Wrapped(std::int64_t texel) const
{
  const std::int64_t size = this->NumberOfTexels;
  switch (this->Wrap)
  {
    case MesoWrap::Repeat:
      return static_cast<int>((texel % size + size) % size);
    case MesoWrap::Mirror:
    {
      const std::int64_t inPeriod = (texel % (2 * size) + 2 * size) % (2 * size);
      return static_cast<int>(inPeriod < size ? inPeriod : 2 * size - 1 - inPeriod);
    }
    case MesoWrap::Clamp:
      break;
  }
  return static_cast<int>(std::min(std::max<std::int64_t>(texel, 0), size - 1));
}

double MesoHeightPyramid::Axis::Low(std::int64_t tile, int cell) const
{
  if (this->Clamped())
  {
    return cell == 0 ? -Infinity : cell - 1.;
  }
  return static_cast<double>(tile * this->NumberOfCells + cell);
}

double MesoHeightPyramid::Axis::High(std::int64_t tile, int cell) const
{
  if (this->Clamped())
  {
    return cell == this->NumberOfCells - 1 ? Infinity : cell;
  }
  return static_cast<double>(tile * this->NumberOfCells + cell + 1);
}

std::int64_t MesoHeightPyramid::Axis::TileOf(double coordinate) const
{
  return this->Clamped() ? 0
                         : static_cast<std::int64_t>(std::floor(coordinate / this->NumberOfCells));
}

int MesoHeightPyramid::Axis::CellOf(std::int64_t tile, double coordinate) const
{
  const double cell = this->Clamped()
    ? std::floor(coordinate) + 1.
    : std::floor(coordinate - static_cast<double>(tile * this->NumberOfCells));
  return static_cast<int>(std::min(std::max(cell, 0.), this->NumberOfCells - 1.));
}

MesoHeightPyramid::MesoHeightPyramid(
  int width, int height, MesoWrap wrap, std::vector<float> heights, MesoInterpolation interpolation)
  : Kind(interpolation)
  , Columns(width, wrap)
  , Rows(height, wrap)
  , Texture(width, height, wrap, std::move(heights))
{
  while (((this->Columns.Cells() - 1) >> this->TopLevel()) > 0 ||
    ((this->Rows.Cells() - 1) >> this->TopLevel()) > 0)
  {
    this->AddLevel();
  }
}

std::array<double, 4> MesoHeightPyramid::Corners(int column, int row) const
{
  const int x = this->Columns.FirstTexel(column);
  const int y = this->Rows.FirstTexel(row);
  return { this->Height(x, y), this->Height(x + 1, y), this->Height(x, y + 1),
    this->Height(x + 1, y + 1) };
}

MesoHeightPyramid::Range MesoHeightPyramid::RangeOf(int level, int i, int j) const
{
  if (level == 0 && this->Kind == MesoInterpolation::Bicubic)
  {
    // A B-spline stays between the least and the greatest of the texels that it is made of.
    const int x = this->Columns.FirstTexel(i);
    const int y = this->Rows.FirstTexel(j);
    const auto corner = static_cast<float>(this->Height(x, y));
    Range range = { corner, corner };
    for (int texel = 0; texel < 16; ++texel)
    {
      const auto height = static_cast<float>(this->Height(x - 1 + texel % 4, y - 1 + texel / 4));
      range = { std::min(range.Low, height), std::max(range.High, height) };
    }
    return range;
  }
  if (level == 0)
  {
    // The corners are floats, so nothing is lost.
    const std::array<double, 4> corners = this->Corners(i, j);
    const auto range = std::minmax_element(corners.begin(), corners.end());
    return { static_cast<float>(*range.first), static_cast<float>(*range.second) };
  }
  const Level& there = this->Levels[level - 1];
  return there.Ranges[std::size_t(j) * there.Width + i];
}

void MesoHeightPyramid::AddLevel()
{
  const int level = this->TopLevel() + 1;
  const int below = level - 1;
  Level next;
  next.Width = ((this->Columns.Cells() - 1) >> level) + 1;
  next.Height = ((this->Rows.Cells() - 1) >> level) + 1;
  next.Ranges.reserve(std::size_t(next.Width) * next.Height);
  const int lastColumn = (this->Columns.Cells() - 1) >> below;
  const int lastRow = (this->Rows.Cells() - 1) >> below;
  for (int j = 0; j < next.Height; ++j)
  {
    for (int i = 0; i < next.Width; ++i)
    {
      Range range = this->RangeOf(below, 2 * i, 2 * j);
      for (int child = 1; child < 4; ++child)
      {
        const int column = std::min(2 * i + child % 2, lastColumn);
        const int row = std::min(2 * j + child / 2, lastRow);
        const Range part = this->RangeOf(below, column, row);
        range = { std::min(range.Low, part.Low), std::max(range.High, part.High) };
      }
      next.Ranges.push_back(range);
    }
  }
  this->Levels.push_back(std::move(next));
}

std::size_t MesoHeightPyramid::MemoryBytes() const
{
  std::size_t bytes = std::size_t(this->Columns.Texels()) * this->Rows.Texels() * sizeof(float);
  for (const Level& level : this->Levels)
  {
    bytes += level.Ranges.size() * sizeof(Range);
  }
  return bytes;
}
