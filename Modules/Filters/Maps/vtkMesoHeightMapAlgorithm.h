/**
 * @class vtkMesoHeightMapAlgorithm
 * @brief What filters that compute something from a whole height map have in common.
 *
 * Input: a plane image of one component, float heights in [0,1] (MesoToHeights makes them), row 0 at
 * v = 0. An input that is none, or holds a number outside of [0,1] or none at all (NaN), is an error,
 * and the output is empty; so it is where the work was aborted (AbortExecute).
 */

#ifndef vtkMesoHeightMapAlgorithm_h
#define vtkMesoHeightMapAlgorithm_h

#include "MesoOptions.h"           // for MesoWrap
#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoWholeImageAlgorithm.h"

#include <functional>
#include <vector>

class MESOFILTERSMAPS_EXPORT vtkMesoHeightMapAlgorithm : public vtkMesoWholeImageAlgorithm
{
public:
  vtkTypeMacro(vtkMesoHeightMapAlgorithm, vtkMesoWholeImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// What lies outside of the map. Default MesoWrap::Repeat.
  vtkSetEnumMacro(Wrap, MesoWrap);
  vtkGetEnumMacro(Wrap, MesoWrap);
  ///@}

protected:
  vtkMesoHeightMapAlgorithm() = default;
  ~vtkMesoHeightMapAlgorithm() override = default;

  /// The heights of the input, row by row, row 0 at v = 0.
  struct Map
  {
    int Width = 0;
    int Height = 0;
    std::vector<float> Heights;
  };

  /// Fill the output, which has the input's structure and no arrays. What it holds after an abort
  /// is thrown away.
  virtual void Compute(const Map& map, vtkImageData* output) = 0;

  /**
   * Call work(first, end) for rows (or other items) 0 to `count` in parallel, in bands between which
   * progress is told and AbortExecute is looked at. Returns false where the work was aborted.
   *
   * @param done,all the parts of the whole progress that lie before and within these items
   */
  bool ForRows(
    int count, const std::function<void(int, int)>& work, double done = 0., double all = 1.);

  int RequestData(
    vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector*) override;

private:
  vtkMesoHeightMapAlgorithm(const vtkMesoHeightMapAlgorithm&) = delete;
  void operator=(const vtkMesoHeightMapAlgorithm&) = delete;

  MesoWrap Wrap = MesoWrap::Repeat;
};

#endif
