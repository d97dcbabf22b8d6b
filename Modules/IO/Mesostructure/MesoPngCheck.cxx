#include "MesoPngCheck.h"

#include "MesoBinaryNumbers.h"
#include "MesoMessage.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <vector>

namespace
{
constexpr std::size_t SignatureBytes = 8;
const char* const Signature = "\x89PNG\r\n\x1a\n";

/// The remainders of a byte by the polynomial of CRC-32 (ISO 3309), which PNG uses.
std::array<std::uint32_t, 256> MakeRemainders()
{
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte)
  {
    std::uint32_t remainder = byte;
    for (int bit = 0; bit < 8; ++bit)
    {
      remainder = (remainder >> 1) ^ ((remainder & 1) != 0 ? 0xedb88320u : 0u);
    }
    table[byte] = remainder;
  }
  return table;
}

std::uint32_t Checksum(const std::vector<char>& bytes)
{
  static const std::array<std::uint32_t, 256> remainders = MakeRemainders();
  std::uint32_t sum = 0xffffffffu;
  for (char byte : bytes)
  {
    sum = (sum >> 8) ^ remainders[(sum ^ static_cast<unsigned char>(byte)) & 0xffu];
  }
  return ~sum;
}

std::string At(std::size_t position, const std::string& reason)
{
  return "byte " + std::to_string(position) + ": " + reason;
}
}

std::string MesoPngProblem(const std::string& fileName)
{
  std::ifstream file(fileName, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::size_t>(std::max<std::streamoff>(file.tellg(), 0));
  file.seekg(0);
  char head[SignatureBytes] = {};
  file.read(head, SignatureBytes);
  if (!file || std::string(head, SignatureBytes) != std::string(Signature, SignatureBytes))
  {
    return {};
  }
  std::size_t position = SignatureBytes;
  constexpr std::size_t frame = 12; // length, name and checksum
  std::string name;
  std::vector<char> content; // name and data, of which the checksum is
  while (name != "IEND")
  {
    if (position + frame > size)
    {
      return At(size, "the file ends before its last chunk");
    }
    char number[4];
    file.read(number, sizeof(number));
    const std::size_t length = MesoBinaryNumber<std::uint32_t>(number, true);
    if (length > size - position - frame)
    {
      return At(size, "the file ends in the chunk that begins at byte " + std::to_string(position));
    }
    content.resize(4 + length);
    file.read(content.data(), static_cast<std::streamsize>(content.size()));
    file.read(number, sizeof(number));
    name.assign(content.data(), 4);
    if (!file || MesoBinaryNumber<std::uint32_t>(number, true) != Checksum(content))
    {
      return At(position, "the chunk \"" + MesoPrintable(name) + "\" has a wrong checksum");
    }
    const bool isFirst = position == SignatureBytes;
    constexpr std::size_t headerLength = 13;
    if (isFirst && (name != "IHDR" || length != headerLength))
    {
      return At(position, "the first chunk is not a header");
    }
    if (isFirst &&
      (MesoBinaryNumber<std::uint32_t>(content.data() + 4, true) == 0 ||
        MesoBinaryNumber<std::uint32_t>(content.data() + 8, true) == 0))
    {
      return "has no pixels";
    }
    position += frame + length;
  }
  return {};
}
