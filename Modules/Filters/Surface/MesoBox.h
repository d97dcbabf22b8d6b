#ifndef MesoBox_h
#define MesoBox_h

#ifndef GLM_FORCE_SWIZZLE
#define GLM_FORCE_SWIZZLE // before the first header of GLM, as the kernels need it
#endif
#include <glm/glm.hpp>

/// A box, of points in any space.
struct MesoBox
{
  glm::dvec3 Low;
  glm::dvec3 High;
};

#endif
