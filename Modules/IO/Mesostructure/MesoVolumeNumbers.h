#ifndef MesoVolumeNumbers_h
#define MesoVolumeNumbers_h

/**
 * @file MesoVolumeNumbers.h
 * @brief The numbers of a volume's file, as its header says they are stored.
 */

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <array>
#include <string>

class vtkImageData;

/// Samples a side, and bytes of a volume in memory, at most; checked before memory is taken.
constexpr int MesoVolumeLargestSide = 4096;
constexpr std::uint64_t MesoVolumeMostBytes = std::uint64_t(2) << 30;

struct MesoVolumeHeader
{
  enum class Coding
  {
    Raw,
    Gzip, ///< or zlib
    Text
  };
  std::array<int, 3> Size = { 0, 0, 0 };
  std::array<double, 3> Spacing = { 1., 1., 1. };
  int Type = VTK_VOID; ///< of VTK's
  bool IsBigEndian = false;
  Coding Encoding = Coding::Raw;
};

/**
 * The image of a header and of the bytes that it speaks of. Throws MesoInputError "file: reason" where the
 * header makes no sense, or the numbers are fewer or more than it says.
 */
vtkSmartPointer<vtkImageData> MesoDecodeVolume(
  const MesoVolumeHeader& header, const std::string& bytes, const std::string& fileName);

#endif
