#include "MesoObjFile.h"

#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoTextWords.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string_view>

namespace
{
// What the OBJ specification has beside v, vt, vn and f.
constexpr std::string_view PassedOver[] = { "g", "o", "s", "mg", "usemtl", "mtllib", "usemap",
  "maplib", "bevel", "c_interp", "d_interp", "lod", "shadow_obj", "trace_obj", "ctech", "stech",
  "cstype", "deg", "bmat", "step", "parm", "trim", "hole", "scrv", "sp", "end", "con", "call",
  "csh", "vp" };
constexpr std::string_view OtherElements[] = { "p", "l", "curv", "curv2", "surf", "bzp", "bsp",
  "cdc", "cdp", "res" };

template <std::size_t N>
bool Contains(const std::string_view (&words)[N], std::string_view word)
{
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

class Scanner
{
public:
  explicit Scanner(const std::string& fileName)
    : FileName(fileName)
  {
  }

  MesoMeshFile Scan(const std::string& text)
  {
    const char* position = text.data();
    const char* const end = position + text.size();
    position += text.compare(0, 3, "\xef\xbb\xbf") == 0 ? 3 : 0; // a byte order mark
    std::size_t line = 0;
    while (position < end)
    {
      const char* lineEnd = this->EndOfLine(position, end);
      this->Line = ++line;
      const char* textEnd = this->WithoutReturn(position, lineEnd);
      if (textEnd > position && textEnd[-1] == '\\')
      {
        // A line that goes on in the next: only these are copied.
        std::string joined;
        while (textEnd > position && textEnd[-1] == '\\')
        {
          joined.append(position, textEnd - 1).append(" ");
          position = lineEnd < end ? lineEnd + 1 : end;
          lineEnd = this->EndOfLine(position, end);
          textEnd = this->WithoutReturn(position, lineEnd);
          line += position < end ? 1 : 0;
        }
        joined.append(position, textEnd);
        this->ScanLine(joined);
      }
      else
      {
        this->ScanLine(std::string_view(position, textEnd - position));
      }
      position = lineEnd + 1;
    }
    this->Finish();
    return std::move(this->File);
  }

private:
  enum IndexKind
  {
    Position,
    TextureCoordinate,
    Normal
  };
  struct LateIndex
  {
    std::size_t Line;
    IndexKind Kind;
    std::int32_t Number;
  };

  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw MesoInputError(
      this->FileName + ": line " + std::to_string(this->Line) + ": " + MesoPrintable(reason));
  }

  static const char* EndOfLine(const char* begin, const char* end)
  {
    const void* found = begin < end ? std::memchr(begin, '\n', end - begin) : nullptr;
    return found ? static_cast<const char*>(found) : end;
  }

  static const char* WithoutReturn(const char* begin, const char* end)
  {
    return end > begin && end[-1] == '\r' ? end - 1 : end;
  }

  void ScanLine(std::string_view rest)
  {
    const std::string_view keyword = MesoNextWord(rest);
    if (keyword.empty())
    {
      return;
    }
    if (keyword == "v")
    {
      this->File.Positions.push_back(this->Numbers<3>("v", rest, 3));
    }
    else if (keyword == "vt")
    {
      this->File.TextureCoordinates.push_back(this->Numbers<2>("vt", rest, 1));
    }
    else if (keyword == "vn")
    {
      this->File.Normals.push_back(this->Numbers<3>("vn", rest, 3));
    }
    else if (keyword == "f" || keyword == "fo")
    {
      this->ScanFace(rest);
    }
    else if (!Contains(PassedOver, keyword))
    {
      this->NoteOther(keyword);
    }
  }

  template <std::size_t N>
  std::array<double, N> Numbers(const char* keyword, std::string_view rest, std::size_t least) const
  {
    std::array<double, N> numbers{};
    for (std::size_t i = 0; i < N; ++i)
    {
      const std::string_view word = MesoNextWord(rest);
      if (word.empty())
      {
        if (i < least)
        {
          this->Fail(std::string(keyword) + " has " + std::to_string(i) + " of " +
            std::to_string(least) + " numbers");
        }
        break;
      }
      const std::string problem = MesoReadNumber(word, numbers[i]);
      if (!problem.empty())
      {
        this->Fail(problem);
      }
    }
    return numbers;
  }

  void ScanFace(std::string_view rest)
  {
    std::size_t corners = 0;
    for (std::string_view word = MesoNextWord(rest); !word.empty(); word = MesoNextWord(rest))
    {
      this->File.Corners.push_back(this->Corner(word));
      ++corners;
      if (corners > MesoMeshMostCorners)
      {
        this->Fail("face has more than " + std::to_string(MesoMeshMostCorners) + " corners");
      }
    }
    if (corners < 3)
    {
      this->Fail("face has " + std::to_string(corners) + " corners, fewer than 3");
    }
    this->File.CloseFace(this->Line);
  }

  MesoMeshCorner Corner(std::string_view word)
  {
    std::string_view parts[3];
    std::string_view rest = word;
    std::size_t count = 0;
    for (;; ++count)
    {
      if (count == 3)
      {
        this->Fail(MesoQuoted(word) + " is not a corner of a face");
      }
      const std::size_t slash = rest.find('/');
      parts[count] = rest.substr(0, slash);
      if (slash == std::string_view::npos)
      {
        break;
      }
      rest.remove_prefix(slash + 1);
    }
    if (parts[0].empty())
    {
      this->Fail(MesoQuoted(word) + " names no vertex");
    }
    return { this->Index(parts[0], Position, this->File.Positions.size()),
      this->Index(parts[1], TextureCoordinate, this->File.TextureCoordinates.size()),
      this->Index(parts[2], Normal, this->File.Normals.size()) };
  }

  std::int32_t Index(std::string_view word, IndexKind kind, std::size_t countSoFar)
  {
    if (word.empty())
    {
      return -1;
    }
    std::int64_t index = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (stop != word.data() + word.size() || error == std::errc::invalid_argument)
    {
      this->Fail(MesoQuoted(word) + " is not an index");
    }
    const auto count = static_cast<std::int64_t>(countSoFar);
    const std::int64_t number = index < 0 ? count + index : index - 1;
    if (error == std::errc::result_out_of_range || index == 0 || number < 0 || number > INT32_MAX)
    {
      this->FailIndex(kind, std::string(word.substr(0, 40)), countSoFar);
    }
    if (number >= count)
    {
      // Elements may come after the faces that use them, so this is decided at the file's end.
      this->LateIndices.push_back({ this->Line, kind, static_cast<std::int32_t>(number) });
    }
    return static_cast<std::int32_t>(number);
  }

  [[noreturn]] void FailIndex(IndexKind kind, const std::string& index, std::size_t count) const
  {
    const char* const names[] = { "vertex", "texture coordinate", "normal" };
    this->Fail(std::string("there is no ") + names[kind] + " " + index + " (there are " +
      std::to_string(count) + ")");
  }

  void NoteOther(std::string_view keyword)
  {
    const bool isWord = std::all_of(
      keyword.begin(), keyword.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
    if (!isWord || !std::isalpha(static_cast<unsigned char>(keyword[0])))
    {
      this->Fail(MesoQuoted(keyword) + " is not an OBJ keyword");
    }
    Others& others = Contains(OtherElements, keyword) ? this->Elements : this->Unknown;
    if (others.Count++ == 0)
    {
      others.First =
        "line " + std::to_string(this->Line) + ": " + std::string(keyword.substr(0, 40));
    }
  }

  void Finish()
  {
    const std::size_t counts[] = { this->File.Positions.size(),
      this->File.TextureCoordinates.size(), this->File.Normals.size() };
    for (const LateIndex& late : this->LateIndices)
    {
      if (static_cast<std::size_t>(late.Number) >= counts[late.Kind])
      {
        this->Line = late.Line;
        this->FailIndex(
          late.Kind, std::to_string(late.Number + std::int64_t(1)), counts[late.Kind]);
      }
    }
    if (this->Unknown.Count > 0)
    {
      this->File.Notes.push_back(std::to_string(this->Unknown.Count) +
        " lines have keywords that OBJ does not have (first " + this->Unknown.First + ")");
    }
    if (this->Elements.Count > 0)
    {
      this->File.Notes.push_back(std::to_string(this->Elements.Count) +
        " points, lines, curves or surfaces are left out (first " + this->Elements.First + ")");
    }
    if (this->File.NumberOfFaces() == 0)
    {
      const std::string unknown =
        this->Unknown.Count > 0 ? " (" + this->Unknown.First + " is not OBJ)" : "";
      throw MesoInputError(this->FileName + ": holds no faces" + unknown);
    }
  }

  struct Others
  {
    std::size_t Count = 0;
    std::string First;
  };

  const std::string& FileName;
  MesoMeshFile File;
  std::size_t Line = 0;
  std::vector<LateIndex> LateIndices;
  Others Elements;
  Others Unknown;
};
}

MesoMeshFile MesoParseObj(const std::string& text, const std::string& fileName)
{
  if (text.empty())
  {
    throw MesoInputError(fileName + ": is empty");
  }
  return Scanner(fileName).Scan(text);
}
