#ifndef vtkMesoMeshPart_h
#define vtkMesoMeshPart_h

/**
 * @class vtkMesoMeshPart
 * @brief The triangles of a mesh on which a value lies in a range.
 *
 * For a mesh that is drawn with a technique here and another there: the parts of ranges that meet
 * make up the mesh, each triangle in one of them, and since points keep their normals and frames the
 * parts are shaded as one.
 *
 * Input port 0: vtkPolyData. Output port 0: its polygons whose corners' mean value v satisfies
 * Range[0] <= v < Range[1], in their order, the points they use, in their order, and all of their
 * data. Where there is an array `MesoVertex`, its numbers are made dense again. A value that is not
 * a number lies in no range.
 *
 * One vtkErrorMacro line and an empty output are given where there is no such array or component.
 *
 * @sa vtkMesoSurfaceFrames
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the name

class MESOFILTERSSURFACE_EXPORT vtkMesoMeshPart : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoMeshPart* New();
  vtkTypeMacro(vtkMesoMeshPart, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// What the value is: `x`, `y` or `z` of the position, `u` or `v` of the texture coordinates, else
  /// the name of a point array. Default: `z`.
  vtkSetMacro(By, std::string);
  vtkGetMacro(By, std::string);
  ///@}

  ///@{
  /// Of a point array: which component; -1: the magnitude of the tuple, or the value where there is
  /// one component. Default: -1.
  vtkSetMacro(Component, int);
  vtkGetMacro(Component, int);
  ///@}

  ///@{
  /// From, up to but without. Default: 0, 1.
  vtkSetVector2Macro(Range, double);
  vtkGetVector2Macro(Range, double);
  ///@}

protected:
  vtkMesoMeshPart() = default;
  ~vtkMesoMeshPart() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoMeshPart(const vtkMesoMeshPart&) = delete;
  void operator=(const vtkMesoMeshPart&) = delete;

  std::string By = "z";
  int Component = -1;
  double Range[2] = { 0., 1. };
};

#endif
