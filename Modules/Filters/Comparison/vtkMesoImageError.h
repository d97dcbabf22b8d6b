#ifndef vtkMesoImageError_h
#define vtkMesoImageError_h

/**
 * @class vtkMesoImageError
 * @brief Compare a picture with the true one: FLIP, SSIM and RMSE.
 *
 * Input port 0: the truth, port 1: the test; pictures of one size as MesoPictureOfImage() takes them.
 * Output port 0: the FLIP error of each pixel (MesoFlip.h) as an image of one float in [0,1], named
 * `FLIP`, with the truth's extent.
 *
 * Inputs that cannot be compared give one vtkErrorMacro line, an empty output and figures that are
 * not numbers.
 *
 * @sa MesoComparePictures, which this class forwards to
 */

#include "mesoFiltersComparisonModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class MESOFILTERSCOMPARISON_EXPORT vtkMesoImageError : public vtkImageAlgorithm
{
public:
  static vtkMesoImageError* New();
  vtkTypeMacro(vtkMesoImageError, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Figures of the last update, over all pixels.
  vtkGetMacro(FlipMean, double);
  vtkGetMacro(Ssim, double);
  vtkGetMacro(Rmse, double);
  ///@}

protected:
  vtkMesoImageError();
  ~vtkMesoImageError() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoImageError(const vtkMesoImageError&) = delete;
  void operator=(const vtkMesoImageError&) = delete;

  double FlipMean;
  double Ssim;
  double Rmse;
};

#endif
