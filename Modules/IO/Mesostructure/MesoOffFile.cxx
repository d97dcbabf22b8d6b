#include "MesoOffFile.h"

#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoTextWords.h"

namespace
{
class Scanner
{
public:
  Scanner(const std::string& text, const std::string& fileName)
    : FileName(fileName)
    , Size(text.size())
    , Lines(text)
  {
  }

  MesoMeshFile Scan()
  {
    std::string_view line = this->NextLine("the header");
    this->ScanHeader(line);
    std::string_view rest = line;
    if (MesoNextWord(rest).empty())
    {
      line = this->NextLine("the counts");
    }
    const std::size_t vertices = this->Count(line, "vertices");
    const std::size_t faces = this->Count(line, "faces");
    for (std::size_t i = 0; i < vertices; ++i)
    {
      this->ScanVertex(i, vertices);
    }
    for (std::size_t i = 0; i < faces; ++i)
    {
      this->ScanFace(i, faces);
    }
    if (this->Lines.NextWithWords(line))
    {
      this->File.Notes.push_back("line " + std::to_string(this->Lines.Number()) +
        " and what follows are after the last face and are not read");
    }
    if (this->NumbersPassedOver > 0)
    {
      this->File.Notes.push_back("colours or further numbers of " +
        std::to_string(this->NumbersPassedOver) + " vertices and faces are not used");
    }
    if (faces == 0)
    {
      throw MesoInputError(this->FileName + ": holds no faces");
    }
    return std::move(this->File);
  }

private:
  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw MesoInputError(this->FileName + ": line " + std::to_string(this->Lines.Number()) + ": " +
      MesoPrintable(reason));
  }

  std::string_view NextLine(const std::string& wanted)
  {
    std::string_view line;
    if (!this->Lines.NextWithWords(line))
    {
      this->Fail("the file ends where " + wanted + " should be");
    }
    return line;
  }

  /// Takes the first word off `line` where it is a kind of OFF.
  void ScanHeader(std::string_view& line)
  {
    std::string_view rest = line;
    std::string_view word = MesoNextWord(rest);
    if (word.size() < 3 || word.substr(word.size() - 3) != "OFF")
    {
      std::int64_t number = 0;
      if (!MesoReadInteger(word, number).empty())
      {
        this->Fail("the file begins with " + MesoQuoted(word) + ", neither OFF nor a count");
      }
      return; // the word OFF may be left out
    }
    const std::string_view kind = word;
    line = rest;
    word.remove_suffix(3);
    const auto take = [&](std::string_view prefix)
    {
      const bool isThere = word.substr(0, prefix.size()) == prefix;
      word.remove_prefix(isThere ? prefix.size() : 0);
      return isThere;
    };
    this->HasTexture = take("ST");
    take("C"); // colours are passed over wherever they stand
    this->HasNormal = take("N");
    if (!word.empty())
    {
      this->Fail(MesoQuoted(kind) + " is a kind of OFF that is not read ([ST][C][N]OFF are)");
    }
    if (MesoNextWord(rest) == "BINARY")
    {
      this->Fail("binary OFF is not read; text is");
    }
  }

  std::size_t Count(std::string_view& line, const std::string& what) const
  {
    std::int64_t count = 0;
    const std::string_view word = MesoNextWord(line);
    const std::string problem = MesoReadInteger(word, count);
    if (!problem.empty())
    {
      this->Fail("number of " + what + ": " + problem);
    }
    // Each takes a line of two bytes at least: no memory is taken for what cannot be there.
    if (count < 0 || static_cast<std::uint64_t>(count) > this->Size / 2 + 1)
    {
      this->Fail("says " + std::to_string(count) + " " + what + ", which a file of " +
        std::to_string(this->Size) + " bytes cannot hold");
    }
    return static_cast<std::size_t>(count);
  }

  template <std::size_t N>
  std::array<double, N> Numbers(
    const std::string& element, const char* what, std::string_view& line) const
  {
    std::array<double, N> numbers{};
    for (double& number : numbers)
    {
      const std::string_view word = MesoNextWord(line);
      const std::string problem =
        word.empty() ? "has too few numbers" : MesoReadNumber(word, number);
      if (!problem.empty())
      {
        this->Fail(element + ": " + what + " " + problem);
      }
    }
    return numbers;
  }

  void ScanVertex(std::size_t i, std::size_t count)
  {
    const std::string element = "vertex " + std::to_string(i);
    std::string_view line = this->NextLine(element + " of " + std::to_string(count));
    this->File.Positions.push_back(this->Numbers<3>(element, "position", line));
    if (this->HasNormal)
    {
      this->File.Normals.push_back(this->Numbers<3>(element, "normal", line));
    }
    std::vector<std::string_view> further;
    for (std::string_view word = MesoNextWord(line); !word.empty(); word = MesoNextWord(line))
    {
      further.push_back(word);
    }
    if (this->HasTexture)
    {
      // The colour before them has 3 or 4 numbers, so that they are found from the line's end.
      std::array<double, 2> coordinates{};
      if (further.size() < 2)
      {
        this->Fail(element + ": texture coordinates has too few numbers");
      }
      for (std::size_t k = 0; k < 2; ++k)
      {
        const std::string problem = MesoReadNumber(further[further.size() - 2 + k], coordinates[k]);
        if (!problem.empty())
        {
          this->Fail(element + ": texture coordinate " + problem);
        }
      }
      this->File.TextureCoordinates.push_back(coordinates);
      further.resize(further.size() - 2);
    }
    this->NumbersPassedOver += further.empty() ? 0 : 1;
  }

  void ScanFace(std::size_t i, std::size_t count)
  {
    const std::string element = "face " + std::to_string(i);
    std::string_view line = this->NextLine(element + " of " + std::to_string(count));
    std::int64_t corners = 0;
    std::string problem = MesoReadInteger(MesoNextWord(line), corners);
    if (!problem.empty())
    {
      this->Fail(element + ": number of corners: " + problem);
    }
    if (corners < 3 || corners > static_cast<std::int64_t>(MesoMeshMostCorners))
    {
      this->Fail(element + " has " + std::to_string(corners) + " corners, " +
        (corners < 3 ? "fewer than 3" : "more than " + std::to_string(MesoMeshMostCorners)));
    }
    const auto vertices = static_cast<std::int64_t>(this->File.Positions.size());
    for (std::int64_t k = 0; k < corners; ++k)
    {
      std::int64_t vertex = 0;
      const std::string_view word = MesoNextWord(line);
      problem = word.empty() ? "too few corners" : MesoReadInteger(word, vertex);
      if (problem.empty() && (vertex < 0 || vertex >= vertices))
      {
        problem = "there is no vertex " + std::to_string(vertex) + " (there are " +
          std::to_string(vertices) + ", from 0)";
      }
      if (!problem.empty())
      {
        this->Fail(element + ": " + problem);
      }
      const auto number = static_cast<std::int32_t>(vertex);
      this->File.Corners.push_back(
        { number, this->HasTexture ? number : -1, this->HasNormal ? number : -1 });
    }
    this->NumbersPassedOver += MesoNextWord(line).empty() ? 0 : 1;
    this->File.CloseFace(this->Lines.Number());
  }

  const std::string& FileName;
  std::size_t Size;
  MesoTextLines Lines;
  bool HasTexture = false;
  bool HasNormal = false;
  std::size_t NumbersPassedOver = 0;
  MesoMeshFile File;
};
}

MesoMeshFile MesoParseOff(const std::string& text, const std::string& fileName)
{
  return Scanner(text, fileName).Scan();
}
