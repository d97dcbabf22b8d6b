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
 * An unknown pattern, key or value (MesoVolumePatternProblem()) or a size outside 2 to
 * MesoVolumeMaximumSize gives one vtkErrorMacro line and an empty output; so does an abort.
 */

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <map>    // for parameters
#include <string> // for names

class MESOFILTERSMAPS_EXPORT vtkMesoVolumeSource : public vtkImageAlgorithm
{
public:
  static vtkMesoVolumeSource* New();
  vtkTypeMacro(vtkMesoVolumeSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// One of MesoVolumePatternNames(). Default: weave.
  void SetPattern(const char* pattern);
  const char* GetPattern() const { return this->Pattern.c_str(); }
  ///@}

  ///@{
  /// Voxels along x, y, z. Default: 64, 64, 32.
  vtkSetVector3Macro(Size, int);
  vtkGetVector3Macro(Size, int);
  ///@}

  ///@{
  /// Chooses among patterns of the same look; woven ones do not depend on it. Default: 1.
  vtkSetMacro(Seed, unsigned int);
  vtkGetMacro(Seed, unsigned int);
  ///@}

  /// Sets one of the pattern's keys (MesoVolumePatternParameters()); keys not set have their defaults.
  void SetParameter(const std::string& key, double value);
  /// Sets all keys back to their defaults.
  void ClearParameters();

  /// Why the last update gave nothing; empty where it gave a volume.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

protected:
  vtkMesoVolumeSource();
  ~vtkMesoVolumeSource() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoVolumeSource(const vtkMesoVolumeSource&) = delete;
  void operator=(const vtkMesoVolumeSource&) = delete;

  std::string Problem() const;

  std::string Pattern = "weave";
  int Size[3] = { 64, 64, 32 };
  unsigned int Seed = 1;
  std::map<std::string, double> Parameters;
  std::string ErrorMessage;
};

#endif
