#ifndef MesoSurfaceColors_h
#define MesoSurfaceColors_h

/**
 * @file MesoSurfaceColors.h
 * @brief What the keys `color_by` and `lookup_table` of a scene come to.
 */

#include "MesoScene.h"
#include "vtkSmartPointer.h"

class vtkMesoPolyDataMapper;
class vtkPolyData;

/// Whether the filter that makes the array needs tangent frames.
bool MesoColorNeedsFrames(const MesoSceneColorBy& colorBy);

/// The mesh with the array that is named: made where it is one of the surface filters' and the mesh
/// has none of its own. Throws a MesoInputError where there is no such array or component.
vtkSmartPointer<vtkPolyData> MesoWithColorArray(vtkPolyData* mesh, const MesoSceneColorBy& colorBy,
  const std::string& place, std::vector<std::string>& warnings);

/// Makes the mapper colour by the array, which its input and the base mesh have. The range is that of
/// the base mesh, so that it is the same in every technique.
void MesoSetSurfaceColors(
  const MesoSceneColorBy& colorBy, vtkPolyData* base, vtkMesoPolyDataMapper* mapper);

#endif
