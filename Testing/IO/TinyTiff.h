#ifndef TinyTiff_h
#define TinyTiff_h

// TIFF files of several images, byte by byte: 8 bits a number, one strip an image, not compressed.

#include "MessageOf.h" // for BytesOf

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct TinyTiffImage
{
  std::uint32_t Width;
  std::uint32_t Height;
  std::uint16_t Channels;
  std::string Numbers; ///< rows from the top
};

inline std::string TinyTiff(const std::vector<TinyTiffImage>& images)
{
  std::string bytes = std::string("II*\0", 4) + BytesOf(std::uint32_t(8));
  for (const TinyTiffImage& image : images)
  {
    // A directory, and behind it the bits of its channels and the numbers.
    const std::array<std::array<std::uint32_t, 3>, 9> entries = { { { 256, 4, image.Width },
      { 257, 4, image.Height }, { 258, 3, 8 }, { 259, 3, 1 },
      { 262, 3, image.Channels < 3 ? 1u : 2u }, { 273, 4, 0 }, { 277, 3, image.Channels },
      { 278, 4, image.Height }, { 279, 4, static_cast<std::uint32_t>(image.Numbers.size()) } } };
    const auto behind = static_cast<std::uint32_t>(bytes.size() + 2 + 12 * entries.size() + 4);
    const std::uint32_t numbers = behind + 2u * image.Channels;
    bytes += BytesOf(static_cast<std::uint16_t>(entries.size()));
    for (const auto& [tag, type, value] : entries)
    {
      const bool isBits = tag == 258 && image.Channels > 2; // which do not fit into the entry
      bytes += BytesOf(static_cast<std::uint16_t>(tag)) +
        BytesOf(static_cast<std::uint16_t>(type)) +
        BytesOf(tag == 258 ? std::uint32_t(image.Channels) : std::uint32_t(1)) +
        BytesOf(isBits   ? behind
            : tag == 273 ? numbers
                         : value);
    }
    const bool isLast = &image == &images.back();
    bytes += BytesOf(
      isLast ? std::uint32_t(0) : numbers + static_cast<std::uint32_t>(image.Numbers.size()));
    for (int channel = 0; channel < image.Channels; ++channel)
    {
      bytes += BytesOf(std::uint16_t(8));
    }
    bytes += image.Numbers;
  }
  return bytes;
}

#endif
