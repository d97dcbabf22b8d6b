#ifndef MesoPushPull_h
#define MesoPushPull_h

/**
 * @file MesoPushPull.h
 * @brief Fills what is unknown in a map from what is known around it (Gortler et al. 1996).
 *
 * The known values are averaged down a pyramid, and what is unknown is read bilinearly from the next
 * coarser level, from the coarsest down: smooth, and close to the known values' border near it.
 */

#include "mesoFiltersSurfaceModule.h" // for export macro

#include <vector>

/**
 * Known values stay as they are. Where nothing is known nothing is changed.
 *
 * @param values width * height * components, interleaved, row by row
 * @param known a texel each
 */
MESOFILTERSSURFACE_EXPORT void MesoPushPull(std::vector<float>& values, int components,
  const std::vector<bool>& known, int width, int height);

#endif
