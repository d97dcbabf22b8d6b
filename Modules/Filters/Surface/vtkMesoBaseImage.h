#ifndef vtkMesoBaseImage_h
#define vtkMesoBaseImage_h

/**
 * @class vtkMesoBaseImage
 * @brief Bake a mesh into an image over its texture coordinates, for relief over the mesh itself.
 *
 * `relief-quadric` with the base `surface` or `bent` looks the mesh up by texture coordinates while it
 * follows a ray. A texel holds the point and the unit normal of the mesh at its centre: positions are
 * linear in each triangle, normals are interpolated linearly and made unit.
 *
 * Input port 0: vtkPolyData with point normals and texture coordinates (2), as vtkMesoSurfaceFrames
 * and vtkMesoShapeSource give it. Polygons and strips are cut into triangles; other cells are left
 * out.
 *
 * Output port 0: vtkImageData, W x H x 1, with the point data
 * - `MesoBasePosition` (4, float): position less MesoBaseCentre in object units, and 1 inside a chart,
 *   0.5 beside it, 0 where the base is unknown.
 * - `MesoBaseNormal` (4, float): unit normal in object space, and 0.
 *
 * and the field data (1 tuple each, double)
 * - `MesoBaseCentre` (3): middle of the mesh's bounds.
 * - `MesoBaseScale` (2), `MesoBaseOffset` (2): a texel's centre (i, j) has the texture coordinates
 *   (u, v) with (u, v) * scale + offset = (i, j).
 * - `MesoBaseWraps` (2): 1 where the mesh closes along the axis, so that the image's last column is
 *   followed by its first.
 *
 * Beside charts the nearest triangle goes on, flat, for four texels. A texel that several triangles
 * cover which lie apart (overlapping or mirrored charts) is unknown: NumberOfAmbiguousTexels counts
 * them. SetSizeFor chooses a size for a mesh.
 *
 * One vtkErrorMacro line and an empty image are given for missing normals or texture coordinates, for
 * numbers that are not finite (the first point is named), for cells with points that do not exist and
 * for texture coordinates that span no area.
 *
 * @sa vtkMesoReliefMapper, Documentation/Techniques/CurvedRelief.md
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <string> // for messages

class vtkPolyData;

class MESOFILTERSSURFACE_EXPORT vtkMesoBaseImage : public vtkImageAlgorithm
{
public:
  static vtkMesoBaseImage* New();
  vtkTypeMacro(vtkMesoBaseImage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Texels along u and v, 16 to 8192 each. Default: 256, 256. The four at each end of an axis on which
  /// the mesh does not close lie beside it.
  void SetSize(int width, int height);
  vtkGetVector2Macro(Size, int);
  ///@}

  /// Choose the size for a mesh: the median triangle is eight texels wide and high, up to `most`
  /// texels along an axis. Leaves it where the mesh has no texture coordinates.
  void SetSizeFor(vtkPolyData* mesh, int most = 1024);

  /// Why the last update gave nothing; empty where it gave an image.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }
  ///@{
  /// Texels inside one chart, and those that several parts of the mesh cover.
  vtkGetMacro(NumberOfInsideTexels, vtkIdType);
  vtkGetMacro(NumberOfAmbiguousTexels, vtkIdType);
  ///@}

protected:
  vtkMesoBaseImage() = default;
  ~vtkMesoBaseImage() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoBaseImage(const vtkMesoBaseImage&) = delete;
  void operator=(const vtkMesoBaseImage&) = delete;

  void Compute(vtkPolyData* input, vtkImageData* output);

  int Size[2] = { 256, 256 };
  std::string ErrorMessage;
  vtkIdType NumberOfInsideTexels = 0;
  vtkIdType NumberOfAmbiguousTexels = 0;
};

#endif
