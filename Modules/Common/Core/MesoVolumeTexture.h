#ifndef MesoVolumeTexture_h
#define MesoVolumeTexture_h

/**
 * @class MesoVolumeTexture
 * @brief A volume of signed distances in memory, read as a shader reads its texture.
 *
 * Offers the accessors that the kernel Volume.glsl asks for; Real is the number that the kernels around
 * it compute with. Voxel centres lie at (i + 0.5) / size; x runs fastest. x and y repeat, z ends at its
 * outermost voxels. Constant after construction, so threads may share it.
 *
 * @sa MesoKernels.h
 */

#ifndef GLM_FORCE_SWIZZLE
#define GLM_FORCE_SWIZZLE // before the first header of GLM: v.xy()
#endif
#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

template <typename Real>
class MesoVolumeTexture
{
public:
  /// Throws std::invalid_argument unless there is a distance for each voxel, and at least one voxel.
  MesoVolumeTexture(const std::array<int, 3>& size, std::vector<float> distances)
    : Size(size[0], size[1], size[2])
    , Distances(std::move(distances))
  {
    if (size[0] < 1 || size[1] < 1 || size[2] < 1 ||
      this->Distances.size() != std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]))
    {
      throw std::invalid_argument("a volume needs one distance for each voxel");
    }
  }

  glm::ivec3 volumeSize() const { return this->Size; }

  Real fetchVolume(const glm::ivec3& voxel) const
  {
    return Real(
      this->Distances[(std::size_t(voxel.z) * this->Size.y + voxel.y) * this->Size.x + voxel.x]);
  }

  Real sampleVolume(const glm::vec<3, Real>& place) const
  {
    Real sum = 0;
    glm::ivec3 low;
    glm::vec<3, Real> weight;
    for (int axis = 0; axis < 3; ++axis)
    {
      const Real at = place[axis] * Real(this->Size[axis]) - Real(0.5);
      low[axis] = static_cast<int>(std::floor(at));
      weight[axis] = at - std::floor(at);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      glm::ivec3 voxel;
      Real part = 1;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int up = (corner >> axis) & 1;
        const int size = this->Size[axis];
        const int i = low[axis] + up;
        voxel[axis] = axis == 2 ? (i < 0          ? 0
                                      : i >= size ? size - 1
                                                  : i)
                                : ((i % size) + size) % size;
        part *= up ? weight[axis] : 1 - weight[axis];
      }
      sum += part * this->fetchVolume(voxel);
    }
    return sum;
  }

private:
  glm::ivec3 Size;
  std::vector<float> Distances;
};

#endif
