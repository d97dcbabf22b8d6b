#include "MesoPlyFile.h"

#include "MesoBinaryNumbers.h"
#include "MesoMessage.h"
#include "MesoPlyHeader.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoTextWords.h"

#include <cmath>
#include <set>

namespace
{
/// The numbers of a PLY file one after the other, in text or binary.
class Numbers
{
public:
  Numbers(const std::string& bytes, const MesoPlyHeader& header, const std::string& fileName)
    : FileName(fileName)
    , Bytes(bytes)
    , IsText(header.Encoding == MesoPlyHeader::Format::Text)
    , IsBigEndian(header.Encoding == MesoPlyHeader::Format::BigEndian)
    , Position(header.Bytes)
    , Lines(std::string_view(bytes).substr(header.Bytes), header.Lines)
  {
  }

  /// `element` and `count` say in messages where this is.
  void BeginElement(const std::string& element, std::size_t number, std::size_t count)
  {
    this->Element = &element;
    this->ElementNumber = number;
    if (this->IsText && !this->Lines.NextWithWords(this->Line))
    {
      this->Line = {};
      this->Fail("the file ends before this one of " + std::to_string(count));
    }
  }

  void EndElement()
  {
    if (this->IsText && !MesoNextWord(this->Line).empty())
    {
      this->Fail("the line has more numbers than the element's properties");
    }
  }

  double Next(const MesoPlyProperty& property, MesoPlyType type)
  {
    if (this->IsText)
    {
      double number = 0.;
      const std::string_view word = MesoNextWord(this->Line);
      const std::string problem =
        word.empty() ? "the line has no number for it" : MesoReadNumber(word, number);
      if (!problem.empty())
      {
        this->Fail(property.Name + ": " + problem);
      }
      return number;
    }
    const std::size_t size = MesoPlyBytes(type);
    if (this->Bytes.size() - this->Position < size)
    {
      this->Position = this->Bytes.size();
      this->Fail(property.Name + ": the file ends");
    }
    const double number = this->Binary(type);
    this->Position += size;
    if (!(std::abs(number) <= MesoMeshLargestNumber))
    {
      this->Position -= size;
      this->Fail(property.Name + " is not finite or beyond 1e30");
    }
    return number;
  }

  /// All numbers of a list.
  void NextList(const MesoPlyProperty& property, std::vector<double>& list)
  {
    const double count = this->Next(property, property.CountType);
    const std::size_t left = this->IsText ? this->Line.size() : this->Bytes.size() - this->Position;
    if (!(count >= 0.) || count != std::floor(count) || count > static_cast<double>(left))
    {
      this->Fail(property.Name + ": a list cannot have " + MesoNumberText(count) + " numbers here");
    }
    list.resize(static_cast<std::size_t>(count));
    for (double& number : list)
    {
      number = this->Next(property, property.Type);
    }
  }

  [[noreturn]] void Fail(const std::string& reason) const
  {
    const std::string place = this->IsText ? "line " + std::to_string(this->Lines.Number())
                                           : "byte " + std::to_string(this->Position);
    throw MesoInputError(this->FileName + ": " + place + ": " +
      MesoPrintable(*this->Element + " " + std::to_string(this->ElementNumber) + ": " + reason));
  }

  bool HasText() const { return this->IsText; }
  std::size_t LineNumber() const { return this->Lines.Number(); }
  /// Where what is left begins, "line 12" or "byte 345", or an empty text where nothing is.
  std::string WhatIsLeft()
  {
    if (this->IsText)
    {
      std::string_view line;
      return this->Lines.NextWithWords(line) ? "line " + std::to_string(this->Lines.Number()) : "";
    }
    return this->Position < this->Bytes.size() ? "byte " + std::to_string(this->Position) : "";
  }

private:
  double Binary(MesoPlyType type) const
  {
    const char* const bytes = this->Bytes.data() + this->Position;
    switch (type)
    {
      case MesoPlyType::Int8:
        return MesoBinaryNumber<std::int8_t>(bytes, this->IsBigEndian);
      case MesoPlyType::UInt8:
        return MesoBinaryNumber<std::uint8_t>(bytes, this->IsBigEndian);
      case MesoPlyType::Int16:
        return MesoBinaryNumber<std::int16_t>(bytes, this->IsBigEndian);
      case MesoPlyType::UInt16:
        return MesoBinaryNumber<std::uint16_t>(bytes, this->IsBigEndian);
      case MesoPlyType::Int32:
        return MesoBinaryNumber<std::int32_t>(bytes, this->IsBigEndian);
      case MesoPlyType::UInt32:
        return MesoBinaryNumber<std::uint32_t>(bytes, this->IsBigEndian);
      case MesoPlyType::Float:
        return MesoBinaryNumber<float>(bytes, this->IsBigEndian);
      case MesoPlyType::Double:
        return MesoBinaryNumber<double>(bytes, this->IsBigEndian);
    }
    return 0.;
  }

