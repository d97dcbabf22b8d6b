#ifndef vtkMesoPrismShell_h
#define vtkMesoPrismShell_h

/**
 * @class vtkMesoPrismShell
 * @brief Extrude each triangle of a mesh along its normals: the shell that mesostructure lives in.
 *
 * A prism stands on each triangle; its points are q(b, z) = sum_i b_i (p_i + (z - r) H n_i), for b over
 * the triangle and z in [0, 1] (Wang2004, section 3.1, Figure 3): p_i the corners, n_i their unit
 * normals, H the Thickness and r the Reference. Points of one position and normal are one corner of the
 * shell, so that neighbouring prisms share their fins. A fin is bilinear; it is drawn as two triangles,
 * and both prisms cut it along the same diagonal, which runs from the bottom of the corner of the
 * lower number. Where no prism is beyond a fin - at an open boundary, at a hard edge (one position,
 * several normals), at a T-junction, where more than two triangles meet - it closes the shell.
 *
 * Input port 0: vtkPolyData with texture coordinates; normals of points are taken, or made where there
 * are none. Polygons and strips become triangles.
 *
 * Output port 0: the shell's faces, wound so that their fronts are outside, and with them what a shader
 * needs of each prism. No triangle or point is shared between prisms. For prism i points 6 i to 6 i + 5
 * are its bottom corners and then its top corners, and its polygons are bottom, top, and two for each fin
 * that closes the shell (with InnerFins each fin, so that it has 8). Point arrays, of the type of the input's points:
 *
 *     Normals (3)             n_i, unit
 *     TextureCoordinates (2)  the mesh's own, the same below and above
 *     MesoPrism (1)           i
 *     MesoShellHeight (1)     z: 0 or 1; of Slices, theirs
 *
 * Field data:
 *
 *     MesoPrismTable (4, 7 tuples a prism, float)  bottom corner k less MesoPrismCentre, and u of its
 *                             texture coordinate; k = 0, 1, 2; H n_k and v; and flags with the numbers
 *                             of the prisms beyond fins 0, 1 and 2, -1 for none. Flags: bit k: the
 *                             diagonal of fin k runs from the bottom of corner k + 1; bit 3 + k: what
 *                             fills the prism ends at fin k
 *     MesoPrismCentre (3, double)  the middle of the mesh's box, object space
 *     MesoPrismTriangle (1, a prism each)  the number of its triangle in the triangulated input
 *
 * Lengths are in object units. The thickness may be at most 1 / c_max inward and 1 / |c_min| outward of a
 * surface with these curvatures; a prism past that turns over (Jacobian dq/d(b, z) not of one sign).
 * Such triangles are told by number, and nothing is done about them unless ClampThickness asks for it.
 *
 * One vtkErrorMacro line and an empty output are given for what is not finite, missing texture
 * coordinates, a thickness that is not positive, and a mesh of more than 2^24 triangles. An input without
 * triangles gives an empty output.
 *
 * @sa vtkMesoShellMapper, vtkMesoMovedMesh
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for messages
#include <vector>

struct MesoPrismShell;
struct MesoPrismShellInput;

class MESOFILTERSSURFACE_EXPORT vtkMesoPrismShell : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoPrismShell* New();
  vtkTypeMacro(vtkMesoPrismShell, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// H, from the shell's bottom to its top, object units, > 0. Default: 1.
  vtkSetMacro(Thickness, double);
  vtkGetMacro(Thickness, double);
  ///@}

  ///@{
  /// r: z where the mesh lies. 0 (the default): the shell is all outside; 1: all inside.
  vtkSetClampMacro(Reference, double, 0., 1.);
  vtkGetMacro(Reference, double);
  ///@}

  ///@{
  /// Map coordinate = texture coordinate x tiles: by whole tiles the map goes on across a seam of
  /// texture coordinates. Default: 1, 1.
  vtkSetVector2Macro(Tiles, double);
  vtkGetVector2Macro(Tiles, double);
  ///@}

  ///@{
  /// 0 (the default): the prisms' faces. More: in their place so many slices of each prism, at the
  /// middles of equal parts of z, wound as the mesh (Meyer1998); prism i then has 3 Slices points and
  /// Slices polygons, from its bottom to its top.
  vtkSetClampMacro(Slices, int, 0, 4096);
  vtkGetMacro(Slices, int);
  ///@}

  ///@{
  /// Whether fins between two prisms are among the polygons. Without them these are the outside of the shell,
  /// from where rays are followed from prism to prism by the table. Default: off.
  vtkSetMacro(InnerFins, bool);
  vtkGetMacro(InnerFins, bool);
  vtkBooleanMacro(InnerFins, bool);
  ///@}

  ///@{
  /// Make the shell thinner around prisms that turn over, until none does. Default: off.
  vtkSetMacro(ClampThickness, bool);
  vtkGetMacro(ClampThickness, bool);
  vtkBooleanMacro(ClampThickness, bool);
  ///@}

  /// Why the last update gave nothing; empty where it gave a shell.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

  ///@{
  /// Of the last update: triangles whose prism turns over (with ClampThickness, those that would have),
  /// triangles without area, fins that close the shell, fins across which the map does not go on, and
  /// the smallest part of the thickness that ClampThickness has left.
  const std::vector<vtkIdType>& GetInvertedTriangles() const { return this->InvertedTriangles; }
  vtkGetMacro(NumberOfDegenerateTriangles, vtkIdType);
  vtkGetMacro(NumberOfOpenFins, vtkIdType);
  vtkGetMacro(NumberOfSeamFins, vtkIdType);
  vtkGetMacro(LeastRise, double);
  ///@}

protected:
  vtkMesoPrismShell() = default;
  ~vtkMesoPrismShell() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoPrismShell(const vtkMesoPrismShell&) = delete;
  void operator=(const vtkMesoPrismShell&) = delete;

  void Execute(vtkPolyData* input, vtkPolyData* output);

  double Thickness = 1.;
  double Reference = 0.;
  double Tiles[2] = { 1., 1. };
  bool InnerFins = false;
  bool ClampThickness = false;
  int Slices = 0;
  std::string ErrorMessage;
  std::vector<vtkIdType> InvertedTriangles;
  vtkIdType NumberOfDegenerateTriangles = 0;
  vtkIdType NumberOfOpenFins = 0;
  vtkIdType NumberOfSeamFins = 0;
  double LeastRise = 1.;
};

#endif
