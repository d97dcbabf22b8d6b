#include "MesoVolumeFormats.h"

#include "MesoFileBytes.h"
#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoVolumeNumbers.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

namespace
{
int TypeOf(const std::string& name)
{
  static const std::map<std::string, int> types = { { "signed char", VTK_SIGNED_CHAR },
    { "int8", VTK_SIGNED_CHAR }, { "int8_t", VTK_SIGNED_CHAR }, { "uchar", VTK_UNSIGNED_CHAR },
    { "unsigned char", VTK_UNSIGNED_CHAR }, { "uint8", VTK_UNSIGNED_CHAR },
    { "uint8_t", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT }, { "short int", VTK_SHORT },
    { "signed short", VTK_SHORT }, { "int16", VTK_SHORT }, { "int16_t", VTK_SHORT },
    { "ushort", VTK_UNSIGNED_SHORT }, { "unsigned short", VTK_UNSIGNED_SHORT },
    { "uint16", VTK_UNSIGNED_SHORT }, { "uint16_t", VTK_UNSIGNED_SHORT }, { "int", VTK_INT },
    { "signed int", VTK_INT }, { "int32", VTK_INT }, { "int32_t", VTK_INT },
    { "uint", VTK_UNSIGNED_INT }, { "unsigned int", VTK_UNSIGNED_INT },
    { "uint32", VTK_UNSIGNED_INT }, { "uint32_t", VTK_UNSIGNED_INT }, { "float", VTK_FLOAT },
    { "double", VTK_DOUBLE } };
  const auto found = types.find(name);
  return found == types.end() ? VTK_VOID : found->second;
}

std::vector<double> Numbers(std::string text)
{
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
  std::istringstream words(text);
  std::vector<double> numbers;
  double number = 0.;
  while (words >> number)
  {
    numbers.push_back(number);
  }
  return numbers;
}

/// A header's lines up to an empty one, and the file's place behind it.
class Nrrd
{
public:
  Nrrd(const std::string& bytes, const std::string& fileName)
    : FileName(fileName)
  {
    if (bytes.compare(0, 4, "NRRD") != 0)
    {
      this->Fail("is no NRRD file: it does not begin with NRRD");
    }
    std::size_t place = 0;
    while (place < bytes.size())
    {
      const std::size_t end = std::min(bytes.find('\n', place), bytes.size());
      std::string line = bytes.substr(place, end - place);
      place = std::min(end + 1, bytes.size());
      if (!line.empty() && line.back() == '\r')
      {
        line.pop_back();
      }
      if (line.empty())
      {
        break;
      }
      this->Take(line);
    }
    this->Rest = bytes.substr(place);
  }

  vtkSmartPointer<vtkImageData> Read()
  {
    MesoVolumeHeader header;
    const std::vector<double> sizes = Numbers(this->Of("sizes"));
    if (this->Of("dimension") != "3" || sizes.size() != 3)
    {
      this->Fail("is no volume of three dimensions and one number a sample");
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      header.Size[axis] =
        sizes[axis] >= 1. && sizes[axis] <= 1e6 ? static_cast<int>(sizes[axis]) : 0;
    }
    header.Type = TypeOf(this->Of("type"));
    header.IsBigEndian = this->Of("endian") == "big";
    this->ReadSpacing(header);
    this->ReadEncoding(header);
    return MesoDecodeVolume(header, this->Data(header), this->FileName);
  }

private:
  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw MesoInputError(this->FileName + ": " + MesoPrintable(reason));
  }

  void Take(const std::string& line)
  {
    const std::size_t colon = line.find(": ");
    if (line[0] == '#' || colon == std::string::npos)
    {
      return; // a comment, the magic or a key of the user's own
    }
    std::string value = line.substr(colon + 2);
    value.erase(0, value.find_first_not_of(" \t"));
    value.erase(value.find_last_not_of(" \t") + 1);
    this->Fields[line.substr(0, colon)] = value;
  }

  std::string Of(const std::string& key) const
  {
    const auto found = this->Fields.find(key);
    return found == this->Fields.end() ? std::string() : found->second;
  }

  void ReadSpacing(MesoVolumeHeader& header) const
  {
    const std::vector<double> spacings = Numbers(this->Of("spacings"));
    const std::vector<double> directions = Numbers(this->Of("space directions"));
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (spacings.size() == 3)
      {
        header.Spacing[axis] = spacings[axis];
      }
      else if (directions.size() == 9)
      {
        header.Spacing[axis] =
          std::hypot(directions[3 * axis], directions[3 * axis + 1], directions[3 * axis + 2]);
      }
    }
  }

  void ReadEncoding(MesoVolumeHeader& header) const
  {
    const std::string encoding = this->Of("encoding");
    if (encoding == "gzip" || encoding == "gz")
    {
      header.Encoding = MesoVolumeHeader::Coding::Gzip;
    }
    else if (encoding == "text" || encoding == "txt" || encoding == "ascii")
    {
      header.Encoding = MesoVolumeHeader::Coding::Text;
    }
    else if (encoding != "raw")
    {
      this->Fail("has the encoding '" + encoding + "'; raw, gzip and text can be read");
    }
  }

  /// What the header speaks of, here or in a file beside it, without what is to be skipped.
  std::string Data(const MesoVolumeHeader& header) const
  {
    std::string data = this->Rest;
    std::string name = this->Of("data file");
    name = name.empty() ? this->Of("datafile") : name;
    if (!name.empty())
    {
      if (name.find(' ') != std::string::npos || name == "LIST")
      {
        this->Fail("has its numbers in several files, which is not available");
      }
      const auto beside = std::filesystem::path(this->FileName).parent_path() / name;
      data = MesoReadBytes(beside.string(), MesoVolumeMostBytes, "a volume file");
    }
    for (double lines = this->Skip("line skip"); lines > 0.; --lines)
    {
      const std::size_t end = data.find('\n');
      data.erase(0, end == std::string::npos ? data.size() : end + 1);
    }
    const double skip = this->Skip("byte skip");
    if (skip > 0.)
    {
      data.erase(0, std::min(data.size(), static_cast<std::size_t>(skip)));
    }
    else if (skip < 0. && header.Encoding == MesoVolumeHeader::Coding::Raw)
    {
      // The numbers are the file's last bytes.
      const std::size_t wanted = std::size_t(header.Size[0]) * std::size_t(header.Size[1]) *
        std::size_t(header.Size[2]) * std::size_t(vtkDataArray::GetDataTypeSize(header.Type));
      data.erase(0, data.size() - std::min(data.size(), wanted));
    }
    return data;
  }

  double Skip(const char* key) const
  {
    const std::vector<double> numbers =
      Numbers(this->Of(key).empty() ? this->Of(Joined(key)) : this->Of(key));
    return numbers.empty() ? 0. : std::clamp(numbers[0], -1., double(MesoVolumeMostBytes));
  }

  /// "line skip" may be spelt without the blank.
  static std::string Joined(std::string key)
  {
    key.erase(std::remove(key.begin(), key.end(), ' '), key.end());
    return key;
  }

  const std::string& FileName;
  std::map<std::string, std::string> Fields;
  std::string Rest;
};
}

vtkSmartPointer<vtkImageData> MesoParseNrrd(const std::string& bytes, const std::string& fileName)
{
  return Nrrd(bytes, fileName).Read();
}
