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
 * Pattern: one of MesoPatternNames(), default brick; its keys are MesoPatternParameters().
 *
 * An unknown pattern, key or value (MesoPatternProblem()) or a size outside 1 to
 * MesoPatternMaximumSize gives one vtkErrorMacro line and an empty output.
 */

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoBuiltInSource.h"

class MESOFILTERSMAPS_EXPORT vtkMesoPatternSource : public vtkMesoBuiltInSource
{
public:
  static vtkMesoPatternSource* New();
  vtkTypeMacro(vtkMesoPatternSource, vtkMesoBuiltInSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Texels along s and t. Default: 256, 256.
  vtkSetVector2Macro(Size, int);
  vtkGetVector2Macro(Size, int);
  ///@}

protected:
  vtkMesoPatternSource();
  ~vtkMesoPatternSource() override = default;

  std::string Problem() const override;
  std::array<int, 3> SamplesAlong() const override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoPatternSource(const vtkMesoPatternSource&) = delete;
  void operator=(const vtkMesoPatternSource&) = delete;

  int Size[2] = { 256, 256 };
};

#endif
