#ifndef MesoPrismTexture_h
#define MesoPrismTexture_h

#include "MesoMapTexture.h"
#include "vtkType.h" // for vtkMTimeType

#include <array>

class vtkPolyData;

/**
 * @class MesoPrismTexture
 * @brief The prisms of a shell (vtkMesoPrismShell) as a texture; see Shaders/Common/PrismAccess.glsl.
 */
class MesoPrismTexture : public MesoMapTexture
{
public:
  MesoPrismTexture();

  /// Null: none. Returns what the shell lacks, or an empty text.
  std::string SetShell(vtkPolyData* shell);
  /// The point that the prisms' corners are counted from, object space.
  const std::array<double, 3>& GetCentre() const { return this->Centre; }

  /// Whether the shell has edges, where what lies in it is cut.
  bool HasEnds() const { return this->Ends; }

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  vtkPolyData* Shell = nullptr; ///< that the image was made of; never looked into
  vtkMTimeType ShellTime = 0;
  std::array<double, 3> Centre = { 0., 0., 0. };
  bool Ends = false;
};

#endif
