/**
 * @class vtkMesoObjectNormalMap
 * @brief A mesh and a height map on it become the normal map of the relief in object space.
 *
 * Each texel whose centre lies in a triangle of the mesh's texture coordinates has the normal of
 * `q = p + (h - 1) D n` there, with the normal and the tangents of the vertices interpolated and the change of n
 * left out, as bump mapping has it. Texels up to one beside a triangle continue it, so that filtering at a
 * chart's border reads normals; the rest are 0, no direction. Coordinates outside of [0,1] are
 * wrapped.
 *
 * Input 0: the height map, one float component in [0,1]. Input 1: the mesh, with normals, two texture
 * coordinates and the arrays of vtkMesoSurfaceFrames. Output: an image of Size with the point scalars
 * `Normal`, three floats, unit or 0, row 0 at t = 0.
 *
 * An object space map knows each point of the mesh, so charts must not overlap: where they do the last
 * triangle wins, and GetNumberOfOverlaps() tells. What cannot be used is said in one vtkErrorMacro line,
 * and the output is empty.
 *
 * Source: Marschner2008, normal mapping.
 *
 * @sa vtkMesoNormalMap, vtkMesoBumpMapper
 */

#ifndef vtkMesoObjectNormalMap_h
#define vtkMesoObjectNormalMap_h

#include "MesoOptions.h"           // for MesoWrap
#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoObjectNormalMap : public vtkImageAlgorithm
{
public:
  static vtkMesoObjectNormalMap* New();
  vtkTypeMacro(vtkMesoObjectNormalMap, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Texels along u and v, 1 to 16384. Default 512, 512.
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /// D, the depth of the deepest point, object units, at least 0. Default 0.1.
  vtkSetClampMacro(Scale, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /// Height map coordinate = texture coordinate x Tiles; each above 0. Default 1, 1.
  vtkSetVector2Macro(Tiles, double);
  vtkGetVector2Macro(Tiles, double);
  ///@}

  ///@{
  /// What lies outside of the height map. Default MesoWrap::Repeat.
  vtkSetEnumMacro(Wrap, MesoWrap);
  vtkGetEnumMacro(Wrap, MesoWrap);
  ///@}

  /// Texels of the last update whose centres lie in more than one triangle.
  vtkIdType GetNumberOfOverlaps() const { return this->NumberOfOverlaps; }

protected:
  vtkMesoObjectNormalMap();
  ~vtkMesoObjectNormalMap() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation*, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;

private:
  vtkMesoObjectNormalMap(const vtkMesoObjectNormalMap&) = delete;
  void operator=(const vtkMesoObjectNormalMap&) = delete;

  int Size[2] = { 512, 512 };
  double Scale = 0.1;
  double Tiles[2] = { 1., 1. };
  MesoWrap Wrap = MesoWrap::Repeat;
  vtkIdType NumberOfOverlaps = 0;
};

#endif
