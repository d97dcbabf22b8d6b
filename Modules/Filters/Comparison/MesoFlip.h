#ifndef MesoFlip_h
#define MesoFlip_h

/**
 * @file MesoFlip.h
 * @brief FLIP: how large a difference between two pictures looks when they are flipped through.
 *
 * Andersson2020, for pictures of low dynamic range. The colour pipeline blurs colours as the eye blurs
 * them at the given distance, takes their distance (HyAB) in Hunt-adjusted L*a*b* and maps it to [0,1].
 * The feature pipeline measures how edges and points of the luminance differ. The error is that of
 * colour to the power of 1 - that of features.
 *
 * The value is 0 where the surroundings are equal and at most 1; it does not change when the two
 * pictures change places. Outside the picture the nearest pixel stands.
 */

#include "MesoPicture.h"

/**
 * The error of each pixel, row 0 = top, each in [0,1].
 *
 * @param truth,test of one size; throws MesoInputError where they are not
 * @param pixelsPerDegree of the visual field, > 0: 67 is 0.7 m from a screen of 3840 pixels on 0.7 m
 */
MESOFILTERSCOMPARISON_EXPORT std::vector<float> MesoFlip(
  const MesoPicture& truth, const MesoPicture& test, double pixelsPerDegree = 67.);

#endif
