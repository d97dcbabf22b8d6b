#ifndef MesoImageFile_h
#define MesoImageFile_h

/**
 * @file MesoImageFile.h
 * @brief Images in the precision and with the channels that their files have.
 *
 * All that OpenImageIO reads; values are those of the file: no color conversion, no multiplication
 * by alpha. An image's file may hold more images than one, of which the first is read.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

/// Pixels in either direction, at most; checked before memory is taken.
constexpr int MesoImageLargestSide = 16384;
/// Bytes of an image in memory, at most; checked before memory is taken.
constexpr std::uint64_t MesoImageMostBytes = std::uint64_t(4) << 30;

using MesoImageAttribute = std::variant<std::string, double>;

struct MesoImageHeader
{
  enum class Type
  {
    UnsignedChar,
    UnsignedShort,
    Float ///< also for files of half and of double
  };
  int Width = 0;
  int Height = 0;
  Type ValueType = Type::UnsignedChar;
  /// "Y", "R", "G", "B", "A" or as the file names them. OpenImageIO puts an OpenEXR file's color
  /// first and sorts the others.
  std::vector<std::string> ChannelNames;
  std::string Format;           ///< of the file: "png", "tiff", "openexr", ...
  std::string StoredType;       ///< "uint8", "uint16", "half", "float" or "double"
  bool HasColorProfile = false; ///< an ICC profile, which is left alone
  std::map<std::string, MesoImageAttribute> Attributes; ///< texts and numbers of the file
  std::vector<std::string> Notes;                       ///< what is odd about it, a line each

  std::size_t NumberOfValues() const
  {
    return std::size_t(this->Width) * std::size_t(this->Height) * this->ChannelNames.size();
  }
  std::size_t BytesPerValue() const
  {
    return this->ValueType == Type::UnsignedChar ? 1 : this->ValueType == Type::Float ? 4 : 2;
  }
};

/// An image file that is open for reading.
class MESOIOMESOSTRUCTURE_EXPORT MesoImageInput
{
public:
  /// Opens the file and reads what precedes the pixels. Throws MesoInputError "file: reason" where
  /// it is no image, a volume, over the limits, or has integers of more than 16 bits or a sign.
  explicit MesoImageInput(const std::string& fileName);
  ~MesoImageInput();
  MesoImageInput(const MesoImageInput&) = delete;
  MesoImageInput& operator=(const MesoImageInput&) = delete;

  const MesoImageHeader& Header() const { return this->Description; }

  enum class RowOrder
  {
    TopFirst,
    BottomFirst
  };
  /// Reads all pixels, channels interleaved, NumberOfValues() of ValueType. Throws MesoInputError
  /// where the file is truncated or damaged.
  void Read(void* pixels, RowOrder order) { this->Read(pixels, order, 0); }

  /// The images that the file holds, counted up to one more than `most`.
  int CountImages(int most);
  /// The same of the image of that number, counted from 0. Throws MesoInputError too where it is of
  /// another size or type than the first.
  void Read(void* pixels, RowOrder order, int image);

private:
  class File;
  std::string FileName;
  std::unique_ptr<File> Implementation;
  MesoImageHeader Description;
};

/**
 * Writes a float OpenEXR file (ZIP compressed, in place; MesoWriteExr is the one to call). `data`
 * is interleaved with the top row first. The same arguments give the same bytes.
 * @return what went wrong, or an empty string.
 */
std::string MesoEncodeExr(const std::string& fileName, int width, int height,
  const std::vector<std::string>& channelNames, const float* data,
  const std::map<std::string, MesoImageAttribute>& attributes);

/**
 * Writes an image, whole or not at all: PNG (8 or 16 bit), TIFF (either, or float) or OpenEXR (float),
 * as the name ends. The same arguments give the same bytes.
 *
 * @param width,height 1 to MesoImageLargestSide
 * @param channels 1 (grey) to 4
 * @param data width * height * channels values, interleaved, the top row first; [0,1] stands for
 *   what the integers hold, and what is beyond is cut off
 * Throws MesoInputError "file: reason".
 */
MESOIOMESOSTRUCTURE_EXPORT void MesoWriteImage(const std::string& fileName, int width, int height,
  int channels, MesoImageHeader::Type type, const float* data);

#endif
