#ifndef MesoVolumeInput_h
#define MesoVolumeInput_h

/**
 * @file MesoVolumeInput.h
 * @brief Reads a scene's volume, whatever it is made of, into the canonical form.
 */

#include "MesoScene.h"
#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"

class vtkImageData;

/**
 * Makes the pattern, or reads the file: a canonical volume (MesoVolume.h). What is odd about it is added
 * to `warnings`, a line each, beginning with `place`. Throws MesoInputError "place: file: reason".
 */
MESORENDERINGMESOSTRUCTURE_EXPORT vtkSmartPointer<vtkImageData> MesoReadVolume(
  const MesoSceneVolume& volume, const std::string& place, std::vector<std::string>& warnings);

/// The volume with the colours of a file (MesoSetVolumeColors); the volume itself stays as it is. Throws
/// MesoInputError "place: file: reason".
MESORENDERINGMESOSTRUCTURE_EXPORT vtkSmartPointer<vtkImageData> MesoColoredVolume(
  vtkImageData* volume, const std::string& file, const std::string& place);

#endif
