#ifndef vtkMesoPrincipalCurvatures_h
#define vtkMesoPrincipalCurvatures_h

/**
 * @class vtkMesoPrincipalCurvatures
 * @brief Principal curvatures and directions of a mesh at its points, with a confidence.
 *
 * Input port 0: vtkPolyData. Polygons and strips are cut into triangles; vertex and line cells are
 * left out. Triangles must be wound so that their normals point outward; normals of the input,
 * where it has them, turn the sign: convex is positive along them.
 *
 * Output port 0: vtkPolyData, the same points with the input's point and cell data and the point
 * data
 * - `Normals` (3, active, unit): the input's as they are; where it has none, or one of length 0,
 *   means of the triangles around the merged vertex, weighted with their angles there.
 * - `MesoVertex` (1, double): number of the merged vertex. The input's if it numbers positions,
 *   else made, as vtkMesoSurfaceFrames does.
 * - `MesoCurvature` (2): c_max >= c_min in 1 / object unit, positive where the surface is convex.
 * - `MesoPrincipalDirections` (6): unit directions in object space of c_max, then of c_min, at
 *   right angles to the point's normal n and to each other; (c_max, c_min, n) is right-handed. A
 *   direction has no sense: of the first its largest component is positive. At umbilics it is any
 *   pair, the same in every run.
 * - `MesoCurvatureConfidence` (1): 0 to 1; MesoJetFit.h has its definition.
 *
 * Values belong to merged vertices, so that a seam of the texture is no border. A polynomial of
 * degree 4 is fitted to the two rings around each (MesoJetFit.h has the equations, MesoSiteFits.h
 * the choice of neighbours, MesoSmoothPatches.h what a crease is), one-sided at open borders. Where
 * normals are split at a crease, the points on each side have the curvatures of their side.
 *
 * All three arrays are 0, directions too, where there are no curvatures: at isolated points, where
 * fewer than six neighbours can be reached without crossing a crease, where neighbours lie on a
 * line, and at points of a crease or of touching sheets that belong to both sides. No array is ever
 * NaN.
 *
 * Arrays are double where the input's positions are double, else float; curvatures beyond float's
 * range are refused as not found (0). vtkSMPTools runs over the vertices; results do not depend on
 * the number of threads. An update that is aborted gives an empty output.
 *
 * An input without points gives an output without points. One vtkErrorMacro line and an empty
 * output are given for positions or normals that are not finite (the first point is named), and
 * cells with points that do not exist.
 *
 * @sa vtkMesoQuadricFit vtkMesoSurfaceFrames
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for messages

class MESOFILTERSSURFACE_EXPORT vtkMesoPrincipalCurvatures : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoPrincipalCurvatures* New();
  vtkTypeMacro(vtkMesoPrincipalCurvatures, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Degrees, 0 to 180: an edge is a crease where the normals of its two triangles differ by more.
  /// Default: 60.
  vtkSetClampMacro(FeatureAngle, double, 0., 180.);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  /// Why the last update gave nothing; empty where it gave a mesh.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }
  /// Points without curvatures after the last update.
  vtkGetMacro(NumberOfPointsWithout, vtkIdType);

protected:
  vtkMesoPrincipalCurvatures() = default;
  ~vtkMesoPrincipalCurvatures() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoPrincipalCurvatures(const vtkMesoPrincipalCurvatures&) = delete;
  void operator=(const vtkMesoPrincipalCurvatures&) = delete;

  void Execute(vtkPolyData* input, vtkPolyData* output);

  double FeatureAngle = 60.;
  std::string ErrorMessage;
  vtkIdType NumberOfPointsWithout = 0;
};

#endif
