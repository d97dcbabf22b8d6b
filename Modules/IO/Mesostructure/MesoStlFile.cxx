#include "MesoStlFile.h"

#include "MesoBinaryNumbers.h"
#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoTextWords.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace
{
constexpr std::size_t HeaderBytes = 84;
constexpr std::size_t FacetBytes = 50;

using Vector = std::array<double, 3>;

/// Facets of either form as faces of three positions each.
class Facets
{
public:
  void Add(const Vector& normal, const std::array<Vector, 3>& corners, std::size_t place)
  {
    for (const Vector& corner : corners)
    {
      this->File.Corners.push_back(
        { static_cast<std::int32_t>(this->File.Positions.size()), -1, -1 });
      this->File.Positions.push_back(corner);
    }
    this->File.CloseFace(place);
    double dot = 0.;
    for (int k = 0; k < 3; ++k)
    {
      const int i = (k + 1) % 3;
      const int j = (k + 2) % 3;
      dot += normal[k] *
        ((corners[1][i] - corners[0][i]) * (corners[2][j] - corners[0][j]) -
          (corners[1][j] - corners[0][j]) * (corners[2][i] - corners[0][i]));
    }
    this->Contradictions += dot < 0. ? 1 : 0;
  }

  MesoMeshFile Finish(const std::string& fileName)
  {
    if (this->File.NumberOfFaces() == 0)
    {
      throw MesoInputError(fileName + ": holds no faces");
    }
    if (this->Contradictions > 0)
    {
      this->File.Notes.push_back(std::to_string(this->Contradictions) + " of " +
        std::to_string(this->File.NumberOfFaces()) +
        " facets have normals against the order of their corners, which is what is taken");
    }
    return std::move(this->File);
  }

  MesoMeshFile File;

private:
  std::size_t Contradictions = 0;
};

MesoMeshFile ReadBinary(const std::string& bytes, const std::string& fileName)
{
  const auto fail = [&](std::size_t position, const std::string& reason)
  { throw MesoInputError(fileName + ": byte " + std::to_string(position) + ": " + reason); };
  if (bytes.size() < HeaderBytes)
  {
    throw MesoInputError(fileName + ": is no STL: it does not begin with \"solid\", and has " +
      std::to_string(bytes.size()) + " bytes where a binary header has " +
      std::to_string(HeaderBytes));
  }
  const std::size_t count = MesoBinaryNumber<std::uint32_t>(bytes.data() + 80, false);
  const std::size_t available = (bytes.size() - HeaderBytes) / FacetBytes;
  if (count > available)
  {
    fail(bytes.size(),
      "the file ends after " + std::to_string(available) + " of " + std::to_string(count) +
        " facets");
  }
  Facets facets;
  facets.File.PlaceName = "face";
  std::size_t withAttribute = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t begin = HeaderBytes + i * FacetBytes;
    std::array<Vector, 4> vectors; // the normal, then the corners
    for (std::size_t k = 0; k < 12; ++k)
    {
      const std::size_t position = begin + 4 * k;
      const double number = MesoBinaryNumber<float>(bytes.data() + position, false);
      if (k >= 3 && !(std::abs(number) <= MesoMeshLargestNumber))
      {
        fail(
          position, "facet " + std::to_string(i) + ": a coordinate is not finite or beyond 1e30");
      }
      vectors[k / 3][k % 3] = number;
    }
    facets.Add(vectors[0], { vectors[1], vectors[2], vectors[3] }, i);
    withAttribute += bytes[begin + 48] != 0 || bytes[begin + 49] != 0 ? 1 : 0;
  }
  const std::size_t end = HeaderBytes + count * FacetBytes;
  if (bytes.size() > end)
  {
    facets.File.Notes.push_back(std::to_string(bytes.size() - end) +
      " bytes after the last facet (from byte " + std::to_string(end) + ") are not read");
  }
  if (withAttribute > 0)
  {
    facets.File.Notes.push_back(
      "attributes (colours) of " + std::to_string(withAttribute) + " facets are not used");
  }
  return facets.Finish(fileName);
}

