#ifndef MesoVDMPart_h
#define MesoVDMPart_h

#include "MesoMapTexture.h"
#include "MesoVDMTable.h"

#include <array>

class vtkDataArray;

/**
 * @class MesoVDMPart
 * @brief One texture of a table of view-dependent displacements (vtkMesoVDM).
 *
 * See Shaders/Common/VDMAccess.glsl.
 */
class MesoVDMPart : public MesoMapTexture
{
public:
  enum class Kind
  {
    Weights,        ///< of four factors, over map and azimuth
    Functions,      ///< of four factors, over half the polar angle's tangent and curvature
    AngleFunctions, ///< of four factors, over curvature
    Table,          ///< the table itself, polar angles in fours
    Angles          ///< and its largest angles, curvatures in fours
  };

  /// @param group which four factors
  MesoVDMPart(Kind kind, int group);

  /// The table, and how many of its factors are used for distances and angles; 0, 0: it has none.
  void SetTable(vtkImageData* table, const MesoVDMLayout& layout, const std::array<int, 2>& ranks);

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  bool IsPartOf(const std::array<int, 2>& ranks) const;
  std::string UploadWeights(vtkOpenGLRenderWindow* window);
  std::string UploadFunctions(vtkOpenGLRenderWindow* window);
  /// A function's value where a texture has it: `place` among the polar angles; 0 of what is not used.
  double FunctionAt(vtkDataArray* functions, int factor, double place, int curvature) const;
  std::string UploadSlices(vtkOpenGLRenderWindow* window);
  /// The first number of a factor's weights, and the number that 1 in the texture lies above it.
  std::array<double, 2> SpanOf(int factor) const;

  Kind ThisKind;
  int Group;
  MesoVDMLayout Layout;
  std::array<int, 2> Ranks = { 0, 0 };
};

#endif
