#ifndef MesoSceneAttributes_h
#define MesoSceneAttributes_h

/**
 * @file MesoSceneAttributes.h
 * @brief What a reader of AOVs must know of the scene: objects, lights, camera.
 */

#include "MesoExr.h"
#include "mesoRenderingMesostructureModule.h" // for export macro

class MesoSceneBuilder;
class vtkRenderer;

/**
 * Attributes for an EXR file of a scene's AOVs. Lengths are in world units where nothing else is
 * said; a vector is three numbers, `.x`, `.y`, `.z`.
 *
 * | name | value |
 * | --- | --- |
 * | `meso.<n>.name` | of object n, counted as the channel `object` does |
 * | `meso.<n>.scale` | D, in object units |
 * | `meso.<n>.world_units` | world units in an object unit: cube root of the matrix's volume factor |
 * | `meso.<n>.map_width`, `.map_height` | texels; not there without a map |
 * | `meso.light.<k>.towards` | unit vector towards directional light k, counted as `shadow.<k>` is |
 * | `meso.light.<k>.position` | of a light that has one, instead |
 * | `meso.camera.position`, `.forward` | of the camera; unit vector along its axis |
 * | `meso.camera.right`, `.up` | from the middle of the picture to that of its right and upper side, |
 * | | at the distance 1, or at every distance where `meso.camera.parallel` is 1 (else 0) |
 *
 * The renderer's lights and camera are taken as they were drawn last.
 *
 * @param aspect width / height of the picture
 */
MESORENDERINGMESOSTRUCTURE_EXPORT MesoExrAttributes MesoAttributesOfScene(
  const MesoSceneBuilder& builder, vtkRenderer* renderer, double aspect);

#endif
