#ifndef MesoGDMTexels_h
#define MesoGDMTexels_h

/**
 * @class MesoGDMTexels
 * @brief A table of distances through a volume in memory, read as a shader reads its textures.
 *
 * Offers the accessors that the kernels GDMTable, GDMFactors and GDMWhole ask for; Real is the number that
 * the kernels around it compute with. Constant after construction, so threads may share it.
 *
 * @sa MesoKernels.h, vtkMesoGDMTable
 */

#ifndef GLM_FORCE_SWIZZLE
#define GLM_FORCE_SWIZZLE // before the first header of GLM: v.xy()
#endif
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

template <typename Real>
class MesoGDMTexels
{
public:
  using Vector2 = glm::vec<2, Real>;
  using Vector4 = glm::vec<4, Real>;

  /**
   * @param size W, H, D
   * @param directions azimuths, polars
   * @param even equal steps of cos(theta)
   * @param rank products, a multiple of four; 0: the whole table
   * @param weights (phi, y, x) tuples of `rank` weights; or, where rank is 0, of polars x D distances
   * @param functions (theta, z) tuples of `rank` numbers
   */
  MesoGDMTexels(const glm::ivec3& size, const glm::ivec2& directions, bool even, int rank,
    std::vector<float> weights, std::vector<float> functions = {})
    : Size(size)
    , Directions(directions)
    , Even(even)
    , Rank(rank)
    , Weights(std::move(weights))
    , Functions(std::move(functions))
  {
    const auto rows = std::size_t(size.x) * std::size_t(size.y) * std::size_t(directions.x);
    const auto columns = std::size_t(directions.y) * std::size_t(size.z);
    if (size.x < 1 || size.y < 1 || size.z < 2 || directions.x < 1 || directions.y < 2 ||
      rank % 4 != 0 || this->Weights.size() != rows * (rank > 0 ? std::size_t(rank) : columns) ||
      this->Functions.size() != columns * std::size_t(rank))
    {
      throw std::invalid_argument("a table's numbers are not as many as its size asks for");
    }
  }

  ///@{
  /// The accessors, named as the kernels call them.
  glm::ivec3 gdmSize() const { return this->Size; }
  glm::ivec2 gdmDirections() const { return this->Directions; }
  bool gdmEven() const { return this->Even; }
  int gdmGroups() const { return this->Rank / 4; }

  Vector4 gdmWeights(int group, const Vector2& tile, Real azimuth) const
  {
    const Axis x = Repeated(tile.x * Real(this->Size.x) - Real(0.5), this->Size.x);
    const Axis y = Repeated(tile.y * Real(this->Size.y) - Real(0.5), this->Size.y);
    const Axis phi = Repeated(azimuth, this->Directions.x);
    const auto inSlice = [&](int slice)
    {
      const auto inRow = [&](int row)
      {
        return (1 - x.Weight) * this->Weight(group, x.Low, row, slice) +
          x.Weight * this->Weight(group, x.High, row, slice);
      };
      return (1 - y.Weight) * inRow(y.Low) + y.Weight * inRow(y.High);
    };
    return (1 - phi.Weight) * inSlice(phi.Low) + phi.Weight * inSlice(phi.High);
  }

  Vector4 gdmFunctions(int group, Real polar, Real level) const
  {
    const Axis theta = Clamped(polar, this->Directions.y);
    const Axis z = Clamped(level, this->Size.z);
    const auto at = [&](int t)
    {
      return (1 - z.Weight) * this->Function(group, t, z.Low) +
        z.Weight * this->Function(group, t, z.High);
    };
    return (1 - theta.Weight) * at(theta.Low) + theta.Weight * at(theta.High);
  }

  Real fetchGDM(const glm::ivec3& point, const glm::ivec2& direction) const
  {
    const std::size_t columns = std::size_t(this->Directions.y) * std::size_t(this->Size.z);
    return Real(this->Weights[this->Row(point.x, point.y, direction.x) * columns +
      std::size_t(direction.y) * std::size_t(this->Size.z) + std::size_t(point.z)]);
  }
  ///@}

private:
  struct Axis
  {
    int Low;
    int High;
    Real Weight; ///< of High
  };

  static Axis Repeated(Real place, int count)
  {
    const Real low = std::floor(place);
    const int wrapped = (int(low) % count + count) % count;
    return { wrapped, (wrapped + 1) % count, place - low };
  }

  static Axis Clamped(Real place, int count)
  {
    const Real inside = std::min(std::max(place, Real(0)), Real(count - 1));
    const int low = std::min(int(inside), count - 2);
    return { low, low + 1, inside - Real(low) };
  }

  std::size_t Row(int x, int y, int azimuth) const
  {
    return (std::size_t(azimuth) * std::size_t(this->Size.y) + std::size_t(y)) *
      std::size_t(this->Size.x) +
      std::size_t(x);
  }

  static Vector4 Four(const float* numbers)
  {
    return { Real(numbers[0]), Real(numbers[1]), Real(numbers[2]), Real(numbers[3]) };
  }
  Vector4 Weight(int group, int x, int y, int azimuth) const
  {
    return Four(this->Weights.data() + this->Row(x, y, azimuth) * std::size_t(this->Rank) +
      std::size_t(4 * group));
  }
  Vector4 Function(int group, int polar, int level) const
  {
    const std::size_t column = std::size_t(polar) * std::size_t(this->Size.z) + std::size_t(level);
    return Four(this->Functions.data() + column * std::size_t(this->Rank) + std::size_t(4 * group));
  }

  glm::ivec3 Size;
  glm::ivec2 Directions;
  bool Even;
  int Rank;
  std::vector<float> Weights;
  std::vector<float> Functions;
};

#endif
