#ifndef vtkMesoPatternSource_h
#define vtkMesoPatternSource_h

/**
 * @class vtkMesoPatternSource
 * @brief Make a built-in height map as an image.
 *
 * Samples a function of MesoPattern.h at the texel centres ((i + 0.5) / width, (j + 0.5) / height).
 * The map tiles exactly; maps of different sizes show the same surface; the same seed gives the
 * same bytes.
 *
 * Output port 0: vtkImageData, width x height x 1, spacing 1, origin 0, with the active point
 * scalars `Height` (1, float): heights in [0,1], row 0 at the bottom (t = 0).
 *
 * An unknown pattern, key or value (MesoPatternProblem()) or a size outside 1 to
 * MesoPatternMaximumSize gives one vtkErrorMacro line and an empty output.
 */

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <map>    // for parameters
#include <string> // for names

class MESOFILTERSMAPS_EXPORT vtkMesoPatternSource : public vtkImageAlgorithm
{
public:
  static vtkMesoPatternSource* New();
  vtkTypeMacro(vtkMesoPatternSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// One of MesoPatternNames(). Default: brick.
  void SetPattern(const char* pattern);
  const char* GetPattern() const { return this->Pattern.c_str(); }
  ///@}

  ///@{
  /// Texels along s and t. Default: 256, 256.
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /// Chooses among patterns of the same look; `step` and `checkerboard` do not depend on it. Default: 1.
  vtkSetMacro(Seed, unsigned int);
  vtkGetMacro(Seed, unsigned int);
  ///@}

  /// Sets one of the pattern's keys (MesoPatternParameters()); keys not set have their defaults.
  void SetParameter(const std::string& key, double value);
  /// Sets all keys back to their defaults.
  void ClearParameters();

  /// Why the last update gave nothing; empty where it gave a map.
  const std::string& GetErrorMessage() const { return this->ErrorMessage; }

protected:
  vtkMesoPatternSource();
  ~vtkMesoPatternSource() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoPatternSource(const vtkMesoPatternSource&) = delete;
  void operator=(const vtkMesoPatternSource&) = delete;

  std::string Pattern = "brick";
  int Size[2] = { 256, 256 };
  unsigned int Seed = 1;
  std::map<std::string, double> Parameters;
  std::string ErrorMessage;
};

#endif
