#ifndef MesoPictureError_h
#define MesoPictureError_h

#include "MesoPicture.h"

#include <limits>

/// Figures of error of a picture against the true one; see MesoComparePictures().
struct MesoPictureError
{
  double FlipMean = std::numeric_limits<double>::quiet_NaN();
  double Ssim = std::numeric_limits<double>::quiet_NaN();
  double Rmse = std::numeric_limits<double>::quiet_NaN();
  std::vector<float> FlipMap; ///< of every pixel, whether it counts or not; row 0 = top
};

/**
 * Compare two pictures of one size. `FlipMean` (MesoFlip(), 67 pixels per degree) and `Ssim`
 * (MesoSsim()) are means over pixels, `Rmse` is the root of the mean squared difference of linear
 * red, green and blue (stored values decoded as sRGB).
 *
 * @param counts for each pixel whether the means take it in; empty for all. Where none is, the
 * figures are not a number.
 * Throws MesoInputError where sizes differ.
 */
MESOFILTERSCOMPARISON_EXPORT MesoPictureError MesoComparePictures(
  const MesoPicture& truth, const MesoPicture& test, const std::vector<bool>& counts = {});

#endif
