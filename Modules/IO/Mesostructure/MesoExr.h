#ifndef MesoExr_h
#define MesoExr_h

/**
 * @file MesoExr.h
 * @brief OpenEXR files of named float channels, as AOVs are kept in.
 */

#include "MesoImageFile.h" // for MesoImageAttribute and the limits

/// Texts and numbers beside the pixels, by name.
using MesoExrAttributes = std::map<std::string, MesoImageAttribute>;

/// Channels of a file, row 0 = top, interleaved.
struct MesoExrImage
{
  int Width = 0;
  int Height = 0;
  std::vector<std::string> ChannelNames;
  std::vector<float> Data; ///< Width * Height * ChannelNames.size(), as in the file: also NaN
  MesoExrAttributes Attributes;

  /// A pixel of a channel, by numbers from 0; row 0 is the top.
  float At(int column, int row, std::size_t channel) const
  {
    return this
      ->Data[(std::size_t(row) * this->Width + column) * this->ChannelNames.size() + channel];
  }
};

/**
 * Write a float OpenEXR file, whole or not at all. The same arguments give the same bytes.
 *
 * @param width,height 1 to MesoImageLargestSide
 * @param channelNames not empty, all different; the file keeps them sorted, so read by name
 * @param data width * height * channelNames.size() values, row 0 = top, interleaved
 * @param attributes texts and numbers (as double) to keep beside the pixels
 * Throws MesoInputError "file: reason".
 */
MESOIOMESOSTRUCTURE_EXPORT void MesoWriteExr(const std::string& fileName, int width, int height,
  const std::vector<std::string>& channelNames, const float* data,
  const MesoExrAttributes& attributes = {});

/**
 * Read channels of an OpenEXR file (or another image of float values) by name, in the order given;
 * without names, all in the order of MesoImageHeader::ChannelNames. Throws MesoInputError where a
 * channel is not there, naming those that are.
 */
MESOIOMESOSTRUCTURE_EXPORT MesoExrImage MesoReadExr(
  const std::string& fileName, const std::vector<std::string>& channelNames = {});

#endif
