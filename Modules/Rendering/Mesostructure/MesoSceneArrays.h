#ifndef MesoSceneArrays_h
#define MesoSceneArrays_h

/**
 * @file MesoSceneArrays.h
 * @brief Point arrays that a scene names, made where they are Meso's own, and the parts they choose.
 */

#include "MesoScene.h"
#include "vtkSmartPointer.h"

#include <optional>
#include <string>
#include <vector>

class vtkPolyData;

/// Whether the filter that makes the array needs tangent frames.
bool MesoArrayNeedsFrames(const std::string& name);

/// The mesh with the array that is named: made where it is one of the surface filters' and the mesh
/// has none of its own. Throws a MesoInputError where there is no such array or component.
vtkSmartPointer<vtkPolyData> MesoWithArray(vtkPolyData* mesh, const std::string& name,
  const std::optional<int>& component, const std::string& place,
  std::vector<std::string>& warnings);

/// The part of a mesh that the key `part` names. Throws a MesoInputError where nothing is left.
vtkSmartPointer<vtkPolyData> MesoPartOfMesh(vtkPolyData* mesh, const MesoScenePart& part,
  const std::string& place, std::vector<std::string>& warnings);

#endif
