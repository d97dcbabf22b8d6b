#ifndef vtkMesoDisplacedMesh_h
#define vtkMesoDisplacedMesh_h

/**
 * @class vtkMesoDisplacedMesh
 * @brief Dice a mesh finely and displace it by a height map: relief as ordinary triangles.
 *
 * The surface is q = p + (h - r) D n (MesoDisplacement.h has the equations). Its diced points lie on
 * it, their positions computed in double; between them it is replaced by flat triangles. The error
 * against it falls fourfold when FacetsPerTexel is doubled, as long as no facet crosses a line of
 * texel centres, where a bilinear map has creases; there it falls at least by half.
 *
 * Input port 0: vtkPolyData with active point texture coordinates of 2 components (or an array of
 * that size named `TextureCoordinates`). Polygons and strips are cut into triangles, vertex and line
 * cells left out. Normals are made where there are none: means over merged vertices, weighted with
 * angles. `MesoVertex`, as vtkMesoSurfaceFrames and vtkMesoShapeSource give it, says which points
 * are one position; without it points of exactly equal position are.
 *
 * Input port 1: the height map, vtkImageData of one slice with one component of float in [0,1], row
 * 0 at t = 0, texel centres at (i + 0.5) / size, bilinear between them.
 *
 * Output port 0: vtkPolyData, triangles with the winding of the input's, and the point data
 * - `Normals` (3, active, unit): the shading normal of the displaced surface.
 * - `TextureCoordinates` (2, active): the mesh's own.
 * - `MesoRelief` (1): depth 1 - h in [0,1].
 * Arrays and points are double where the input's positions are double, else float. The input's
 * other point data are carried along where they are named (AddCarriedArray), interpolated; its cell
 * data are not, its field data are.
 *
 * **Closed.** The number of segments of an edge is decided by that edge alone (MesoDicePlan.h), and
 * a point on it is computed once for all triangles and charts around: a closed mesh gives a closed
 * one, with equal positions bit for bit, wherever the surface itself is closed. It is torn where
 * normals or heights differ between the sides of an edge: at hard edges, and at seams of the
 * texture across which the map does not continue. NumberOfTornEdges and LargestTear say so.
 *
 * vtkSMPTools runs over points and triangles; results do not depend on the number of threads. An
 * update that is aborted gives an empty output. An input without points gives an output without
 * points. One vtkErrorMacro line and an empty output are given for more triangles than
 * MaximumNumberOfTriangles (before memory is taken for them), for missing texture coordinates or carried arrays,
 * positions, normals, coordinates or heights that are not finite or heights outside [0,1] (the
 * first is named), cells with points that do not exist, and parameters out of range.
 *
 * Source of the normal: Blinn1978, Marschner2008.
 *
 * @sa vtkMesoSurfaceFrames
 */

#include "MesoOptions.h"              // for MesoWrap
#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <set>    // for names
#include <string> // for messages

class MesoDicePlan;
class MesoDisplacement;
class vtkImageData;
struct MesoTriangleMesh;

class MESOFILTERSSURFACE_EXPORT vtkMesoDisplacedMesh : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoDisplacedMesh* New();
  vtkTypeMacro(vtkMesoDisplacedMesh, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The height map, input port 1.
  void SetHeightMapData(vtkImageData* heights);
  void SetHeightMapConnection(vtkAlgorithmOutput* heights);
  ///@}

  ///@{
  /// D, the height of the relief from its deepest point to its highest, in object units, >= 0.
  /// Default: 0.
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /// r, the height that lies on the base mesh, in [0,1]: 1 displaces inward, 0 outward. Default: 1.
  vtkSetMacro(Reference, double);
  vtkGetMacro(Reference, double);
  ///@}

  ///@{
  /// Map coordinate = texture coordinate x tiles; each > 0. Default: 1, 1.
  vtkSetVector2Macro(Tiles, double);
  vtkGetVector2Macro(Tiles, double);
  ///@}

  ///@{
  /// What lies outside the map. Default: MesoWrap::Repeat.
  vtkSetEnumMacro(Wrap, MesoWrap);
  vtkGetEnumMacro(Wrap, MesoWrap);
  ///@}

  ///@{
  /// Segments of an edge a texel along the axis of the map on which it is longer, > 0. Triangles
  /// grow with its square. Default: 1 (MesoFacetsPerTexel has the qualities').
  vtkSetMacro(FacetsPerTexel, double);
  vtkGetMacro(FacetsPerTexel, double);
  ///@}

  ///@{
  /// More triangles are refused, 1 to 500 million. Default: 20 million, about 0.7 GB with points of
  /// float.
  vtkSetClampMacro(MaximumNumberOfTriangles, vtkIdType, 1, 500000000);
  vtkGetMacro(MaximumNumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /// Whether normals are those of the displaced surface, or n, the base's, interpolated. Default:
  /// on.
  vtkSetMacro(DetailNormals, bool);
  vtkGetMacro(DetailNormals, bool);
  vtkBooleanMacro(DetailNormals, bool);
  ///@}

  ///@{
  /// Point arrays of the input that the output has too, interpolated linearly, those of integers as
  /// floats; names of the output's own arrays change nothing. Default: none.
  void AddCarriedArray(const std::string& name);
  void ClearCarriedArrays();
  ///@}

  /// Why the last update gave nothing; empty where it gave a mesh.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }
  /// Edges of the base along which the last output is torn.
  vtkGetMacro(NumberOfTornEdges, vtkIdType);
  /// The largest distance across a torn edge, in object units.
  vtkGetMacro(LargestTear, double);

protected:
  vtkMesoDisplacedMesh();
  ~vtkMesoDisplacedMesh() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoDisplacedMesh(const vtkMesoDisplacedMesh&) = delete;
  void operator=(const vtkMesoDisplacedMesh&) = delete;

  void CheckParameters() const;
  void Execute(vtkPolyData* input, vtkImageData* heights, vtkPolyData* output);
  template <typename Array>
  bool Fill(const MesoDicePlan& plan, const MesoDisplacement& surface, const MesoTriangleMesh& mesh,
    vtkPolyData* input, vtkPolyData* output);
  template <typename Work>
  bool ForEach(vtkIdType size, double from, double to, const Work& work);

  double Scale = 0.;
  double Reference = 1.;
  double Tiles[2] = { 1., 1. };
  MesoWrap Wrap = MesoWrap::Repeat;
  double FacetsPerTexel = 1.;
  vtkIdType MaximumNumberOfTriangles = 20000000;
  bool DetailNormals = true;
  std::set<std::string> CarriedArrays;
  std::string ErrorMessage;
  vtkIdType NumberOfTornEdges = 0;
  double LargestTear = 0.;
};

#endif
