#ifndef vtkMesoMapFromMesh_h
#define vtkMesoMapFromMesh_h

/**
 * @class vtkMesoMapFromMesh
 * @brief The maps that make a coarse mesh look like a detailed one.
 *
 * For the centre of each texel that a triangle of the base covers, the base has a position p and a
 * normal n; the detail lies at q = p + s n, where the line along n, inward and outward, meets the
 * detail's outer side nearest to p (Marschner2008, "maps from geometry"). With s in a height map,
 * h = (s - low) / (high - low), D = high - low and r = -low / D, the surface p + (h - r) D n is the
 * detail again.
 *
 * Input port 0: the base, vtkPolyData with texture coordinates that are an atlas. The map repeats
 * outside of [0,1] x [0,1].
 * Input port 1: the detail, vtkPolyData; for Correspondence Texture with texture coordinates that run
 * over the same atlas.
 *
 * Output port 0: vtkImageData of Size, row 0 at v = 0, with the point data
 * - `Displacement` (1 float, active): s in object units along the unit normal, + outward.
 * - `NormalObject` (3 float, unit): the detail's normal at q.
 * - `Normal` (3 float, unit): the same in the base's tangent space, as coordinates in the directions
 *   of dp/du and dp/dv at right angles to n, and n.
 * - a float array for each name given to AddDetailArray, interpolated at q: colours, curvatures.
 * - `State` (unsigned char): 0 no chart there, 1 met, 2 void: the detail lies within Reach nowhere
 *   along the line, 3 fold: the line meets the outer side more than once, or the displacement jumps
 *   by more than SlopeLimit texel widths towards a neighbouring texel.
 * Void texels and those outside of charts are filled from what is around them (push-pull), so that
 * sampling at charts' edges reads what belongs there.
 *
 * One vtkErrorMacro line and an empty output are given for missing or wild texture coordinates,
 * triangles longer than the map, arrays that the detail has not, meshes without triangles, and an
 * atlas of which nothing meets the detail.
 *
 * @sa vtkMesoDisplacedMesh
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <set>
#include <string>

class vtkPolyData;

class MESOFILTERSSURFACE_EXPORT vtkMesoMapFromMesh : public vtkImageAlgorithm
{
public:
  static vtkMesoMapFromMesh* New();
  vtkTypeMacro(vtkMesoMapFromMesh, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The detailed mesh, as data or as the output of another algorithm: input port 1.
  void SetDetailData(vtkPolyData* detail);
  void SetDetailConnection(vtkAlgorithmOutput* detail);
  ///@}

  ///@{
  /// Texels along u and v, 1 to 8192. Default: 1024, 1024.
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /// How far from the base the detail is looked for, inward and outward, in object units; 0 (the
  /// default): a tenth of the diagonal of the detail's bounds.
  vtkSetMacro(Reach, double);
  vtkGetMacro(Reach, double);
  ///@}

  /// How a point of the detail is found.
  enum CorrespondenceKind
  {
    Rays,   ///< where the line along the normal meets it
    Texture ///< where it has the same texture coordinates; what is off the normal is dropped
  };
  ///@{
  /// Default: Rays.
  vtkSetClampMacro(Correspondence, int, Rays, Texture);
  vtkGetMacro(Correspondence, int);
  ///@}

  ///@{
  /// Whether lines run along the triangle's own normal in place of the interpolated one, which makes the
  /// map jump from triangle to triangle. Default: off.
  vtkSetMacro(GeometricNormals, bool);
  vtkGetMacro(GeometricNormals, bool);
  vtkBooleanMacro(GeometricNormals, bool);
  ///@}

  ///@{
  /// A jump in displacement between neighbouring texels counts as a fold where it is more than this
  /// many times their distance; > 0. Default: 8 (83 degrees).
  vtkSetMacro(SlopeLimit, double);
  vtkGetMacro(SlopeLimit, double);
  ///@}

  ///@{
  /// Point arrays of the detail that become maps as well.
  void AddDetailArray(const std::string& name);
  void ClearDetailArrays();
  ///@}

  ///@{
  /// Texels of each state after the last update; overlapping are those under several triangles.
  vtkGetMacro(NumberOfMetTexels, vtkIdType);
  vtkGetMacro(NumberOfVoidTexels, vtkIdType);
  vtkGetMacro(NumberOfFoldTexels, vtkIdType);
  vtkGetMacro(NumberOfOverlappingTexels, vtkIdType);
  ///@}
  ///@{
  /// Least and largest displacement of a texel that met the detail.
  vtkGetVector2Macro(DisplacementRange, double);
  ///@}
  /// Correspondence Texture: how far the detail lies off the base's normals, at most. Else 0.
  vtkGetMacro(LargestDrift, double);

protected:
  vtkMesoMapFromMesh();
  ~vtkMesoMapFromMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;
  int RequestUpdateExtent(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;
  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;

private:
  vtkMesoMapFromMesh(const vtkMesoMapFromMesh&) = delete;
  void operator=(const vtkMesoMapFromMesh&) = delete;

  void MakeMaps(vtkPolyData* base, vtkPolyData* detail, vtkImageData* output);

  int Size[2] = { 1024, 1024 };
  double Reach = 0.;
  int Correspondence = Rays;
  bool GeometricNormals = false;
  double SlopeLimit = 8.;
  std::set<std::string> DetailArrays;
  vtkIdType NumberOfMetTexels = 0;
  vtkIdType NumberOfVoidTexels = 0;
  vtkIdType NumberOfFoldTexels = 0;
  vtkIdType NumberOfOverlappingTexels = 0;
  double DisplacementRange[2] = { 0., 0. };
  double LargestDrift = 0.;
};

#endif
