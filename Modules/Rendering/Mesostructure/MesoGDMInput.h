#ifndef MesoGDMInput_h
#define MesoGDMInput_h

/**
 * @file MesoGDMInput.h
 * @brief The table of a scene's volume (vtkMesoGDMTable): read of a baked file, or baked and kept.
 */

#include "MesoBakedFile.h"
#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkMesoGDMTable;

/// What a table was made with, and the table, as a baked file of kind "gdm" holds them.
MESORENDERINGMESOSTRUCTURE_EXPORT MesoBaked MesoBakedGDM(vtkMesoGDMTable* table);

/**
 * The table of a baked file. Throws MesoInputError "place: file: reason" where it is no baked file, of
 * another kind, or not whole.
 */
MESORENDERINGMESOSTRUCTURE_EXPORT vtkSmartPointer<vtkImageData> MesoReadGDM(
  const std::string& fileName, const std::string& place);

/**
 * The table of a canonical volume, out of the cache (MesoBakeOnce) where it is there.
 *
 * @param rank products; 0: the whole table, 16 bits a distance
 * @param cautious vtkMesoGDMTable::SetCautious(), for look-ups that are corrected
 */
MESORENDERINGMESOSTRUCTURE_EXPORT vtkSmartPointer<vtkImageData> MesoMakeGDM(vtkImageData* volume,
  int rank, bool cautious, const std::string& place, std::vector<std::string>& warnings);

/// The canonical volume that a table was made of.
MESORENDERINGMESOSTRUCTURE_EXPORT vtkSmartPointer<vtkImageData> MesoVolumeOfGDM(
  vtkImageData* table);

#endif
