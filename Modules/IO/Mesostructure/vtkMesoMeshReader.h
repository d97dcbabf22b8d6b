#ifndef vtkMesoMeshReader_h
#define vtkMesoMeshReader_h

/**
 * @class vtkMesoMeshReader
 * @brief Read a mesh file as triangles over points that are split where the surface has seams.
 *
 * Formats by the file's name: OBJ, PLY, STL, OFF, VTP, glTF and GLB. The file is scanned and checked
 * first (MesoMeshFile.h and each format's header say what is refused), OpenMesh joins the faces (MesoMeshTopology.h), polygons are cut into triangles (MesoTriangulate.h), and each
 * different corner (position, texture coordinate, normal) becomes a point. Triangles keep the
 * file's order and winding.
 *
 * Output port 0: vtkPolyData with point data
 * - `TextureCoordinates` (2, active): as in the file, t up. Absent, with a warning, where the file
 *   has none; (0, 0) with a warning at single corners that have none.
 * - `Normals` (3, active, unit length, float): those of the file. Absent where a corner has none;
 *   vtkMesoSurfaceFrames makes them.
 * - `MesoVertex` (1, double): number of the merged vertex, from 0. Points of equal position share
 *   it. Faces that do not fit a manifold (a third face at an edge, doubled or turned faces) are
 *   sheets with vertices of their own, reported by a warning.
 * - the further point arrays of a VTP file, under their names
 *
 * Positions and texture coordinates are float, or double where a float would be off by more than
 * 1e-6 of the diagonal of their bounding box.
 *
 * A file that is refused gives one vtkErrorMacro line "file: line N: reason" and an empty output.
 * What is odd but readable (unused vertices, faces without area, ...) is one vtkWarningMacro line
 * each, and in GetNotes().
 *
 * @sa vtkMesoSurfaceFrames
 */

#include "mesoIOMesostructureModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for messages
#include <vector> // for messages

class MESOIOMESOSTRUCTURE_EXPORT vtkMesoMeshReader : public vtkPolyDataAlgorithm
{
public:
  static vtkMesoMeshReader* New();
  vtkTypeMacro(vtkMesoMeshReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to read; its name ends in one of MesoMeshExtensions(), in small or capital letters.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Why the last update gave nothing; empty where it gave a mesh.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }
  /// What was odd about the file last read, a line each, without the file's name.
  const std::vector<std::string>& GetNotes() const { return this->Notes; }
  /// Edges of the file's polygons that have a face on one side only, after the last update.
  vtkGetMacro(NumberOfOpenEdges, vtkIdType);
  /// 1, and one more for each sheet of faces that do not fit a manifold, after the last update.
  vtkGetMacro(NumberOfSheets, vtkIdType);

protected:
  vtkMesoMeshReader();
  ~vtkMesoMeshReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoMeshReader(const vtkMesoMeshReader&) = delete;
  void operator=(const vtkMesoMeshReader&) = delete;

  void Read(vtkPolyData* output);

  char* FileName = nullptr;
  std::string ErrorMessage;
  std::vector<std::string> Notes;
  vtkIdType NumberOfOpenEdges = 0;
  vtkIdType NumberOfSheets = 0;
};

#endif
