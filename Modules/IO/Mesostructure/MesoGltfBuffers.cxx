#include "MesoGltfBuffers.h"

#include "MesoBinaryNumbers.h"
#include "MesoFileBytes.h"
#include "MesoMeshFile.h"
#include "MesoMessage.h"

#include <filesystem>

namespace
{
constexpr double Largest = 2147483647.; // of counts, offsets and numbers
constexpr MesoSceneRange Whole = { 0., Largest, true };

std::size_t IntegerOr(const MesoSceneValue& value, const std::string& key, std::size_t fallback)
{
  value.With(key,
    [&](const MesoSceneValue& number)
    { fallback = static_cast<std::size_t>(number.ToInteger(Whole)); });
  return fallback;
}

int DigitOfHex(char character)
{
  const std::string digits = "0123456789abcdef";
  const std::size_t digit = digits.find(static_cast<char>(character | 0x20));
  return digit == std::string::npos ? -1 : static_cast<int>(digit);
}

/// A URI's text with %20 and the like as the characters they stand for.
std::string Decoded(const std::string& uri)
{
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i)
  {
    const bool isCode = uri[i] == '%' && i + 2 < uri.size() && DigitOfHex(uri[i + 1]) >= 0 &&
      DigitOfHex(uri[i + 2]) >= 0;
    text +=
      isCode ? static_cast<char>(DigitOfHex(uri[i + 1]) * 16 + DigitOfHex(uri[i + 2])) : uri[i];
    i += isCode ? 2 : 0;
  }
  return text;
}

std::string FromBase64(const MesoSceneValue& place, const std::string& text, std::size_t begin)
{
  const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = begin; i < text.size() && text[i] != '='; ++i)
  {
    const std::size_t digit = alphabet.find(text[i]);
    if (digit == std::string::npos)
    {
      place.Fail("character " + std::to_string(i) + " is not base64");
    }
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8)
    {
      count -= 8;
      bytes += static_cast<char>((bits >> count) & 0xff);
    }
  }
  return bytes;
}

/// A type of number: its size, and how it is read.
struct Component
{
  std::size_t Bytes;
  double (*Read)(const char*);
  double Most; ///< by which a normalised integer is divided
};

template <typename T>
Component MakeComponent(double most)
{
  return { sizeof(T),
    [](const char* bytes) { return static_cast<double>(MesoBinaryNumber<T>(bytes, false)); },
    most };
}

Component ComponentOf(const MesoSceneValue& accessor)
{
  const MesoSceneValue type = accessor.At("componentType");
  switch (static_cast<int>(type.ToInteger(Whole)))
  {
    case 5120:
      return MakeComponent<std::int8_t>(127.);
    case 5121:
      return MakeComponent<std::uint8_t>(255.);
    case 5122:
      return MakeComponent<std::int16_t>(32767.);
    case 5123:
      return MakeComponent<std::uint16_t>(65535.);
    case 5125:
      return MakeComponent<std::uint32_t>(4294967295.);
    case 5126:
      return MakeComponent<float>(1.);
    default:
      type.Fail("is no type of number (5120 to 5123, 5125, 5126)");
  }
}
}

MesoSceneValue MesoGltfElement(
  const MesoSceneValue& root, const std::string& key, const MesoSceneValue& index)
{
  const auto number = static_cast<std::size_t>(index.ToInteger(Whole));
  const std::size_t count = root.Has(key) ? root.At(key).ToCount() : 0;
  if (number >= count)
  {
    index.Fail("there is no " + key + "[" + std::to_string(number) + "] (there are " +
      std::to_string(count) + ")");
  }
  return root.At(key).ElementAt(number);
}

MesoGltfBuffers::MesoGltfBuffers(
  const MesoSceneValue& root, const std::string& fileName, std::string binary)
  : Root(root)
  , FileName(fileName)
  , Binary(std::move(binary))
{
}