  const std::string& FileName;
  const std::string& Bytes;
  bool IsText;
  bool IsBigEndian;
  std::size_t Position;
  MesoTextLines Lines;
  std::string_view Line;
  const std::string* Element = nullptr;
  std::size_t ElementNumber = 0;
};

class Scanner
{
public:
  Scanner(const std::string& bytes, const std::string& fileName)
    : FileName(fileName)
    , Header(MesoReadPlyHeader(bytes, fileName))
    , Source(bytes, this->Header, fileName)
  {
    this->File.PlaceName = this->Source.HasText() ? "line" : "face";
  }

  MesoMeshFile Scan()
  {
    for (const MesoPlyElement& element : this->Header.Elements)
    {
      if (element.Name == "vertex")
      {
        this->ScanVertices(element);
      }
      else if (element.Name == "face" || element.Name == "tristrips")
      {
        this->ScanFaces(element);
      }
      else
      {
        this->PassOver(element);
      }
    }
    this->Finish();
    return std::move(this->File);
  }

private:
  void ScanVertices(const MesoPlyElement& element)
  {
    const std::size_t none = element.Properties.size();
    const auto slots = [&](const std::vector<std::string>& names)
    {
      std::vector<std::size_t> found;
      for (const std::string& name : names)
      {
        const std::size_t slot = element.Find(name);
        if (slot < none && !element.Properties[slot].IsList)
        {
          found.push_back(slot);
        }
      }
      return found.size() == names.size() ? found : std::vector<std::size_t>();
    };
    const auto position = slots({ "x", "y", "z" });
    const auto normal = slots({ "nx", "ny", "nz" });
    std::vector<std::size_t> texture;
    for (const auto& names : std::vector<std::vector<std::string>>{
           { "s", "t" }, { "u", "v" }, { "texture_u", "texture_v" }, { "texture_s", "texture_t" } })
    {
      texture = texture.empty() ? slots(names) : texture;
    }
    if (position.empty())
    {
      throw MesoInputError(this->FileName + ": the element vertex lacks one of x, y, z");
    }
    this->NoteUnused(element, { position, normal, texture });
    std::vector<double> values(element.Properties.size());
    for (std::size_t i = 0; i < element.Count; ++i)
    {
      this->Source.BeginElement(element.Name, i, element.Count);
      for (std::size_t k = 0; k < element.Properties.size(); ++k)
      {
        values[k] = this->Value(element.Properties[k], this->Ignored);
      }
      this->Source.EndElement();
      this->File.Positions.push_back(
        { values[position[0]], values[position[1]], values[position[2]] });
      if (!normal.empty())
      {
        this->File.Normals.push_back({ values[normal[0]], values[normal[1]], values[normal[2]] });
      }
      if (!texture.empty())
      {
        this->File.TextureCoordinates.push_back({ values[texture[0]], values[texture[1]] });
      }
    }
    this->HasNormal = !normal.empty();
    this->HasTexture = !texture.empty();
    this->HasVertices = true;
  }

  /// Reads a property; a list's numbers go to `list`.
  double Value(const MesoPlyProperty& property, std::vector<double>& list)
  {
    if (property.IsList)
    {
      this->Source.NextList(property, list);
      return 0.;
    }
    return this->Source.Next(property, property.Type);
  }

  void ScanFaces(const MesoPlyElement& element)
  {
    if (!this->HasVertices)
    {
      throw MesoInputError(
        this->FileName + ": the element " + element.Name + " comes before the vertices it names");
    }
    const std::size_t none = element.Properties.size();
    const auto listOf = [&](const std::string& name)
    {
      const std::size_t slot = element.Find(name);
      return slot < none && element.Properties[slot].IsList ? slot : none;
    };
    const std::size_t indices =
      listOf("vertex_indices") < none ? listOf("vertex_indices") : listOf("vertex_index");
    if (indices == none)
    {
      throw MesoInputError(this->FileName + ": the element " + element.Name +
        " has no list vertex_indices or vertex_index");
    }
    const bool isStrip = element.Name == "tristrips";
    const std::size_t texture = isStrip ? none : listOf("texcoord");
    const std::size_t textureNumber = isStrip ? none : element.Find("texnumber");
    this->NoteUnused(element, { { indices, texture, textureNumber } });
    std::vector<double> vertices;
    std::vector<double> coordinates;
    for (std::size_t i = 0; i < element.Count; ++i)
    {
      this->Source.BeginElement(element.Name, i, element.Count);
      for (std::size_t k = 0; k < element.Properties.size(); ++k)
      {
        const double value = this->Value(element.Properties[k],
          k == indices     ? vertices
            : k == texture ? coordinates
                           : this->Ignored);
        if (k == textureNumber)
        {
          this->TextureNumbers.insert(value);
        }
      }
      this->Source.EndElement();
      const std::size_t place = this->Source.HasText() ? this->Source.LineNumber() : i;
      if (isStrip)
      {
        this->AddStrips(vertices, place);
      }
      else
      {
        this->AddFace(vertices, texture < none ? &coordinates : nullptr, place);
      }
    }
  }

