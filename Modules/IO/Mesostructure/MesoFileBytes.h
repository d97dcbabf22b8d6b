#ifndef MesoFileBytes_h
#define MesoFileBytes_h

/**
 * @file MesoFileBytes.h
 * @brief Whole files, and clear words where there is none.
 */

#include "mesoIOMesostructureModule.h" // for export macro

#include <cstdint>
#include <string>

/// Throws MesoInputError "file: reason" where this is no file: not there, a folder, a device.
MESOIOMESOSTRUCTURE_EXPORT void MesoCheckIsFile(const std::string& fileName);

/// Why a name is not that of a file, "there is no such file" or "is a folder, not a file", or an
/// empty text where it is.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoWhyNoFile(const std::string& fileName);

/// The file's bytes, at most `most` of them, which is checked before memory is taken. `kind` names
/// what is too large: "a mesh file". Throws MesoInputError.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoReadBytes(
  const std::string& fileName, std::uintmax_t most, const std::string& kind);

#endif
