#ifndef MesoPlyHeader_h
#define MesoPlyHeader_h

/**
 * @file MesoPlyHeader.h
 * @brief The text at the head of a PLY file: which elements follow, of which properties.
 */

#include <cstddef>
#include <string>
#include <vector>

enum class MesoPlyType
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float,
  Double
};

/// Bytes of a number of this type.
std::size_t MesoPlyBytes(MesoPlyType type);

struct MesoPlyProperty
{
  std::string Name;
  MesoPlyType Type = MesoPlyType::Float;
  bool IsList = false;
  MesoPlyType CountType = MesoPlyType::UInt8; ///< of a list
};

struct MesoPlyElement
{
  std::string Name;
  std::size_t Count = 0;
  std::vector<MesoPlyProperty> Properties;

  /// The number of the property of this name, or that of no property.
  std::size_t Find(const std::string& name) const;
};

struct MesoPlyHeader
{
  enum class Format
  {
    Text,
    LittleEndian,
    BigEndian
  };
  Format Encoding = Format::Text;
  std::vector<MesoPlyElement> Elements;
  std::size_t Lines = 0; ///< of the header
  std::size_t Bytes = 0; ///< of the header, where the data begin
};

/// Throws MesoInputError "file: line N: reason".
MesoPlyHeader MesoReadPlyHeader(const std::string& bytes, const std::string& fileName);

#endif
