/**
 * @class vtkMesoMeshTile
 * @brief Make a canonical volume of a closed mesh that fills a tile.
 *
 * Box says which part of space is the tile; its sides in x and y become 1 each, and what the mesh has beyond
 * them comes in from the other side, as part of the tiles beside. Distances are exact to the triangles in the
 * samples around the surface and measured from there (MesoDistanceTransform), so the surface is right to a
 * small part of a voxel.
 *
 * Input: vtkPolyData of triangles that close a space and face outwards; it is taken as such (MesoReportMesh
 * counts its open edges). Output: a canonical volume (MesoVolume.h).
 *
 * An empty mesh, a box without a volume or a tile without anything solid in it gives one vtkErrorMacro
 * line and an empty output.
 */

#ifndef vtkMesoMeshTile_h
#define vtkMesoMeshTile_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoMeshTile : public vtkImageAlgorithm
{
public:
  static vtkMesoMeshTile* New();
  vtkTypeMacro(vtkMesoMeshTile, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Least and most x, y and z of the tile. Default: 0 to 0 each, which is the mesh's own box.
  vtkSetVector6Macro(Box, double);
  vtkGetVector6Macro(Box, double);
  ///@}

  ///@{
  /// Voxels along x, y, z, 2 to MesoVolumeMaximumSize. Default: 64, 64, 32.
  vtkSetVector3Macro(Size, int);
  vtkGetVector3Macro(Size, int);
  ///@}

protected:
  vtkMesoMeshTile() = default;
  ~vtkMesoMeshTile() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoMeshTile(const vtkMesoMeshTile&) = delete;
  void operator=(const vtkMesoMeshTile&) = delete;

  double Box[6] = { 0., 0., 0., 0., 0., 0. };
  int Size[3] = { 64, 64, 32 };
};

#endif
