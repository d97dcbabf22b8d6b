#include "MesoFileBytes.h"

#include "MesoScene.h" // for MesoInputError

#include <filesystem>
#include <fstream>

std::string MesoWhyNoFile(const std::string& fileName)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(fileName, error);
  if (!std::filesystem::exists(status))
  {
    return "there is no such file";
  }
  if (std::filesystem::is_directory(status))
  {
    return "is a folder, not a file";
  }
  return std::filesystem::is_regular_file(status) ? "" : "is a device or a pipe, not a file";
}

void MesoCheckIsFile(const std::string& fileName)
{
  const std::string reason = MesoWhyNoFile(fileName);
  if (!reason.empty())
  {
    throw MesoInputError(fileName + ": " + reason);
  }
}

std::string MesoReadBytes(const std::string& fileName, std::uintmax_t most, const std::string& kind)
{
  MesoCheckIsFile(fileName);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(fileName, error);
  if (error || size > most)
  {
    throw MesoInputError(fileName + ": is larger than " + kind + " may be (" +
      std::to_string((most + (1u << 20) - 1) >> 20) + " MiB)");
  }
  std::string bytes(size, '\0');
  std::ifstream file(fileName, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(size)))
  {
    throw MesoInputError(fileName + ": cannot be read");
  }
  return bytes;
}
