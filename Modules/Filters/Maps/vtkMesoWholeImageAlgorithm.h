/**
 * @class vtkMesoWholeImageAlgorithm
 * @brief What filters that need all of an image at once have in common.
 *
 * One input, vtkImageData, of which the whole is asked for, whatever part of the output is wanted. The
 * output is as large as the input, unless a filter's RequestInformation says otherwise.
 */

#ifndef vtkMesoWholeImageAlgorithm_h
#define vtkMesoWholeImageAlgorithm_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkImageAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoWholeImageAlgorithm : public vtkImageAlgorithm
{
public:
  vtkTypeMacro(vtkMesoWholeImageAlgorithm, vtkImageAlgorithm);

protected:
  vtkMesoWholeImageAlgorithm() = default;
  ~vtkMesoWholeImageAlgorithm() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoWholeImageAlgorithm(const vtkMesoWholeImageAlgorithm&) = delete;
  void operator=(const vtkMesoWholeImageAlgorithm&) = delete;
};

#endif
