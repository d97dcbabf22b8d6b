#ifndef MesoHeightColors_h
#define MesoHeightColors_h

#include "vtkNew.h"          // for the texture
#include "vtkSmartPointer.h" // for the table

#include <cstddef>
#include <string>

class vtkLookupTable;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

/**
 * @class MesoHeightColors
 * @brief A lookup table as a texture of one row, for colours by the height at the hit.
 *
 * See Shaders/Common/HeightColorDec.glsl.
 */
class MesoHeightColors
{
public:
  MesoHeightColors();
  ~MesoHeightColors();
  MesoHeightColors(const MesoHeightColors&) = delete;
  void operator=(const MesoHeightColors&) = delete;

  void SetTable(vtkLookupTable* table);
  vtkLookupTable* GetTable() const { return this->Table; }

  /// Make the texture ready and bind it. Returns why that failed, or an empty text.
  std::string Activate(vtkOpenGLRenderWindow* window);
  void SetUniforms(vtkShaderProgram* program);
  void Deactivate();
  void ReleaseGraphicsResources(vtkWindow* window);
  std::size_t GetGPUBytes() const;

private:
  vtkSmartPointer<vtkLookupTable> Table;
  vtkNew<vtkTextureObject> Texture;
  unsigned long long UploadedTime = 0; ///< MTime of the table that the texture holds
};

#endif
