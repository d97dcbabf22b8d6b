#include "MesoVolumeNumbers.h"

#include "MesoMessage.h"
#include "MesoScene.h" // for MesoInputError
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtk_zlib.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace
{
/// Fills all of `target`; returns what is wrong with the bytes, or an empty text.
std::string Inflate(std::string_view bytes, char* target, std::size_t count)
{
  z_stream stream = {};
  constexpr int AnyHeader = 15 + 32; // gzip or zlib, whichever it is
  if (inflateInit2(&stream, AnyHeader) != Z_OK)
  {
    return "zlib does not start";
  }
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data())); // read only
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(target);
  stream.avail_out = static_cast<uInt>(count);
  const int result = inflate(&stream, Z_FINISH);
  const bool isFull = stream.avail_out == 0;
  inflateEnd(&stream);
  if (isFull && result == Z_STREAM_END)
  {
    return {};
  }
  return isFull ? "its compressed numbers are more than it says, or damaged"
                : "its compressed numbers are fewer than it says, or damaged";
}

void SwapBytes(char* values, std::size_t count, int size)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    std::reverse(values + i * std::size_t(size), values + (i + 1) * std::size_t(size));
  }
}

/// Numbers of a text; returns what is wrong with it, or an empty text.
std::string ReadText(std::string_view text, vtkDataArray* target)
{
  const char* place = text.data();
  for (vtkIdType i = 0; i < target->GetNumberOfTuples(); ++i)
  {
    char* end = nullptr;
    const double number = std::strtod(place, &end);
    if (end == place)
    {
      return "has " + std::to_string(i) + " numbers, not the " +
        std::to_string(target->GetNumberOfTuples()) + " that it says";
    }
    if (!(number >= target->GetDataTypeMin() && number <= target->GetDataTypeMax()))
    {
      return "number " + std::to_string(i) + " is beyond its type";
    }
    target->SetTuple1(i, number);
    place = end;
  }
  const std::string_view rest = text.substr(static_cast<std::size_t>(place - text.data()));
  if (rest.find_first_not_of(" \t\r\n\f\v") != std::string_view::npos)
  {
    return "has more than the " + std::to_string(target->GetNumberOfTuples()) +
      " numbers that it says";
  }
  return {};
}

/// The bytes of the numbers, without what is before them.
std::string_view NumbersIn(
  std::string_view bytes, const MesoVolumeHeader& header, std::size_t wanted)
{
  for (std::size_t lines = 0; lines < header.SkippedLines && !bytes.empty(); ++lines)
  {
    const std::size_t end = bytes.find('\n');
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
  const bool isAtEnd = header.IsAtEnd && header.Encoding == MesoVolumeHeader::Coding::Raw;
  const std::size_t skipped = isAtEnd ? bytes.size() - std::min(bytes.size(), wanted)
                                      : std::min(bytes.size(), header.SkippedBytes);
  bytes.remove_prefix(skipped);
  return bytes;
}

bool IsBigEndianHere()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 0;
}
}

vtkSmartPointer<vtkImageData> MesoDecodeVolume(
  const MesoVolumeHeader& header, std::string_view all, const std::string& fileName)
{
  const auto fail = [&](const std::string& reason)
  { throw MesoInputError(fileName + ": " + reason); };
  for (const double spacing : header.Spacing)
  {
    if (!(spacing > 0.) || !std::isfinite(spacing))
    {
      fail("has a spacing that is not above 0");
    }
  }
  const std::size_t count =
    std::size_t(header.Size[0]) * std::size_t(header.Size[1]) * std::size_t(header.Size[2]);
  const auto typeSize = std::size_t(vtkDataArray::GetDataTypeSize(header.Type));
  const std::string_view bytes = NumbersIn(all, header, count * typeSize);
  // zlib makes at most 1032 bytes of one.
  constexpr std::uint64_t mostOfOne = 1100;
  const std::uint64_t mostHeld = header.Encoding == MesoVolumeHeader::Coding::Gzip
    ? bytes.size() * mostOfOne
    : header.Encoding == MesoVolumeHeader::Coding::Text ? bytes.size() * typeSize
                                                        : bytes.size();
  if (count * typeSize > MesoVolumeMostBytes)
  {
    fail("takes more than 2 GiB in memory");
  }
  if (count * typeSize > mostHeld)
  {
    fail("holds fewer numbers than the " + std::to_string(count) + " that it says");
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(header.Size.data());
  image->SetSpacing(header.Spacing.data());
  image->AllocateScalars(header.Type, 1);
  auto* values = static_cast<char*>(image->GetScalarPointer());
  std::string problem;
  switch (header.Encoding)
  {
    case MesoVolumeHeader::Coding::Raw:
      std::memcpy(values, bytes.data(), count * typeSize);
      break;
    case MesoVolumeHeader::Coding::Gzip:
      problem = Inflate(bytes, values, count * typeSize);
      break;
    case MesoVolumeHeader::Coding::Text:
      problem = ReadText(bytes, image->GetPointData()->GetScalars());
      break;
  }
  if (!problem.empty())
  {
    fail(problem);
  }
  if (header.Encoding != MesoVolumeHeader::Coding::Text && typeSize > 1 &&
    header.IsBigEndian != IsBigEndianHere())
  {
    SwapBytes(values, count, static_cast<int>(typeSize));
  }
  return image;
}
