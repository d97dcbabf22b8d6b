#ifndef vtkMesoDirectionLines_h
#define vtkMesoDirectionLines_h

/**
 * @class vtkMesoDirectionLines
 * @brief Short lines along the principal directions of a mesh, to be drawn over it.
 *
 * Input port 0: vtkPolyData with the point arrays `MesoCurvature` (2), `MesoPrincipalDirections` (6)
 * and `MesoCurvatureConfidence` (1), as vtkMesoPrincipalCurvatures gives them. Cells are not looked
 * at, so that vtkMaskPoints may choose fewer points.
 *
 * Output port 0: vtkPolyData of lines of two points, with their middle at the point moved by Lift
 * along `Normals` (where the input has them), and the point array `MesoCurvature` (1), the curvature
 * along the line. Lines of c_max and of c_min of a point follow one another.
 *
 * There is no line where there is no direction: where the confidence is not above
 * MinimumConfidence, at umbilics, where
 *
 *     c_max - c_min <= UmbilicTolerance * max(|c_max|, |c_min|),
 *
 * where the surface is as good as flat, c_max - c_min <= 1e-4 / d with d the diagonal of the
 * input's bounds, and where a number is not finite.
 *
 * One vtkErrorMacro line and an empty output are given where an array is missing.
 *
 * @sa vtkMesoPrincipalCurvatures
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class MESOFILTERSSURFACE_EXPORT vtkMesoDirectionLines : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoDirectionLines* New();
  vtkTypeMacro(vtkMesoDirectionLines, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether lines along the direction of c_max are made. Default: on.
  vtkSetMacro(Maximum, bool);
  vtkGetMacro(Maximum, bool);
  vtkBooleanMacro(Maximum, bool);
  ///@}

  ///@{
  /// Whether lines along the direction of c_min are made. Default: on.
  vtkSetMacro(Minimum, bool);
  vtkGetMacro(Minimum, bool);
  vtkBooleanMacro(Minimum, bool);
  ///@}

  ///@{
  /// Length of a line in object units; 0 means 1/60 of the diagonal of the input's bounds.
  /// Default: 0.
  vtkSetClampMacro(Length, double, 0., VTK_DOUBLE_MAX);
  vtkGetMacro(Length, double);
  ///@}

  ///@{
  /// Height of a line's middle above the point, in lengths: what keeps lines out of concave and
  /// coarse places. Default: 0.1.
  vtkSetMacro(Lift, double);
  vtkGetMacro(Lift, double);
  ///@}

  ///@{
  /// Points of this confidence or less have no lines, 0 to 1. Default: 0.
  vtkSetClampMacro(MinimumConfidence, double, 0., 1.);
  vtkGetMacro(MinimumConfidence, double);
  ///@}

  ///@{
  /// Points whose curvatures differ by this fraction of the larger or less have no lines, 0 to 2.
  /// Default: 0.05.
  vtkSetClampMacro(UmbilicTolerance, double, 0., 2.);
  vtkGetMacro(UmbilicTolerance, double);
  ///@}

protected:
  vtkMesoDirectionLines() = default;
  ~vtkMesoDirectionLines() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoDirectionLines(const vtkMesoDirectionLines&) = delete;
  void operator=(const vtkMesoDirectionLines&) = delete;

  bool Maximum = true;
  bool Minimum = true;
  double Length = 0.;
  double Lift = 0.1;
  double MinimumConfidence = 0.;
  double UmbilicTolerance = 0.05;
};

#endif
