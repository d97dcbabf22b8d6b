#ifndef MesoSampling_h
#define MesoSampling_h

/**
 * @file MesoSampling.h
 * @brief Numbers for samples of pixels and directions: even, and the same in every run.
 */

#include "MesoRadicalInverse.h" // for even points

#ifndef GLM_FORCE_SWIZZLE
#define GLM_FORCE_SWIZZLE // as MesoHeightTexture.h asks for
#endif
#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>

/// Numbers in [0,1) that look random, from a seed: the generator splitmix64.
class MesoRandom
{
public:
  explicit MesoRandom(std::uint64_t seed)
    : State(seed)
  {
  }

  double Next()
  {
    this->State += 0x9e3779b97f4a7c15u;
    std::uint64_t bits = this->State;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    bits ^= bits >> 31;
    return static_cast<double>(bits >> 11) * 0x1p-53;
  }

private:
  std::uint64_t State;
};

/// A unit direction on the side of `normal` (unit), as dense as its cosine, from numbers in [0,1).
inline glm::dvec3 MesoCosineDirection(const glm::dvec3& normal, double u, double v)
{
  const glm::dvec3 away =
    std::abs(normal.x) < 0.6 ? glm::dvec3(1., 0., 0.) : glm::dvec3(0., 1., 0.);
  const glm::dvec3 tangent = glm::normalize(glm::cross(normal, away));
  const double azimuth = 2. * 3.14159265358979323846 * u;
  const double sine = std::sqrt(v);
  return sine * (std::cos(azimuth) * tangent + std::sin(azimuth) * glm::cross(normal, tangent)) +
    std::sqrt(1. - v) * normal;
}

#endif
