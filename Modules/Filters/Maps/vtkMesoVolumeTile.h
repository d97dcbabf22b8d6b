/**
 * @class vtkMesoVolumeTile
 * @brief Cut a tile out of a volume, make it repeat and give it another size.
 *
 * Three steps, each left out where it is not asked for:
 * - Crop: the samples that are the tile.
 * - Blend: the last samples in x (and y), this part of the tile, are faded into the first and taken away, so
 *   that the tile ends as it begins; it becomes so much narrower.
 * - Size: samples are means over what they cover, weighted by a tent as wide as the sparser of both grids, so that
 *   detail that the new grid cannot hold is averaged, not missed; in x and y over the border of the tile.
 *
 * Input: an image of three dimensions; of its scalars the first component is taken. Output: the tile with
 * float scalars `Number`, and the spacing that keeps its extent.
 *
 * A crop that is not inside of the image gives one vtkErrorMacro line and an empty output.
 */

#ifndef vtkMesoVolumeTile_h
#define vtkMesoVolumeTile_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoWholeImageAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoVolumeTile : public vtkMesoWholeImageAlgorithm
{
public:
  static vtkMesoVolumeTile* New();
  vtkTypeMacro(vtkMesoVolumeTile, vtkMesoWholeImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// First and, past the last, end of the samples in x, y and z. Default: 0 to 0 each, which is all.
  vtkSetVector6Macro(Crop, int);
  vtkGetVector6Macro(Crop, int);
  ///@}

  ///@{
  /// Part of the width and of the height that is faded, 0 to 0.5. Default 0.
  vtkSetClampMacro(Blend, double, 0., 0.5);
  vtkGetMacro(Blend, double);
  ///@}

  ///@{
  /// Samples of the output; 0 (default): as many as there are.
  vtkSetVector3Macro(Size, int);
  vtkGetVector3Macro(Size, int);
  ///@}

protected:
  vtkMesoVolumeTile() = default;
  ~vtkMesoVolumeTile() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoVolumeTile(const vtkMesoVolumeTile&) = delete;
  void operator=(const vtkMesoVolumeTile&) = delete;

  /// How many of so many samples along x or y are faded away.
  int FadedOf(int count) const;

  int Crop[6] = { 0, 0, 0, 0, 0, 0 };
  double Blend = 0.;
  int Size[3] = { 0, 0, 0 };
};

#endif
