#ifndef MesoHeightVolume_h
#define MesoHeightVolume_h

/**
 * @file MesoHeightVolume.h
 * @brief A height map as a volume, for the techniques that draw volumes.
 */

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;

/**
 * The solid below a height map: z < h(x, y), a canonical volume (MesoVolume.h) of depth 1/4 tile, whose
 * surface is the bilinear one of the heights. It has as many voxels as the map has texels, 2 to 64 a side, and
 * 32 in z; larger maps are averaged down as volumes are (vtkMesoVolumeTile). Heights 0 and 1 lie 0.55
 * voxels within bottom and top, and those between accordingly, so that there is ground everywhere and no
 * peak is cut: 1/58 of the scale at most.
 *
 * @param heights what MesoToHeights makes: one float in [0, 1] a texel
 * @param place "file: nodes[i].mesostructure", before messages
 */
MESORENDERINGMESOSTRUCTURE_EXPORT vtkSmartPointer<vtkImageData> MesoVolumeOfHeights(
  vtkImageData* heights, const std::string& place, std::vector<std::string>& warnings);

#endif
