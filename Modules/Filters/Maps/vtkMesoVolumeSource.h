#ifndef vtkMesoVolumeSource_h
#define vtkMesoVolumeSource_h

/**
 * @class vtkMesoVolumeSource
 * @brief Make a built-in volume.
 *
 * Samples a function of MesoVolumePattern.h at the voxel centres and gives each sample its distance to the
 * surface. The volume tiles in x and y; volumes of different sizes show the same surface; the same
 * seed gives the same bytes.
 *
 * Output port 0: a canonical volume (MesoVolume.h) with the point scalars `MesoSignedDistance` and the
 * field data array `MesoVolumeDepth`, the pattern's `depth`.
 *
 * Pattern: one of MesoVolumePatternNames(), default weave; its keys are MesoVolumePatternParameters().
 *
 * An unknown pattern, key or value (MesoVolumePatternProblem()) or a size outside 2 to
 * MesoVolumeMaximumSize gives one vtkErrorMacro line and an empty output; so does an abort.
 */

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoBuiltInSource.h"

class MESOFILTERSMAPS_EXPORT vtkMesoVolumeSource : public vtkMesoBuiltInSource
{
public:
  static vtkMesoVolumeSource* New();
  vtkTypeMacro(vtkMesoVolumeSource, vtkMesoBuiltInSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Voxels along x, y, z. Default: 64, 64, 32.
  vtkSetVector3Macro(Size, int);
  vtkGetVector3Macro(Size, int);
  ///@}

protected:
  vtkMesoVolumeSource();
  ~vtkMesoVolumeSource() override = default;

  std::string Problem() const override;
  std::array<int, 3> SamplesAlong() const override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoVolumeSource(const vtkMesoVolumeSource&) = delete;
  void operator=(const vtkMesoVolumeSource&) = delete;

  int Size[3] = { 64, 64, 32 };
};

#endif
