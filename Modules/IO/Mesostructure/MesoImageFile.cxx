#include "MesoImageFile.h"

#include "MesoAtomicFile.h"
#include "MesoFileBytes.h"
#include "MesoMessage.h"
#include "MesoPngCheck.h"
#include "MesoScene.h" // for MesoInputError

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>

namespace
{
using OIIO::TypeDesc;

/// What was said last, in one line; `said` alone does not tell that all went well.
std::string Reason(std::string said)
{
  while (!said.empty() && (said.back() == '\n' || said.back() == ' '))
  {
    said.pop_back();
  }
  return said.empty() ? "it is truncated or damaged" : MesoPrintable(said);
}

bool IsServed(const TypeDesc& type)
{
  switch (type.basetype)
  {
    case TypeDesc::UINT8:
    case TypeDesc::UINT16:
    case TypeDesc::HALF:
    case TypeDesc::FLOAT:
    case TypeDesc::DOUBLE:
      return true;
    default:
      return false;
  }
}

/// The reason to refuse an image with this header, or an empty string.
std::string Problem(const OIIO::ImageSpec& spec, const MesoImageHeader& header)
{
  const std::string limit = std::to_string(MesoImageLargestSide);
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1)
  {
    return "has no pixels";
  }
  if (spec.width > MesoImageLargestSide || spec.height > MesoImageLargestSide)
  {
    return "is " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
      " pixels, over the limit of " + limit + " in either direction";
  }
  if (spec.depth > 1)
  {
    return "is a volume, not an image";
  }
  std::vector<TypeDesc> types = spec.channelformats;
  types.push_back(spec.format);
  for (const TypeDesc& type : types)
  {
    if (!IsServed(type))
    {
      return std::string("holds values of type ") + type.c_str() +
        ", which is not available yet (8 and 16 bit without sign, half and float are)";
    }
  }
  if (std::uint64_t(header.NumberOfValues()) * header.BytesPerValue() > MesoImageMostBytes)
  {
    return "takes more than 4 GiB in memory";
  }
  return {};
}

TypeDesc TypeOf(MesoImageHeader::Type type)
{
  return type == MesoImageHeader::Type::UnsignedChar ? TypeDesc::UINT8
    : type == MesoImageHeader::Type::UnsignedShort   ? TypeDesc::UINT16
                                                     : TypeDesc::FLOAT;
}

/// Writes in place. What went wrong, or an empty string.
std::string Encode(
  const std::string& fileName, const std::string& format, OIIO::ImageSpec spec, const float* data)
{
  const auto output = OIIO::ImageOutput::create(format);
  if (!output)
  {
    return Reason(OIIO::geterror());
  }
  // Without one OpenImageIO writes the time of day, and no two files are the same.
  spec.attribute("DateTime", "");
  const bool isWritten =
    output->open(fileName, spec) && output->write_image(TypeDesc::FLOAT, data) && output->close();
  return isWritten ? std::string() : Reason(output->geterror());
}

MesoImageHeader HeaderOf(const OIIO::ImageSpec& spec)
{
  MesoImageHeader header;
  header.Width = spec.width;
  header.Height = spec.height;
  header.ValueType = spec.format == TypeDesc::UINT8 ? MesoImageHeader::Type::UnsignedChar
    : spec.format == TypeDesc::UINT16               ? MesoImageHeader::Type::UnsignedShort
                                                    : MesoImageHeader::Type::Float;
  header.StoredType = spec.format.c_str();
  header.HasColorProfile = spec.find_attribute("ICCProfile") != nullptr;
  header.ChannelNames = spec.channelnames;
  for (const auto& attribute : spec.extra_attribs)
  {
    const std::string name = attribute.name().string();
    if (attribute.type() == TypeDesc::STRING)
    {
      header.Attributes[name] = attribute.get_string();
    }
    else if (attribute.type() == TypeDesc::DOUBLE)
    {
      header.Attributes[name] = *static_cast<const double*>(attribute.data());
    }
    else if (attribute.type() == TypeDesc::FLOAT || attribute.type() == TypeDesc::INT)
    {
      header.Attributes[name] = double(attribute.get_float());
    }
  }
  if (spec.width != spec.full_width || spec.height != spec.full_height)
  {
    header.Notes.push_back("the pixels cover " + std::to_string(spec.width) + " x " +
      std::to_string(spec.height) + " of a picture of " + std::to_string(spec.full_width) + " x " +
      std::to_string(spec.full_height) + "; they are taken as the whole");
  }
  if (spec.get_int_attribute("Orientation", 1) != 1)
  {
    header.Notes.push_back("asks to be turned or mirrored (orientation " +
      std::to_string(spec.get_int_attribute("Orientation", 1)) + "), which is not done");
  }
  return header;
}
}

class MesoImageInput::File
{
public:
  std::unique_ptr<OIIO::ImageInput> Input;
};

