/**
 * @class vtkMesoNormalMap
 * @brief A height map becomes the normal map of its relief, in tangent space.
 *
 * Over a flat tile whose sides are TileSize long, with D = Scale the depth of the relief in the same
 * unit, the surface (x, y, D h) has the normal (-D h_u / s_u, -D h_v / s_v, 1), made unit; u runs to
 * the right, v up, h_u and h_v are heights per tile. They are central differences over one texel,
 * with Wrap deciding what lies beyond the border: the shading normal of the truth at the texels'
 * centres (Marschner2008, "normals").
 *
 * Output: the input's image with the point scalars `Normal`: three floats, unit, z > 0.
 *
 * @sa vtkMesoPatternSource
 */

#ifndef vtkMesoNormalMap_h
#define vtkMesoNormalMap_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoHeightMapAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoNormalMap : public vtkMesoHeightMapAlgorithm
{
public:
  static vtkMesoNormalMap* New();
  vtkTypeMacro(vtkMesoNormalMap, vtkMesoHeightMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// D, from height 0 to height 1, in the unit of TileSize; at least 0. Default 0.1.
  vtkSetClampMacro(Scale, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /// How long a tile is along u and v; each above 0. Default 1, 1.
  vtkSetVector2Macro(TileSize, double);
  vtkGetVector2Macro(TileSize, double);
  ///@}

protected:
  vtkMesoNormalMap() = default;
  ~vtkMesoNormalMap() override = default;

  void Compute(const Map& map, vtkImageData* output) override;

private:
  vtkMesoNormalMap(const vtkMesoNormalMap&) = delete;
  void operator=(const vtkMesoNormalMap&) = delete;

  double Scale = 0.1;
  double TileSize[2] = { 1., 1. };
};

#endif
