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
#include <string_view>

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
  std::size_t SkippedLines = 0; ///< before the numbers
  std::size_t SkippedBytes = 0; ///< behind these lines
  bool IsAtEnd = false;         ///< the numbers, where they are raw, are the last bytes
};

/**
 * The image of a header, whose size and type have been checked, and of the bytes that it speaks of, behind which
 * there is a 0. Throws MesoInputError "file: reason" where the spacing makes no sense, the numbers are fewer than it
 * says, or, compressed or as text, more.
 */
vtkSmartPointer<vtkImageData> MesoDecodeVolume(
  const MesoVolumeHeader& header, std::string_view bytes, const std::string& fileName);

#endif
