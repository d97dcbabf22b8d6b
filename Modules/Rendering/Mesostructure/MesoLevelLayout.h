#ifndef MesoLevelLayout_h
#define MesoLevelLayout_h

#include <cstddef>

/**
 * @class MesoLevelLayout
 * @brief Where the levels of a map's pyramid lie in one texture: the map first, the others side by side above it.
 *
 * What cornerOfLevel in Shaders/Common/ConeAccess.glsl counts by.
 */
class MesoLevelLayout
{
public:
  /// @param width, rows texels of the map's own part
  /// @param levels with the map
  MesoLevelLayout(std::size_t width, std::size_t rows, std::size_t levels)
    : Width(width)
    , Rows(rows)
    , Levels(levels)
  {
  }

  std::size_t GetWidth() const { return this->Width; }
  std::size_t GetHeight() const
  {
    return this->Levels > 1 ? this->Rows + this->Rows / 2 : this->Rows;
  }
  std::size_t GetTexels() const { return this->Width * this->GetHeight(); }
  /// The number of a level's first texel, row by row.
  std::size_t FirstOf(std::size_t level) const
  {
    return level == 0 ? 0 : this->Rows * this->Width + this->Width - ((2 * this->Width) >> level);
  }

private:
  std::size_t Width;
  std::size_t Rows;
  std::size_t Levels;
};

#endif