class TextScanner
{
public:
  TextScanner(const std::string& text, const std::string& fileName)
    : FileName(fileName)
    , Lines(text)
  {
  }

  MesoMeshFile Scan()
  {
    std::string_view line;
    std::size_t solids = 0;
    bool isOpen = false;
    while (this->Lines.NextWithWords(line))
    {
      std::string_view rest = line;
      const std::string word = this->Lower(MesoNextWord(rest));
      if (word == "solid")
      {
        ++solids;
        isOpen = true;
      }
      else if (word == "endsolid")
      {
        isOpen = false;
      }
      else if (word == "facet" && isOpen)
      {
        this->ScanFacet(rest);
      }
      else
      {
        this->Fail(MesoQuoted(word) + " stands where " + (isOpen ? "facet or endsolid" : "solid") +
          " should");
      }
    }
    if (isOpen)
    {
      this->Fail("the file ends before endsolid");
    }
    if (solids > 1)
    {
      this->Result.File.Notes.push_back(std::to_string(solids) + " solids are taken as one mesh");
    }
    return this->Result.Finish(this->FileName);
  }

private:
  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw MesoInputError(this->FileName + ": line " + std::to_string(this->Lines.Number()) + ": " +
      MesoPrintable(reason));
  }

  static std::string Lower(std::string_view word)
  {
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return lower;
  }

  void ExpectWord(std::string_view& rest, const char* wanted) const
  {
    const std::string_view word = MesoNextWord(rest);
    if (this->Lower(word) != wanted)
    {
      this->Fail(MesoQuoted(word) + " stands where " + wanted + " should");
    }
  }

  std::string_view NextLine(const char* wanted)
  {
    std::string_view line;
    if (!this->Lines.NextWithWords(line))
    {
      this->Fail(std::string("the file ends where ") + wanted + " should be");
    }
    this->ExpectWord(line, wanted);
    return line;
  }

  Vector Numbers(const char* what, std::string_view rest) const
  {
    Vector numbers{};
    for (double& number : numbers)
    {
      const std::string_view word = MesoNextWord(rest);
      const std::string problem =
        word.empty() ? "has fewer than 3 numbers" : MesoReadNumber(word, number);
      if (!problem.empty())
      {
        this->Fail(std::string(what) + " " + problem);
      }
    }
    return numbers;
  }

  void ScanFacet(std::string_view rest)
  {
    const std::size_t place = this->Lines.Number();
    this->ExpectWord(rest, "normal");
    Vector normal{};
    for (double& component : normal)
    {
      // Facets without area come with normals of all kinds, "nan" among them.
      if (!MesoReadNumber(MesoNextWord(rest), component).empty())
      {
        normal = {};
        break;
      }
    }
    std::string_view loop = this->NextLine("outer");
    this->ExpectWord(loop, "loop");
    std::array<Vector, 3> corners;
    for (Vector& corner : corners)
    {
      corner = this->Numbers("vertex", this->NextLine("vertex"));
    }
    this->NextLine("endloop");
    this->NextLine("endfacet");
    this->Result.Add(normal, corners, place);
  }

  const std::string& FileName;
  MesoTextLines Lines;
  Facets Result;
};

bool IsBinary(const std::string& bytes)
{
  if (bytes.size() >= HeaderBytes &&
    bytes.size() ==
      HeaderBytes +
        FacetBytes * std::size_t(MesoBinaryNumber<std::uint32_t>(bytes.data() + 80, false)))
  {
    return true; // even where the header's free text begins with "solid"
  }
  std::string_view rest(bytes);
  rest = rest.substr(0, rest.find('\n'));
  const std::string_view word = MesoNextWord(rest);
  return word != "solid" && word != "SOLID" && word != "Solid";
}
}

MesoMeshFile MesoParseStl(const std::string& bytes, const std::string& fileName)
{
  return IsBinary(bytes) ? ReadBinary(bytes, fileName) : TextScanner(bytes, fileName).Scan();
}
