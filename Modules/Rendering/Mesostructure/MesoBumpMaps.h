#ifndef MesoBumpMaps_h
#define MesoBumpMaps_h

/**
 * @file MesoBumpMaps.h
 * @brief The maps that the techniques of vtkMesoBumpMapper draw, read or made of a scene's height map.
 */

#include "MesoNormalMap.h"
#include "MesoOptions.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkMesoBumpMapper;
class vtkPolyData;
struct MesoSceneMaterial;

/// A normal map and what its numbers mean.
struct MesoNormals
{
  vtkSmartPointer<vtkImageData> Image; ///< null: none
  MesoNormalMapMeaning Meaning;
};

/// The depth of the relief in widths of a tile, over the whole mesh: what tables are baked for.
double MesoDepthInTiles(vtkPolyData* mesh, const MesoMesostructureOptions& options);

/// The material's normal map; throws MesoInputError "place: reason" where it is none.
MesoNormals MesoReadNormalMap(
  const MesoSceneMaterial& material, const std::string& place, std::vector<std::string>& warnings);

/// The horizons of a height map as the relief's depth on the mesh asks for, and the filter's Scale.
vtkSmartPointer<vtkImageData> MesoMakeHorizons(vtkImageData* heights, vtkPolyData* mesh,
  const MesoMesostructureOptions& options, double& scale, const std::string& place,
  std::vector<std::string>& warnings);

/// Gives the mapper what its technique draws: normals made of the heights where `given` has none, and
/// horizons. Heights may be null.
void MesoSetBumpMaps(vtkMesoBumpMapper* mapper, vtkImageData* heights, vtkPolyData* mesh,
  const MesoNormals& given, const std::string& place, std::vector<std::string>& warnings);

#endif
