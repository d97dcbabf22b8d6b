#ifndef MesoSsim_h
#define MesoSsim_h

/**
 * @file MesoSsim.h
 * @brief SSIM: how alike the structure of two pictures is around each pixel.
 *
 * WangZ2004, with its constants K1 = 0.01, K2 = 0.03 and its window, a Gaussian of
 * 1.5 pixels cut to 11x11. Values are luma: 0.2126 R + 0.7152 G + 0.0722 B of linear light, to which
 * stored values are decoded as sRGB; the range L is 1. At the picture's edge the part of the window
 * that lies inside counts.
 */

#include "MesoPicture.h"

/// The index of each pixel, row 0 = top: 1 where the surroundings are equal, at least -1. Throws
/// MesoInputError where the pictures differ in size.
MESOFILTERSCOMPARISON_EXPORT std::vector<float> MesoSsim(
  const MesoPicture& truth, const MesoPicture& test);

#endif
