#ifndef MesoHeightPyramid_h
#define MesoHeightPyramid_h

/**
 * @class MesoHeightPyramid
 * @brief A height map as cells between texel centres, with the least and greatest height of blocks.
 *
 * Texel coordinates: x = s * width - 0.5, y = t * height - 0.5 for map coordinates (s, t), so that
 * texel centres lie at whole numbers. A cell is the square between four of them, on which the
 * height is bilinear in the heights of its four corners.
 *
 * The map fills the plane as its wrap says. It is cut into tiles of Cells() cells along each axis:
 * `repeat` has as many cells as texels; `mirror` twice as many, for the tile and its image; `clamp`
 * has one tile alone, whose first and last cells reach to infinity, constant across.
 *
 * Blocks of 2^level cells keep the range of their heights; the topmost block is the tile. Constant
 * after construction, so threads may share it.
 */

#include "MesoHeightTexture.h"
#include "mesoRenderingReferenceModule.h" // for export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

class MESORENDERINGREFERENCE_EXPORT MesoHeightPyramid
{
public:
  struct Range
  {
    float Low;
    float High;
  };

  /// Heights in [0,1], row by row, row 0 at t = 0. Throws std::invalid_argument as
  /// MesoHeightTexture does.
  MesoHeightPyramid(int width, int height, MesoWrap wrap, std::vector<float> heights,
    MesoInterpolation interpolation = MesoInterpolation::Bilinear);

  /// How heights run in a cell: bilinear in its corners, or as the uniform cubic B-spline of the 4 x 4
  /// texels around it (MesoSplineCell).
  MesoInterpolation Interpolation() const { return this->Kind; }

  /// One direction of the map.
  class Axis
  {
  public:
    Axis(int texels, MesoWrap wrap);

    int Texels() const { return this->NumberOfTexels; }
    /// Cells of a tile.
    int Cells() const { return this->NumberOfCells; }
    /// The texel, in [0, Texels()), that stands for any number.
    int Wrapped(std::int64_t texel) const;
    /// The lower texel, not wrapped, of a cell of tile 0; the upper is the next.
    int FirstTexel(int cell) const { return this->Clamped() ? cell - 1 : cell; }
    /// Where a cell of a tile begins and ends, in texel coordinates.
    double Low(std::int64_t tile, int cell) const;
    double High(std::int64_t tile, int cell) const;
    /// The tile and the cell of it around a texel coordinate.
    std::int64_t TileOf(double coordinate) const;
    int CellOf(std::int64_t tile, double coordinate) const;

    /// Whether all beyond the border of the map is level.
    bool Clamped() const { return this->Wrap == MesoWrap::Clamp; }

  private:
    int NumberOfTexels;
    int NumberOfCells;
    MesoWrap Wrap;
  };

  const Axis& X() const { return this->Columns; }
  const Axis& Y() const { return this->Rows; }

  /// The height of a texel, wrapped.
  double Height(std::int64_t column, std::int64_t row) const
  {
    return this->Texture.fetchHeight({ this->Columns.Wrapped(column), this->Rows.Wrapped(row) });
  }

  /// Bilinear height at map coordinates.
  double HeightAt(double s, double t) const { return this->Texture.sampleHeight({ s, t }); }

  /// Heights at (low, low), (high, low), (low, high), (high, high) of a cell of tile 0.
  std::array<double, 4> Corners(int column, int row) const;

  /// The level of the block that is the whole tile.
  int TopLevel() const { return static_cast<int>(this->Levels.size()); }
  /// Range of the heights on the block (i, j) of 2^level by 2^level cells.
  Range RangeOf(int level, int i, int j) const;

  std::size_t MemoryBytes() const;

private:
  /// The ranges of one level, from 1 on; those of single cells are found from their corners.
  struct Level
  {
    int Width;
    int Height;
    std::vector<Range> Ranges;
  };
  void AddLevel();

  MesoInterpolation Kind;
  Axis Columns;
  Axis Rows;
  MesoHeightTexture<double> Texture;
  std::vector<Level> Levels;
};

#endif
