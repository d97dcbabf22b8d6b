/**
 * @class vtkMesoSignedDistance
 * @brief Make a canonical volume of an image whose numbers say where there is solid.
 *
 * Input: an image of three dimensions; its scalars' first component is solid from Threshold on (or below
 * it: SolidBelow). The surface is where the trilinear interpolant of the numbers is Threshold, so
 * grey values place it between the samples. The image is one tile, whose sides in x and y become 1; what
 * lies beside it is the tile again.
 *
 * Output: a canonical volume (MesoVolume.h): distances to the surface, Euclidean in tile widths.
 *
 * An input that is no volume, is larger than MesoVolumeMaximumSize a side or holds numbers that
 * are not finite gives one vtkErrorMacro line and an empty output; so does an abort (without a line).
 */

#ifndef vtkMesoSignedDistance_h
#define vtkMesoSignedDistance_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoWholeImageAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoSignedDistance : public vtkMesoWholeImageAlgorithm
{
public:
  static vtkMesoSignedDistance* New();
  vtkTypeMacro(vtkMesoSignedDistance, vtkMesoWholeImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The number at the surface. Default 0.5.
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /// Numbers below Threshold are solid, not those from it on. Default off.
  vtkSetMacro(SolidBelow, bool);
  vtkGetMacro(SolidBelow, bool);
  vtkBooleanMacro(SolidBelow, bool);
  ///@}

  ///@{
  /// Thickness of the shell in tile widths; 0 (default): the image's thickness over its width in x, by
  /// its spacing.
  vtkSetClampMacro(Depth, double, 0., 1e6);
  vtkGetMacro(Depth, double);
  ///@}

protected:
  vtkMesoSignedDistance() = default;
  ~vtkMesoSignedDistance() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoSignedDistance(const vtkMesoSignedDistance&) = delete;
  void operator=(const vtkMesoSignedDistance&) = delete;

  double Threshold = 0.5;
  bool SolidBelow = false;
  double Depth = 0.;
};

#endif
