/**
 * @class vtkMesoMaximumMip
 * @brief A height map becomes the pyramid of its maxima: how high the surface is over blocks of patches.
 *
 * Level 0 holds for texel (i, j) the greatest height of the bilinear patch between the centres of the
 * texels i and i + 1, j and j + 1, which is that of its four texels; Wrap says which texels lie beyond the
 * border. The patches before the first texel are no higher than the first patches (clamp, mirror) or are
 * the last ones (repeat). Each level halves the one before, rounding up, down to 1 x 1: its texels hold
 * the greatest of the up to four below. Maxima are exact: heights of texels.
 *
 * Output: the input's image with the point scalars `Maximum` (1, float), which are level 0; in the field
 * data the levels from 1 on as `Maximum1`, `Maximum2`, ... (1, float), row by row, and `MaximumSizes` (2,
 * int): width and height of every level, level 0 first.
 *
 * Source: Tevs2008. @sa vtkMesoConeMap
 */

#ifndef vtkMesoMaximumMip_h
#define vtkMesoMaximumMip_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoHeightMapAlgorithm.h"

class MESOFILTERSMAPS_EXPORT vtkMesoMaximumMip : public vtkMesoHeightMapAlgorithm
{
public:
  static vtkMesoMaximumMip* New();
  vtkTypeMacro(vtkMesoMaximumMip, vtkMesoHeightMapAlgorithm);

protected:
  vtkMesoMaximumMip() = default;
  ~vtkMesoMaximumMip() override = default;

  void Compute(const Map& map, vtkImageData* output) override;

private:
  vtkMesoMaximumMip(const vtkMesoMaximumMip&) = delete;
  void operator=(const vtkMesoMaximumMip&) = delete;
};

#endif
