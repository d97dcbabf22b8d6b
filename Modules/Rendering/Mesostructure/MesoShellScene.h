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

/**
 * The shell over a node's mesh (vtkMesoPrismShell), as thick as the options' Scale. Prisms that turn over
 * are warned of. Throws MesoInputError where there is no such shell, or where the options' effects are
 * such that are only shown together.
 *
 * @param inScene "file: nodes[i]", for messages
 */
vtkSmartPointer<vtkPolyData> MesoMakeShell(vtkPolyData* base,
  const MesoMesostructureOptions& options, const std::string& inScene,
  std::vector<std::string>& warnings);

/// The volume's table of distances (MesoMakeGDM), whole at the quality Full. Throws as that does.
vtkSmartPointer<vtkImageData> MesoMakeShellTable(vtkImageData* volume,
  const MesoMesostructureOptions& options, const std::string& place,
  std::vector<std::string>& warnings);

/// Throws MesoInputError for what a material says that no volume is drawn with.
void MesoCheckShellMaterial(const MesoSceneMaterial& material, const std::string& inScene);

#endif
