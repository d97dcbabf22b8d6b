#ifndef vtkMesoMovedMesh_h
#define vtkMesoMovedMesh_h

/**
 * @class vtkMesoMovedMesh
 * @brief Move a mesh along its normals, and fit its tangent frames again.
 *
 * For relief that rises above its mesh. The surface q = p + (h - r) D n with r < 1 lies inward of
 * p' = p + (1 - r) D n, and q = p' + (h - 1) D n is what techniques draw that rasterise a base and
 * look below it. So that base has to be the mesh moved by Distance = (1 - r) D. Between the points
 * p' is linear, so it differs from the true one by Distance times the square of half the angle by
 * which n turns over a triangle.
 *
 * Input port 0: vtkPolyData with point normals of any length but 0 and texture coordinates, as
 * vtkMesoSurfaceFrames and vtkMesoShapeSource give it.
 *
 * Output port 0: the input, its points at p + Distance n with n the unit normal, and the arrays of
 * vtkMesoSurfaceFrames fitted to them: `MesoTangent`, `MesoBitangent`, `MesoTileScale`,
 * `MesoFrameValid`. Points of one position and normal stay one position; those of one position and
 * different normals (hard edges) come apart, as the true surface does, and `MesoVertex` is made
 * anew. Other arrays, normals among them, stay as they are: curvatures and quadrics are those
 * of the mesh that was moved, and are to be made afterwards.
 *
 * One vtkErrorMacro line and an empty output are given for missing normals, normals of length 0 or
 * not finite, a Distance that is not finite, and what vtkMesoSurfaceFrames refuses. An input without
 * points gives an output without points.
 *
 * @sa vtkMesoSurfaceFrames, vtkMesoDisplacedMesh
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for messages

class MESOFILTERSSURFACE_EXPORT vtkMesoMovedMesh : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoMovedMesh* New();
  vtkTypeMacro(vtkMesoMovedMesh, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// How far each point is moved along its normal, object units; negative: inward. Default: 0.
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  /// Why the last update gave nothing; empty where it gave a mesh.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

protected:
  vtkMesoMovedMesh() = default;
  ~vtkMesoMovedMesh() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoMovedMesh(const vtkMesoMovedMesh&) = delete;
  void operator=(const vtkMesoMovedMesh&) = delete;

  void Execute(vtkPolyData* input, vtkPolyData* output);

  double Distance = 0.;
  std::string ErrorMessage;
};

#endif
