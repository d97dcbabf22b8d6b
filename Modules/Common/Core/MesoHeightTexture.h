#ifndef MesoHeightTexture_h
#define MesoHeightTexture_h

/**
 * @class MesoHeightTexture
 * @brief A height map in memory, read as a shader reads its texture.
 *
 * Offers the four accessors that the kernel HeightField.glsl asks for, and those of levels and cones that
 * HeightLevels.glsl and HeightCone.glsl ask for; Real is the number that the kernels around it compute with. Heights are in [0,1], row by row, row 0 at map coordinate v = 0;
 * texel centres lie at (i + 0.5) / size. Constant after construction, so threads may share it.
 *
 * sampleHeight follows the OpenGL 3.2 core specification, section 3.8.8 (wrap modes REPEAT,
 * CLAMP_TO_EDGE and MIRRORED_REPEAT, filter LINEAR), written apart from the kernels. Samplers may
 * round the weights; SetWeightBits(8) does as most devices do.
 *
 * @sa MesoKernels.h
 */

#include "MesoOptions.h" // for MesoWrap

#ifndef GLM_FORCE_SWIZZLE
#define GLM_FORCE_SWIZZLE // before the first header of GLM: v.xy()
#endif
#include <glm/glm.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

template <typename Real>
class MesoHeightTexture
{
public:
  /// Throws std::invalid_argument unless there are width x height heights, at least one.
  MesoHeightTexture(int width, int height, MesoWrap wrap, std::vector<float> heights)
    : Width(width)
    , Height(height)
    , Wrap(wrap)
    , Heights(std::move(heights))
  {
    if (width < 1 || height < 1 || this->Heights.size() != std::size_t(width) * std::size_t(height))
    {
      throw std::invalid_argument("Height map of " + std::to_string(width) + " x " +
        std::to_string(height) + " texels: got " + std::to_string(this->Heights.size()) +
        " heights");
    }
  }

  /// Fraction bits of sampleHeight's weights; 0 (default): as exact as Real.
  void SetWeightBits(int bits) { this->WeightSteps = bits > 0 ? std::ldexp(Real(1), bits) : 0; }

  /// Cones of free space, four codes a texel each (MesoHeightCones); searches by cones need them.
  /// Throws std::invalid_argument where there are not four a texel.
  void SetCones(const std::vector<unsigned char>& apex, const std::vector<unsigned char>& steepness)
  {
    const std::size_t codes = 4 * this->Heights.size();
    if (apex.size() != codes || steepness.size() != codes)
    {
      throw std::invalid_argument("Cones of " + std::to_string(this->Heights.size()) +
        " texels: got " + std::to_string(apex.size()) + " apexes and " +
        std::to_string(steepness.size()) + " steepnesses");
    }
    this->ConeApex = apex;
    this->ConeSteepness = steepness;
  }

  /// A level of the map's pyramid above the map itself, with its cones.
  struct Level
  {
    int Width;
    int Height;
    std::vector<float> Heights;
    std::vector<unsigned char> ConeApex;
    std::vector<unsigned char> ConeSteepness;
  };
  /// The levels from the first above the map on, and the one that searches look for.
  void SetLevels(std::vector<Level> levels, int searched)
  {
    this->Levels = std::move(levels);
    this->Searched = searched;
  }

  ///@{
  /// The accessors, named as the kernels call them.
  Real fetchHeight(const glm::ivec2& texel) const
  {
    return this->Heights[std::size_t(texel.y) * std::size_t(this->Width) + std::size_t(texel.x)];
  }
  Real sampleHeight(const glm::vec<2, Real>& uv) const
  {
    const Axis column = this->FindTexels(uv.x, this->Width);
    const Axis row = this->FindTexels(uv.y, this->Height);
    const auto between = [&](int y)
    {
      return (1 - column.Weight) * this->fetchHeight({ column.Low, y }) +
        column.Weight * this->fetchHeight({ column.High, y });
    };
    return (1 - row.Weight) * between(row.Low) + row.Weight * between(row.High);
  }
  glm::ivec2 mapSize() const { return { this->Width, this->Height }; }
  int surfaceLevel() const { return this->Searched; }
  glm::ivec2 levelSize(int level) const
  {
    return level == 0 ? this->mapSize()
                      : glm::ivec2(this->Above(level).Width, this->Above(level).Height);
  }
  Real fetchLevel(const glm::ivec2& texel, int level) const
  {
    return level == 0 ? this->fetchHeight(texel)
                      : this->Above(level).Heights[this->At(texel, level)];
  }
  glm::vec<2, Real> fetchCone(const glm::ivec2& texel, int travel, int level) const
  {
    const auto& apex = level == 0 ? this->ConeApex : this->Above(level).ConeApex;
    const auto& steepness = level == 0 ? this->ConeSteepness : this->Above(level).ConeSteepness;
    const std::size_t i = 4 * this->At(texel, level) + std::size_t(travel);
    return { Real(apex.at(i)) / Real(255), Real(steepness.at(i)) / Real(255) };
  }
  int wrapMode() const { return static_cast<int>(this->Wrap); }
  ///@}

private:
  const Level& Above(int level) const { return this->Levels.at(std::size_t(level) - 1); }
  std::size_t At(const glm::ivec2& texel, int level) const
  {
    return std::size_t(texel.y) * std::size_t(this->levelSize(level).x) + std::size_t(texel.x);
  }

  /// The two texels around a map coordinate along one axis, and the upper one's weight.
  struct Axis
  {
    int Low;
    int High;
    Real Weight;
  };

  Axis FindTexels(Real coordinate, int size) const
  {
    Real inMap = 0;
    if (std::isfinite(coordinate))
    {
      const Real period = this->Wrap == MesoWrap::Mirror ? 2 : 1;
      inMap = this->Wrap == MesoWrap::Clamp ? std::min(std::max(coordinate, Real(0)), Real(1))
                                            : coordinate - period * std::floor(coordinate / period);
    }
    const Real texel = inMap * Real(size) - Real(0.5);
    const Real low = std::floor(texel);
    Real weight = texel - low;
    if (this->WeightSteps > 0)
    {
      weight = std::floor(weight * this->WeightSteps + Real(0.5)) / this->WeightSteps;
    }
    return { this->WrapTexel(int(low), size), this->WrapTexel(int(low) + 1, size), weight };
  }

  int WrapTexel(int texel, int size) const
  {
    switch (this->Wrap)
    {
      case MesoWrap::Repeat:
        return (texel % size + size) % size;
      case MesoWrap::Clamp:
        return std::min(std::max(texel, 0), size - 1);
      case MesoWrap::Mirror:
      {
        const int inPeriod = (texel % (2 * size) + 2 * size) % (2 * size);
        return inPeriod < size ? inPeriod : 2 * size - 1 - inPeriod;
      }
    }
    return 0;
  }

  int Width;
  int Height;
  MesoWrap Wrap;
  std::vector<float> Heights;
  std::vector<unsigned char> ConeApex;
  std::vector<unsigned char> ConeSteepness;
  std::vector<Level> Levels;
  int Searched = 0;
  Real WeightSteps = 0;
};

#endif
