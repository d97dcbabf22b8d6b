#include "MesoPlyHeader.h"

#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoTextWords.h"

#include <map>

namespace
{
class HeaderScanner
{
public:
  HeaderScanner(const std::string& bytes, const std::string& fileName)
    : FileName(fileName)
    , Bytes(bytes)
    , Lines(bytes)
  {
  }

  MesoPlyHeader Scan()
  {
    std::string_view line;
    this->Lines.Next(line);
    if (line != "ply")
    {
      this->Fail("the file does not begin with the line \"ply\"");
    }
    bool hasFormat = false;
    while (true)
    {
      if (!this->Lines.Next(line))
      {
        this->Fail("the file ends before end_header");
      }
      const std::string_view keyword = MesoNextWord(line);
      if (keyword == "end_header")
      {
        break;
      }
      if (keyword == "format")
      {
        this->ScanFormat(line);
        hasFormat = true;
      }
      else if (keyword == "element")
      {
        this->ScanElement(line);
      }
      else if (keyword == "property")
      {
        this->ScanProperty(line);
      }
      else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty())
      {
        this->Fail(MesoQuoted(keyword) + " is not a keyword of a PLY header");
      }
    }
    if (!hasFormat)
    {
      this->Fail("the header has no line \"format\"");
    }
    this->Header.Lines = this->Lines.Number();
    this->Header.Bytes = this->Bytes.size() - this->Lines.After().size();
    return std::move(this->Header);
  }

private:
  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw MesoInputError(this->FileName + ": line " + std::to_string(this->Lines.Number()) + ": " +
      MesoPrintable(reason));
  }

  void ScanFormat(std::string_view rest)
  {
    const std::string_view format = MesoNextWord(rest);
    using Format = MesoPlyHeader::Format;
    if (format == "ascii")
    {
      this->Header.Encoding = Format::Text;
    }
    else if (format == "binary_little_endian" || format == "binary_big_endian")
    {
      this->Header.Encoding =
        format == "binary_big_endian" ? Format::BigEndian : Format::LittleEndian;
    }
    else
    {
      this->Fail(MesoQuoted(format) +
        " is not a format of PLY (ascii, binary_little_endian, binary_big_endian)");
    }
    const std::string_view version = MesoNextWord(rest);
    if (version != "1.0")
    {
      this->Fail("version " + MesoQuoted(version) + " is not read; 1.0 is");
    }
  }

  void ScanElement(std::string_view rest)
  {
    MesoPlyElement element;
    element.Name = MesoNextWord(rest);
    std::int64_t count = 0;
    const std::string problem = MesoReadInteger(MesoNextWord(rest), count);
    if (element.Name.empty() || !problem.empty() || count < 0)
    {
      this->Fail("element needs a name and a count" + (problem.empty() ? "" : ": " + problem));
    }
    if (this->Find(element.Name))
    {
      this->Fail("element " + MesoQuoted(element.Name) + " is there already");
    }
    // Each takes a byte at least: no memory is taken for what cannot be there.
    if (static_cast<std::uint64_t>(count) > this->Bytes.size())
    {
      this->Fail("says " + std::to_string(count) + " elements " + MesoQuoted(element.Name) +
        ", which a file of " + std::to_string(this->Bytes.size()) + " bytes cannot hold");
    }
    element.Count = static_cast<std::size_t>(count);
    this->Header.Elements.push_back(element);
  }

  bool Find(const std::string& name) const
  {
    for (const MesoPlyElement& element : this->Header.Elements)
    {
      if (element.Name == name)
      {
        return true;
      }
    }
    return false;
  }

  MesoPlyType Type(std::string_view word) const
  {
    static const std::map<std::string_view, MesoPlyType> types = { { "char", MesoPlyType::Int8 },
      { "int8", MesoPlyType::Int8 }, { "uchar", MesoPlyType::UInt8 },
      { "uint8", MesoPlyType::UInt8 }, { "short", MesoPlyType::Int16 },
      { "int16", MesoPlyType::Int16 }, { "ushort", MesoPlyType::UInt16 },
      { "uint16", MesoPlyType::UInt16 }, { "int", MesoPlyType::Int32 },
      { "int32", MesoPlyType::Int32 }, { "uint", MesoPlyType::UInt32 },
      { "uint32", MesoPlyType::UInt32 }, { "float", MesoPlyType::Float },
      { "float32", MesoPlyType::Float }, { "double", MesoPlyType::Double },
      { "float64", MesoPlyType::Double } };
    const auto found = types.find(word);
    if (found == types.end())
    {
      this->Fail(MesoQuoted(word) + " is not a type of PLY");
    }
    return found->second;
  }

  void ScanProperty(std::string_view rest)
  {
    if (this->Header.Elements.empty())
    {
      this->Fail("a property comes before the first element");
    }
    MesoPlyProperty property;
    std::string_view word = MesoNextWord(rest);
    property.IsList = word == "list";
    if (property.IsList)
    {
      property.CountType = this->Type(MesoNextWord(rest));
      word = MesoNextWord(rest);
      if (property.CountType == MesoPlyType::Float || property.CountType == MesoPlyType::Double)
      {
        this->Fail("a list's count must be a whole number");
      }
    }
    property.Type = this->Type(word);
    property.Name = MesoNextWord(rest);
    MesoPlyElement& element = this->Header.Elements.back();
    if (property.Name.empty())
    {
      this->Fail("the property has no name");
    }
    if (element.Find(property.Name) < element.Properties.size())
    {
      this->Fail("property " + MesoQuoted(property.Name) + " is there already");
    }
    element.Properties.push_back(property);
  }

  const std::string& FileName;
  const std::string& Bytes;
  MesoTextLines Lines;
  MesoPlyHeader Header;
};
}

std::size_t MesoPlyBytes(MesoPlyType type)
{
  switch (type)
  {
    case MesoPlyType::Int8:
    case MesoPlyType::UInt8:
      return 1;
    case MesoPlyType::Int16:
    case MesoPlyType::UInt16:
      return 2;
    case MesoPlyType::Int32:
    case MesoPlyType::UInt32:
    case MesoPlyType::Float:
      return 4;
    case MesoPlyType::Double:
      return 8;
  }
  return 8;
}

std::size_t MesoPlyElement::Find(const std::string& name) const
{
  std::size_t i = 0;
  while (i < this->Properties.size() && this->Properties[i].Name != name)
  {
    ++i;
  }
  return i;
}

MesoPlyHeader MesoReadPlyHeader(const std::string& bytes, const std::string& fileName)
{
  return HeaderScanner(bytes, fileName).Scan();
}
