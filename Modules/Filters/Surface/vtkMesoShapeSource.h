#ifndef vtkMesoShapeSource_h
#define vtkMesoShapeSource_h

/**
 * @class vtkMesoShapeSource
 * @brief Make a built-in shape as triangles, with its exact normals and tangent frames.
 *
 * Evaluates a closed form of MesoShape.h on a grid over each of its charts.
 * Triangles are counter-clockwise seen from outside; none has two corners at one position.
 *
 * Output port 0: vtkPolyData, object space, with point data
 * - `Normals` (3, active): unit, outward.
 * - `TextureCoordinates` (2, active): (u, v) in [0,1].
 * - `MesoVertex` (1, double): number of the merged vertex, from 0 without a gap. Points on both
 *   sides of a seam share it, as do all points of a pole and those of a cube's edge.
 * - `MesoTangent`, `MesoBitangent` (3 each): unit directions of dp/du and dp/dv.
 * - `MesoTileScale` (2): |dp/du| and |dp/dv| in object units.
 * - `MesoFrameValid` (1): 1 everywhere.
 *
 * A pole (of a sphere, a cone, a capped end) is one point a segment, with u in the middle of its segment. There |dp/du| is 0
 * by the closed form and the frame has no inverse, although the surface around is smooth and its
 * relief too. So poles have the limit direction along their meridian as tangent and the |dp/du| of
 * half a ring away, which is about the mean of their triangle, and count as valid.
 *
 * An unknown shape, key or value gives one vtkErrorMacro line (MesoShapeProblem()) and an empty
 * output.
 *
 * @sa vtkMesoSurfaceFrames
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <map>    // for parameters
#include <string> // for names
#include <vector> // for values

class MESOFILTERSSURFACE_EXPORT vtkMesoShapeSource : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoShapeSource* New();
  vtkTypeMacro(vtkMesoShapeSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// One of MesoShapeNames(). Default: plane.
  void SetShape(const char* shape);
  const char* GetShape() const { return this->Shape.c_str(); }
  ///@}

  /// Sets one of the shape's keys (MesoShapeParameters()); keys not set have their defaults.
  void SetParameter(const std::string& key, const std::vector<double>& values);
  /// Sets all keys back to their defaults.
  void ClearParameters();

  ///@{
  /// Precision of positions and arrays: vtkAlgorithm::SINGLE_PRECISION (default), else double.
  vtkSetMacro(OutputPointsPrecision, int);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  /// Why the last update gave nothing; empty where it gave a shape.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

protected:
  vtkMesoShapeSource();
  ~vtkMesoShapeSource() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoShapeSource(const vtkMesoShapeSource&) = delete;
  void operator=(const vtkMesoShapeSource&) = delete;

  std::string Shape = "plane";
  std::map<std::string, std::vector<double>> Parameters;
  int OutputPointsPrecision = SINGLE_PRECISION;
  std::string ErrorMessage;
};

#endif
