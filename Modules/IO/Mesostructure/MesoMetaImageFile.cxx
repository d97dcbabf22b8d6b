#include "MesoVolumeFormats.h"

#include "MesoVolumeFields.h"
#include "MesoVolumeNumbers.h"
#include "vtkImageData.h"

#include <algorithm>
#include <map>

namespace
{
int TypeOf(const std::string& name)
{
  static const std::map<std::string, int> types = { { "MET_CHAR", VTK_SIGNED_CHAR },
    { "MET_UCHAR", VTK_UNSIGNED_CHAR }, { "MET_SHORT", VTK_SHORT },
    { "MET_USHORT", VTK_UNSIGNED_SHORT }, { "MET_INT", VTK_INT }, { "MET_UINT", VTK_UNSIGNED_INT },
    { "MET_FLOAT", VTK_FLOAT }, { "MET_DOUBLE", VTK_DOUBLE } };
  const auto found = types.find(name);
  return found == types.end() ? VTK_VOID : found->second;
}

/// Fields up to the one that ends the header, behind which `place` lies then.
MesoVolumeFields ReadFields(
  const std::string& bytes, const std::string& fileName, std::size_t& place)
{
  MesoVolumeFields fields(fileName);
  while (place < bytes.size() && !fields.Has("ElementDataFile"))
  {
    const std::size_t end = std::min(bytes.find('\n', place), bytes.size());
    const std::string line = bytes.substr(place, end - place);
    place = std::min(end + 1, bytes.size());
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos)
    {
      fields.Fail("",
        "has a line without '=' in its header: it is no MetaImage, or it does not end in "
        "ElementDataFile");
    }
    const std::size_t last = line.find_last_not_of(" \t", equals == 0 ? 0 : equals - 1);
    const std::size_t first = line.find_first_not_of(" \t");
    fields.Set(line.substr(first, last == std::string::npos ? 0 : last + 1 - first),
      line.substr(equals + 1));
  }
  return fields;
}

MesoVolumeHeader HeaderOf(const MesoVolumeFields& fields)
{
  MesoVolumeHeader header;
  const std::string channels = fields.Of("ElementNumberOfChannels");
  if (fields.Of("NDims") != "3" || (!channels.empty() && channels != "1"))
  {
    fields.Fail("", "is no volume of three dimensions and one number a sample");
  }
  header.Size = fields.Size("DimSize");
  const std::string spacing = fields.OneOf({ "ElementSpacing", "ElementSize" });
  if (fields.Has(spacing))
  {
    const std::vector<double> numbers = fields.Numbers(spacing, 3);
    std::copy(numbers.begin(), numbers.end(), header.Spacing.begin());
  }
  header.Type = TypeOf(fields.Of("ElementType"));
  if (header.Type == VTK_VOID)
  {
    fields.Fail("ElementType", "'" + fields.Of("ElementType") + "' is no type that can be read");
  }
  header.IsBigEndian =
    fields.IsTrue("BinaryDataByteOrderMSB") || fields.IsTrue("ElementByteOrderMSB");
  header.Encoding = fields.IsTrue("CompressedData")            ? MesoVolumeHeader::Coding::Gzip
    : fields.Has("BinaryData") && !fields.IsTrue("BinaryData") ? MesoVolumeHeader::Coding::Text
                                                               : MesoVolumeHeader::Coding::Raw;
  const double skipped = fields.WholeNumber("HeaderSize", -1., double(MesoVolumeMostBytes), 0.);
  header.IsAtEnd = skipped < 0.;
  header.SkippedBytes = static_cast<std::size_t>(std::max(skipped, 0.));
  return header;
}
}

vtkSmartPointer<vtkImageData> MesoParseMetaImage(
  const std::string& bytes, const std::string& fileName)
{
  std::size_t place = 0;
  const MesoVolumeFields fields = ReadFields(bytes, fileName, place);
  MesoVolumeHeader header = HeaderOf(fields);
  const std::string name = fields.Of("ElementDataFile");
  if (name == "LOCAL")
  {
    header.SkippedBytes = 0; // it counts from the file's beginning: the header
    return MesoDecodeVolume(header, std::string_view(bytes).substr(place), fileName);
  }
  if (name.empty() || name == "LIST" || name.find('%') != std::string::npos)
  {
    fields.Fail("ElementDataFile", "has its numbers in several files, or in none: one is read");
  }
  return MesoDecodeVolume(header, fields.BytesBeside("ElementDataFile"), fileName);
}
