#ifndef MesoShellScene_h
#define MesoShellScene_h

/**
 * @file MesoShellScene.h
 * @brief The shell of prisms in which a scene's mesostructure of volumes is drawn.
 */

#include "MesoOptions.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;
struct MesoSceneMaterial;
struct MesoSceneNode;

/**
 * The shell over a node's mesh (vtkMesoPrismShell), as thick as the options' Scale; of the technique Slices
 * and the Stack Prism cut into slices (MesoSlicesOf). Prisms that turn over
 * are warned of. Throws MesoInputError where there is no such shell, or where the options' effects are
 * such that are only shown together.
 *
 * @param inScene "file: nodes[i]", for messages
 */
vtkSmartPointer<vtkPolyData> MesoMakeShell(vtkPolyData* base, vtkImageData* volume,
  const MesoMesostructureOptions& options, const std::string& inScene,
  std::vector<std::string>& warnings);

/// A node's canonical volume, and its table of distances where the technique looks them up.
struct MesoShellVolume
{
  vtkSmartPointer<vtkImageData> Volume;
  vtkSmartPointer<vtkImageData> Table; ///< null: the technique has no use for it
};

/// Reads the volume, or makes one of the node's `heights` (MesoVolumeOfHeights), and makes its table (of gdm:
/// whole at the quality Full); or reads a baked table, which has its volume in it. Throws
/// MesoInputError "place...: reason".
MesoShellVolume MesoReadShellVolume(const MesoSceneNode& node, vtkImageData* heights,
  const std::string& place, std::vector<std::string>& warnings);

/// Throws MesoInputError for what a material says that no volume is drawn with.
void MesoCheckShellMaterial(const MesoSceneMaterial& material, const std::string& inScene);

#endif
