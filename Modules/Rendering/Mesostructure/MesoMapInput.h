#ifndef MesoMapInput_h
#define MesoMapInput_h

/**
 * @file MesoMapInput.h
 * @brief Reads a scene's map, whatever it is made of, and checks it against the surface it is on.
 */

#include "MesoScene.h"
#include "vtkSmartPointer.h"

class vtkImageData;
class vtkPolyData;

/// A map as it is stored, and what its numbers mean.
struct MesoStoredMap
{
  /// One component or more, of which the first is height or depth.
  vtkSmartPointer<vtkImageData> Image;
  /// The scene's `range`; of elevations (.dem) without one, the lowest and the highest.
  std::optional<std::array<double, 2>> Range;
};

/**
 * Makes the pattern or reads the file: an image, of a relief map its alpha channel, or elevations
 * (.dem, whose image has the samples' distances in metres as its spacing). A relief map whose normals
 * contradict its depths is warned of. Throws MesoInputError where it cannot be read.
 */
MesoStoredMap MesoReadMap(
  const MesoSceneMap& map, const std::string& place, std::vector<std::string>& warnings);

/// Object units between samples: the scene's `sample_spacing`, else that of elevations (.dem).
std::optional<std::array<double, 2>> MesoSampleSpacing(
  const MesoSceneMap& map, vtkImageData* heights);

/**
 * Warns where the samples lie otherwise on the surface than they say: the median over all points of
 * |dp/du| / (tiles x samples) is off by more than a tenth. A mesh without frames is not checked.
 */
void MesoCheckSampleSpacing(const MesoSceneNode& node, vtkImageData* heights, vtkPolyData* mesh,
  const std::string& place, std::vector<std::string>& warnings);

#endif
