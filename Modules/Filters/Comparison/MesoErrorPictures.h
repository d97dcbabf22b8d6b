#ifndef MesoErrorPictures_h
#define MesoErrorPictures_h

/**
 * @file MesoErrorPictures.h
 * @brief Errors as pictures to look at.
 */

#include "MesoGeometryError.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkImageData;

using MesoByteColor = std::array<unsigned char, 3>;

/// The colour of a value in [0,1]: from black over violet and orange to a pale yellow, lighter all the
/// way, by 16 colours of the map "magma" (S. van der Walt and N. Smith, CC0), linear between them.
/// Values outside take the ends.
MESOFILTERSCOMPARISON_EXPORT MesoByteColor MesoColorOfError(double value);

MESOFILTERSCOMPARISON_EXPORT MesoByteColor MesoColorOfClass(MesoPixelClass kind);
/// Its name for a legend: "hole", "missing", ...
MESOFILTERSCOMPARISON_EXPORT const char* MesoNameOfClass(MesoPixelClass kind);

/// RGB, unsigned char, row 0 at the bottom as VTK keeps pictures; the map's row 0 is the top.
MESOFILTERSCOMPARISON_EXPORT vtkSmartPointer<vtkImageData> MesoPictureOfErrors(
  const std::vector<float>& errors, int width, int height);
MESOFILTERSCOMPARISON_EXPORT vtkSmartPointer<vtkImageData> MesoPictureOfClasses(
  const std::vector<MesoPixelClass>& classes, int width, int height);

#endif
