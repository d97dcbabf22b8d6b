#ifndef MesoAtomicFile_h
#define MesoAtomicFile_h

/**
 * @file MesoAtomicFile.h
 * @brief Writes a file beside its place and moves it there whole, or not at all.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <cstddef>
#include <string>

/**
 * Names a file beside `fileName` for the caller to write; Commit() renames it, which replaces what
 * was there in one step. Without a Commit() the destructor removes it. The name begins with a dot
 * and keeps the extension, which many writers go by. A link is followed: its target is replaced.
 */
class MESOIOMESOSTRUCTURE_EXPORT MesoAtomicFile
{
public:
  /// Throws MesoInputError where the folder does not exist or `fileName` is there but no file.
  explicit MesoAtomicFile(const std::string& fileName);
  ~MesoAtomicFile();
  MesoAtomicFile(const MesoAtomicFile&) = delete;
  MesoAtomicFile& operator=(const MesoAtomicFile&) = delete;

  /// The file to write; it does not exist yet.
  const std::string& TemporaryName() const { return this->Temporary; }

  /// Throws MesoInputError where the file was not written or cannot be moved.
  void Commit();

  /// Write a whole file of `size` bytes. Throws MesoInputError where that is not possible.
  static void Write(const std::string& fileName, const void* bytes, std::size_t size);

private:
  std::string Given;
  std::string Target;
  std::string Temporary;
  bool Committed = false;
};

#endif
