#ifndef vtkMesoGeometryImage_h
#define vtkMesoGeometryImage_h

/**
 * @class vtkMesoGeometryImage
 * @brief Make a geometry image: a mesh with an atlas as an image of its positions and normals.
 *
 * Input: vtkPolyData with point normals and texture coordinates in [0,1] x [0,1], each place of which is
 * used once. Where they go beyond it the image lies over what they cover. Points of equal position, or of equal `MesoVertex`, are one vertex.
 *
 * Output: vtkImageData with levels of detail one above the other, each half the size of the one before
 * it, from Size down to SmallestSize or more. Level k lies in the first columns of its rows; row 0 of a
 * level is at v = 0, texel centres are at (i + 0.5) / size. Point data, float unless said:
 * - `MesoPosition` (3, scalars): object space, 0 where there is no chart.
 * - `MesoNormal` (3): unit.
 * - `TextureCoordinates` (2): where on the mesh the sample was taken.
 * - `MesoChart` (1, int): number of the chart from 1, below 0 where it is mirrored; 0: none.
 * Field data: `MesoLevels` (4, double): size, first row, and the distance of the mesh's points from the
 * level's surface, root mean square and largest, in object units.
 *
 * The grids are closed where the mesh is: samples at the edges of charts lie on the cuts between them
 * (MesoGeometryImage.h). Every level is sampled from the mesh.
 *
 * One vtkErrorMacro line and an empty output are given for inputs without normals or texture coordinates,
 * numbers that are not finite, coordinates over more than two tiles and parameters out of range. An update that is
 * aborted gives an empty output.
 *
 * Sources: Gu, Gortler and Hoppe, "Geometry Images", SIGGRAPH 2002; Marschner, "Representing geometric
 * details with textures", 2008; Sander et al., "Multi-Chart Geometry Images", 2003.
 *
 * @sa vtkMesoGeometryImageMapper
 */

#include "mesoFiltersSurfaceModule.h" // for export macro
#include "vtkImageAlgorithm.h"
#include "vtkSmartPointer.h" // for surfaces

#include <string> // for messages

class vtkPolyData;

class MESOFILTERSSURFACE_EXPORT vtkMesoGeometryImage : public vtkImageAlgorithm
{
public:
  static vtkMesoGeometryImage* New();
  vtkTypeMacro(vtkMesoGeometryImage, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  static constexpr int SmallestSize = 8;

  ///@{
  /// Texels along each side of the finest level, 8 to 4096. Default: 256.
  vtkSetClampMacro(Size, int, SmallestSize, 4096);
  vtkGetMacro(Size, int);
  ///@}

  /// Why the last update gave nothing; empty where it gave an image.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }
  /// Texels of the finest level that several parts of the mesh share.
  vtkGetMacro(NumberOfOverlaps, vtkIdType);
  vtkGetMacro(NumberOfCharts, int);

  /// Number of levels of a geometry image; 0 where it is none, and `problem` says why.
  static int NumberOfLevelsOf(vtkImageData* image, std::string& problem);
  /// A level of a geometry image as triangles with `Normals` and `TextureCoordinates`.
  static vtkSmartPointer<vtkPolyData> SurfaceOf(vtkImageData* image, int level);

protected:
  vtkMesoGeometryImage() = default;
  ~vtkMesoGeometryImage() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoGeometryImage(const vtkMesoGeometryImage&) = delete;
  void operator=(const vtkMesoGeometryImage&) = delete;

  void Make(vtkPolyData* input, vtkImageData* output);

  int Size = 256;
  std::string ErrorMessage;
  vtkIdType NumberOfOverlaps = 0;
  int NumberOfCharts = 0;
};

#endif
