#ifndef MesoHeightTexture_h
#define MesoHeightTexture_h

/**
 * @class MesoHeightTexture
 * @brief A height map in memory, read as a shader reads its texture.
 *
 * Offers the four accessors that the kernel HeightField.glsl asks for, and fetchCone that HeightCone.glsl
 * asks for; Real is the number that the kernels around it compute with. Heights are in [0,1], row by row, row 0 at map coordinate v = 0;
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
  glm::vec<2, Real> fetchCone(const glm::ivec2& texel, int travel) const
  {
    const std::size_t i =
      4 * (std::size_t(texel.y) * std::size_t(this->Width) + std::size_t(texel.x)) +
      std::size_t(travel);
    return { Real(this->ConeApex.at(i)) / Real(255), Real(this->ConeSteepness.at(i)) / Real(255) };
  }
  int wrapMode() const { return static_cast<int>(this->Wrap); }
  ///@}

private:
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
  Real WeightSteps = 0;
};

#endif