MesoImageInput::MesoImageInput(const std::string& fileName)
  : FileName(fileName)
  , Implementation(new File)
{
  MesoCheckIsFile(fileName);
  const std::string damage = MesoPngProblem(fileName);
  if (!damage.empty())
  {
    throw MesoInputError(fileName + ": " + damage);
  }
  OIIO::ImageSpec wanted;
  wanted.attribute("oiio:UnassociatedAlpha", 1); // the file's colors, not those times alpha
  wanted.attribute("oiio:RawColor", 1);
  auto& input = this->Implementation->Input;
  input = OIIO::ImageInput::open(fileName, &wanted);
  if (!input)
  {
    throw MesoInputError(
      fileName + ": is not an image that can be read: " + Reason(OIIO::geterror()));
  }
  this->Description = HeaderOf(input->spec());
  this->Description.Format = input->format_name();
  const std::string problem = Problem(input->spec(), this->Description);
  if (!problem.empty())
  {
    throw MesoInputError(fileName + ": " + problem);
  }
  // Formats that are decoded on opening (progressive JPEG) say here that they are truncated.
  if (input->has_error())
  {
    throw MesoInputError(fileName + ": cannot be read: " + Reason(input->geterror()));
  }
  if (input->seek_subimage(1, 0))
  {
    this->Description.Notes.emplace_back("holds several images, of which the first is taken");
  }
  input->geterror(); // that there is no second image is no error
  if (!input->seek_subimage(0, 0))
  {
    throw MesoInputError(fileName + ": cannot be read: " + Reason(input->geterror()));
  }
}

MesoImageInput::~MesoImageInput() = default;

int MesoImageInput::CountImages(int most)
{
  auto& input = *this->Implementation->Input;
  int count = 1;
  while (count <= most && input.seek_subimage(count, 0))
  {
    ++count;
  }
  input.geterror(); // that there is no further image is no error
  return count;
}

void MesoImageInput::Read(void* pixels, RowOrder order, int image)
{
  const auto& header = this->Description;
  const OIIO::ImageSpec spec = this->Implementation->Input->spec(image, 0);
  const bool isLikeTheFirst = spec.width == header.Width && spec.height == header.Height &&
    spec.depth <= 1 && spec.nchannels == static_cast<int>(header.ChannelNames.size()) &&
    spec.format.c_str() == header.StoredType;
  if (!isLikeTheFirst)
  {
    throw MesoInputError(this->FileName + ": image " + std::to_string(image) +
      " is of another size or type than the first");
  }
  const auto pixelBytes =
    static_cast<OIIO::stride_t>(header.ChannelNames.size() * header.BytesPerValue());
  const OIIO::stride_t rowBytes = pixelBytes * header.Width;
  const bool isFlipped = order == RowOrder::BottomFirst;
  auto* first = static_cast<char*>(pixels) + (isFlipped ? rowBytes * (header.Height - 1) : 0);
  auto& input = *this->Implementation->Input;
  const bool isRead = input.read_image(image, 0, 0, static_cast<int>(header.ChannelNames.size()),
    TypeOf(header.ValueType), first, pixelBytes, isFlipped ? -rowBytes : rowBytes);
  // A truncated JPEG or DDS file is "read", with grey for what is missing, and an error beside it.
  if (!isRead || input.has_error())
  {
    throw MesoInputError(this->FileName + ": cannot be read: " + Reason(input.geterror()));
  }
}

std::string MesoEncodeExr(const std::string& fileName, int width, int height,
  const std::vector<std::string>& channelNames, const float* data,
  const std::map<std::string, MesoImageAttribute>& attributes)
{
  OIIO::ImageSpec spec(width, height, static_cast<int>(channelNames.size()), TypeDesc::FLOAT);
  spec.channelnames = channelNames;
  spec.attribute("compression", "zip");
  for (const auto& [name, value] : attributes)
  {
    if (const auto* text = std::get_if<std::string>(&value))
    {
      spec.attribute(name, *text);
    }
    else
    {
      spec.attribute(name, TypeDesc::DOUBLE, std::get_if<double>(&value));
    }
  }
  return Encode(fileName, "exr", spec, data);
}

void MesoWriteImage(const std::string& fileName, int width, int height, int channels,
  MesoImageHeader::Type type, const float* data)
{
  using Type = MesoImageHeader::Type;
  const std::string extension = std::filesystem::path(fileName).extension().string();
  const bool isTiff = extension == ".tif" || extension == ".tiff";
  if (!isTiff && extension != (type == Type::Float ? ".exr" : ".png"))
  {
    throw MesoInputError(fileName + ": cannot be written: " +
      (type == Type::Float ? "float values go to .exr or .tif"
                           : "values of 8 or 16 bit go to .png or .tif"));
  }
  const auto isSide = [](int side) { return side >= 1 && side <= MesoImageLargestSide; };
  if (!isSide(width) || !isSide(height) || channels < 1 || channels > 4)
  {
    throw MesoInputError(fileName + ": cannot be written with " + std::to_string(width) + " x " +
      std::to_string(height) + " pixels of " + std::to_string(channels) + " channels");
  }
  const OIIO::ImageSpec spec(width, height, channels, TypeOf(type));
  MesoAtomicFile atomic(fileName);
  const std::string problem = Encode(atomic.TemporaryName(), extension.substr(1), spec, data);
  if (!problem.empty())
  {
    throw MesoInputError(fileName + ": cannot be written: " + problem);
  }
  atomic.Commit();
}
