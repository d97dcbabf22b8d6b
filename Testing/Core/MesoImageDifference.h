#ifndef MesoImageDifference_h
#define MesoImageDifference_h

/**
 * @file MesoImageDifference.h
 * @brief Compare two 8-bit images pixel by pixel, strictly.
 *
 * Each pixel is compared with the pixel in the same place: no shift, no averaging, no greyscale. A
 * pixel's difference is the largest of its channels', in units of 1/255. (VTK 9.1's comparator
 * allows a shift of 2 pixels, averages 3x3 and overlooks differences below 105: it passes an image
 * that is 40 % brighter.)
 */

#include "vtkSmartPointer.h" // for the picture of the difference
#include "vtkType.h"         // for vtkIdType

#include <string> // for reasons

class vtkImageData;

/**
 * How much two images may differ, in two steps, so that a test's picture holds on llvmpipe and on
 * hardware alike:
 * - Small: rounding and filtering differ between drivers by 1 or 2 steps of 255 anywhere, and by
 *   more at creases and texel edges: more than SmallDifference in at most SmallFraction of the
 *   pixels (90 of 300x300).
 * - Large: a pixel at a silhouette may be covered by one rasteriser and not by the other, which is
 *   as large a difference as there is, but seldom: more than LargeDifference in at most
 *   LargeFraction of the pixels (9 of 300x300), which a wrong patch of 5x5 pixels is beyond.
 */
struct MesoImageLimits
{
  int SmallDifference = 2;
  double SmallFraction = 1e-3;
  int LargeDifference = 32;
  double LargeFraction = 1e-4;

  /// No difference at all.
  static MesoImageLimits Exact() { return { 0, 0., 0, 0. }; }
};

struct MesoImageDifference
{
  /// Why the images cannot be compared (size, channels, type); empty where they can.
  std::string Problem;
  vtkIdType Pixels = 0;
  vtkIdType SmallPixels = 0;  ///< pixels that differ by more than SmallDifference
  vtkIdType LargePixels = 0;  ///< pixels that differ by more than LargeDifference
  int ChannelMaximum[4] = {}; ///< largest difference in each channel, 0 to 255
  double Mean = 0.;           ///< mean over all values of all channels, 0 to 255
  bool Within = false;        ///< comparable and within the limits

  /// One line with all of it.
  std::string Describe() const;
};

/// Compares two images of unsigned char with 1 to 4 channels and the same dimensions.
MesoImageDifference MesoCompareImages(
  vtkImageData* image, vtkImageData* expected, const MesoImageLimits& limits = {});

/// The same with two PNG files. A file that cannot be read is a Problem.
MesoImageDifference MesoCompareImageFiles(
  const std::string& image, const std::string& expected, const MesoImageLimits& limits = {});

/// |image - expected| in each channel times 16 (so that 2 of 255 can be seen), without alpha. The
/// images must be comparable.
vtkSmartPointer<vtkImageData> MesoDifferencePicture(vtkImageData* image, vtkImageData* expected);

///@{
/// PNG files. Read gives null where the file is not there or is not a PNG. Write makes the folder,
/// writes beside and renames, and is false where that fails.
vtkSmartPointer<vtkImageData> MesoReadPNG(const std::string& path);
bool MesoWritePNG(vtkImageData* image, const std::string& path);
///@}

#endif
