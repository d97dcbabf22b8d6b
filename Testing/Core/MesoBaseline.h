#ifndef MesoBaseline_h
#define MesoBaseline_h

/**
 * @file MesoBaseline.h
 * @brief Compare a picture with the baseline of the same name that is kept in the repository.
 *
 *   EXPECT_TRUE(MesoCompareWithBaseline(window, "TestReliefPlane"));
 *
 * The baseline is <baseline folder>/<name>.png. Where the picture is not within the limits, or
 * there is no baseline, the test fails and <output folder>/<name>.png is written, with
 * <name>.diff.png (the difference times 16) where there are two of the same size; the message says
 * the paths. With MESO_UPDATE_BASELINES=1 in the environment the picture becomes the baseline and
 * the test passes.
 */

#include "MesoImageDifference.h"

#include "vtkSmartPointer.h" // for images

#include <gtest/gtest.h> // for AssertionResult
#include <string>        // for names

class vtkImageData;
class vtkRenderWindow;

struct MesoTestFolders
{
  std::string Baseline; ///< Testing/<Room>/Baseline of the source tree
  std::string Output;   ///< in the build tree
};

/// Compares an 8-bit image with the baseline.
testing::AssertionResult MesoCompareWithBaseline(vtkImageData* image, const std::string& name,
  const MesoImageLimits& limits, const MesoTestFolders& folders);

/// Renders the window and gives its pixels: RGB, or RGBA.
vtkSmartPointer<vtkImageData> MesoGrabWindow(vtkRenderWindow* window, bool alpha = false);

#ifdef MESO_BASELINE_FOLDER // set by meso_add_rendering_test
/// With the folders of this test program.
inline testing::AssertionResult MesoCompareWithBaseline(
  vtkImageData* image, const std::string& name, const MesoImageLimits& limits = {})
{
  return MesoCompareWithBaseline(image, name, limits, { MESO_BASELINE_FOLDER, MESO_OUTPUT_FOLDER });
}

/// Renders the window and compares its RGB pixels, with the folders of this test program.
inline testing::AssertionResult MesoCompareWithBaseline(
  vtkRenderWindow* window, const std::string& name, const MesoImageLimits& limits = {})
{
  return MesoCompareWithBaseline(MesoGrabWindow(window), name, limits);
}
#endif

#endif
