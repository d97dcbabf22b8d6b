#ifndef MesoBakeCache_h
#define MesoBakeCache_h

/**
 * @file MesoBakeCache.h
 * @brief Tables that a scene needs are baked once and kept in a folder for the next time.
 *
 * The folder is what the environment variable MESO_CACHE names, else `meso` in XDG_CACHE_HOME, else
 * in the user's .cache; MESO_CACHE set to nothing turns keeping off. Each table is a baked file
 * (MesoBakedFile.h) named by its kind and by a checksum of what it was made from, so any of them may
 * be removed at any time, and several programs may use the folder at once.
 */

#include "MesoBakedFile.h"
#include "mesoIOMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"           // for the table

#include <functional>
#include <map>
#include <string>
#include <vector>

/// A checksum of an image's grid and point data, to be a parameter of what is baked from it.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoContentOf(vtkImageData* image);

/// The folder that tables are kept in; empty where keeping is off or no folder is known.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoBakeCacheFolder();

/// A name, for a file, of what is of this kind and made with these parameters, and of nothing else.
MESOIOMESOSTRUCTURE_EXPORT std::string MesoBakeName(
  const std::string& kind, const std::map<std::string, MesoBakedParameter>& parameters);

/**
 * The table of this kind and these parameters: read where it was kept, else baked and kept.
 *
 * @param kind as MesoBaked::Kind
 * @param parameters all that the table depends on: the content of what it is baked from
 *   (MesoContentOf), options, and a number that grows when the baker's results change
 * @param bake makes the table, as MesoBaked::Table; what it throws is passed on, and nothing is kept
 * @param warnings gains a line where the table could not be kept
 */
MESOIOMESOSTRUCTURE_EXPORT MesoBaked MesoBakeOnce(const std::string& kind,
  const std::map<std::string, MesoBakedParameter>& parameters,
  const std::function<vtkSmartPointer<vtkImageData>()>& bake, std::vector<std::string>& warnings);

#endif
