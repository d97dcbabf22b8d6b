/**
 * @class vtkMesoGDMTable
 * @brief Make the generalized displacement map of a volume: how far the solid is from every point, in every
 * direction.
 *
 * d(x, y, z, theta, phi) at the points and directions of MesoGDMSweep.h: the distance in tile widths,
 * measured in (x, y, F z), that a ray goes to the solid of the volume and of the equal tiles around it; 0 in
 * the solid; where the ray leaves the shell before, the distance to the plane that it leaves through. Both are
 * told apart where the ray ends: on the solid's surface the volume's distance is 0, on the plane it is
 * more, unless the solid reaches the plane there and the ray meets it just then.
 *
 * The table is a matrix whose rows are (phi, y, x) and whose columns are (theta, z), the last fastest, and
 * is kept as a sum of Rank products (MesoTableFactors.h): d = sum_r W_r(x, y, phi) E_r(theta, z). The
 * weights W may be kept as whole numbers of 8 or 16 bits between the least and the greatest of each product.
 *
 * Input: a canonical volume (MesoVolume.h) of at least 2 x 2 x 2 samples.
 *
 * Output: an image of W x H x Azimuths with the point scalars
 * - `MesoGDMWeights`: Rank components, float, or unsigned char or short as Bits says; or
 * - `MesoGDMDistances` where Rank is 0: Polars x D components (theta, z), the same types, of which the
 *   greatest whole number stands for Reach;
 *
 * and the field data arrays
 * - `MesoGDMFunctions`: Polars x D tuples of Rank floats, E (not where Rank is 0);
 * - `MesoGDMWeightRange`: 2 tuples of Rank floats: what the least and the greatest whole number of each
 *   product's weights stand for (of floats: 0 and 1);
 * - `MesoGDMShape` (8 doubles): W, H, D, Azimuths, Polars, 1 where directions are even over the sphere, Reach,
 *   Rank;
 * - `MesoGDMVolume` (W x H x D floats) and `MesoVolumeDepth`: the volume, which hits are looked up in.
 *
 * An input that is no canonical volume gives one vtkErrorMacro line and an empty output; so does an
 * abort (without a line). The same volume gives the same bytes on any number of threads.
 *
 * Source: Wang2004, sections 3.1 and 4.1.
 */

#ifndef vtkMesoGDMTable_h
#define vtkMesoGDMTable_h

#include "mesoFiltersMapsModule.h" // for export macro
#include "vtkMesoWholeImageAlgorithm.h"

#include <vector> // for errors

class MESOFILTERSMAPS_EXPORT vtkMesoGDMTable : public vtkMesoWholeImageAlgorithm
{
public:
  static vtkMesoGDMTable* New();
  vtkTypeMacro(vtkMesoGDMTable, vtkMesoWholeImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Directions around z, 1 to 360. Default 16.
  vtkSetClampMacro(Azimuths, int, 1, 360);
  vtkGetMacro(Azimuths, int);
  ///@}

  ///@{
  /// Directions from +z to -z, 2 to 360. Default 32.
  vtkSetClampMacro(Polars, int, 2, 360);
  vtkGetMacro(Polars, int);
  ///@}

  ///@{
  /// Directions evenly over the sphere: equal steps of cos(theta), not of theta. Default off.
  vtkSetMacro(Even, bool);
  vtkGetMacro(Even, bool);
  vtkBooleanMacro(Even, bool);
  ///@}

  ///@{
  /// The largest distance of the table in tile widths, 0.1 to 64. Default 8.
  vtkSetClampMacro(Reach, double, 0.1, 64.);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /// Products that are kept, up to 64; 0: the whole table. Default 16.
  vtkSetClampMacro(Rank, int, 0, 64);
  vtkGetMacro(Rank, int);
  ///@}

  ///@{
  /// 8, 16, or 32 for float: of the weights, or of the whole table. Default 16.
  void SetBits(int bits);
  vtkGetMacro(Bits, int);
  ///@}

  ///@{
  /// Follow each point's own ray (MesoVolumeRay) instead of sweeping: exact, and slower. Default off.
  vtkSetMacro(Exact, bool);
  vtkGetMacro(Exact, bool);
  vtkBooleanMacro(Exact, bool);
  ///@}

  ///@{
  /**
   * Where a ray in one of the eight directions beside its own meets the solid nearer by more than a voxel, keep that
   * distance: what is interpolated then passes nothing thin, and the volume's distance takes a look-up on from there.
   * Default off.
   */
  vtkSetMacro(Cautious, bool);
  vtkGetMacro(Cautious, bool);
  vtkBooleanMacro(Cautious, bool);
  ///@}

  /// Of the last update: RMS over the table, in tile widths, of what 1, 2, ... Rank products leave of it;
  /// that of the whole numbers is not in it. Empty where Rank is 0.
  const std::vector<double>& GetFactorErrors() const { return this->FactorErrors; }

  /// Of the last update: the part of the table's numbers whose own ray was followed.
  vtkGetMacro(FollowedPart, double);

protected:
  vtkMesoGDMTable() = default;
  ~vtkMesoGDMTable() override = default;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMesoGDMTable(const vtkMesoGDMTable&) = delete;
  void operator=(const vtkMesoGDMTable&) = delete;

  bool MakeTable(vtkImageData* volume, std::vector<float>& table);
  bool AddFactors(const std::vector<float>& table, std::size_t columns, vtkImageData* output);

  int Azimuths = 16;
  int Polars = 32;
  bool Even = false;
  double Reach = 8.;
  int Rank = 16;
  int Bits = 16;
  bool Exact = false;
  bool Cautious = false;
  std::vector<double> FactorErrors;
  double FollowedPart = 0.;
};

#endif
