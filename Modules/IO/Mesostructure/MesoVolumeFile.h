#ifndef MesoVolumeFile_h
#define MesoVolumeFile_h

/**
 * @file MesoVolumeFile.h
 * @brief Volumes as their files hold them: VTI, NRRD, MetaImage, TIFF of several images.
 */

#include "MesoImageReport.h"           // for the seam
#include "mesoIOMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;

/// .vti, .nrrd, .nhdr, .mhd, .mha, .tif, .tiff.
MESOIOMESOSTRUCTURE_EXPORT const std::vector<std::string>& MesoVolumeExtensions();

/// What is asked of each sample of a volume's file.
enum class MesoSamples
{
  Numbers, ///< one number; of a VTI file's several the first counts
  Colors   ///< red, green and blue, and what there is more: VTI and TIFF files have them
};

/**
 * Read a volume, by the end of its name: numbers of the file's type, the spacing of its samples, x fastest.
 * The images of a TIFF file are its slices from z = 0 upwards, the last row of each at y = 0.
 *
 * Throws MesoInputError "file: reason" where there is no such file, it is of none of the formats, larger
 * than 4096 samples a side or 2 GiB, damaged, or has more dimensions than three; or, of TIFF files, has other
 * channels than are asked for.
 */
MESOIOMESOSTRUCTURE_EXPORT vtkSmartPointer<vtkImageData> MesoReadVolumeFile(
  const std::string& fileName, MesoSamples samples = MesoSamples::Numbers);

struct MesoVolumeReport
{
  std::array<int, 3> Size;
  std::array<double, 3> Spacing;
  std::string Type;
  double Least = 0.; ///< of the finite numbers, first component
  double Most = 0.;
  double Mean = 0.;
  std::size_t NotFinite = 0;
  /// The number that parts the others best into two groups (Otsu1979): a threshold where none is given.
  double Parting = 0.;
  std::array<MesoTilingReport, 2> Tiling; ///< over the border in x, in y
};

/// Counts what is in a volume.
MESOIOMESOSTRUCTURE_EXPORT MesoVolumeReport MesoReportVolume(vtkImageData* volume);

#endif
