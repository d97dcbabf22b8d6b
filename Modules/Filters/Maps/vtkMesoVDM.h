/**
 * @class vtkMesoVDM
 * @brief A height map becomes a table: where each ray into its relief meets it, over curved bases too.
 *
 * For each texel, direction of travel and curvature of the base along it, the table tells the point that a
 * ray through the texel's place on the base meets first (MesoVDMTable.h has the axes, the units and what
 * is stored). The map is a tile that repeats, 1 x 1 large and Depth deep, of any size; where that differs
 * from the table's it is resampled, bilinearly or by means over the table's texels.
 *
 * Output: an image of texels x azimuths with field data that MesoVDMLayout::Read understands, the map as it
 * was resampled in the field data `Heights` (float, in [0,1]), what linear interpolation between its angles
 * leaves as `AngularError` (root mean square of stored numbers in [0,1]), and
 *
 * - with Ranks 0, the table itself: `VDM` (16 bit, polar angles x curvatures, the scalars), `MVM` (16 bit,
 *   curvatures: the largest polar angle at which a ray meets anything, of 90 degrees); 65535 stands for 1;
 * - else its factors: `Weights` (8 or 16 bit, as many as the larger rank, the scalars), whose largest code
 *   stands for WeightLow + WeightWidth and 0 for WeightLow (field data), and in the field data
 *   `VDMFunctions` (float, a tuple of Ranks[0] for each polar angle and curvature, curvature slowest),
 *   `MVMFunctions` (a tuple of Ranks[1] for each curvature): a stored number is the sum of products, of the
 *   largest angles what they leave to 90 degrees, over 90 degrees; and
 *   `Errors`: the root mean square that the first 1, 2, ... products leave, of stored numbers in [0,1];
 *   `FactorErrors`: what all of them, coded, leave of the distances' numbers, root mean square and maximum,
 *   and of the largest angles over convex bases, of 90 degrees, root mean square.
 *
 * Takes 4 bytes of memory a number of the table while it works, and 5 for each weight, or for the table
 * itself 2 a number. The same on any number of threads.
 *
 * Source: Wang et al., "View-Dependent Displacement Mapping", SIGGRAPH 2003, sections 3.1, 3.3, appendix.
 *
 * @sa vtkMesoVDMMapper
 */

#ifndef vtkMesoVDM_h
#define vtkMesoVDM_h

#include "MesoVDMTable.h"          // for MesoVDMLayout
#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoHeightMapAlgorithm.h"

#include <cstddef>
#include <functional>

class MESOFILTERSMAPS_EXPORT vtkMesoVDM : public vtkMesoHeightMapAlgorithm
{
public:
  static vtkMesoVDM* New();
  vtkTypeMacro(vtkMesoVDM, vtkMesoHeightMapAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The table's axes, depth, nodes and kind of numbers. Ones that make no table are an error of the
  /// update.
  void SetLayout(const MesoVDMLayout& layout);
  const MesoVDMLayout& GetLayout() const { return this->Layout; }
  ///@}

  ///@{
  /// How other curvatures than 0 are baked. Default Exact.
  vtkSetEnumMacro(Curved, MesoVDMCurved);
  vtkGetEnumMacro(Curved, MesoVDMCurved);
  ///@}

  ///@{
  /// Factors of the distances and of the largest angles; 0, 0 for the table itself. Default 8, 4.
  vtkSetVector2Macro(Ranks, int);
  vtkGetVector2Macro(Ranks, int);
  ///@}

  ///@{
  /// Bits of a weight, 8 or 16. Default 8.
  vtkSetClampMacro(Bits, int, 8, 16);
  vtkGetMacro(Bits, int);
  ///@}

  /**
   * What is kept of an update as it goes on, so that one that is stopped need not be begun anew: the numbers
   * of an azimuth, as MesoVDMNumbers. None of it changes what comes out.
   */
  struct Parts
  {
    /// Fills in an azimuth's numbers; false where it has none.
    std::function<bool(int azimuth, float* numbers, std::size_t count)> Take;
    /// Is given an azimuth's numbers, once they are found.
    std::function<void(int azimuth, const float* numbers, std::size_t count)> Keep;
  };
  void SetParts(const Parts& parts) { this->KeptParts = parts; }

  ///@{
  /// Seconds that the last update took for rays and for factors.
  vtkGetMacro(RaySeconds, double);
  vtkGetMacro(FactorSeconds, double);
  ///@}

protected:
  vtkMesoVDM() = default;
  ~vtkMesoVDM() override = default;

  void Compute(const Map& map, vtkImageData* output) override;
  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector) override;

private:
  vtkMesoVDM(const vtkMesoVDM&) = delete;
  void operator=(const vtkMesoVDM&) = delete;

  /// All numbers of the table, of depths in tiles at its texels.
  MesoVDMNumbers Bake(const std::vector<float>& depths);
  void BakeAzimuth(const std::vector<float>& depths, int azimuth, float* numbers) const;
  void StoreFactors(MesoVDMNumbers& numbers, vtkImageData* output);

  MesoVDMLayout Layout;
  MesoVDMCurved Curved = MesoVDMCurved::Exact;
  int Ranks[2] = { 8, 4 };
  int Bits = 8;
  Parts KeptParts;
  double RaySeconds = 0.;
  double FactorSeconds = 0.;
};

#endif
