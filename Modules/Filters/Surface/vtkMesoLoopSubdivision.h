#ifndef vtkMesoLoopSubdivision_h
#define vtkMesoLoopSubdivision_h

/**
 * @class vtkMesoLoopSubdivision
 * @brief Make a mesh finer and smooth: Loop's subdivision surface, texture coordinates carried along.
 *
 * Input: vtkPolyData; polygons and strips are cut into triangles. Points of equal position, or of equal
 * `MesoVertex` where the input has it, are one vertex, so that seams of the texture are no edges. Output:
 * triangles, four times as many a level, with positions on the limit surface (double), the point arrays
 * `TextureCoordinates` (2, active, double, interpolated) where the input has them, and `MesoVertex` (1). It
 * has no normals: vtkMesoSurfaceFrames makes them.
 *
 * An update that is aborted gives an empty output. Boundaries are cubic B-splines of their own points. With more than MostTriangles, or an input that cannot
 * be read, one vtkErrorMacro line says so and the output is empty.
 *
 * Source: Loop, "Smooth Subdivision Surfaces Based on Triangles", University of Utah, 1987.
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for messages

class MESOFILTERSSURFACE_EXPORT vtkMesoLoopSubdivision : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoLoopSubdivision* New();
  vtkTypeMacro(vtkMesoLoopSubdivision, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  static constexpr vtkIdType MostTriangles = 20000000;

  ///@{
  /// How often each triangle is cut into four, 0 (triangles alone) to 6. Default: 1.
  vtkSetClampMacro(Levels, int, 0, 6);
  vtkGetMacro(Levels, int);
  ///@}

  /// Why the last update gave nothing; empty where it gave a mesh.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

protected:
  vtkMesoLoopSubdivision() = default;
  ~vtkMesoLoopSubdivision() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoLoopSubdivision(const vtkMesoLoopSubdivision&) = delete;
  void operator=(const vtkMesoLoopSubdivision&) = delete;

  void Execute(vtkPolyData* input, vtkPolyData* output);

  int Levels = 1;
  std::string ErrorMessage;
};

#endif
