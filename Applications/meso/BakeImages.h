#ifndef BakeImages_h
#define BakeImages_h

#include <string>

class vtkImageData;

/**
 * Write a point array of an image as an image file: PNG, TIFF or OpenEXR as the name ends
 * (MesoWriteImage). Values are written as value * factor + offset, of which [0,1] is what 8 and 16
 * bits hold; what is beyond is cut off there.
 *
 * @param bits 8, 16, or 32 for float
 */
void BakeWriteImage(const std::string& fileName, vtkImageData* image, const std::string& array,
  int bits, double factor = 1., double offset = 0.);

/// Bits that suit a file's name: 32 for .exr, else those given.
int BakeBitsFor(const std::string& fileName, int bits);

#endif
