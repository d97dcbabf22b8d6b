#ifndef MesoScalarBar_h
#define MesoScalarBar_h

/**
 * @file MesoScalarBar.h
 * @brief What a scene says of the numbers on a surface beside their colours: contour lines, scalar bar.
 */

#include "MesoContourLines.h"
#include "MesoScene.h"
#include "vtkSmartPointer.h"

#include <array>

class vtkMesoPolyDataMapper;
class vtkRenderer;
class vtkScalarBarActor;

/// A scene's contour lines in heights. `mapNumbers` are the map's stored numbers of the heights 0 and 1.
MesoContourLines MesoContoursOfScene(
  const MesoSceneContours& contours, const std::array<double, 2>& mapNumbers);

/**
 * A bar of the colours that the mapper draws by `colorBy`, as MesoSetSurfaceColors has set them: at
 * the right of the picture, further bars (`place` counts them from 0) to its left; its letters black
 * or white, whichever stands out from the renderer's background.
 */
vtkSmartPointer<vtkScalarBarActor> MesoMakeScalarBar(const MesoSceneScalarBar& bar,
  const MesoSceneColorBy& colorBy, vtkMesoPolyDataMapper* mapper, int place, vtkRenderer* renderer);

#endif
