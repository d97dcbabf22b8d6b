#ifndef vtkMesoSurfaceFrames_h
#define vtkMesoSurfaceFrames_h

/**
 * @class vtkMesoSurfaceFrames
 * @brief Attach to each point of a textured mesh the tangent frame that relief needs.
 *
 * Input port 0: vtkPolyData with active point texture coordinates of 2 components (or an array of
 * that size named `TextureCoordinates`). Polygons and strips are cut into triangles; vertex and
 * line cells are left out.
 *
 * Output port 0: vtkPolyData, triangles in the input's order, with the input's point and cell data
 * and the point data
 * - `TextureCoordinates` (2, active): the input's.
 * - `Normals` (3, active, unit): the input's as they are; where it has none, or one of length 0,
 *   means of the triangles around the merged vertex, weighted with their angles there, so that a
 *   seam of the texture is no edge of the surface. SplitNormals makes hard edges.
 * - `MesoVertex` (1, double): number of the merged vertex. The input's if it numbers positions (a
 *   whole number from 0 to less than the number of points; equal numbers only at equal positions),
 *   else made: points of exactly equal position are one vertex.
 * - `MesoTangent`, `MesoBitangent` (3 each): unit directions of dp/du and dp/dv in the plane at
 *   right angles to the normal. NOT orthogonalised: charts may be mirrored and sheared.
 * - `MesoTileScale` (2): |dp/du| and |dp/dv|, object units per unit of texture coordinate.
 * - `MesoFrameValid` (1): 1, or 0 where there is no frame. There tangent and bitangent are
 *   orthonormal around the normal, and the scale is that of the whole mesh.
 *
 * MesoFrames.h has the equations, and says what a chart is and when a frame is not valid. A point is
 * split where several charts meet in it, or a chart and its mirror image, and with SplitNormals where
 * its triangles differ in normals; the copies follow the input's points. Made arrays are double where the input's positions are double, else float; points
 * keep their precision.
 *
 * An input without points gives an output without points. One vtkErrorMacro line and an empty
 * output are given for missing texture coordinates, coordinates or normals that are not finite (the
 * first point is named), and cells with points that do not exist.
 *
 * @sa vtkMesoShapeSource
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for messages

class MESOFILTERSSURFACE_EXPORT vtkMesoSurfaceFrames : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoSurfaceFrames* New();
  vtkTypeMacro(vtkMesoSurfaceFrames, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether normals that are made are split at sharp edges. Has no effect on normals that the
  /// input has. Default: off.
  vtkSetMacro(SplitNormals, bool);
  vtkGetMacro(SplitNormals, bool);
  vtkBooleanMacro(SplitNormals, bool);
  ///@}

  ///@{
  /// Degrees, 0 to 180: an edge is sharp where the normals of its two triangles differ by more.
  /// Default: 30.
  vtkSetClampMacro(FeatureAngle, double, 0., 180.);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  /// Why the last update gave nothing; empty where it gave a mesh.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }
  /// Points without a frame after the last update.
  vtkGetMacro(NumberOfInvalidFrames, vtkIdType);

protected:
  vtkMesoSurfaceFrames() = default;
  ~vtkMesoSurfaceFrames() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoSurfaceFrames(const vtkMesoSurfaceFrames&) = delete;
  void operator=(const vtkMesoSurfaceFrames&) = delete;

  void Execute(vtkPolyData* input, vtkPolyData* output);

  bool SplitNormals = false;
  double FeatureAngle = 30.;
  std::string ErrorMessage;
  vtkIdType NumberOfInvalidFrames = 0;
};

#endif
