#ifndef MesoSurfaceColors_h
#define MesoSurfaceColors_h

/**
 * @file MesoSurfaceColors.h
 * @brief What the keys `color_by` and `lookup_table` of a scene come to.
 */

#include "MesoScene.h"

class vtkMesoPolyDataMapper;
class vtkPolyData;

/// Makes the mapper colour by the array, which its input and the base mesh have. The range is that of
/// the base mesh, so that it is the same in every technique.
void MesoSetSurfaceColors(
  const MesoSceneColorBy& colorBy, vtkPolyData* base, vtkMesoPolyDataMapper* mapper);

#endif
