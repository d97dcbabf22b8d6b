#include "MesoExr.h"

#include "MesoAtomicFile.h"
#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError

#include <algorithm>
#include <set>

namespace
{
void CheckForWriting(const std::string& fileName, int width, int height,
  const std::vector<std::string>& channelNames, const float* data)
{
  const auto isSide = [](int side) { return side >= 1 && side <= MesoImageLargestSide; };
  if (!isSide(width) || !isSide(height))
  {
    throw MesoInputError(fileName + ": cannot be written with " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels (1 to " + std::to_string(MesoImageLargestSide) + ")");
  }
  const std::set<std::string> different(channelNames.begin(), channelNames.end());
  if (channelNames.empty() || different.size() != channelNames.size() || different.count("") > 0)
  {
    throw MesoInputError(fileName + ": cannot be written: channels must have names, all different");
  }
  if (!data)
  {
    throw MesoInputError(fileName + ": cannot be written: there are no pixels");
  }
}

/// For each wanted channel its number in the file.
std::vector<std::size_t> FindChannels(const std::string& fileName,
  const std::vector<std::string>& wanted, const std::vector<std::string>& there)
{
  std::vector<std::size_t> numbers;
  for (const std::string& name : wanted)
  {
    const auto found = std::find(there.begin(), there.end(), name);
    if (found == there.end())
    {
      std::string names;
      for (const std::string& other : there)
      {
        names += (names.empty() ? "" : ", ") + other;
      }
      throw MesoInputError(
        fileName + ": has no channel \"" + name + "\" (it has " + MesoPrintable(names) + ")");
    }
    numbers.push_back(found - there.begin());
  }
  return numbers;
}
}

void MesoWriteExr(const std::string& fileName, int width, int height,
  const std::vector<std::string>& channelNames, const float* data,
  const MesoExrAttributes& attributes)
{
  CheckForWriting(fileName, width, height, channelNames, data);
  MesoAtomicFile atomic(fileName);
  const std::string problem =
    MesoEncodeExr(atomic.TemporaryName(), width, height, channelNames, data, attributes);
  if (!problem.empty())
  {
    throw MesoInputError(fileName + ": cannot be written: " + problem);
  }
  atomic.Commit();
}

MesoExrImage MesoReadExr(const std::string& fileName, const std::vector<std::string>& channelNames)
{
  MesoImageInput input(fileName);
  const MesoImageHeader& header = input.Header();
  if (header.ValueType != MesoImageHeader::Type::Float)
  {
    throw MesoInputError(fileName + ": does not hold float values");
  }
  MesoExrImage image;
  image.Width = header.Width;
  image.Height = header.Height;
  image.Attributes = header.Attributes;
  image.ChannelNames = channelNames.empty() ? header.ChannelNames : channelNames;
  const auto numbers = FindChannels(fileName, image.ChannelNames, header.ChannelNames);

  std::vector<float> all(header.NumberOfValues());
  input.Read(all.data(), MesoImageInput::RowOrder::TopFirst);
  if (image.ChannelNames == header.ChannelNames)
  {
    image.Data = std::move(all);
    return image;
  }
  const std::size_t pixels = std::size_t(header.Width) * header.Height;
  image.Data.reserve(pixels * numbers.size());
  for (std::size_t pixel = 0; pixel < pixels; ++pixel)
  {
    for (std::size_t number : numbers)
    {
      image.Data.push_back(all[pixel * header.ChannelNames.size() + number]);
    }
  }
  return image;
}