const std::string& MesoGltfBuffers::Buffer(const MesoSceneValue& index)
{
  const MesoSceneValue buffer = MesoGltfElement(this->Root, "buffers", index);
  const auto number = static_cast<std::size_t>(index.ToInteger(Whole));
  this->Buffers.resize(std::max(this->Buffers.size(), number + 1));
  std::string& bytes = this->Buffers[number];
  const std::size_t length = IntegerOr(buffer, "byteLength", 0);
  if (!bytes.empty() || length == 0)
  {
    return bytes;
  }
  if (!buffer.Has("uri"))
  {
    if (number != 0 || this->Binary.empty())
    {
      buffer.Fail("has no uri, and the file has no binary chunk");
    }
    bytes = std::move(this->Binary);
  }
  else
  {
    const MesoSceneValue uri = buffer.At("uri");
    const std::string text = uri.ToText();
    if (text.compare(0, 5, "data:") == 0)
    {
      const std::size_t data = text.find(";base64,");
      if (data == std::string::npos)
      {
        uri.Fail("holds data that are not base64");
      }
      bytes = FromBase64(uri, text, data + 8);
    }
    else
    {
      const std::filesystem::path folder = std::filesystem::path(this->FileName).parent_path();
      const std::string beside = (folder / Decoded(text)).string();
      const std::string reason = MesoWhyNoFile(beside);
      if (!reason.empty())
      {
        uri.Fail("\"" + MesoPrintable(beside) + "\": " + reason);
      }
      bytes = MesoReadBytes(beside, MesoMeshLargestFile, "a buffer");
    }
  }
  if (bytes.size() < length)
  {
    buffer.Fail("has " + std::to_string(bytes.size()) + " of the " + std::to_string(length) +
      " bytes that byteLength says");
  }
  return bytes;
}

std::vector<double> MesoGltfBuffers::Read(const MesoSceneValue& index, std::size_t components)
{
  const MesoSceneValue accessor = MesoGltfElement(this->Root, "accessors", index);
  const char* const types[] = { "", "SCALAR", "VEC2", "VEC3" };
  if (accessor.At("type").ToText() != types[components])
  {
    accessor.At("type").Fail(std::string("must be ") + types[components]);
  }
  if (accessor.Has("sparse"))
  {
    accessor.At("sparse").Fail("sparse accessors are not read");
  }
  const Component component = ComponentOf(accessor);
  const auto count = static_cast<std::size_t>(accessor.At("count").ToInteger(Whole));
  if (!accessor.Has("bufferView"))
  {
    accessor.Fail("has no bufferView");
  }
  const MesoSceneValue view = MesoGltfElement(this->Root, "bufferViews", accessor.At("bufferView"));
  const std::string& bytes = this->Buffer(view.At("buffer"));
  const std::size_t viewBegin = IntegerOr(view, "byteOffset", 0);
  const std::size_t viewLength = IntegerOr(view, "byteLength", 0);
  if (viewBegin + viewLength > bytes.size())
  {
    view.Fail("ends at byte " + std::to_string(viewBegin + viewLength) + " of a buffer of " +
      std::to_string(bytes.size()));
  }
  const std::size_t size = component.Bytes * components;
  std::size_t stride = IntegerOr(view, "byteStride", 0);
  stride = stride == 0 ? size : stride;
  const std::size_t begin = IntegerOr(accessor, "byteOffset", 0);
  // The numbers above are below 2^31, so that none of this overflows.
  if (stride < size || (count > 0 && begin + stride * (count - 1) + size > viewLength))
  {
    accessor.Fail("its " + std::to_string(count) + " elements go beyond the " +
      std::to_string(viewLength) + " bytes of its bufferView");
  }
  bool isNormalised = false;
  accessor.With(
    "normalized", [&](const MesoSceneValue& value) { isNormalised = value.ToBoolean(); });
  const char* const data = bytes.data() + viewBegin + begin;
  std::vector<double> numbers;
  numbers.reserve(count * components);
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t k = 0; k < components; ++k)
    {
      const double number = component.Read(data + i * stride + k * component.Bytes);
      if (!(std::abs(number) <= MesoMeshLargestNumber))
      {
        accessor.Fail("element " + std::to_string(i) + " is not finite or beyond 1e30");
      }
      numbers.push_back(isNormalised ? std::max(number / component.Most, -1.) : number);
    }
  }
  return numbers;
}
