#ifndef vtkMesoQuadricFit_h
#define vtkMesoQuadricFit_h

/**
 * @class vtkMesoQuadricFit
 * @brief Fit to each point the quadric that `relief-quadric` bends its height field over.
 *
 * Input port 0: vtkPolyData with the point array `MesoTangent` (3), as vtkMesoSurfaceFrames and
 * vtkMesoShapeSource give it. Polygons and strips are cut into triangles; vertex and line cells are
 * left out. Normals are made where there are none.
 *
 * Output port 0: vtkPolyData, the same points with the input's point and cell data, `Normals`,
 * `MesoVertex`, and the point data
 * - `MesoQuadric` (3): a, b, c of z = a x^2 + b y^2 + c x y in 1 / object unit, in object space.
 * - `MesoQuadricCondition` (1): ratio of singular values of the equations, columns of unit length;
 *   1 or more. 0 where there is no fit; the quadric is 0 there too, a plane.
 *
 * **The axes.** With n the point's unit normal and T its `MesoTangent`,
 *
 *     x = T - (T . n) n, made unit,    y = n x x,    z = -n, inward.
 *
 * So (x, y, n) is orthonormal and right-handed, x runs along dp/du, and y does NOT run along dp/dv
 * unless the chart is orthogonal and not mirrored: `MesoBitangent` B has the components
 * (B . x, B . y), B . y < 0 where the chart is mirrored. With `MesoTileScale` (s_u, s_v) a texture
 * step (du, dv) is x = s_u du + s_v (B . x) dv, y = s_v (B . y) dv. Where T lies along n or has no
 * length, x and y are any such pair, and MesoFrameValid is 0.
 *
 * MesoQuadric.h has the equations. Neighbours are those of Rings rings around the merged vertex
 * that can be reached without crossing a crease (MesoSmoothPatches.h). With Full off and Slopes
 * off, one ring and NormalEquations it is the fit of Oliveira2005, section 3, equation 2. On meshes
 * whose normals are estimates, Slopes with two rings is far more exact.
 *
 * 0, not noise, are the quadrics of planes (depths within the rounding of positions and normals),
 * of points with too few neighbours or with all of them on one line, of isolated points, and of
 * points of a crease that belong to both sides. No array is ever NaN. Arrays are double where the
 * input's positions are double, else float. vtkSMPTools runs over the points; results do not depend
 * on the number of threads. An update that is aborted gives an empty output.
 *
 * An input without points gives an output without points. One vtkErrorMacro line and an empty
 * output are given for a missing `MesoTangent`, positions, normals or tangents that are not finite
 * (the first point is named), and cells with points that do not exist.
 *
 * @sa vtkMesoPrincipalCurvatures vtkMesoSurfaceFrames
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for messages

class MESOFILTERSSURFACE_EXPORT vtkMesoQuadricFit : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoQuadricFit* New();
  vtkTypeMacro(vtkMesoQuadricFit, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether c is fitted too. Off: the diagonal quadric of Oliveira2005, c = 0. Default: on.
  vtkSetMacro(Full, bool);
  vtkGetMacro(Full, bool);
  vtkBooleanMacro(Full, bool);
  ///@}

  ///@{
  /// Whether slopes are fitted beside and left out, to make up for errors of the normals. Default:
  /// on.
  vtkSetMacro(Slopes, bool);
  vtkGetMacro(Slopes, bool);
  vtkBooleanMacro(Slopes, bool);
  ///@}

  ///@{
  /// Rings of neighbours, 1 to 8. Default: 2.
  vtkSetClampMacro(Rings, int, 1, 8);
  vtkGetMacro(Rings, int);
  ///@}

  ///@{
  /// Whether the normal equations are solved, as in Oliveira2005, or a QR factorization of the
  /// equations themselves. Default: off.
  vtkSetMacro(NormalEquations, bool);
  vtkGetMacro(NormalEquations, bool);
  vtkBooleanMacro(NormalEquations, bool);
  ///@}

  ///@{
  /// Degrees, 0 to 180: an edge is a crease where the normals of its two triangles differ by more.
  /// Default: 60.
  vtkSetClampMacro(FeatureAngle, double, 0., 180.);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  /// Why the last update gave nothing; empty where it gave a mesh.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }
  /// Points without a quadric after the last update.
  vtkGetMacro(NumberOfPointsWithout, vtkIdType);

protected:
  vtkMesoQuadricFit() = default;
  ~vtkMesoQuadricFit() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoQuadricFit(const vtkMesoQuadricFit&) = delete;
  void operator=(const vtkMesoQuadricFit&) = delete;

  void Execute(vtkPolyData* input, vtkPolyData* output);

  bool Full = true;
  bool Slopes = true;
  int Rings = 2;
  bool NormalEquations = false;
  double FeatureAngle = 60.;
  std::string ErrorMessage;
  vtkIdType NumberOfPointsWithout = 0;
};

#endif