  std::int32_t Index(double value) const
  {
    const std::size_t count = this->File.Positions.size();
    if (value != std::floor(value) || value < 0. || value >= static_cast<double>(count))
    {
      this->Source.Fail("there is no vertex " + MesoNumberText(value) + " (there are " +
        std::to_string(count) + ", from 0)");
    }
    return static_cast<std::int32_t>(value);
  }

  MesoMeshCorner Corner(double value) const
  {
    const std::int32_t index = this->Index(value);
    return { index, this->HasTexture ? index : -1, this->HasNormal ? index : -1 };
  }

  void AddFace(
    const std::vector<double>& vertices, const std::vector<double>* coordinates, std::size_t place)
  {
    const std::size_t corners = vertices.size();
    if (corners < 3 || corners > MesoMeshMostCorners)
    {
      this->Source.Fail("has " + std::to_string(corners) + " corners, " +
        (corners < 3 ? "fewer than 3" : "more than " + std::to_string(MesoMeshMostCorners)));
    }
    if (coordinates && !coordinates->empty() && coordinates->size() != 2 * corners)
    {
      this->Source.Fail("texcoord has " + std::to_string(coordinates->size()) + " numbers for " +
        std::to_string(corners) + " corners, not two each");
    }
    for (std::size_t i = 0; i < corners; ++i)
    {
      MesoMeshCorner corner = this->Corner(vertices[i]);
      if (coordinates && !coordinates->empty())
      {
        corner.TextureCoordinate = static_cast<std::int32_t>(this->File.TextureCoordinates.size());
        this->File.TextureCoordinates.push_back(
          { (*coordinates)[2 * i], (*coordinates)[2 * i + 1] });
      }
      this->File.Corners.push_back(corner);
    }
    this->File.CloseFace(place);
  }

  void AddStrips(const std::vector<double>& vertices, std::size_t place)
  {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (vertices[i] == -1.)
      {
        begin = i + 1;
        continue;
      }
      this->Index(vertices[i]);
      if (i < begin + 2)
      {
        continue;
      }
      const bool isTurned = (i - begin) % 2 != 0;
      this->File.Corners.push_back(this->Corner(vertices[isTurned ? i - 1 : i - 2]));
      this->File.Corners.push_back(this->Corner(vertices[isTurned ? i - 2 : i - 1]));
      this->File.Corners.push_back(this->Corner(vertices[i]));
      this->File.CloseFace(place);
    }
  }

  void PassOver(const MesoPlyElement& element)
  {
    for (std::size_t i = 0; i < element.Count && !element.Properties.empty(); ++i)
    {
      this->Source.BeginElement(element.Name, i, element.Count);
      for (const MesoPlyProperty& property : element.Properties)
      {
        this->Value(property, this->Ignored);
      }
      this->Source.EndElement();
    }
    if (element.Count > 0)
    {
      this->File.Notes.push_back(std::to_string(element.Count) + " elements " +
        MesoPrintable(MesoQuoted(element.Name)) + " are not used");
    }
  }

  void NoteUnused(
    const MesoPlyElement& element, const std::vector<std::vector<std::size_t>>& usedSlots)
  {
    std::set<std::size_t> used;
    for (const auto& slots : usedSlots)
    {
      used.insert(slots.begin(), slots.end());
    }
    std::string names;
    for (std::size_t i = 0; i < element.Properties.size(); ++i)
    {
      if (used.count(i) == 0)
      {
        names += (names.empty() ? "" : ", ") + element.Properties[i].Name;
      }
    }
    if (!names.empty())
    {
      this->File.Notes.push_back(
        MesoPrintable("properties of " + element.Name + " that are not used: " + names));
    }
  }

  void Finish()
  {
    if (this->TextureNumbers.size() > 1)
    {
      this->File.Notes.push_back("faces use " + std::to_string(this->TextureNumbers.size()) +
        " different images (texnumber), which are taken as one");
    }
    const std::string left = this->Source.WhatIsLeft();
    if (!left.empty())
    {
      this->File.Notes.push_back(
        left + " and what follows are after the last element and are not read");
    }
    if (this->File.NumberOfFaces() == 0)
    {
      throw MesoInputError(this->FileName + ": holds no faces" +
        (this->File.Positions.empty()
            ? ""
            : " (" + std::to_string(this->File.Positions.size()) + " vertices alone)"));
    }
  }

  const std::string& FileName;
  const MesoPlyHeader Header;
  Numbers Source;
  bool HasVertices = false;
  bool HasNormal = false;
  bool HasTexture = false;
  std::set<double> TextureNumbers;
  std::vector<double> Ignored;
  MesoMeshFile File;
};
}

MesoMeshFile MesoParsePly(const std::string& bytes, const std::string& fileName)
{
  return Scanner(bytes, fileName).Scan();
}
