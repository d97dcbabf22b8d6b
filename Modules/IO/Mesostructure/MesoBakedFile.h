#ifndef MesoBakedFile_h
#define MesoBakedFile_h

/**
 * @file MesoBakedFile.h
 * @brief Tables that are computed once and kept: one VTK XML image file each.
 *
 * ParaView opens such a file as an image. Its point data is the largest table, its field data holds
 * the others and, under names that begin with "meso.", what the file is:
 *
 *   meso.kind             text: "cone", "maxmip", "horizon", "vdm", ...
 *   meso.format           the version of this layout, MesoBakedFormat
 *   meso.parameter.NAME   a text, or one or more doubles: what the table was made with
 *   meso.checksum         64-bit FNV-1a, hexadecimal, of all of the above and of every array
 *
 * The file ends in an XML comment with the same sum of all bytes before it, by which damage is
 * seen before VTK's XML parser, which crashes on some, gets to see it.
 */

#include "mesoIOMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"           // for the table

#include <map>
#include <string>
#include <variant>
#include <vector>

class vtkImageData;

/// The version of the layout that is written, and the only one that is read.
constexpr int MesoBakedFormat = 1;

using MesoBakedParameter = std::variant<std::string, std::vector<double>>;

struct MesoBaked
{
  std::string Kind;
  std::map<std::string, MesoBakedParameter> Parameters;
  /// Point data: the largest table; field data: named arrays of any length.
  vtkSmartPointer<vtkImageData> Table;
};

/**
 * Write a baked file, whole or not at all. The same contents give the same bytes.
 *
 * Throws MesoInputError "file: reason" where it cannot be written or the contents make no sense: no
 * kind, no point data, an array without a name or of bits, a name of ours among the field data.
 */
MESOIOMESOSTRUCTURE_EXPORT void MesoWriteBaked(const std::string& fileName, const MesoBaked& baked);

/**
 * Read a baked file. Its field data comes back without what begins with "meso.".
 *
 * @param kind the kind that is wanted, or empty for any
 * Throws MesoInputError "file: reason" where there is no such file, it is damaged or was written by
 * another program, is of another kind or of another version of the layout.
 */
MESOIOMESOSTRUCTURE_EXPORT MesoBaked MesoReadBaked(
  const std::string& fileName, const std::string& kind = {});

#endif
