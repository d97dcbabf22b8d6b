#include "MesoVolumeFormats.h"

#include "MesoVolumeFields.h"
#include "MesoVolumeNumbers.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <map>

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

/// The fields up to an empty line, behind which `place` lies then.
MesoVolumeFields ReadFields(
  const std::string& bytes, const std::string& fileName, std::size_t& place)
{
  MesoVolumeFields fields(fileName);
  if (bytes.compare(0, 4, "NRRD") != 0)
  {
    fields.Fail("", "is no NRRD file: it does not begin with NRRD");
  }
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
    // Others are comments, the magic and keys of the user's own.
    const std::size_t colon = line.find(": ");
    if (line[0] != '#' && colon != std::string::npos)
    {
      fields.Set(line.substr(0, colon), line.substr(colon + 2));
    }
  }
  return fields;
}

void ReadSpacing(const MesoVolumeFields& fields, MesoVolumeHeader& header)
{
  if (fields.Has("spacings"))
  {
    const std::vector<double> spacings = fields.Numbers("spacings", 3);
    std::copy(spacings.begin(), spacings.end(), header.Spacing.begin());
  }
  else if (fields.Has("space directions"))
  {
    const std::vector<double> directions = fields.Numbers("space directions", 9);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      header.Spacing[axis] =
        std::hypot(directions[3 * axis], directions[3 * axis + 1], directions[3 * axis + 2]);
    }
  }
}

void ReadEncoding(const MesoVolumeFields& fields, MesoVolumeHeader& header)
{
  const std::string encoding = fields.Of("encoding");
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
    fields.Fail("encoding", "'" + encoding + "' is none of raw, gzip and text");
  }
  const std::string endian = fields.Of("endian");
  const bool hasOrder = vtkDataArray::GetDataTypeSize(header.Type) > 1 &&
    header.Encoding != MesoVolumeHeader::Coding::Text;
  if (endian != "little" && endian != "big" && (hasOrder || !endian.empty()))
  {
    fields.Fail("endian", "'" + endian + "' is neither little nor big");
  }
  header.IsBigEndian = endian == "big";
  // The two may be spelt without the blank.
  const auto most = double(MesoVolumeMostBytes);
  header.SkippedLines = static_cast<std::size_t>(
    fields.WholeNumber(fields.OneOf({ "line skip", "lineskip" }), 0., most, 0.));
  const double bytes = fields.WholeNumber(fields.OneOf({ "byte skip", "byteskip" }), -1., most, 0.);
  header.IsAtEnd = bytes < 0.;
  header.SkippedBytes = static_cast<std::size_t>(std::max(bytes, 0.));
}
}

vtkSmartPointer<vtkImageData> MesoParseNrrd(const std::string& bytes, const std::string& fileName)
{
  std::size_t place = 0;
  const MesoVolumeFields fields = ReadFields(bytes, fileName, place);
  if (fields.Of("dimension") != "3")
  {
    fields.Fail(
      "dimension", "'" + fields.Of("dimension") + "': a volume has three, and one number a sample");
  }
  MesoVolumeHeader header;
  header.Size = fields.Size("sizes");
  header.Type = TypeOf(fields.Of("type"));
  if (header.Type == VTK_VOID)
  {
    fields.Fail("type", "'" + fields.Of("type") + "' is no type that can be read");
  }
  ReadSpacing(fields, header);
  ReadEncoding(fields, header);
  const std::string key = fields.OneOf({ "data file", "datafile" });
  if (!fields.Has(key))
  {
    return MesoDecodeVolume(header, std::string_view(bytes).substr(place), fileName);
  }
  const std::string name = fields.Of(key);
  if (name.empty() || name.find(' ') != std::string::npos || name == "LIST")
  {
    fields.Fail(key, "has its numbers in several files, or in none: one is read");
  }
  return MesoDecodeVolume(header, fields.BytesBeside(key), fileName);
}
