/**
 * @class vtkMesoReliefMapper
 * @brief Relief mapping: a height map searched along the view ray, over the mesh's tangent plane or
 * quadric.
 *
 * Draws `q = p + (h - 1) D n` as seen from the eye, with D the Scale of the options and h the
 * height map: near detail hides far detail, detail shades itself for each light, and the depth
 * buffer is that of the detail. The options' Technique says which:
 *
 * - Relief (any other than the next): the base is its tangent plane around each fragment, so the
 *   error grows with curvature times D and with grazing views. The outline stays that of the mesh.
 * - ReliefQuadric: the base is the quadric of the point array MesoQuadric (3, vtkMesoQuadricFit)
 *   around each fragment. Rays that come back to the surface are not drawn, so that the outline is
 *   that of the detail. The options' Curved chooses another base in place of the quadric: the circle
 *   of the ray's normal curvature (Osculating), or the mesh itself, looked up in its BaseImage (Bent,
 *   Surface); where the image does not know the mesh, the quadric stands in.
 * - ReliefQuadricExact: the same, with depths measured across the view ray.
 *
 * The mesh that is drawn is where height 1 lies. For relief that rises above a mesh (Reference of
 * the options below 1) it is that mesh moved outward, by vtkMesoMovedMesh.
 *
 * The options' Search says how rays look for the map: linear-binary steps equally and then halves
 * (MesoStepsOfQuality), so that detail thinner than a step can be missed; certified, which the quality
 * Certified stands for, misses nothing of this model. Cone and certified need cones of free space
 * (vtkMesoConeMap), which are computed when the map or its Wrap has changed and kept.
 *
 * Heights: one component of float in [0,1], row 0 at t = 0, bilinear between texel centres.
 *
 * Sources: Policarpo, Oliveira, Comba, "Real-Time Relief Mapping on Arbitrary Polygonal Surfaces",
 * I3D 2005; Oliveira, Policarpo, "An Efficient Representation for Surface Details", 2005, section
 * 2.1 and, for ReliefQuadric, sections 3.2 to 3.5, for ReliefQuadricExact, section 3.1.
 *
 * @sa vtkMesoPolyDataMapper, vtkMesoSurfaceFrames, vtkMesoMovedMesh, vtkMesoQuadricFit
 */

#ifndef vtkMesoReliefMapper_h
#define vtkMesoReliefMapper_h

#include "mesoRenderingMesostructureModule.h" // for export macro
#include "vtkMesoPolyDataMapper.h"

#include <memory>
#include <string> // for Prepare()

class MesoReliefShader;
class vtkImageData;

class MESORENDERINGMESOSTRUCTURE_EXPORT vtkMesoReliefMapper : public vtkMesoPolyDataMapper
{
public:
  static vtkMesoReliefMapper* New();
  vtkTypeMacro(vtkMesoReliefMapper, vtkMesoPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The height map; without one the base mesh is drawn.
  void SetHeightMap(vtkImageData* heights);
  vtkImageData* GetHeightMap();
  vtkMTimeType GetDetailMTime() override;
  ///@}

  /// Draw as another mapper does; the height map and the image of the base are shared.
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  ///@{
  /// Linear steps (at least 1) and halvings (at least 0) of the search, in place of those that the
  /// options' quality stands for, to which 0 linear steps (the default) go back.
  void SetSearchSteps(int linear, int halvings);
  const int* GetSearchSteps() const { return this->SearchSteps; }
  ///@}

  ///@{
  /// The mesh as an image over its texture coordinates (vtkMesoBaseImage), for the bases
  /// MesoCurvedKind::Bent and Surface of the options' Curved.
  void SetBaseImage(vtkImageData* image);
  vtkImageData* GetBaseImage();
  ///@}

  /// Compute now what the first frame would else wait for: the cones. Returns why that failed, or an
  /// empty text.
  std::string Prepare();

protected:
  vtkMesoReliefMapper();
  ~vtkMesoReliefMapper() override;

  MesoTechniqueShader* GetTechnique() override;
  MesoTechnique TechniqueOf(const MesoMesostructureOptions& options) const override;
  void OptionsChanged() override;

private:
  vtkMesoReliefMapper(const vtkMesoReliefMapper&) = delete;
  void operator=(const vtkMesoReliefMapper&) = delete;

  std::unique_ptr<MesoReliefShader> Relief;
  int SearchSteps[2] = { 0, 0 };
};

#endif
