#include "MesoAtomicFile.h"

#include "MesoScene.h" // for MesoInputError

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

MesoAtomicFile::MesoAtomicFile(const std::string& fileName)
  : Given(fileName)
{
  std::error_code error;
  fs::path target = fileName;
  if (fs::is_symlink(target, error))
  {
    target = fs::weakly_canonical(target, error);
  }
  if (fileName.empty() || !target.has_filename())
  {
    throw MesoInputError("\"" + fileName + "\": is not a file name to write to");
  }
  if (fs::exists(target, error) && !fs::is_regular_file(target, error))
  {
    throw MesoInputError(fileName + ": is there already and is not a file");
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
  {
    throw MesoInputError(fileName + ": there is no folder \"" + folder.string() + "\"");
  }
  static std::atomic<unsigned> count{ 0 };
  do
  {
    const std::string name = ".meso-" + std::to_string(getpid()) + "-" + std::to_string(count++);
    this->Temporary = (folder / name).string() + target.extension().string();
  } while (fs::exists(this->Temporary, error)); // left by a process that died
  this->Target = target.string();
}

MesoAtomicFile::~MesoAtomicFile()
{
  if (!this->Committed)
  {
    std::error_code error;
    fs::remove(this->Temporary, error);
  }
}

void MesoAtomicFile::Commit()
{
  std::error_code error;
  fs::rename(this->Temporary, this->Target, error);
  if (error)
  {
    throw MesoInputError(this->Given + ": cannot be written (" + error.message() + ")");
  }
  this->Committed = true;
}

void MesoAtomicFile::Write(const std::string& fileName, const void* bytes, std::size_t size)
{
  MesoAtomicFile atomic(fileName);
  std::ofstream file(atomic.TemporaryName(), std::ios::binary);
  file.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  file.close();
  if (!file)
  {
    throw MesoInputError(fileName + ": cannot be written");
  }
  atomic.Commit();
}
