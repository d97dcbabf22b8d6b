#ifndef MesoGDMTexture_h
#define MesoGDMTexture_h

#include "MesoMapTexture.h"

#include <array>
#include <vector>

/**
 * @class MesoGDMTexture
 * @brief A table of distances through a volume (vtkMesoGDMTable) as textures.
 *
 * As factors: the weights four products to a texel, W x H x groups (azimuths + 1) of them, each group's
 * first azimuth again behind its last, so that the sampler interpolates in x, y and phi; the functions
 * likewise, polars x groups D. Whole: azimuths W x polars H x D, read without a filter.
 * See Shaders/Common/GDMAccess.glsl, GDMFactorsAccess.glsl, GDMWholeAccess.glsl.
 *
 * The volume that hits are looked up in is not among them: MesoVolumeOfGDM gives it.
 */
class MesoGDMTexture : public MesoMapTexture
{
public:
  MesoGDMTexture();

  /// Null: no table. Returns what is wrong with it (MesoGDMTableProblem), or an empty text.
  std::string SetTable(vtkImageData* table);
  vtkImageData* GetTable() const { return this->GetImage(); }

  /// MESO_GDM_GROUPS of the shader: fours of products, 0 where the table is whole.
  int GetGroups() const;

  void SetUniforms(vtkShaderProgram* program) override;

protected:
  std::string Upload(vtkOpenGLRenderWindow* window, MesoWrap wrap) override;

private:
  std::string UploadFactors(vtkOpenGLRenderWindow* window);
  std::string UploadWhole(vtkOpenGLRenderWindow* window);
  std::string Create(vtkOpenGLRenderWindow* window, std::size_t index,
    const std::array<int, 3>& size, int components, int type, const void* texels);

  /// Of each product, four to a group.
  std::vector<std::array<float, 4>> Least;
  std::vector<std::array<float, 4>> Span;
};

#endif
