#include "MesoVolumeFormats.h"

#include "MesoFileBytes.h"
#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "MesoVolumeNumbers.h"
#include "vtkImageData.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

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

/// Three numbers of a text, or none.
bool ReadThree(const std::string& text, std::array<double, 3>& three)
{
  std::istringstream words(text);
  return bool(words >> three[0] >> three[1] >> three[2]);
}
}

vtkSmartPointer<vtkImageData> MesoParseMetaImage(
  const std::string& bytes, const std::string& fileName)
{
  const auto fail = [&](const std::string& reason)
  { throw MesoInputError(fileName + ": " + MesoPrintable(reason)); };
  std::map<std::string, std::string> fields;
  std::size_t place = 0;
  while (place < bytes.size() && !fields.count("ElementDataFile"))
  {
    const std::size_t end = std::min(bytes.find('\n', place), bytes.size());
    const std::string line = bytes.substr(place, end - place);
    place = std::min(end + 1, bytes.size());
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos)
    {
      fail("has a line without '=' in its header: it is no MetaImage, or it does not end in "
           "ElementDataFile");
    }
    const auto trimmed = [](std::string text)
    {
      text.erase(0, text.find_first_not_of(" \t"));
      text.erase(text.find_last_not_of(" \t\r") + 1);
      return text;
    };
    fields[trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
  }
  const auto isTrue = [&](const char* key)
  { return fields[key] == "True" || fields[key] == "true" || fields[key] == "1"; };
  MesoVolumeHeader header;
  std::array<double, 3> size{};
  const std::string channels = fields["ElementNumberOfChannels"];
  if (fields["NDims"] != "3" || !ReadThree(fields["DimSize"], size) ||
    (!channels.empty() && channels != "1"))
  {
    fail("is no volume of three dimensions and one number a sample");
  }
  std::transform(size.begin(), size.end(), header.Size.begin(),
    [](double side) { return side >= 1. && side <= 1e6 ? static_cast<int>(side) : 0; });
  if (!ReadThree(fields["ElementSpacing"], header.Spacing))
  {
    header.Spacing = { 1., 1., 1. };
    ReadThree(fields["ElementSize"], header.Spacing);
  }
  header.Type = TypeOf(fields["ElementType"]);
  header.IsBigEndian = isTrue("BinaryDataByteOrderMSB") || isTrue("ElementByteOrderMSB");
  header.Encoding = isTrue("CompressedData") ? MesoVolumeHeader::Coding::Gzip
    : fields["BinaryData"] == "False"        ? MesoVolumeHeader::Coding::Text
                                             : MesoVolumeHeader::Coding::Raw;
  const std::string name = fields["ElementDataFile"];
  if (name == "LOCAL")
  {
    return MesoDecodeVolume(header, bytes.substr(place), fileName);
  }
  if (name.empty() || name == "LIST" || name.find('%') != std::string::npos)
  {
    fail("has its numbers in several files, or in none: one file is read");
  }
  const auto beside = std::filesystem::path(fileName).parent_path() / name;
  return MesoDecodeVolume(
    header, MesoReadBytes(beside.string(), MesoVolumeMostBytes, "a volume file"), fileName);
}
