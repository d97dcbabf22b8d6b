#ifndef TemporaryFolder_h
#define TemporaryFolder_h

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

/// A new empty folder that is removed with all that is in it.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "meso-XXXXXX").string();
    if (!mkdtemp(pattern.data()))
    {
      throw std::runtime_error("no temporary folder can be made: " + pattern);
    }
    this->Path = pattern;
  }
  ~TemporaryFolder()
  {
    std::error_code error;
    std::filesystem::remove_all(this->Path, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string PathOf(const std::string& name) const { return (this->Path / name).string(); }

  /// Writes a file and returns its path.
  std::string Write(const std::string& name, const std::string& bytes) const
  {
    std::ofstream(this->PathOf(name), std::ios::binary) << bytes;
    return this->PathOf(name);
  }

  /// Names of the files in it.
  std::vector<std::string> Names() const
  {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(this->Path))
    {
      names.push_back(entry.path().filename().string());
    }
    return names;
  }

private:
  std::filesystem::path Path;
};

#endif
