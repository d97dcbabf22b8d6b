#ifndef MesoPicture_h
#define MesoPicture_h

/**
 * @file MesoPicture.h
 * @brief Colour pictures as the figures of error take them.
 */

#include "mesoFiltersComparisonModule.h" // for export macro

#include <cstddef>
#include <string>
#include <vector>

class vtkImageData;

/// Red, green, blue as stored (encoded as sRGB), each in [0,1]; row 0 = top.
struct MesoPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<float> Rgb; ///< 3 * Width * Height

  std::size_t NumberOfPixels() const { return std::size_t(this->Width) * this->Height; }
};

/**
 * The picture of an image of one slice whose row 0 is the bottom, as VTK keeps pictures: unsigned
 * char or unsigned short, of 1 component (grey), 3 (RGB) or 4 (RGBA, all opaque). Throws
 * MesoInputError with the reason for any other.
 */
MESOFILTERSCOMPARISON_EXPORT MesoPicture MesoPictureOfImage(vtkImageData* image);

/// The picture of an image file of 8 or 16 bits. Throws MesoInputError "file: reason" where it cannot
/// be read, or as MesoPictureOfImage() does.
MESOFILTERSCOMPARISON_EXPORT MesoPicture MesoReadPicture(const std::string& fileName);

/// Linear light of a value that is encoded as sRGB (IEC 61966-2-1), both in [0,1].
MESOFILTERSCOMPARISON_EXPORT double MesoLinearOfSRGB(double encoded);

#endif
