#ifndef MesoTableFactors_h
#define MesoTableFactors_h

#include "mesoFiltersMapsModule.h" // for export macro

#include <cstddef>
#include <functional>
#include <vector>

/**
 * @class MesoTableFactors
 * @brief A large table as a sum of few products: its truncated singular value decomposition.
 *
 * The table is a matrix A of many rows and few columns, A = U Lambda E^T = W E^T (Wang2003, section
 * 3.3; Wang2004, section 4.1). Of the products those of the largest singular values are kept, which
 * no other sum of as many products is nearer to in RMS (Eckart and Young).
 *
 * The space of the leading right singular vectors is found by subspace iteration on A^T A, and the
 * decomposition within it (Rayleigh and Ritz) through the small matrix (A Q)^T (A Q), in double
 * precision; A itself is never copied. Of tables with up to 256 columns, and where rank is near the
 * number of columns, that is the Gram matrix's eigendecomposition, exact. Tables that are constant,
 * empty or of less rank are no different: their further singular values are 0, and so are their
 * weights. The same table gives the same factors on any number of threads.
 */
class MESOFILTERSMAPS_EXPORT MesoTableFactors
{
public:
  /// Told how much is done, 0 to 1; false stops.
  using Progress = std::function<bool(double)>;

  /**
   * Factor a table.
   *
   * @param table rows x columns, row by row, finite
   * @param rank products that are kept, >= 1; more than there are columns are taken as so many
   * @return false where it was stopped
   */
  bool Compute(const float* table, std::size_t rows, std::size_t columns, int rank,
    const Progress& progress = {});

  int GetRank() const { return static_cast<int>(this->SingularValues.size()); }

  /// W = U Lambda: a row of GetRank() weights for each row of the table.
  const std::vector<float>& GetWeights() const { return this->Weights; }

  /// E: a row of GetRank() numbers for each column of the table; its columns are orthonormal, the sign
  /// such that the number of largest magnitude is positive.
  const std::vector<float>& GetEigenFunctions() const { return this->EigenFunctions; }

  /// Those kept, largest first.
  const std::vector<double>& GetSingularValues() const { return this->SingularValues; }

  /// RMS over the table of what the first `rank` products leave of it.
  double GetError(int rank) const;

  /// The sum of the first `rank` products at a place of the table.
  float GetValue(std::size_t row, std::size_t column, int rank) const;

private:
  std::size_t Rows = 0;
  std::size_t Columns = 0;
  double SquareSum = 0.; ///< of the table's numbers
  std::vector<float> Weights;
  std::vector<float> EigenFunctions;
  std::vector<double> SingularValues;
};

#endif
